"""What a page shows when it opens: colours, quantities, what is left out until it is asked for; on both backgrounds."""

import inspect
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import Browser
from mechanisms import cantilever, pendulum
from moving import flexible_arm
from rides import ride
from test_view_frames import hoisted

import flexel as fx
from flexel.apps.view.page import mode_data, scene_data
from flexel.apps.view.page.data import MECHANISM
from flexel.results.linearization import Linearization


def loaded() -> fx.Motion:
    """A row of two leaf springs, bent by a force in its middle that grows."""
    m = fx.Model()
    for i in range(3):
        m.point(f"P{i}", (0.05 * i, 0, 0), fixed=i == 0)
        m.frame(f"R{i}", fixed=i == 0)
    strip = fx.Rectangle(0.5e-3, 10e-3)
    for i in range(2):
        ends = (f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}")
        m.beam(f"leaf{i}", *ends, direction=(0, 1, 0), section=strip, material="steel")
    m.load("P2.y", fx.Ramp(0, 1, 0, 0.1))
    s = m.build()
    return s.static_path(s.equilibrium(), t_end=1.0)


COLOURS = {"": pendulum, "bending moment": flexible_arm, "normal stress": loaded, "tension": hoisted}


@pytest.mark.parametrize("value", COLOURS)
def test_flexible_parts_are_coloured_by_what_they_carry(value: str) -> None:
    made: Any = COLOURS[value]()
    made = made.build() if isinstance(made, fx.Model) else made
    motion = made if isinstance(made, fx.Motion) else made.simulate(0.1, progress=False)
    assert scene_data(motion, frames=2)["colour"] == value


def test_modes_are_coloured_by_their_stress() -> None:
    system = cantilever()
    assert mode_data(system.linearize(system.equilibrium()))["colour"] == "normal stress of the mode"


def aside(scene: dict[str, Any]) -> set[tuple[str, str]]:
    return {(shape["style"], shape["name"]) for shape in scene["shapes"] if shape.get("aside")}


def test_points_within_lines_and_boxes_of_bodies_with_a_shape_are_left_out() -> None:
    """Of a rope all points but its ends, of a row of beams its middle; a body with several points needs no box."""
    rope = aside(scene_data(hoisted(), frames=2))
    assert len(rope) == 19 and {style for style, _ in rope} == {"joint"}
    assert aside(scene_data(loaded(), frames=2)) == {("joint", "P1")}
    assert {style for style, _ in aside(scene_data(ride(0.1, 2, progress=False), frames=2))} == {"box"}
    alone = scene_data(flexible_arm().build().simulate(0.1, progress=False), frames=2)
    assert any(shape["style"] == "box" for shape in alone["shapes"]) and not aside(alone)


PLOTS: dict[str, tuple[Callable[[], fx.Motion], list[str]]] = {
    "deformations of a beam are none": (
        lambda: flexible_arm().build().simulate(0.5, progress=False),
        ["pivot.angle", "A.x", "A.y"],
    ),
    "strains of a rope are none": (hoisted, ["sheave axle.angle", "load.y"]),
    "angles of joints": (
        lambda: ride(0.5, 5, progress=False),
        ["lean.angle", "steer.angle", "rear spin.angle"],
    ),
    "the end that a load bends": (loaded, ["P2.x", "P2.y"]),
}


@pytest.mark.parametrize("kind", PLOTS)
def test_the_plot_begins_with_what_a_person_can_see(kind: str) -> None:
    make, names = PLOTS[kind]
    plots = scene_data(make(), frames=5)["plots"]
    assert plots["shown"] == names
    assert [row["name"] for row in plots["rows"][: len(names)]] == names
    assert not any("lambda" in row["name"] for row in plots["rows"])


def test_load_steps_have_no_seconds(tmp_path: Path, fresh: Browser) -> None:
    """The title, the time beside the slider and the plots tell the load parameter, also of a motion from a file."""
    for motion in (loaded(), fx.load(loaded().save(tmp_path / "path.npz"))):
        scene = scene_data(motion)
        assert not motion.over_time and scene["title"] == "Load parameter from 0 to 1"
        assert motion.plot("P2.y").axes[0].get_xlabel() == "load parameter"
    fresh.open(loaded().view(tmp_path / "path.html"), "#t=0.5")
    assert fresh.value("document.querySelector('#time').textContent") == "0.50"
    assert "over load parameter" in fresh.value("document.querySelector('#strip').getAttribute('aria-label')")
    swing = pendulum().simulate(1.0, progress=False)
    assert swing.over_time and scene_data(swing, frames=2)["title"] == "Motion from 0 to 1 s"


def test_the_middle_of_a_mechanism_that_goes_far_is_followed(tmp_path: Path, fresh: Browser) -> None:
    """A bicycle stays in the middle of the picture, as large at the end as at the start."""
    scene = scene_data(ride(5.0, 60, progress=False))
    assert scene["camera"]["follow"] == MECHANISM
    ends = []
    for part in ("#t=0", "#t=5"):
        fresh.open(ride(5.0, 60, progress=False).view(tmp_path / "ride.html"), part)
        assert fresh.value("document.querySelector('#follow').value") == MECHANISM
        shown = fresh.picture()
        dark = np.argwhere(np.max(shown, axis=2) < 60)
        ends.append((dark.mean(axis=0) / shown.shape[:2], np.ptp(dark[:, 1]) / shown.shape[1]))
    for middle, width in ends:
        assert np.all(np.abs(middle - 0.5) < 0.2) and width > 0.4
    assert ends[0][1] == pytest.approx(ends[1][1], rel=0.15)


def test_what_stays_behind_does_not_make_what_is_followed_small(tmp_path: Path, fresh: Browser) -> None:
    """A bar that flies 100 m away from a fixed point."""
    m = fx.Model()
    m.point("start", (0, 0), fixed=True)
    for name, x in (("tail", 0.0), ("nose", 1.0)):
        m.point(name, (x, 0))
        m.point_mass(f"{name} mass", name, 1.0)
    m.truss("bar", "tail", "nose")
    system = m.build()
    start = system.state_at(rates={name: 10.0 * name.endswith(".x") for name in system.dynamic})
    motion = system.simulate(10.0, start=start, progress=False)
    assert motion["nose.x"][-1] > 50
    fresh.open(motion.view(tmp_path / "flight.html"), "#t=5")
    assert fresh.value("document.querySelector('#follow').value") == MECHANISM
    shown = fresh.picture()
    columns = np.argwhere(np.max(shown, axis=2) < 140)[:, 1]
    assert np.ptp(columns) > 0.4 * shown.shape[1]


def test_a_ruler_tells_a_round_length(tmp_path: Path, fresh: Browser) -> None:
    """A rod of 1 m is as many times longer in the picture than the ruler as in truth."""
    fresh.open(pendulum().simulate(0.1, progress=False).view(tmp_path / "swing.html"), "#t=0")
    length = float(fresh.value("document.querySelector('#length').textContent").removesuffix(" m"))
    bar = fresh.box("#bar")["width"]
    shown = fresh.picture()
    blue = np.argwhere((shown[..., 2] > 100) & (shown[..., 0] < 60))
    rod = float(np.hypot(*np.ptp(blue, axis=0)))
    assert bar > 30 and rod / bar == pytest.approx(1.0 / length, rel=0.05)


def test_nothing_of_the_panel_is_cut_at_800_pixels(tmp_path: Path, fresh: Browser) -> None:
    fresh.resize(1280, 800)
    for name, motion in (("hoist", hoisted()), ("ride", ride(0.5, 5, progress=False))):
        fresh.open(motion.view(tmp_path / f"{name}.html"), "#t=0")
        sizes = fresh.value(
            "[document.querySelector('#panel').scrollHeight, document.querySelector('#panel').clientHeight]"
        )
        assert sizes[0] <= sizes[1], name


def test_a_dark_page_has_a_dark_picture(tmp_path: Path, fresh: Browser) -> None:
    """Background, grid, plot and parts take other colours, and take them back, while the page is open."""
    if fresh.name == "firefox":
        pytest.skip("the protocol of Firefox cannot change the preferred colours of an open page")
    fresh.open(ride(0.5, 5, progress=False).view(tmp_path / "ride.html"), "#t=0")
    seen = []
    for wish in ("light", "dark", "light"):
        fresh.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": wish}])
        fresh.frame()
        shown, plot = fresh.picture(), fresh.picture("#strip")
        seen.append(
            (float(np.median(shown)), float(np.median(plot)), int(np.sum(np.max(shown, axis=2) < 40)))
        )
    assert seen[0][0] > 200 and seen[1][0] < 60 and seen[2] == seen[0]
    assert seen[1][2] > 1000 > 0.1 * seen[0][2]


def test_options_of_view_are_in_its_signature() -> None:
    """With the defaults of what makes the page; the views of periodic solutions and flexures show the same."""
    shown = inspect.signature(fx.Motion.view).parameters
    for name, parameter in inspect.signature(scene_data).parameters.items():
        assert name == "motion" or shown[name].default == parameter.default, name
    modes = inspect.signature(Linearization.view).parameters
    for name, parameter in inspect.signature(mode_data).parameters.items():
        assert name == "about" or modes[name].default == parameter.default, name
    for kind in (fx.Flexure, fx.PeriodicSolution):
        assert inspect.signature(kind.view) == inspect.signature(fx.Motion.view)
        assert "slower : float" in (inspect.getdoc(kind.view) or "")


def test_a_small_frame_has_room_for_the_picture(tmp_path: Path, fresh: Browser) -> None:
    fresh.resize(420, 360)
    fresh.open(pendulum().simulate(0.5, progress=False).view(tmp_path / "swing.html"), "#t=0")
    assert fresh.box("#picture")["height"] > 150 and fresh.box("#plots")["height"] == 0
    fresh.resize(420, 700)
    fresh.frame()
    assert fresh.box("#plots")["height"] > 80
