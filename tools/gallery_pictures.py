"""Draws the small pictures of the gallery: what the viewer shows of the last line of each program.

`python tools/gallery_pictures.py [NAME …]` writes them to docs/images/gallery/, of the named programs or of all.
It needs Chromium. Look at them.
"""

from __future__ import annotations

import ast
import contextlib
import io
import sys
import tempfile
from importlib import import_module
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib import pyplot as plt
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
PROGRAMS, PICTURES = ROOT / "examples" / "gallery", ROOT / "docs" / "images" / "gallery"
SIZE = (400, 280)  # of a picture in the list
WINDOW = (800, 560)  # of the drawing, which is shrunk to it
TIME = 0.35  # share of the motion at which it is shown
TIMES = {
    "caster_shimmy": 0.9,
    "delta_robot": 0.9,
    "differential": 0.0,
    "four_bar": 0.9,
    "hanging_chain": 1.0,
    "own_element": 0.8,
    "robot_arm": 0.9,
    "trebuchet": 0.62,
    "walking_leg": 0.9,
}
LARGEST = "0.25"  # amplitude of a mode


def last_line(name: str) -> Any:
    """Run a program of the gallery; return the value of its last line."""
    file = PROGRAMS / f"{name}.py"
    body = ast.parse(file.read_text(encoding="utf-8")).body
    last = body.pop()
    assert isinstance(last, ast.Expr)
    names: dict[str, Any] = {"__name__": name}
    with contextlib.redirect_stdout(io.StringIO()):
        exec(compile(ast.Module(body, []), str(file), "exec"), names)
        plt.close("all")
        return eval(compile(ast.Expression(last.value), str(file), "eval"), names)


def picture(browser: Any, page: Path, time: float) -> Image.Image:
    """Return the drawing of a page of the viewer at a share of its time."""
    browser.resize(*WINDOW)
    browser.open(page)
    for hidden in ("header", "#panel", "#keys", "#plots", "footer", "#controls"):
        browser.value(
            f"document.querySelectorAll('{hidden}').forEach((found) => {{ found.style.display = 'none' }})"
        )
    browser.value("dispatchEvent(new Event('resize'))")
    if browser.value("document.querySelector('#play').textContent") == "Pause":
        browser.value("document.querySelector('#play').click()")
    browser.choose("#amplitude", LARGEST)
    browser.choose("#scrub", browser.value(f"String({time} * document.querySelector('#scrub').max)"))
    browser.value("document.querySelector('#fit').click()")
    browser.frame()
    return Image.fromarray(browser.picture().astype("uint8"))


def main(names: list[str]) -> None:
    """Draw the pictures."""
    sys.path.insert(0, str(ROOT / "tests"))
    browsers = import_module("browser")
    mpl.use("Agg")
    PICTURES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as place, browsers.start("chromium", Path(place)) as browser:
        for name in names or sorted(file.stem for file in PROGRAMS.glob("[a-z]*.py")):
            page = last_line(name).write(Path(place) / f"{name}.html")
            drawn = picture(browser, page, TIMES.get(name, TIME))
            drawn.resize(SIZE, Image.Resampling.LANCZOS).quantize(64).save(
                PICTURES / f"{name}.png", optimize=True
            )


if __name__ == "__main__":
    main(sys.argv[1:])
