"""The viewer in real browsers, Chromium and Firefox: it shows the motion, plays it, responds to keys and touch."""

import json
from pathlib import Path

import numpy as np
import pytest
from browser import Browser
from mechanisms import cantilever, pendulum, pendulum_model
from numpy.typing import NDArray

import flexel as fx
from flexel.apps.view.page import page, scene_data, view_modes
from flexel.apps.view.plot import Sketch
from flexel.examples.bicycle import bicycle, kick

BAR = (11, 95, 165)  # colours of parts, see flexel.apps.view.scene.PAINT
BEAM = (46, 133, 64)


@pytest.fixture(scope="module")
def ride() -> fx.Motion:
    return kick(bicycle(), 4.5, 1.0, rtol=1e-8)


@pytest.fixture(scope="module")
def swing() -> fx.Motion:
    return pendulum().simulate(2.0, progress=False)


def where(picture: NDArray[np.int16], colour: tuple[int, int, int], far: float = 60.0) -> NDArray[np.float64]:
    """Places (k, 2), right and up, of the pixels whose hue is that of a part, whatever the light."""
    p = picture.astype(float)
    strength = p.max(axis=2)
    scaled = p * (max(colour) / np.maximum(strength, 1.0))[:, :, None]
    found = np.argwhere((np.abs(scaled - colour).sum(axis=2) < far) & (np.ptp(p, axis=2) > 40))
    return np.column_stack([found[:, 1], -found[:, 0]]).astype(float)


def tick(browser: Browser, where: str, name: str) -> None:
    """Click a box of a list."""
    browser.value(
        f"[...document.querySelectorAll('#{where} label')]"
        f".find(label => label.textContent === {json.dumps(name)}).click()"
    )
    browser.frame()


def test_a_rod_is_seen_as_thick_and_as_opaque_as_said(tmp_path: Path, fresh: Browser) -> None:
    """A thin red rod, a thick one, a see-through one that is paler, and one that is hidden."""
    thick, counts, paleness = {"section": fx.Circle(0.2)}, [], []
    for look in ({}, thick, thick | {"opacity": 0.4}, {"hidden": True}):
        m = pendulum_model()
        m.look("rod", colour="#cc1a1a", **look)  # type: ignore[arg-type]
        fresh.open(m.build().simulate(0.5, samples=3, progress=False).view(tmp_path / "rod.html"), "#t=0")
        picture = fresh.picture()
        found = (picture[:, :, 0] - picture[:, :, 1:].max(axis=2)) > 60
        counts.append(int(found.sum()))
        paleness.append(float(picture[found].min(axis=1).mean()) if found.any() else 0.0)
    assert counts[0] > 300 and min(counts[1:3]) > 5 * counts[0] and counts[3] == 0
    assert paleness[2] > paleness[1] + 40


@pytest.mark.parametrize("t", [0.0, 0.6, 1.3])
def test_the_rod_is_seen_at_its_angle(swing: fx.Motion, tmp_path: Path, fresh: Browser, t: float) -> None:
    """The pixels of a pendulum's rod lie on a line at the angle that the motion has."""
    path = swing.view(tmp_path / "swing.html", frames=201)
    fresh.open(path, f"#t={t}")
    places = where(fresh.picture(), BAR)
    assert len(places) > 300
    middle = places.mean(axis=0)
    along = np.linalg.svd(places - middle, full_matrices=False)[2][0]
    x, y = swing.at(t).position("A")
    assert abs(along @ np.array([x, y])) == pytest.approx(1.0, abs=1e-4)


# the browser's clock and the time shown, in eight frames one after another
FRAMES = """new Promise((done) => {
  const found = [];
  requestAnimationFrame(function look(stamp) {
    found.push([stamp, %s]);
    if (found.length < 8) requestAnimationFrame(look); else done(found);
  });
})"""


def test_playing_advances_and_space_pauses(swing: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """It plays when opened, at the speed of the clock; space stops it and starts it, the picture changes with it."""
    fresh.open(swing.view(tmp_path / "swing.html"))
    time = "parseFloat(document.querySelector('#time').textContent)"
    stamps, shown = np.array(fresh.value(FRAMES % time)).T
    steps = np.minimum(np.diff(stamps) / 1000, 0.1)  # a browser that was away for longer does not jump
    assert shown[-1] > shown[0]
    assert np.diff(shown) == pytest.approx(steps, abs=0.0101)  # two roundings to 0.01 s
    fresh.wait(f"{time} > 0.5")
    fresh.press(" ")
    assert fresh.value("document.querySelector('#play').textContent") == "Play"
    first, held = fresh.picture(), fresh.value(time)
    assert np.array_equal(first, fresh.picture())
    fresh.press("ArrowRight")
    assert fresh.value(time) == pytest.approx(held + 0.01, abs=0.0101)
    fresh.press("End")
    assert fresh.value(time) == 2.0
    assert np.abs(fresh.picture() - first).max() > 100
    fresh.press(" ")
    assert fresh.value("document.querySelector('#play').textContent") == "Pause"


def test_every_control_is_reached_by_tab_and_has_a_name(
    ride: fx.Motion, tmp_path: Path, fresh: Browser
) -> None:
    """Tab goes through all that can be used, each with a role and a name for a screen reader."""
    fresh.open(ride.view(tmp_path / "ride.html", frames=11, title="Ride"), "#t=0")
    count = fresh.value("document.querySelectorAll('button, input, select, summary, canvas').length")
    seen = set()
    for _ in range(count + 5):
        fresh.press("Tab")
        seen.add(
            fresh.value(
                "(() => { const element = document.activeElement; "
                "const own = element.tagName === 'SUMMARY' ? element : element.parentElement; "
                "return element.id || own.textContent })()"
            )
        )
    hidden = {"mode", "amplitude", "colour"}  # a motion of rigid parts only
    assert {"picture", "play", "scrub", "speed", "follow", "arrowsize", "fit", "top", "road", "Trace"} <= seen
    assert not hidden & seen
    assert fresh.nameless() == []
    fresh.value("document.body.append(document.createElement('button'))")
    assert len(fresh.nameless()) == 1


@pytest.mark.long
def test_the_scrubber_follow_trace_and_colour(ride: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """Scrubbing goes to its time; a followed node stays in the middle; a trace and colours are visible."""
    sketch = Sketch("rear hub", "rear frame", [(0, 0, -0.3), (0.3, 0, -0.9)])
    fresh.open(ride.view(tmp_path / "ride.html", view=fx.View(sketches=[sketch])), "#t=0")
    fresh.choose("#scrub", "0.5")
    assert fresh.value("document.querySelector('#time').textContent") == "0.50 s"
    for box in ("road", "forces", "outlines"):
        tick(fresh, "show", box)
    fresh.choose("#follow", "head")
    fresh.press("Home")
    before = where(fresh.picture(), BAR).mean(axis=0)
    fresh.press("End")
    assert np.allclose(where(fresh.picture(), BAR).mean(axis=0), before, atol=12)  # 4.5 m farther
    fresh.choose("#follow", "")
    without = len(where(fresh.picture(), BEAM))
    tick(fresh, "trace", "rear contact")
    assert len(where(fresh.picture(), BEAM)) > without + 20


def test_colour_by_bending_moment(tmp_path: Path, fresh: Browser) -> None:
    """A cantilever with a transverse load: bright at the clamp, dark at the tip, and the legend tells the range."""
    m = fx.Model()
    for name, x in (("O", 0.0), ("A", 1.0)):
        m.point(name, (x, 0, 0), fixed=x == 0)
        m.frame(f"R{name}", fixed=x == 0)
    m.beam(
        "arm", "O", "RO", "A", "RA", direction=(0, 1, 0), section=fx.Rectangle(0.05, 0.05), material="steel"
    )
    m.load("A.z", -10.0)
    system = m.build()
    state = system.equilibrium()
    fresh.open(
        view_modes(
            state,
            tmp_path / "arm.html",
            system.vibrations(state, count=1),
            view=fx.View(azimuth=-90, elevation=0),
        )
    )
    fresh.click("#play")
    fresh.choose("#amplitude", "0")
    fresh.choose("#colour", "bending moment")
    assert fresh.value("document.querySelector('#what').textContent") == "bending moment [N m]"
    assert fresh.value("document.querySelector('#high').textContent") == "10"
    shown = fresh.picture()
    left, right = where(shown, (253, 231, 37), 45), where(shown, (68, 1, 84), 45)
    assert len(left) > 50 and len(right) > 50
    assert left[:, 0].max() < right[:, 0].min()


def test_the_amplitude_slider_scales_a_mode(tmp_path: Path, fresh: Browser) -> None:
    """At the largest displacement of the first bending mode the strip's tip is as far off as the slider says."""
    system = cantilever()
    state = system.equilibrium()
    view = fx.View(azimuth=-90, elevation=90)
    fresh.open(view_modes(state, tmp_path / "modes.html", system.vibrations(state, count=2), view=view))
    assert fresh.value("document.querySelectorAll('#mode option').length") == 2
    assert fresh.value("document.querySelector('#colour').value") == "normal stress of the mode"
    fresh.choose("#colour", "")
    fresh.choose("#scrub", "0")  # the phase at which it is farthest
    heights = []
    for amplitude in ("0", "0.1", "0.2"):
        fresh.choose("#amplitude", amplitude)
        places = where(fresh.picture(), BEAM)
        right = places[:, 0] > places[:, 0].max() - 3
        heights.append(places[right, 1].mean())
    first, second = heights[1] - heights[0], heights[2] - heights[0]
    assert abs(first) > 10
    assert second / first == pytest.approx(2.0, rel=0.1)


def test_dragging_turns_and_wheel_zooms(swing: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """Seen from the side after a quarter turn by keys or mouse, a planar mechanism has no width; keys zoom."""
    fresh.open(swing.view(tmp_path / "swing.html"), "#t=0")
    x, y = fresh.middle("canvas")
    wide = np.ptp(where(fresh.picture(), BAR)[:, 0])
    height = fresh.value("document.querySelector('canvas').clientHeight")
    fresh.drag((x, y), (x + np.pi / 2 / 4 * height, y))
    assert np.ptp(where(fresh.picture(), BAR)[:, 0]) < 0.15 * wide
    fresh.click("#side")
    fresh.value("document.querySelector('canvas').focus()")
    tall = np.ptp(where(fresh.picture(), BAR)[:, 1])
    for _ in range(2):
        fresh.press("-")
    assert np.ptp(where(fresh.picture(), BAR)[:, 1]) == pytest.approx(0.81 * tall, rel=0.03)
    fresh.press("ArrowRight")
    assert np.ptp(where(fresh.picture(), BAR)[:, 0]) < np.ptp(where(fresh.picture(), BAR)[:, 1])
    fresh.click("#fit")
    assert np.ptp(where(fresh.picture(), BAR)[:, 0]) == pytest.approx(wide, abs=2)


def test_on_a_phone(ride: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """Nothing is wider than the screen, what is to be touched is large enough, and two fingers zoom."""
    fresh.resize(360, 640, phone=True)
    fresh.open(
        ride.view(tmp_path / "ride.html", frames=11, title="Ride", view=fx.View(centre="head")), "#t=0"
    )
    assert fresh.value("document.scrollingElement.scrollWidth") == 360
    assert fresh.value("document.querySelector('#panel').open") is False
    for name in ("#play", "#scrub", "#speed"):
        box = fresh.box(name)
        assert box["height"] >= 40 and box["right"] <= 360 and box["bottom"] <= 640, name
    before = np.ptp(where(fresh.picture(), BAR)[:, 0])
    x, y = fresh.middle("canvas")
    fingers = [[(x - d, y), (x + d, y)] for d in (40.0, 60.0, 80.0)]
    fresh.touch(*fingers)
    assert np.ptp(where(fresh.picture(), BAR)[:, 0]) > 1.5 * before


def test_what_goes_wrong_is_written_on_the_page(tmp_path: Path, browser: Browser) -> None:
    """A page that was cut says so instead of staying white."""
    text = pendulum_page()
    path = tmp_path / "cut.html"
    path.write_text(text.replace('"counts":[2]', '"counts":null'))
    browser.open(path)
    assert "stopped" in browser.value("document.querySelector('[role=alert]').textContent")
    browser.complaints.clear()


def pendulum_page() -> str:
    return page(scene_data(pendulum().simulate(0.1, progress=False), frames=2))
