"""Linearized equations about a state as a result: with state space, closed loops, plots and files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack, overload

from flexel.base.arguments import flag
from flexel.base.arrays import StateSpace
from flexel.base.blas import in_one_thread
from flexel.base.outside import DataFrame, Dataset, Figure
from flexel.linear.response import FrequencyResponse, frequency_response
from flexel.linear.sampled import SampledLoop, sampled_loop
from flexel.linear.sensors import state_space
from flexel.mechanics.linearized_system import LinearizedSystem

if TYPE_CHECKING:
    from flexel.apps.view.options import ModeOptions
    from flexel.apps.view.page import Page
    from flexel.apps.view.scene import View
    from flexel.mechanics.modes import Mode


class Linearization(LinearizedSystem):
    """Linearized equations about a state, from `System.linearize`.

    Attributes
    ----------
    M, C : ndarray (nd, nd)
    K : ndarray (nd, nq)
        Columns for dynamic, then kinematic degrees of freedom.
    A_k, B_k : ndarray (nk, nd), ndarray (nk, nq)
        𝒜 and ℬ of δq_k' = 𝒜 δq_d' + ℬ δq.
    Z : ndarray (nd, nz)
        Generalized forces of the laws' internal states: M δq_d'' + C δq_d' + K δq + Z δz = F δu.
    Z_v, Z_q, Z_z : ndarray (nz, nd), ndarray (nz, nq), ndarray (nz, nz)
        δz' = Z_v δq_d' + Z_q δq + Z_z δz.
    dynamic, kinematic, prescribed, internal : tuple of str
        Names of the degrees of freedom, of the prescribed motions and of the laws' internal states.
    state : State
        The state about which it was linearized.
    """

    @in_one_thread
    def state_space(self, inputs: Sequence[str] = (), outputs: Sequence[str] = ()) -> StateSpace:
        """Return state-space matrices A, B, C, D.

        Parameters
        ----------
        inputs : sequence of str
            Names of loads (any quantity: the generalized force dual to it) or of prescribed motions.  The input of
            a prescribed motion is its acceleration, labelled ``road.y''``; its rate and value join the states, in that
            order.  ``displacement:road.y`` makes its displacement the input: the states are then shifted, so that no
            rates of the input are needed, and marked with a star.
        outputs : sequence of str
            Names of quantities; a suffix ``'`` selects the rate, ``''`` the acceleration, and a prefix
            ``force:`` the stress or reaction.

        Returns
        -------
        A, B, C, D : ndarray
        """
        return state_space(self, inputs, outputs)

    @in_one_thread
    def sampled(self) -> SampledLoop:
        """Return the closed loop of the sampled controllers over one period.

        Controllers may have different periods: the loop then covers their least common multiple, and begins when
        all of them measure.

        Raises
        ------
        LinearizationError
            If no controller is sampled, if periods have no common multiple that is short enough, or if a controller is
            not smooth or at its limit there.

        Warns
        -----
        UnsteadyWarning
            If the state is not a fixed point of the loop: it accelerates, or a controller would change its outputs.

        Examples
        --------
        >>> system.linearize().sampled().eigenvalues()  # doctest: +SKIP
        """
        return sampled_loop(self)

    @in_one_thread
    def frequency_response(
        self, inputs: str | Sequence[str], outputs: str | Sequence[str], frequencies: Any = None
    ) -> FrequencyResponse:
        """Return complex amplitudes of outputs per unit amplitude of inputs: C (iω - A)⁻¹ B + D.

        Parameters
        ----------
        inputs, outputs : str or sequence of str
            As in `state_space`.
        frequencies : array_like (nf,), optional
            [Hz]; by default from a tenth of the lowest to ten times the highest natural frequency, closer together
            about resonances and antiresonances.

        Returns
        -------
        FrequencyResponse
            ``frequencies`` (nf,) [Hz], ``values`` (nf, outputs, inputs), ``magnitude``, ``decibels``, ``phase`` [rad].

        Raises
        ------
        LinearizationError, ModelError
            As `state_space`; no name; a negative frequency, or one at which the response is infinite.

        Examples
        --------
        >>> lin.frequency_response("motor.angle", "tip.y", [1.0, 10.0]).magnitude[:, 0, 0]  # doctest: +SKIP
        """
        return frequency_response(self, inputs, outputs, frequencies)

    @in_one_thread
    def bode(
        self,
        inputs: str | Sequence[str],
        outputs: str | Sequence[str],
        frequencies: Any = None,
        *,
        path: str | Path | None = None,
        decibels: bool = False,
        title: str = "",
    ) -> Figure:
        """Plot magnitude and phase of outputs against the frequency of inputs (needs matplotlib).

        Parameters
        ----------
        inputs, outputs : str or sequence of str
            As in `state_space`; every pair is drawn, magnitudes of different units on separate axes.
        frequencies : array_like (nf,), optional
            [Hz]; those about resonances between them are added, so that no peak is cut off.
        path : path, optional
            File for the figure; the suffix determines the format.
        decibels : bool
            Magnitudes in decibels relative to one unit; ratios on a logarithmic axis otherwise.
        title : str

        Examples
        --------
        >>> lin.bode("motor.angle", ["tip.y", "motor.angle"], path="bode.png")  # doctest: +SKIP
        """
        from flexel.apps.view.bode import plot_bode

        found = frequency_response(self, inputs, outputs, frequencies, refine=True)
        return plot_bode(found, path, decibels=flag(decibels, "bode", "decibels"), title=title)

    def plot(self, path: str | Path | None = None) -> Figure:
        """Plot the eigenvalues in the complex plane (needs matplotlib)."""
        from flexel.apps.view.graphs import plot_poles

        return plot_poles([self.eigenvalues()], path)

    def plot_mode(self, number: int, path: str | Path | None = None, **options: Any) -> Figure:
        """Draw the shape of a mode of `modes`, over the state in grey; see `flexel.apps.view.deflected.plot_shape`."""
        from flexel.apps.view.deflected import plot_shape
        from flexel.apps.view.options import checked

        mode = self.mode(number)
        title = f"{mode.name}: {mode.eigenvalue:.4g} 1/s"
        return plot_shape(
            self.state,
            self.mode_shape(number),
            path,
            **{"title": title} | checked("plot_mode", plot_shape, options),
        )

    @overload
    def view(self, path: str | Path, **options: Unpack[ModeOptions]) -> Path: ...

    @overload
    def view(self, path: None = None, **options: Unpack[ModeOptions]) -> Page: ...

    def view(
        self,
        path: str | Path | None = None,
        modes: Sequence[Mode] | None = None,
        *,
        view: View | None = None,
        title: str = "",
        caption: str = "",
        **unknown: Any,
    ) -> Path | Page:
        """Make an HTML page that shows the modes in any browser, with amplitude and phase.

        Parameters
        ----------
        path : path, optional
            Ends in ``.html``.  Without it the page is returned, which a notebook shows as the result of a cell.
        modes : sequence of Mode, optional
            Those of `modes` to show; by default the slowest twelve.
        view : View, optional
            Camera, window and sketches.
        title, caption : str
            Written above the picture.

        Raises
        ------
        ModelError
            An unknown option, with what to write instead; a mode of another model.
        """
        from flexel.apps.view.page import view_modes

        return view_modes(self, path, modes, view=view, title=title, caption=caption, **unknown)

    @in_one_thread
    def to_control(self, inputs: Sequence[str], outputs: Sequence[str] = (), *, name: str = "flexel") -> Any:
        """Return a labelled `control.StateSpace` (needs python-control).

        Parameters
        ----------
        inputs, outputs : sequence of str
            As in `state_space`; the outputs are the degrees of freedom if none are named.
        name : str
            Name of the system, for `control.interconnect`.

        Raises
        ------
        FlexelError
            If python-control is not installed.
        LinearizationError, ModelError
            No inputs; duplicate or unknown names.

        Examples
        --------
        >>> plant = lin.to_control(["motor.angle"], ["tip.y", "motor.angle'"])  # doctest: +SKIP
        >>> plant.input_labels, plant.output_labels  # doctest: +SKIP
        (['motor_angle'], ['tip_y', "motor_angle'"])
        """
        from flexel.results.control import to_control

        return to_control(self, inputs, outputs, name=name)

    @in_one_thread
    def to_scipy(self, inputs: Sequence[str], outputs: Sequence[str] = ()) -> Any:
        """Return a `scipy.signal.StateSpace`; its states, inputs and outputs are ordered as in `state_space`."""
        from flexel.results.control import to_scipy

        return to_scipy(self, inputs, outputs)

    def save_state_space(self, path: str | Path, inputs: Sequence[str], outputs: Sequence[str] = ()) -> Path:
        """Write A, B, C, D and the names of states, inputs and outputs to a .mat file, for Matlab's ``ss(A, B, C, D)``.

        Raises
        ------
        ModelError
            A suffix other than .mat.
        """
        from flexel.results.control import save_state_space

        return save_state_space(self, path, inputs, outputs)

    def to_xarray(self) -> Dataset:
        """Return matrices, eigenvalues and modes as an xarray.Dataset with names and units along rows and columns."""
        from flexel.results.saved.archive_linear import to_xarray

        return to_xarray(self)

    def to_pandas(self) -> DataFrame:
        """Return a pandas.DataFrame of the modes: eigenvalue, frequency, damping ratio, and participating degrees of
        freedom.
        """
        from flexel.results.saved.archive_linear import to_pandas

        return to_pandas(self)

    def save(self, path: str | Path) -> Path:
        """Write all matrices with their names as .nc, .npz, .mat or .csv; `flexel.load` reads them back.

        For A, B, C and D alone, in Matlab format, see `save_state_space`.
        """
        from flexel.results.saved.archive_linear import save

        return save(self, path)


def as_linearization(found: LinearizedSystem) -> Linearization:
    """Return linearized equations as a result."""
    made = Linearization(**{field.name: getattr(found, field.name) for field in fields(found)})
    object.__setattr__(made, "_afterwards", getattr(found, "_afterwards", None))
    return made
