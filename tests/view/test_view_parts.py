"""The viewer in a browser: many parts stay light, Fit fits, pointing shows values, the strip follows the time."""

import io
import re
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import Browser
from mechanisms import pendulum
from numpy.typing import NDArray

import flexel as fx
from flexel.apps.view.figures import COLOURS
from flexel.apps.view.page import Page, scene_data, write_page
from flexel.apps.view.page.data import part
from flexel.apps.view.primitives import Shape, rectangle

TIP = "(() => { const t = document.querySelector('#tip'); return t.hidden ? '' : t.textContent })()"
FRAMES = 61
DRAW_CALLS = 40  # at most, for 200 parts


def strut(load: float = 20.0) -> fx.System:
    """A mass on a spring and a slider in a guide, with a load, above a floor."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 1), fixed=True)
    m.point("A", (0.3, 0, 0.6))
    m.point("B", (0.8, 0, 0.6))
    m.fix("A.y", "B.y", "B.z")
    m.truss("strut", "O", "A")
    m.spring("strut.elongation", 2000.0, 20.0)
    m.truss("rod", "A", "B")
    for name in "AB":
        m.point_mass(f"mass {name}", name, 2.0)
    m.load("A.x", load)
    return m.build()


@pytest.fixture(scope="module")
def motion() -> fx.Motion:
    return strut().simulate(1.0, progress=False)


def moving(count: int) -> list[dict[str, Any]]:
    """Half beams that bend, a quarter bars that swing, a quarter points: their parts over the frames."""
    found = []
    x = np.linspace(0, 1, 17)
    k = np.arange(FRAMES)[:, None]
    for i in range(count):
        y = 0.1 * np.sin(3 * x + 0.3 * k + i) + 0.02 * i
        line = np.stack(np.broadcast_arrays(x, y, 0.1 * (i % 7)), axis=-1)
        if i % 4 < 2:
            values = {"bending moment": np.hstack([k + i, 2.0 * k])}
            found.append(part(Shape("beam", f"b{i}", (line,), outline=rectangle(0.02, 0.01), values=values)))
        elif i % 4 == 2:
            found.append(part(Shape("bar", f"r{i}", (line[:, [0, -1]],))))
        else:
            found.append(part(Shape("joint", f"p{i}", (line[:, -1:],))))
    return found


@pytest.mark.long
def test_two_hundred_parts_take_few_draw_calls(tmp_path: Path, fresh: Browser) -> None:
    """Counted by the renderer in every picture; the time of the script is printed, the median while it plays."""
    swing = pendulum().simulate(2.0, progress=False)
    scene = scene_data(swing, frames=FRAMES)
    scene["shapes"] += moving(200)
    scene["floor"] = {"axes": np.eye(3).tolist(), "height": -0.5}
    fresh.open(write_page(scene, tmp_path / "many.html"))
    calls, script = [], []
    for _ in range(25):
        time.sleep(0.05)
        calls.append(int(fresh.value("document.querySelector('#picture').dataset.calls")))
        script.append(float(fresh.value("document.querySelector('#picture').dataset.script")))
    print(f"draw calls {max(calls)}, script {np.median(script):.2f} ms a picture")
    assert 0 < max(calls) <= DRAW_CALLS
    fresh.choose("#colour", "bending moment")
    assert int(fresh.value("document.querySelector('#picture').dataset.calls")) <= DRAW_CALLS


def ink(picture: NDArray[np.int16]) -> NDArray[np.intp]:
    """Rows and columns of coloured pixels (k, 2)."""
    return np.argwhere(np.ptp(picture, axis=2) > 50)


@pytest.mark.parametrize("size", [(1200, 400), (900, 640), (390, 800)])
def test_fit_fills_windows_of_any_shape(tmp_path: Path, fresh: Browser, size: tuple[int, int]) -> None:
    """A swinging pendulum: nothing is cut, and it reaches almost from edge to edge one way."""
    path = pendulum().simulate(0.5, progress=False).view(tmp_path / "swing.html", plots=[])
    fresh.resize(*size)
    seen = []
    fresh.open(path, "#t=0")
    fresh.value("document.querySelector('#panel').open = false")
    for t in ("0", "0.2", "0.4", "0.6", "0.8", "1"):
        fresh.choose("#scrub", t)
        picture = fresh.picture()
        seen.append(ink(picture))
    places = np.vstack(seen)
    low, high, whole = places.min(axis=0), places.max(axis=0), np.array(picture.shape[:2])
    assert np.all(low > 0) and np.all(high < whole - 1)
    assert np.max((high - low) / whole) > 0.75


def test_pointing_shows_name_and_values(motion: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """The spring in the middle of the strut, with its tension at that time."""
    fresh.open(motion.view(tmp_path / "strut.html", view=fx.View(azimuth=-90, elevation=0)), "#t=0")
    box = fresh.box("#picture")
    found: set[str] = set()
    places = [(i / 25, j / 16) for i in range(1, 25) for j in range(1, 16)]
    for across, down in sorted(places, key=lambda place: abs(place[1] - 0.5)):  # the strut is in the middle
        fresh.point((box["x"] + box["width"] * across, box["y"] + box["height"] * down))
        found.add(fresh.value(TIP))
        if {"", "load on A\n20 N"} <= found and any(text.startswith("spring strut") for text in found):
            break
    tension = motion[0].force("strut.elongation")
    reported = [text for text in found if text.startswith("spring strut")]
    assert reported and f"tension {tension:.3g} N" in reported[0], found
    assert "load on A\n20 N" in found
    assert "" in found


def test_the_strip_shows_chosen_quantities_and_goes_to_a_time(
    motion: fx.Motion, tmp_path: Path, fresh: Browser
) -> None:
    """The value at the time stands beside the name; a click goes to its time; more are chosen by name."""
    fresh.open(motion.view(tmp_path / "strut.html", plots=["strut.elongation'"]), "#t=0.5")
    fresh.frame()
    key = "document.querySelector('#key').textContent"
    reported = float(fresh.value(key).removeprefix("strut.elongation' ").removesuffix(" m/s"))
    assert reported == pytest.approx(motion.at(0.5).rate("strut.elongation"), rel=6e-3, abs=1e-4)
    box = fresh.box("#strip")
    left, right = box["x"] + 58, box["x"] + box["width"] - 8
    fresh.drag((left + 0.2 * (right - left), box["y"] + 20), (left + 0.25 * (right - left), box["y"] + 20))
    shown = float(fresh.value("document.querySelector('#time').textContent.split(' ')[0]"))
    assert shown == pytest.approx(0.25, abs=0.006)
    fresh.value(
        "[...document.querySelectorAll('#quantities label')].find(label => label.textContent === 'B.x').click()"
    )
    fresh.frame()
    assert "B.x 0." in fresh.value(key)


@pytest.mark.long
def test_the_strip_has_the_style_of_the_figures(motion: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """Lines in the colours of figures, each on axes with quantity and unit."""
    names = ["A.x", "B.x", "rod.elongation'"]
    plots = scene_data(motion, frames=41, plots=names)["plots"]
    assert [row["label"] for row in plots["rows"][:3]] == ["A.x [m]", "B.x [m]", "rod.elongation' [m/s]"]
    assert [row["shared"] for row in plots["rows"][:3]] == [
        "displacement [m]",
        "displacement [m]",
        "velocity [m/s]",
    ]
    fresh.open(motion.view(tmp_path / "strut.html", plots=names), "#t=0.5")
    shown = fresh.picture("#strip")
    for colour in COLOURS[:3]:
        rgb = [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
        assert np.sum(np.abs(shown - rgb).sum(axis=2) < 30) > 100, colour


@pytest.mark.long
def test_the_floor_has_lines_both_ways(motion: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """Also those that begin behind the eye: they cross each row of pixels near the lower edge."""
    view = fx.View(azimuth=-90, elevation=25)
    fresh.open(motion.view(tmp_path / "strut.html", view=view, plots=[]), "#t=0")
    lowest = fresh.picture().max(axis=2)[-60:]
    dark = lowest < np.median(lowest) - 8
    crossings = np.sum(dark[:, 1:] & ~dark[:, :-1], axis=1)
    assert np.median(crossings) > 3


def test_noise_has_one_colour_and_outliers_do_not_hide_the_rest(tmp_path: Path, fresh: Browser) -> None:
    """Of 200 bars one has 1000 times the tension; the robust scale ends at that of the others."""
    scene = scene_data(pendulum().simulate(0.1, progress=False), frames=2)
    for i in range(200):
        line = np.array([(0, 0.01 * i, 0), (1, 0.01 * i, 0)])
        values = {"tension": np.array([1e6 if i == 7 else 1e3 + i]), "strain": np.array([1e-15 * i])}
        scene["shapes"].append(part(Shape("bar", f"r{i}", (line,), values=values)))
    scene["floors"] = {"tension": 1e-3, "strain": 1e-12}
    fresh.open(write_page(scene, tmp_path / "bars.html"), "#t=0")
    high = "document.querySelector('#high').textContent"
    fresh.choose("#colour", "tension")
    assert 1100 < float(fresh.value(high)) < 1250
    fresh.choose("#scale", "run")
    fresh.frame()
    assert float(fresh.value(high)) == 1e6
    fresh.choose("#colour", "strain")
    assert fresh.value(high) == "everywhere"
    assert fresh.value("document.querySelector('#low').textContent") == "0"


def test_a_notebook_that_is_not_trusted_says_so(motion: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """JupyterLab then takes the page out of its frame; what is in view is the text behind it."""
    Image = pytest.importorskip("PIL.Image", reason="pip install 'flexel[plot]'")
    shown = motion.page(frames=5)._repr_html_()
    emptied = re.sub(r' srcdoc="[^"]*"', "", shown)
    path = tmp_path / "notebook.html"
    path.write_text(f"<!DOCTYPE html><html><body>{emptied}</body></html>")
    fresh.go(path.as_uri())
    assert "trust the notebook" in fresh.value("document.body.innerText")
    ink = fresh.screenshot(fresh.box("p"))
    path.write_text(f"<!DOCTYPE html><html><body>{shown}</body></html>")
    fresh.go(path.as_uri())
    fresh.wait(
        "document.querySelector('iframe')?.contentDocument?.querySelector('#picture')?.dataset.frame !== undefined"
    )
    covered = fresh.screenshot(fresh.box("p"))
    words, page = (np.asarray(Image.open(io.BytesIO(png)).convert("L"), dtype=int) for png in (ink, covered))
    assert np.sum(words < 90) > 200  # they are seen where the frame is empty
    assert np.mean(np.abs(words - page) > 60) > 0.01  # and covered by the page


def test_a_notebook_shows_the_page_in_a_frame(motion: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """The result of a cell is a frame that can be resized; what is in it draws the motion, without other files."""
    shown = motion.page(frames=5, title='A "strut" & <more>')._repr_html_()
    path = tmp_path / "notebook.html"
    path.write_text(f"<!DOCTYPE html><html><body>{shown}</body></html>")
    fresh.go(path.as_uri())
    inner = "document.querySelector('iframe')?.contentDocument?.querySelector('#picture')"
    fresh.wait(f"{inner}?.dataset.frame !== undefined")
    assert fresh.value("document.querySelector('iframe').title") == 'A "strut" & <more>'
    assert fresh.value(f"{inner}.clientHeight") > 100
    assert fresh.value("getComputedStyle(document.querySelector('iframe').parentElement).resize") == "both"
    assert "srcdoc" in motion._repr_html_()
    with pytest.raises(fx.ModelError, match="Page: height"):
        Page({}, height=0)
