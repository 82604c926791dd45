"""Animates a mechanism: a GIF or an MP4 drawn by matplotlib, or the page of `flexel.apps.view.page`.

Each frame is one PNG, so the writers differ only in how they join the frames.
"""

from __future__ import annotations

import base64
import html
import io
import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.apps.view import drawing
from flexel.apps.view.options import span_of
from flexel.apps.view.scene import View, canvas, draw, painted, view_of
from flexel.base.arguments import path_of, positive
from flexel.base.errors import FlexelError, ModelError
from flexel.base.files import replacing
from flexel.base.progress import followed, seen
from flexel.model.state import State

if TYPE_CHECKING:
    from flexel.integration.trajectory import Trajectory


class Animation:
    """An animation in memory, which a notebook shows as the result of a cell.

    Attributes
    ----------
    data : bytes
        A GIF.
    """

    def __init__(self, data: bytes, title: str) -> None:
        self.data, self.title = data, title

    def __repr__(self) -> str:
        return f"Animation({len(self.data) / 1e6:.2g} MB as .gif)"

    def write(self, path: str | Path) -> Path:
        """Write the GIF to a file.

        Raises
        ------
        ModelError
            A suffix other than .gif.
        """
        place = path_of(path, "animation")
        if place.suffix != ".gif":
            raise ModelError(f"animation '{place}': it is a GIF; write .gif, or motion.animate('{place}')")
        with replacing(place, "animation") as part:
            part.write_bytes(self.data)
        return place

    def _repr_html_(self) -> str:
        """Return the picture with its data; no other file is needed."""
        name = html.escape(self.title or "Motion", quote=True)
        return f'<img alt="{name}" src="data:image/gif;base64,{base64.b64encode(self.data).decode()}">'


def animation(motion: Trajectory, fps: float = 12.0, title: str = "", **options: Any) -> Animation:
    """Animate a motion in memory; options as in `animate`."""
    with TemporaryDirectory() as folder:
        made = animate(motion, Path(folder) / "motion.gif", fps, title=title, **options)
        return Animation(made.read_bytes(), title)


def animate(
    motion: Trajectory,
    path: str | Path,
    fps: float = 12.0,
    *,
    view: View | None = None,
    between: tuple[float, float] | None = None,
    title: str = "",
    caption: str = "",
    slower: float = 1.0,
    size: tuple[float, float] = (7.2, 4.2),
    dpi: int = 100,
    progress: bool | None = None,
) -> Path:
    """Animate a motion.

    Parameters
    ----------
    path : path
        ``.gif`` (needs Pillow, which comes with matplotlib), ``.mp4`` (needs the program ffmpeg), or ``.html``: the
        page of `Motion.view`.
    fps : float
        Frames per second of the picture; the page interpolates between them.  For a motion by generalized-alpha
        or from a file, the frames are the stored states nearest to their times.
    view : View, optional
        Camera, window, trails and sketches; by default the window contains the whole motion.
    between : (start, end), optional
        Times [s] of the part to be shown; all by default.
    title, caption : str
        Written above the picture; the caption on the page only.
    slower : float
        Seconds of picture per second of motion.
    size, dpi
        Size and resolution of the frames of a GIF or an MP4, in inches and dots per inch.
    progress : bool, optional
        Progress bar on stderr; by default where stderr is a terminal, and in a notebook.

    Returns
    -------
    Path

    Raises
    ------
    ModelError
        Another suffix, or an unknown node in the view.
    FlexelError
        If matplotlib or ffmpeg is missing.
    """
    path = path_of(path, "animate")
    known = [*WRITERS, ".html"]
    if path.suffix not in known:
        raise ModelError(
            f"animate '{path}': suffix '{path.suffix}' is unknown; use one of {', '.join(known)}"
        )
    owner = f"animate '{path}'"
    fps, slower = positive(fps, owner, "fps"), positive(slower, owner, "slower")
    if path.suffix == ".mp4" and shutil.which("ffmpeg") is None:
        raise FlexelError(
            f"animate '{path}': the program ffmpeg is not installed; install it (`apt install ffmpeg`), or write .html "
            "or .gif"
        )
    start, end = span_of(motion, between, owner)
    count = max(2, round((end - start) * slower * fps) + 1)
    if path.suffix == ".html":
        from flexel.apps.view.page import view_motion

        shown: dict[str, Any] = {"view": view, "title": title, "caption": caption, "progress": progress}
        return view_motion(motion, path, frames=count, between=between, slower=slower, **shown)
    state_at = motion.at if motion.interpolates else motion.nearest
    states = [state_at(float(t)) for t in np.linspace(start, end, count)]
    view = _whole(states) if view is None else view_of(view, owner)
    drawn = _frames(states, view, title, size, dpi)
    frames = followed(drawn, seen(progress, "animate"), len(states), "frame")
    with replacing(path, "animate") as part:
        WRITERS[path.suffix](part, list(frames), fps)
    return path


def _whole(states: list[State]) -> View:
    """Return a view whose window contains the whole motion."""
    places = painted(drawing.shapes(states))
    low, high = places.min(axis=(0, 1)), places.max(axis=(0, 1))
    middle = (low + high) / 2
    return View(centre=tuple(middle.tolist()), span=1.1 * max(float(np.max(high - low)), 1e-9))


def _frames(
    states: list[State], view: View, title: str, size: tuple[float, float], dpi: int
) -> Iterator[bytes]:
    """Yield one PNG for each state, with the tracks so far and the time."""
    tracks = {name: np.array([state.position(name) for state in states]) for name in view.trails}
    tracks = {n: np.pad(track, ((0, 0), (0, 3 - track.shape[1]))) for n, track in tracks.items()}
    with canvas(states[0], size) as (drawn, axes):
        heading = drawn.suptitle(title or " ")
        for i, state in enumerate(states):
            axes.clear()
            draw(state, axes, view, {name: track[: i + 1] for name, track in tracks.items()})
            text = f"{title}   t = {state.t:5.2f} s" if title else f"t = {state.t:5.2f} s"
            heading.set_text(text)
            buffer = io.BytesIO()
            drawn.savefig(buffer, format="png", dpi=dpi)
            yield buffer.getvalue()


def _fewer_colours(frame: bytes) -> bytes:
    """Return the same picture with a palette of 64 colours, a third of the size."""
    from PIL import Image

    buffer = io.BytesIO()
    with Image.open(io.BytesIO(frame)) as picture:
        picture.convert("RGB").quantize(64, dither=Image.Dither.NONE).save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def _write_gif(path: Path, frames: list[bytes], fps: float) -> None:
    from PIL import Image

    pictures = [Image.open(io.BytesIO(_fewer_colours(frame))) for frame in frames]
    rest, duration = pictures[1:], round(1000 / fps)
    pictures[0].save(path, save_all=True, append_images=rest, duration=duration, loop=0)


def _write_mp4(path: Path, frames: list[bytes], fps: float) -> None:
    command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "image2pipe", "-framerate", f"{fps:g}", "-i", "-"]
    command += ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", str(path)]
    result = subprocess.run(command, input=b"".join(frames), capture_output=True, check=False)
    if result.returncode:
        raise FlexelError(
            f"animate '{path}': ffmpeg failed: {result.stderr.decode(errors='replace').strip()}"
        )


WRITERS: dict[str, Callable[[Path, list[bytes], float], None]] = {
    ".gif": _write_gif,
    ".mp4": _write_mp4,
}
