"""A motion as a result: its states over time, with plots, animations, pages, tables and files."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from html import escape
from inspect import getdoc, signature
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, Unpack, overload

from flexel.base.arguments import path_of
from flexel.base.errors import FlexelError
from flexel.base.outside import DataFrame, Dataset, Figure
from flexel.integration.trajectory import Trajectory

if TYPE_CHECKING:
    from flexel.apps.view.animation import Animation
    from flexel.apps.view.options import MotionOptions
    from flexel.apps.view.page import Page
    from flexel.apps.view.scene import View
    from flexel.mechanics.linearized_system import LinearizedSystem


F = TypeVar("F", bound=Callable[..., Any])


def with_options_of(method: Callable[..., Any]) -> Callable[[F], F]:
    """Show the signature and the options of another method, to which a method passes all that it is given."""

    def shown(function: F) -> F:
        told = getdoc(method) or ""
        function.__signature__ = signature(method)  # type: ignore[attr-defined]
        function.__doc__ = f"{getdoc(function)}\n\n{told[told.index('Parameters') :]}"
        return function

    return shown


class Motion(Trajectory):
    """The states of a simulated or prescribed motion at the stored times, from a simulation or a file.

    ``motion["rod.bend1"]`` is the time history (nt,) of a quantity, ``motion["rod.bend1'"]`` of its rate,
    ``motion["rod.bend1''"]`` of its acceleration, ``motion["force:rod.bend1"]`` of its stress or reaction; plots and
    tables use the same names.  ``motion[i]`` is the i-th state.

    Attributes
    ----------
    t : ndarray (nt,)
        Stored times [s].
    events : list of (str, State)
        Events in the order of their occurrence.
    statistics : dict of str to int
        Steps, evaluations of the equations of motion, changes of coordinates.
    message : str
        How the integration ended, why its method was chosen, the warnings, and the verdict.
    warnings : tuple of str
        Warnings of the method about the motion; each was also issued as a Python warning when it was computed.
    verdict : str
        Result of the audit in one line: the energy balance, the number of events, and whether a contact was passed.
        Empty for a motion that was not audited, such as an interrupted one.
    rechoices : list of (float, tuple of str, tuple of str)
        Changes of the degrees of freedom within an explicit integration: times [s], old and new names.
    energy_terms : dict of str to list of float, optional
        For an implicit integration, at the stored times: energy in contacts, energy dissipated and work so far [J];
        see `energy_balance`.
    """

    def plot(
        self,
        *names: str | Sequence[str],
        against: Any = (),
        labels: Sequence[str] = (),
        path: str | Path | None = None,
        title: str = "",
    ) -> Figure:
        """Plot time histories of named quantities, alone or compared with other motions (needs matplotlib).

        Parameters
        ----------
        *names : str or sequence of str
            Quantities; ``"steer.angle'"`` is a rate, ``"force:rod.elongation"`` a stress.  Quantities of one unit share
            axes; a list has separate axes.  The degrees of freedom by default.
        against : Motion or sequence of Motion
            Other motions, drawn with other kinds of lines.
        labels : sequence of str
            Names of this motion and of the others, for the legend.
        path : path, optional
            File for the figure; the suffix determines the format.
        title : str

        Raises
        ------
        ModelError
            An unknown name; quantities of different units in one list; a number of labels that is not that of
            the motions.
        FlexelError
            If matplotlib is not installed.

        Examples
        --------
        >>> motion.plot("lean.angle", "lean.angle'")  # doctest: +SKIP
        >>> motion.plot(["A.x", "A.y"], ["B.x"], against=rigid, labels=["flexible", "rigid"])  # doctest: +SKIP
        """
        from flexel.apps.view.histories import plot_histories

        return plot_histories(self, names, path, against=against, labels=labels, title=title)

    def spectrum_plot(
        self,
        *names: str,
        window: str = "hann",
        lin: LinearizedSystem | None = None,
        logarithmic: bool = True,
        limit: float | None = None,
        path: str | Path | None = None,
        title: str = "",
    ) -> Figure:
        """Plot amplitudes of named quantities against frequency, with separate axes for each unit (needs matplotlib).

        Parameters
        ----------
        *names : str
            Quantities; the degrees of freedom by default.
        window : str
            As in `spectrum`.
        lin : Linearization, optional
            Its natural frequencies (of oscillation, with damping) are marked.
        logarithmic : bool
            Logarithmic scale of the amplitudes.
        limit : float, optional
            Largest frequency shown [Hz].
        path : path, optional
            File for the figure; the suffix determines the format.
        title : str
        """
        from flexel.apps.view.graphs import plot_spectra

        return plot_spectra(
            self, names, path, window=window, lin=lin, logarithmic=logarithmic, limit=limit, title=title
        )

    def plot_phase(self, x: str, y: str | None = None, *, path: str | Path | None = None) -> Figure:
        """Plot one quantity against another, by default the rate of `x` against `x`; lengths have equal scales."""
        from flexel.apps.view.graphs import plot_phase

        return plot_phase(self, x, f"{x}'" if y is None else y, path)

    def plot_shapes(self, *times: float, path: str | Path | None = None, **options: Any) -> Figure:
        """Draw the mechanism at the stored states nearest to the times; see `deflected.plot_states`."""
        from flexel.apps.view.deflected import plot_states
        from flexel.apps.view.options import checked

        return plot_states(self, times, path, **checked("plot_shapes", plot_states, options))

    @overload
    def animate(self, path: str | Path, **options: Any) -> Path: ...

    @overload
    def animate(self, path: None = None, **options: Any) -> Animation: ...

    def animate(self, path: str | Path | None = None, **options: Any) -> Path | Animation:
        """Animate the mechanism as .gif or .mp4 (needs matplotlib), or .html: see `view`.

        Without a path the .gif is returned, which a notebook shows as the result of a cell.
        """
        from flexel.apps.view.animation import animate, animation
        from flexel.apps.view.options import checked

        given = checked("animate", animate, options)
        return animation(self, **given) if path is None else animate(self, path_of(path, "animate"), **given)

    @overload
    def view(self, path: str | Path, **options: Unpack[MotionOptions]) -> Path: ...

    @overload
    def view(self, path: None = None, **options: Unpack[MotionOptions]) -> Page: ...

    def view(
        self,
        path: str | Path | None = None,
        *,
        frames: int = 301,
        between: tuple[float, float] | None = None,
        view: View | None = None,
        title: str = "",
        caption: str = "",
        plots: Sequence[str] | None = None,
        slower: float | None = None,
        progress: bool | None = None,
        **unknown: Any,
    ) -> Path | Page:
        """Write an HTML page that shows the motion in any browser, offline.

        Parameters
        ----------
        path : path, optional
            Ends in ``.html``.  Without it the page is returned, which a notebook shows as the result of a cell.
        frames : int
            Equally spaced in time; for a motion by generalized-alpha or from a file, that many of its
            stored states.
        between : (start, end), optional
            Times [s] of the part to show; all by default.
        view : View, optional
            Camera, window, node to follow, trails and sketches.
        title, caption : str
            Written above the picture; the title is the time of the motion by default.
        plots : sequence of str, optional
            Quantities in the plot strip when the page opens, by the names of `series`; by default degrees of freedom
            that a person can see.  The page offers more.
        slower : float, optional
            Seconds of picture per second of motion; by default chosen so that the motion can be followed.
        progress : bool, optional
            Progress bar; by default where stderr is a terminal, and in a notebook.

        Raises
        ------
        ModelError
            An unknown option, with what to write instead; a node in the view that does not exist.

        Examples
        --------
        >>> motion.view("ride.html", view=fx.View(centre="saddle"), plots=["lean.angle"])  # doctest: +SKIP
        """
        from flexel.apps.view.page import view_motion

        return view_motion(
            self,
            path,
            frames=frames,
            between=between,
            view=view,
            title=title,
            caption=caption,
            plots=plots,
            slower=slower,
            progress=progress,
            **unknown,
        )

    def page(self, **options: Any) -> Page:
        """Return the same page in memory, which a notebook shows as the result of a cell; options as in `view`."""
        from flexel.apps.view.options import checked
        from flexel.apps.view.page import Page, scene_data

        return Page(scene_data(self, **checked("page", scene_data, options)))

    def _repr_html_(self) -> str:
        """Show the motion in a notebook, with a third of the frames; or the reason why there is nothing to show."""
        try:
            return self.page(frames=101, progress=False)._repr_html_()
        except FlexelError as error:
            return f"<p>{escape(repr(self))}</p><p>{escape(str(error))}</p>"

    def to_xarray(self, *names: str) -> Dataset:
        """Return an xarray.Dataset: one variable for each name, or everything, labelled, if none is given."""
        from flexel.results.saved.exports import motion_dataset

        return motion_dataset(self, names)

    def to_pandas(self, *names: str) -> DataFrame:
        """Return a pandas.DataFrame over time, a column for each name; all values if none is given.

        The units are in its ``attrs["units"]``.
        """
        from flexel.results.saved.exports import motion_frame

        return motion_frame(self, names)

    def save(self, path: str | Path) -> Path:
        """Write the motion, names and units included, as .nc, .npz, .mat or .csv; `flexel.load` reads it back.

        Examples
        --------
        >>> motion.save("bicycle.nc")  # doctest: +SKIP
        >>> fx.load("bicycle.nc")["lean.angle"]  # doctest: +SKIP
        """
        from flexel.results.saved.archive import record_of
        from flexel.results.saved.record_files import write

        return write(record_of(self), path)
