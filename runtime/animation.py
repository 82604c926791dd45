"""Moving pictures of a mechanism: a self-contained HTML page, a GIF or an MP4.

Each frame is one PNG, so that the three writers differ only in how they join them; the HTML page holds the
frames and its own player and needs nothing from elsewhere.
Imports numpy, tqdm and the runtime rooms of scene and state; matplotlib and Pillow when asked.
"""

from __future__ import annotations

import base64
import html
import io
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from tqdm import tqdm

from flexel import drawing
from flexel.errors import FlexelError, ModelError
from flexel.scene import View, canvas, draw
from flexel.state import State

if TYPE_CHECKING:
    from flexel.result import Motion

PLAYER = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>@TITLE@</title>
<style>
body { font: 15px system-ui, sans-serif; color: #222; max-width: @WIDTH@px; margin: 1em auto; padding: 0 8px }
img { width: 100%; display: block } .bar { display: flex; gap: 10px; align-items: center } input { flex: 1 }
button { font-size: 15px; width: 5em }
</style></head><body>
<h1 style="font-size: 18px">@TITLE@</h1>
<img id="picture" alt="@TITLE@">
<div class="bar"><button id="play">Pause</button><input id="slider" type="range" min="0" max="@LAST@" value="0">
<span id="time"></span></div>
<p>@CAPTION@</p>
<script>
const frames = [@FRAMES@];
const times = [@TIMES@];
const get = id => document.getElementById(id), picture = get("picture"), slider = get("slider");
let playing = true;
function show(i) {
  picture.src = "data:image/png;base64," + frames[i];
  slider.value = i;
  get("time").textContent = times[i].toFixed(2) + " s";
}
get("play").onclick = () => { playing = !playing; get("play").textContent = playing ? "Pause" : "Play"; };
slider.oninput = () => { playing = false; get("play").textContent = "Play"; show(+slider.value); };
setInterval(() => { if (playing) show((+slider.value + 1) % frames.length); }, 1000 / @FPS@);
show(0);
</script></body></html>
"""


def animate(
    motion: Motion,
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
        ``.html`` (self-contained, with a player), ``.gif`` (needs Pillow, which comes with matplotlib) or ``.mp4``
        (needs the program ffmpeg).
    fps : float
        Frames per second of the picture.
    view : View, optional
        Eye, window, trails and sketches; by default all of the motion is within the window.
    between : (start, end), optional
        Times [s] of the part to be shown; all by default.
    title, caption : str
        Written above the picture, and below it in HTML.
    slower : float
        Seconds of picture per second of motion.
    size, dpi
        Of the frames, in inches and dots per inch.
    progress : bool, optional
        Progress bar on stderr; by default where stderr is a terminal.

    Returns
    -------
    Path

    Raises
    ------
    ModelError
        A suffix that is none of these, or an unknown node in the view.
    FlexelError
        If matplotlib or ffmpeg is missing.
    """
    path = Path(path)
    if path.suffix not in WRITERS:
        raise ModelError(
            f"animate '{path}': suffix '{path.suffix}' is unknown; use one of {', '.join(WRITERS)}"
        )
    if not (fps > 0 and slower > 0):
        raise ModelError(f"animate '{path}': fps {fps:g} and slower {slower:g} must be positive")
    if path.suffix == ".mp4" and shutil.which("ffmpeg") is None:
        raise FlexelError(
            f"animate '{path}': the program ffmpeg is not installed; install it, or write .html or .gif"
        )
    start, end = between or (float(motion.t[0]), float(motion.t[-1]))
    times = np.linspace(start, end, max(2, round((end - start) * slower * fps) + 1))
    states = [motion.at(float(t)) for t in times]
    view = view or _whole(states)
    hidden = not sys.stderr.isatty() if progress is None else not progress
    frames = tqdm(_frames(states, view, title, size, dpi), "frames", len(states), disable=hidden, leave=False)
    WRITERS[path.suffix](path, list(frames), times.tolist(), fps, title, caption, round(size[0] * dpi))
    return path


def _whole(states: list[State]) -> View:
    """A view whose window holds all of a motion."""
    places = np.vstack([line for z in states for part in drawing.shapes(z) for line in part.lines])
    low, high = places.min(axis=0), places.max(axis=0)
    middle = (low + high) / 2
    return View(centre=tuple(middle.tolist()), span=1.1 * max(float(np.max(high - low)), 1e-9))


def _frames(
    states: list[State], view: View, title: str, size: tuple[float, float], dpi: int
) -> Iterator[bytes]:
    """One PNG for each state, with the tracks so far and the time."""
    tracks = {name: np.array([state.position(name) for state in states]) for name in view.trails}
    tracks = {n: np.pad(z, ((0, 0), (0, 3 - z.shape[1]))) for n, z in tracks.items()}
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


def _write_html(
    path: Path, frames: list[bytes], times: list[float], fps: float, title: str, caption: str, width: int
) -> None:
    texts = {
        "TITLE": html.escape(title or "Motion"),
        "CAPTION": html.escape(caption),
        "WIDTH": f"{width:d}",
        "LAST": str(len(frames) - 1),
        "FPS": f"{fps:g}",
        "TIMES": ", ".join(f"{t:.6g}" for t in times),
        "FRAMES": ",\n".join(f'"{base64.b64encode(_fewer_colours(frame)).decode()}"' for frame in frames),
    }
    page = PLAYER
    for name, text in texts.items():
        page = page.replace(f"@{name}@", text)
    path.write_text(page, encoding="utf-8")


def _fewer_colours(frame: bytes) -> bytes:
    """The same picture with a palette of 64 colours, a third of the size."""
    from PIL import Image

    buffer = io.BytesIO()
    with Image.open(io.BytesIO(frame)) as picture:
        picture.convert("RGB").quantize(64, dither=Image.Dither.NONE).save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def _write_gif(
    path: Path, frames: list[bytes], times: list[float], fps: float, title: str, caption: str, width: int
) -> None:
    from PIL import Image

    pictures = [Image.open(io.BytesIO(_fewer_colours(frame))) for frame in frames]
    rest, duration = pictures[1:], round(1000 / fps)
    pictures[0].save(path, save_all=True, append_images=rest, duration=duration, loop=0)


def _write_mp4(
    path: Path, frames: list[bytes], times: list[float], fps: float, title: str, caption: str, width: int
) -> None:
    command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "image2pipe", "-framerate", f"{fps:g}", "-i", "-"]
    command += ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", str(path)]
    result = subprocess.run(command, input=b"".join(frames), capture_output=True, check=False)
    if result.returncode:
        raise FlexelError(
            f"animate '{path}': ffmpeg failed: {result.stderr.decode(errors='replace').strip()}"
        )


WRITERS: dict[str, Callable[[Path, list[bytes], list[float], float, str, str, int], None]] = {
    ".html": _write_html,
    ".gif": _write_gif,
    ".mp4": _write_mp4,
}
