"""Pictures of linearized equations, and the frequency response that they show."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flexel.base.outside import Figure
from flexel.mechanics.shown import ShownLinearization

if TYPE_CHECKING:
    from flexel.results.response import FrequencyResponse


class DrawnLinearization(ShownLinearization):
    """The pictures of a `Linearization`."""

    if TYPE_CHECKING:
        eigenvalues: Any
        mode: Any
        mode_shape: Any

    def frequency_response(
        self, inputs: str | Sequence[str], outputs: str | Sequence[str], frequencies: Any = None
    ) -> FrequencyResponse:
        """Complex amplitudes of outputs per unit amplitude of inputs: C (iω - A)⁻¹ B + D.

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
        from flexel.results.response import frequency_response

        return frequency_response(self, inputs, outputs, frequencies)  # type: ignore[arg-type]

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
        """Magnitude and phase of outputs over the frequency of inputs (needs matplotlib).

        Parameters
        ----------
        inputs, outputs : str or sequence of str
            As in `state_space`; every pair is drawn, magnitudes of different units on axes of their own.
        frequencies : array_like (nf,), optional
            [Hz]; those about resonances between them are added, so that no peak is cut off.
        path : path, optional
            File for the figure; the suffix determines the format.
        decibels : bool
            Magnitudes in decibels of one unit; ratios on a logarithmic axis otherwise.
        title : str

        Examples
        --------
        >>> lin.bode("motor.angle", ["tip.y", "motor.angle"], path="bode.png")  # doctest: +SKIP
        """
        from flexel.base.arguments import flag
        from flexel.pictures.bode import plot_bode
        from flexel.results.response import frequency_response

        found = frequency_response(self, inputs, outputs, frequencies, refine=True)  # type: ignore[arg-type]
        return plot_bode(found, path, decibels=flag(decibels, "bode", "decibels"), title=title)

    def plot(self, path: str | Path | None = None) -> Figure:
        """Eigenvalues in the complex plane (needs matplotlib)."""
        from flexel.pictures.graphs import plot_poles

        return plot_poles([self.eigenvalues()], path)

    def plot_mode(self, number: int, path: str | Path | None = None, **options: Any) -> Figure:
        """The shape of a mode of `modes`, over the state in grey; see `flexel.pictures.deflected.plot_shape`."""
        from flexel.pictures.deflected import plot_shape
        from flexel.pictures.options import checked

        mode = self.mode(number)
        title = f"{mode.name}: {mode.eigenvalue:.4g} 1/s"
        return plot_shape(
            self.state,
            self.mode_shape(number),
            path,
            **{"title": title} | checked("plot_mode", plot_shape, options),
        )

    def view(self, path: str | Path, **options: Any) -> Path:
        """An HTML page that shows the modes in any browser, with amplitude and phase.

        Parameters
        ----------
        path : path
            Ends in ``.html``.
        **options
            ``modes``, ``view`` (a `View`), ``title`` and ``caption``; see `flexel.pictures.view.mode_data`.
        """
        from flexel.pictures.view import view_modes

        return view_modes(self, path, **options)  # type: ignore[arg-type]
