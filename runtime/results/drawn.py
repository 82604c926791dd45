"""Pictures of motions: time histories, spectra, one quantity over another, shapes, animations and pages."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flexel.base.arguments import path_of
from flexel.base.arrays import Array
from flexel.base.outside import Figure
from flexel.results.spectrum import amplitudes

if TYPE_CHECKING:
    from flexel.mechanics.linearization import Linearization
    from flexel.pictures.view import Page


class DrawnMotion:
    """The pictures of a `Motion`."""

    if TYPE_CHECKING:
        t: Array
        series: Any

    def plot(
        self,
        *names: str | Sequence[str],
        against: Any = (),
        labels: Sequence[str] = (),
        path: str | Path | None = None,
        title: str = "",
    ) -> Figure:
        """Time histories of named quantities, alone or compared with other motions (needs matplotlib).

        Parameters
        ----------
        *names : str or sequence of str
            Quantities; ``"steer.angle'"`` is a rate, ``"force:rod.elongation"`` a stress.  Those of one unit share
            axes; a list has axes of its own.  The degrees of freedom by default.
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
            An unknown name; quantities of different units in one list; labels that are not one for each motion.
        FlexelError
            If matplotlib is not installed.

        Examples
        --------
        >>> motion.plot("lean.angle", "lean.angle'")  # doctest: +SKIP
        >>> motion.plot(["A.x", "A.y"], ["B.x"], against=rigid, labels=["flexible", "rigid"])  # doctest: +SKIP
        """
        from flexel.pictures.histories import plot_histories

        return plot_histories(self, names, path, against=against, labels=labels, title=title)

    def spectrum(self, name: str, window: str = "hann") -> tuple[Array, Array]:
        """One-sided amplitude spectrum of a quantity: a harmonic on a line of the spectrum shows its own amplitude.

        Parameters
        ----------
        name : str
            Name as in `Motion.series`.
        window : str
            A window of `scipy.signal.get_window`; ``boxcar`` for a whole number of periods.

        Returns
        -------
        f : ndarray (nf,)
            Frequencies [Hz].
        amplitude : ndarray (nf,)
            In the unit of the quantity.

        Raises
        ------
        ModelError
            Times that are not equidistant, or fewer than four; an unknown window.
        """
        return amplitudes(self.t, self.series(name)[0], name, window)

    def spectrum_plot(
        self,
        *names: str,
        window: str = "hann",
        lin: Linearization | None = None,
        logarithmic: bool = True,
        limit: float | None = None,
        path: str | Path | None = None,
        title: str = "",
    ) -> Figure:
        """Amplitudes of named quantities over the frequency, those of one unit on axes of their own (needs matplotlib).

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
        from flexel.pictures.graphs import plot_spectra

        options = {"window": window, "lin": lin, "logarithmic": logarithmic, "limit": limit, "title": title}
        return plot_spectra(self, names, path, **options)  # type: ignore[arg-type]

    def plot_phase(self, x: str, y: str | None = None, *, path: str | Path | None = None) -> Figure:
        """One quantity against another, by default the rate of `x` against `x`; lengths have equal scales."""
        from flexel.pictures.graphs import plot_phase

        return plot_phase(self, x, f"{x}'" if y is None else y, path)  # type: ignore[arg-type]

    def plot_shapes(self, *times: float, path: str | Path | None = None, **options: Any) -> Figure:
        """The mechanism at the stored states nearest to the times; see `flexel.pictures.deflected.plot_states`."""
        from flexel.pictures.deflected import plot_states
        from flexel.pictures.options import checked

        return plot_states(self, times, path, **checked("plot_shapes", plot_states, options))  # type: ignore[arg-type]

    def animate(self, path: str | Path, **options: Any) -> Path:
        """Animation of the mechanism as .gif or .mp4 (needs matplotlib), or .html: see `view`."""
        from flexel.pictures.animation import animate
        from flexel.pictures.options import checked

        return animate(self, path_of(path, "animate"), **checked("animate", animate, options))  # type: ignore[arg-type]

    def view(self, path: str | Path, **options: Any) -> Path:
        """An HTML page that shows the motion in any browser, offline.

        Parameters
        ----------
        path : path
            Ends in ``.html``.
        **options
            ``view`` (a `View`: camera, node to follow, trails, sketches), ``frames``, ``between``, ``title``,
            ``caption``, ``plots``, ``slower`` and ``progress``; see `flexel.pictures.view.scene_data`.

        Raises
        ------
        ModelError
            An unknown option, with what to write instead; a node in the view that does not exist.

        Examples
        --------
        >>> motion.view("ride.html", view=fx.View(centre="saddle"), plots=["lean.angle"])  # doctest: +SKIP
        """
        from flexel.pictures.view import view_motion

        return view_motion(self, path, **options)  # type: ignore[arg-type]

    def page(self, **options: Any) -> Page:
        """The same page in memory, which a notebook shows as the result of a cell; options as of `view`."""
        from flexel.pictures.options import checked
        from flexel.pictures.view import Page, scene_data

        return Page(scene_data(self, **checked("page", scene_data, options)))  # type: ignore[arg-type]

    def _repr_html_(self) -> str:
        """The motion in a notebook, with a third of the frames."""
        return self.page(frames=101, progress=False)._repr_html_()
