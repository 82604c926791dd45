"""The viewer: one HTML file that shows a motion or modes of vibration in a browser, offline."""

from __future__ import annotations

import html
import json
from collections.abc import Mapping, Sequence
from importlib import resources
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING, Any, overload

from flexel.apps.view.options import checked
from flexel.apps.view.page.coding import coded
from flexel.apps.view.page.data import FORMAT, scene_data
from flexel.apps.view.page.mode_shapes import mode_data
from flexel.base.arguments import path_of, whole
from flexel.base.errors import ModelError
from flexel.base.files import replacing
from flexel.base.shown import prints

if TYPE_CHECKING:
    from flexel.apps.view.page.mode_shapes import AnyMode
    from flexel.integration.trajectory import Trajectory
    from flexel.mechanics.linearized_system import LinearizedSystem
    from flexel.model.state import State

__all__ = ["Page", "mode_data", "page", "scene_data", "view_modes", "view_motion", "write_page"]

UNTRUSTED = "Run this cell, or trust the notebook, to see the page."
# Joined as one module in the page, in this order.
SCRIPTS = (
    *(
        "start.js",
        "decode.js",
        "sweep.js",
        "batch.js",
        "colours.js",
        "parts.js",
        "pieces.js",
        "ground.js",
        "orbit.js",
    ),
    *("fit.js", "hover.js", "strip.js", "controls.js", "viewer.js"),
)


@overload
def view_motion(motion: Trajectory, path: str | Path, **options: Any) -> Path: ...


@overload
def view_motion(motion: Trajectory, path: None = None, **options: Any) -> Page: ...


def view_motion(motion: Trajectory, path: str | Path | None = None, **options: Any) -> Path | Page:
    """Write a page that shows a motion; without a path, return it. The options are those of `scene_data`.

    Examples
    --------
    >>> motion.view("bicycle.html")  # doctest: +SKIP
    """
    return _written(scene_data(motion, **checked("view", scene_data, options)), path)


@overload
def view_modes(
    about: LinearizedSystem | State,
    path: str | Path,
    modes: Sequence[AnyMode] | None = None,
    **options: Any,
) -> Path: ...


@overload
def view_modes(
    about: LinearizedSystem | State,
    path: None = None,
    modes: Sequence[AnyMode] | None = None,
    **options: Any,
) -> Page: ...


def view_modes(
    about: LinearizedSystem | State,
    path: str | Path | None = None,
    modes: Sequence[AnyMode] | None = None,
    **options: Any,
) -> Path | Page:
    """Write a page that shows modes of vibration or buckling with a slider for the amplitude, or return it.

    See `mode_data` for the options.

    Examples
    --------
    >>> view_modes(system.linearize(state), "modes.html")  # doctest: +SKIP
    >>> view_modes(state, "modes.html", system.vibrations(state))  # doctest: +SKIP
    """
    return _written(mode_data(about, modes, **checked("view of modes", mode_data, options)), path)


class Page:
    """A page of the viewer in memory; a notebook shows it as the result of a cell, in a frame that can be resized.

    Parameters
    ----------
    scene : mapping
        From `scene_data` or `mode_data`.
    height : int
        Of the frame [pixels].

    Examples
    --------
    >>> Page(mode_data(system.linearize()))  # doctest: +SKIP
    """

    def __init__(self, scene: Mapping[str, Any], height: int = 520) -> None:
        self.scene = scene
        self.height = whole(height, "Page", "height", least=100, most=10_000)

    @prints
    def __repr__(self) -> str:
        return f"Page({self.scene.get('title') or 'Motion'})"

    def write(self, path: str | Path) -> Path:
        """Write the page to a file; see `write_page`."""
        return write_page(self.scene, path)

    def _repr_html_(self) -> str:
        """Return the page in a separate frame, for notebooks; nothing is fetched and no other file is needed.

        A notebook that is not trusted shows no frames: then the words behind it are seen.
        """
        style = f"resize:both;overflow:hidden;width:100%;height:{self.height}px;border:1px solid #d0d7de"
        style += ";position:relative"
        title = html.escape(str(self.scene.get("title") or "Motion"), quote=True)
        inner = html.escape(page(self.scene), quote=True)
        filled = "width:100%;height:100%;border:0;position:relative"
        behind = f'<p style="position:absolute;margin:1em">{UNTRUSTED}</p>'
        frame = f'<iframe title="{title}" srcdoc="{inner}" style="{filled}" allowfullscreen></iframe>'
        return f'<div style="{style}">{behind}{frame}</div>'


def _written(scene: Mapping[str, Any], path: str | Path | None) -> Path | Page:
    """Write the page of a scene; without a path, return it, for a notebook."""
    return Page(scene) if path is None else write_page(scene, path)


def write_page(scene: Mapping[str, Any], path: str | Path) -> Path:
    """Write the page of a scene.

    Raises
    ------
    ModelError
        A suffix other than .html, or a scene of another format.
    """
    path = path_of(path, "view")
    if path.suffix not in (".html", ".htm"):
        raise ModelError(f"view '{path}': the viewer writes HTML; give a file name that ends in .html")
    with replacing(path, "view") as part:
        part.write_text(page(scene), encoding="utf-8")
    return path


def page(scene: Mapping[str, Any]) -> str:
    """Return the page of a scene as text; nothing in the scene is executed."""
    if scene.get("format") != FORMAT:
        raise ModelError(
            f"view: the scene has format {scene.get('format')!r}, this version shows {FORMAT}; save the motion again"
        )
    folder = resources.files("flexel.apps.view.page")
    # only `<` could end a script element
    data = json.dumps(coded(scene), allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")
    return Template(_text(folder, "page.html")).substitute(
        title=html.escape(str(scene.get("title") or "Motion")),
        style=_text(folder, "viewer.css"),
        scene=data,
        three=_text(folder, "three.module.min.js"),
        script="\n".join(_text(folder, name) for name in SCRIPTS),
    )


def _text(folder: Any, name: str) -> str:
    return str(folder.joinpath(name).read_text(encoding="utf-8"))
