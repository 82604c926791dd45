"""The viewer: its data are the motion's; in a real browser the page shows it, plays it, heeds keys and fingers."""

import base64
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import MISSING, PROGRAM, Browser
from numpy.typing import NDArray

import flexel as fx
from flexel.examples.bicycle import bicycle, kick
from flexel.orientation import matrix
from flexel.plot import Sketch, View
from flexel.view import mode_data, page, scene_data, view_modes, view_motion, write_page

in_browser = pytest.mark.skipif(PROGRAM is None, reason=MISSING)
BAR = (11, 95, 165)  # colours of parts, see flexel.scene.PAINT
BEAM = (46, 133, 64)


def pendulum() -> fx.System:
    """A planar rod of 1 m, let go from 60 degrees below the horizontal."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (0.5, -np.sqrt(0.75)))
    m.angle("ground", fixed=True)
    m.angle("turn")
    m.hinge("pivot", "ground", "turn")
    m.beam("rod", "O", "turn", "A", mass_per_length=1.0)
    return m.build()


def cantilever() -> fx.System:
    """A steel strip clamped at one end."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0.1, 0, 0))
    m.frame("wall", fixed=True)
    m.frame("tip")
    strip = fx.Rectangle(0.5e-3, 10e-3)
    m.beam("leaf", "O", "wall", "A", "tip", direction=(0, 1, 0), section=strip, material="steel")
    return m.build()


@pytest.fixture(scope="module")
def ride() -> fx.Motion:
    return kick(bicycle(), 4.5, 1.0, rtol=1e-8)


@pytest.fixture(scope="module")
def swing() -> fx.Motion:
    return pendulum().simulate(2.0, progress=False)


def unpacked(text: str, width: int) -> NDArray[np.float32]:
    """Numbers (frames, width) of a scene."""
    return np.frombuffer(base64.b64decode(text), dtype="<f4").reshape(-1, width)


def parts(scene: dict[str, Any], style: str, name: str | None = None) -> list[dict[str, Any]]:
    return [z for z in scene["shapes"] if z["style"] == style and name in (None, z["name"])]


# -- the data -------------------------------------------------------------------------------------


def test_the_scene_is_plain_json_with_the_states_of_the_motion(ride: fx.Motion) -> None:
    """Points are where the motion has them, and the pose of a wheel turns its rim to where the hub and road are."""
    scene = json.loads(json.dumps(scene_data(ride, frames=11), allow_nan=False))
    assert np.allclose(scene["times"], np.linspace(0, 1, 11), atol=1e-9)
    hub = unpacked(parts(scene, "joint", "rear hub")[0]["data"], 3)
    expected = np.array([ride.at(t).position("rear hub") for t in np.linspace(0, 1, 11)])
    assert np.allclose(hub, expected, rtol=1e-6, atol=1e-7)
    rim = parts(scene, "rim", "rear")[0]
    local, poses = unpacked(rim["local"], 3), unpacked(rim["data"], 7)
    for pose, centre in zip(poses, expected, strict=True):
        ring = pose[:3] + local @ matrix(pose[3:].astype(float)).T
        assert np.allclose(np.linalg.norm(ring - centre, axis=1), 0.3, atol=1e-6)
        assert abs(ring[:, 2].max()) < 0.3 * (1 - np.cos(np.pi / 48))  # z points down, the road is z = 0


def test_what_never_moves_is_stored_once(swing: fx.Motion) -> None:
    """A fixed point has one frame, a moving one all of them."""
    scene = scene_data(swing, frames=50)
    assert len(unpacked(parts(scene, "fixed")[0]["data"], 3)) == 1
    assert len(unpacked(parts(scene, "joint")[0]["data"], 3)) == 50


def test_the_arrows_of_the_road_carry_the_bicycle() -> None:
    """At rest upright the forces of the road on both wheels add up to the weight, straight up."""
    system = bicycle()
    state = system.initial
    mass = sum(float(z.parameters["mass"][0]) for z in system.structure.instances if "mass" in z.parameters)
    motion = system.simulate(0.01, start=state, times=[0.0, 0.01], progress=False)
    forces = [unpacked(z["force"], 3)[0] for z in parts(scene_data(motion, frames=2), "force")]
    assert len(forces) == 2
    assert np.allclose(np.sum(forces, axis=0), (0, 0, -9.81 * mass), atol=1e-3)
    assert all(force[2] < 0 for force in forces)


def test_tension_and_strain_of_two_bars_that_carry_a_load() -> None:
    """Two bars at 45 degrees carry P with N = P / sqrt(2) each, and the strain N / (k l)."""
    m = fx.Model(gravity=(0, -9.81))
    for name, x in (("left", -1.0), ("right", 1.0)):
        m.point(name, (x, 1.0), fixed=True)
    m.point("A", (0, 0))
    for name in ("left", "right"):
        m.truss(f"{name} bar", name, "A", stiffness=1e9)
    m.point_mass("load", "A", 5.0)
    system = m.build()
    state = system.equilibrium()
    scene = mode_data(state, system.vibrations(state))
    N = 5.0 * 9.81 / np.sqrt(2)
    for bar in parts(scene, "bar"):
        assert unpacked(bar["values"]["tension"]["data"], 1)[0, 0] == pytest.approx(N, rel=1e-6)
        assert unpacked(bar["values"]["strain"]["data"], 1)[0, 0] == pytest.approx(
            N / 1e9 / np.sqrt(2), rel=1e-6
        )


def test_modes_are_the_linear_displacements() -> None:
    """The tip of the first mode of a cantilever moves across by 1, no vertex along or sideways."""
    system = cantilever()
    state = system.equilibrium()
    scene = mode_data(state, system.vibrations(state, 2))
    assert [z["text"].endswith("Hz") for z in scene["modes"]] == [True, True]
    leaf = parts(scene, "beam", "leaf")[0]
    first = unpacked(leaf["modes"], 3 * 17)[0].reshape(17, 3)
    assert np.abs(first[-1]).max() == pytest.approx(abs(first[-1, 1]))
    assert abs(first[-1, 1]) == pytest.approx(1.0, rel=1e-6)
    assert np.abs(first[:, [0, 2]]).max() < 1e-6
    modes = system.linearize(state).modes()
    lin = mode_data(system.linearize(state))
    assert len(lin["modes"]) == min(12, len(modes))
    slowest = unpacked(parts(lin, "beam", "leaf")[0]["modes"], 3 * 17)[0].reshape(17, 3)
    assert np.allclose(np.abs(slowest / slowest[-1, 1]), np.abs(first / first[-1, 1]), atol=1e-4)


def test_the_page_is_small_alone_and_executes_nothing_of_the_data(ride: fx.Motion) -> None:
    """Under a megabyte without the data, no address to fetch from, and text that would end the script does not."""
    scene = scene_data(ride, frames=2, title="</script><script>stop()</script>", caption="<b>$three</b>")
    text = page(scene)
    data = json.dumps(scene, separators=(",", ":"))
    assert len(text.encode()) - len(data) < 800_000
    assert text.count("</script>") == 3
    assert "<title>&lt;/script&gt;" in text
    own = text.replace(text[text.index('id="three"') : text.index('<script type="module">')], "")
    assert not re.search(r"https?://|src=|href=", own)


def test_mistakes_are_told(ride: fx.Motion, tmp_path: Path) -> None:
    """Each names the remedy."""
    with pytest.raises(fx.ModelError, match="ends in .html"):
        view_motion(ride, tmp_path / "ride.txt", frames=2)
    with pytest.raises(fx.ModelError, match="frames is 1; give a whole number, 2 or more"):
        scene_data(ride, frames=1)
    with pytest.raises(fx.ModelError, match="unknown node 'haed'; did you mean head"):
        scene_data(ride, view=View(centre="haed"))
    with pytest.raises(fx.ModelError, match="no states from 0.0015"):
        still = cantilever()
        scene_data(still.simulate_stiff(1e-3, progress=False), between=(0.0015, 0.002))
    with pytest.raises(fx.ModelError, match="save the motion again"):
        write_page({"format": 0}, tmp_path / "old.html")
    with pytest.raises(fx.ModelError, match="there are none"):
        mode_data(ride[0], [])
    with pytest.raises(fx.ModelError, match="give the linearization, not the state"):
        system = pendulum()
        mode_data(system.initial, system.linearize().modes())


# -- in a browser ---------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    with Browser(tmp_path_factory.mktemp("browser") / "profile") as found:
        yield found


@pytest.fixture
def fresh(browser: Browser) -> Iterator[Browser]:
    """The browser without old complaints; at the end there must be no new ones, and nothing asked of a network."""
    browser.complaints.clear()
    browser.requests.clear()
    browser.resize(900, 640)
    yield browser
    assert browser.complaints == []
    assert {z.partition(":")[0] for z in browser.requests} <= {"file", "blob", "about"}


def where(picture: NDArray[np.int16], colour: tuple[int, int, int], far: float = 60.0) -> NDArray[np.float64]:
    """Places (k, 2), right and up, of the pixels whose hue is that of a part, whatever the light."""
    p = picture.astype(float)
    strength = p.max(axis=2)
    scaled = p * (max(colour) / np.maximum(strength, 1.0))[:, :, None]
    found = np.argwhere((np.abs(scaled - colour).sum(axis=2) < far) & (np.ptp(p, axis=2) > 40))
    return np.column_stack([found[:, 1], -found[:, 0]]).astype(float)


@in_browser
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


@in_browser
def test_playing_advances_and_space_pauses(swing: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """It plays when opened, at the speed of the clock; space stops it and starts it, the picture changes with it."""
    fresh.open(swing.view(tmp_path / "swing.html"))
    time = "parseFloat(document.querySelector('#time').textContent)"
    start = fresh.value(f"[performance.now(), {time}]")
    fresh.wait(f"{time} > 0.5")
    stop = fresh.value(f"[performance.now(), {time}]")
    assert 0 < stop[1] - start[1] < 1.1 * (stop[0] - start[0]) / 1000 + 0.1
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


@in_browser
def test_every_control_is_reached_by_tab_and_has_a_name(
    ride: fx.Motion, tmp_path: Path, fresh: Browser
) -> None:
    """Tab goes through all that can be used, each with a role and a name for a screen reader."""
    fresh.open(ride.view(tmp_path / "ride.html", frames=11, title="Ride"), "#t=0")
    count = fresh.value("document.querySelectorAll('button, input, select, summary, canvas').length")
    seen = set()
    for _ in range(2 * count):
        fresh.press("Tab")
        seen.add(
            fresh.value(
                "(() => { const z = document.activeElement; return z.id || z.parentElement.textContent })()"
            )
        )
    hidden = {"mode", "amplitude", "colour"}  # a motion of rigid parts only
    assert {"picture", "play", "scrub", "speed", "follow", "trace", "fit", "top", "road"} <= seen
    assert not hidden & seen
    for node in fresh.call("Accessibility.getFullAXTree")["nodes"]:
        can = {z["name"]: z["value"].get("value") for z in node.get("properties", [])}
        if can.get("focusable") and not node["ignored"]:
            assert node["name"]["value"].strip(), node


@in_browser
def test_the_scrubber_follow_trace_and_colour(ride: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """Scrubbing goes to its time; a followed node stays in the middle; a trace and colours are to be seen."""
    sketch = Sketch("rear hub", "rear frame", [(0, 0, -0.3), (0.3, 0, -0.9)])
    fresh.open(ride.view(tmp_path / "ride.html", view=View(sketches=[sketch])), "#t=0")
    fresh.choose("#scrub", "0.5")
    assert fresh.value("document.querySelector('#time').textContent") == "0.50 s"
    for box in ("road", "forces", "outlines"):
        fresh.value(
            f"[...document.querySelectorAll('#show label')].find(z => z.textContent === '{box}').click()"
        )
    fresh.choose("#follow", "head")
    fresh.press("Home")
    before = where(fresh.picture(), BAR).mean(axis=0)
    fresh.press("End")
    assert np.allclose(where(fresh.picture(), BAR).mean(axis=0), before, atol=12)  # 4.5 m farther
    fresh.choose("#follow", "")
    without = len(where(fresh.picture(), BEAM))
    fresh.choose("#trace", "rear contact")
    assert len(where(fresh.picture(), BEAM)) > without + 20


@in_browser
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
            state, tmp_path / "arm.html", system.vibrations(state, 1), view=View(azimuth=-90, elevation=0)
        )
    )
    fresh.click("#play")
    fresh.choose("#amplitude", "0")
    fresh.choose("#colour", "bending moment")
    assert fresh.value("document.querySelector('#high').textContent") == "10 N m"
    shown = fresh.picture()
    left, right = where(shown, (253, 231, 37), 45), where(shown, (68, 1, 84), 45)
    assert len(left) > 50 and len(right) > 50
    assert left[:, 0].max() < right[:, 0].min()


@in_browser
def test_the_amplitude_slider_scales_a_mode(tmp_path: Path, fresh: Browser) -> None:
    """At the largest displacement of the first bending mode the strip's tip is as far off as the slider says."""
    system = cantilever()
    state = system.equilibrium()
    view = View(azimuth=-90, elevation=90)
    fresh.open(view_modes(state, tmp_path / "modes.html", system.vibrations(state, 2), view=view))
    assert fresh.value("document.querySelectorAll('#mode option').length") == 2
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


@in_browser
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


@in_browser
def test_on_a_phone(ride: fx.Motion, tmp_path: Path, fresh: Browser) -> None:
    """Nothing is wider than the screen, what is to be touched is large enough, and two fingers zoom."""
    fresh.resize(360, 640, phone=True)
    fresh.open(ride.view(tmp_path / "ride.html", frames=11, title="Ride", view=View(centre="head")), "#t=0")
    assert fresh.value("document.scrollingElement.scrollWidth") == 360
    assert fresh.value("document.querySelector('#panel').open") is False
    for name in ("#play", "#scrub", "#speed"):
        box = fresh.value(f"document.querySelector('{name}').getBoundingClientRect().toJSON()")
        assert box["height"] >= 40 and box["right"] <= 360 and box["bottom"] <= 640, name
    before = np.ptp(where(fresh.picture(), BAR)[:, 0])
    x, y = fresh.middle("canvas")
    fingers = [[(x - d, y), (x + d, y)] for d in (40.0, 60.0, 80.0)]
    fresh.touch(*fingers)
    assert np.ptp(where(fresh.picture(), BAR)[:, 0]) > 1.5 * before


@in_browser
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
