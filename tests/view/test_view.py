"""The viewer's data are the motion's, and its page is small, alone and harmless."""

import base64
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mechanisms import cantilever, pendulum
from numpy.typing import NDArray

import flexel as fx
from flexel.apps.view.drawing import shapes
from flexel.apps.view.page import mode_data, page, scene_data, view_motion, write_page
from flexel.apps.view.page.data import common
from flexel.apps.view.primitives import lowest
from flexel.base.quaternions import matrix
from flexel.examples.bicycle import bicycle, kick


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
    return [shape for shape in scene["shapes"] if shape["style"] == style and name in (None, shape["name"])]


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


def test_a_model_in_one_point_has_a_size() -> None:
    """Where no lengths are given, the largest body determines the scale, as the cube that has its inertia."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("R")
    m.body("cube", "O", "R", mass=6.0, inertia=(1.0, 1.0, 1.0))  # side 1 m
    scene = scene_data(m.build().simulate(0.1, progress=False), frames=2)
    assert 1.0 < scene["size"] < 1.5
    box = parts(scene, "box", "cube")[0]
    assert np.allclose(np.ptp(unpacked(box["local"], 3), axis=0).max(), 1.0)
    assert np.allclose(np.abs(box["outline"]), 0.5)


def test_a_belt_leaves_its_pulleys_at_a_tangent_and_gears_touch() -> None:
    """Pulleys of different size and a pair of gears; the run of the belt is as long as the common tangent."""
    m = fx.Model()
    for name, x in (("A", 0.0), ("B", 0.5), ("C", 0.8)):
        m.point(name, (x, 0), fixed=True)
        m.angle(f"turn {name}")
    m.planar_belt("belt", "A", "turn A", "B", "turn B", radius_p=0.1, radius_q=0.05, stiffness=100.0)
    m.planar_gear("gears", "B", "turn B", "C", "turn C", radius_p=0.2, radius_q=0.1)
    m.body("pulley", "A", "turn A", mass=1.0, inertia=0.1)
    m.body("gear", "B", "turn B", mass=1.0, inertia=0.1)
    found = shapes(m.build().state_at({"turn A.angle": 0.3, "turn C.angle": 0.0}))
    run = next(shape for shape in found if (shape.style, shape.name) == ("bar", "belt")).lines[0]
    along = run[1] - run[0]
    assert np.linalg.norm(along) == pytest.approx(np.sqrt(0.5**2 - 0.05**2), rel=1e-14)
    assert [np.linalg.norm(arm) for arm in run - [[0, 0, 0], [0.5, 0, 0]]] == pytest.approx([0.1, 0.05])
    assert np.abs((run - [[0, 0, 0], [0.5, 0, 0]]) @ along).max() < 1e-15
    small, large = sorted(
        (np.ptp(shape.lines[0][:, 0]), shape.lines[0][:, 0].max(), shape.lines[0][:, 0].min())
        for shape in found
        if (shape.style, shape.name) == ("rim", "gears")
    )
    assert (small[0], large[0]) == pytest.approx((0.2, 0.4))
    assert large[1] == pytest.approx(small[2])
    spoke = next(shape for shape in found if (shape.style, shape.name) == ("valve", "belt")).lines[0]
    assert spoke[1] == pytest.approx([0.1 * np.cos(0.3), 0.1 * np.sin(0.3), 0.0])


def test_the_arrows_of_the_road_carry_the_bicycle() -> None:
    """At rest upright the forces of the road on both wheels add up to the weight, straight up."""
    system = bicycle()
    state = system.initial
    mass = sum(
        float(instance.parameters["mass"][0])
        for instance in system.structure.instances
        if "mass" in instance.parameters
    )
    motion = system.simulate(0.01, start=state, times=[0.0, 0.01], progress=False)
    forces = [unpacked(arrow["force"], 3)[0] for arrow in parts(scene_data(motion, frames=2), "force")]
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


def rope_on_a_sheave() -> fx.System:
    """A tight rope over a sheave of 0.1 m, pressed into it by 1 mm at two points of contact with springs of 1e5 N/m."""
    m = fx.Model()
    for name, x in (("p", -0.1), ("q", 0.1)):
        m.point(name, (x, 0.109), fixed=True)
        m.slope(f"d{name}", (1.0, 0.0))
    m.point("axle", (0, 0))
    m.angle("turn")
    m.body("sheave", "axle", "turn", mass=1.0, inertia=0.01)
    m.cable("rope", "p", "dp", "q", "dq", EA=1e5, EI=10.0, mass_per_length=0.1)
    contact = {
        "l0": [0.2],
        "xi": [0.5],
        "alpha0": [0.0],
        "offset": [0.0, 0.0],
        "radius": [0.1],
        "rope_radius": [0.01],
    }
    for name in ("touch", "touch too"):
        values = {key: np.array(value) for key, value in contact.items()}
        m.element(name, "planar_cable_circle", "p", "dp", "q", "dq", "axle", "turn", **values)
        m.spring(f"{name}.gap", 1e5)
    return m.build()


def test_a_sheave_is_drawn_once_with_the_forces_on_the_rope() -> None:
    """Whatever the number of contacts; each force is stiffness times depth, away from the axle, where the rope is."""
    with pytest.warns(fx.ModelWarning, match="cannot follow"):  # as long as two radii
        state = rope_on_a_sheave().initial
    found = shapes(state)
    (sheave,) = (shape for shape in found if shape.style == "sheave")
    assert sheave.outline is not None
    assert np.allclose(np.linalg.norm(sheave.outline, axis=1), 0.1)
    forces = [shape for shape in found if shape.style == "force"]
    assert len(forces) == 2
    for arrow in forces:
        assert np.allclose(arrow.lines[0], [(0, 0.109, 0)])
        assert arrow.force is not None
        assert np.allclose(arrow.force, (0, 100.0, 0), atol=1e-6)


def test_a_rope_sags_as_its_cubic_and_shows_its_tension() -> None:
    """The drawn line passes through the ends with their slopes; tension and strain are those of a pulled rope."""
    m = fx.Model()
    m.point("p", (0, 0, 0), fixed=True)
    m.point("q", (1, 0, 0))
    for name in "pq":
        m.slope(f"d{name}", (1.0, 0.0, 0.0))
    m.cable("rope", "p", "dp", "q", "dq", EA=1e5, EI=10.0, mass_per_length=0.1)
    m.load("q.x", 200.0)
    system = m.build()
    state = system.equilibrium()
    (rope,) = (shape for shape in shapes(state) if shape.style == "rope")
    assert np.allclose(rope.lines[0][[0, -1]], [(0, 0, 0), state.position("q")])
    assert np.allclose(rope.values["tension"], 200.0, rtol=1e-6)
    assert np.allclose(rope.values["strain"], 200.0 / 1e5, rtol=5e-3)


def test_modes_are_the_linear_displacements() -> None:
    """The tip of the first mode of a cantilever moves across by 1, no vertex along or sideways."""
    system = cantilever()
    state = system.equilibrium()
    scene = mode_data(state, system.vibrations(state, count=2))
    assert [mode["text"].endswith("Hz") for mode in scene["modes"]] == [True, True]
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


def test_mistakes_are_reported(ride: fx.Motion, tmp_path: Path) -> None:
    """Each names the remedy."""
    with pytest.raises(fx.ModelError, match="ends in .html"):
        view_motion(ride, tmp_path / "ride.txt", frames=2)
    with pytest.raises(fx.ModelError, match="frames 1; give a whole number, 2 or more"):
        scene_data(ride, frames=1)
    with pytest.raises(fx.ModelError, match="unknown node 'haed'; did you mean head"):
        scene_data(ride, view=fx.View(centre="haed"))
    with pytest.raises(fx.ModelError, match="no states from 0.0015"):
        still = cantilever()
        scene_data(still.simulate(1e-3, method="generalized-alpha", progress=False), between=(0.0015, 0.002))
    with pytest.raises(fx.ModelError, match="save the motion again"):
        write_page({"format": 0}, tmp_path / "old.html")
    with pytest.raises(fx.ModelError, match="no modes given"):
        mode_data(ride[0], [])
    system = cantilever()
    with pytest.raises(fx.ModelError, match="give the linearization, not the state"):
        mode_data(system.initial, system.linearize().modes())


def test_modes_show_the_strains_of_their_shape() -> None:
    """A cantilever of one element: strain E-free, by the curvature at the clamp of the cubic, 6/l^2 u - 2/l phi."""
    system = cantilever()
    state = system.equilibrium()
    (mode,) = system.vibrations(state, count=1)
    scene = mode_data(state, [mode])
    leaf = parts(scene, "beam", "leaf")[0]
    strain = np.frombuffer(base64.b64decode(leaf["values"]["bending strain of the mode"]["modal"]), "<f4")
    moved = unpacked(leaf["modes"], 3 * 17)[0].reshape(17, 3)[:, 1]
    slope = (3 * moved[-1] - 4 * moved[-2] + moved[-3]) / (2 * 0.1 / 16)  # of the cubic at the tip
    curvature = 6 / 0.1**2 * moved[-1] - 2 / 0.1 * slope
    assert strain[0] == pytest.approx(abs(curvature) * 0.25e-3, rel=0.02)
    assert strain[1] < 0.3 * strain[0]
    assert scene["units"]["bending moment of the mode"] == "N m"


def test_modes_show_the_strains_of_cables() -> None:
    """A straight one bends by the second derivative of its cubic, which second differences of the line give exactly."""
    m = fx.Model(gravity=(0, 0))
    for name, x in (("A", 0.0), ("B", 1.0)):
        m.point(name, (x, 0), fixed=x == 0)
        m.slope(f"d{name}", (1, 0), fixed=x == 0)
    m.cable("rope", "A", "dA", "B", "dB", section=fx.Circle(0.01), material="steel")
    system = m.build()
    state = system.initial
    (mode,) = system.vibrations(state, count=1)
    rope = parts(mode_data(state, [mode]), "rope", "rope")[0]
    values = {
        name: np.frombuffer(base64.b64decode(value["modal"]), "<f4")
        for name, value in rope["values"].items()
        if "modal" in value
    }
    y = unpacked(rope["modes"], 3 * 9)[0].reshape(9, 3)[:, 1]
    curvature = (y[5] - 2 * y[4] + y[3]) / 0.125**2
    assert abs(curvature) > 0.1 * np.abs(y).max()
    assert values["bending strain of the mode"][2] == pytest.approx(abs(curvature) * 0.005, rel=1e-3)
    assert values["tension of the mode"] == pytest.approx(
        0.0, abs=1e-3 * 2e11 * 7.9e-5 * float(abs(curvature)) * 0.005
    )


@pytest.mark.parametrize("height", [0.05, 0.001])
def test_the_floor_is_below_the_sections_of_beams(height: float) -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("A", (0, 0, 0), fixed=True)
    m.frame("RA", fixed=True)
    m.point("B", (0.1, 0, 0))
    m.frame("RB")
    strip = fx.Rectangle(height, 0.5e-3)
    m.beam("leaf", "A", "RA", "B", "RB", direction=(0, 0, 1), section=strip, material="steel")
    state = m.build().equilibrium()
    drawn, up = shapes(state), np.array([0.0, 0.0, 1.0])
    (leaf,) = [shape for shape in drawn if shape.name == "leaf"]
    assert lowest(leaf, up) == pytest.approx(min(0, float(leaf.lines[0][-1, 2])) - height / 2, rel=1e-3)
    found = common(state, drawn, fx.View(), "", "")["floor"]
    assert found["height"] == pytest.approx(lowest(leaf, up) - 0.02 * 0.1, rel=1e-5)


def test_a_model_without_positions_has_nothing_to_draw(tmp_path: Path) -> None:
    """Two angles: refused by name where a picture is wanted, and said where a notebook would show one."""
    m = fx.Model()
    for name in ("first", "second"):
        m.angle(name)
        m.rotary_inertia(f"{name} rotor", name, 1.0)
    system = m.build()
    motion = system.simulate(0.1, progress=False)
    for drawing in (
        lambda: motion.view(tmp_path / "view.html"),
        lambda: motion.animate(tmp_path / "moving.gif"),
        lambda: system.linearize().view(tmp_path / "modes.html"),
    ):
        with pytest.raises(fx.ModelError, match="no part of the model has a position; give it points"):
            drawing()
    for shown in (motion, m):
        assert "no part of the model has a position" in shown._repr_html_()


def test_buckling_modes_are_shown_with_their_multipliers() -> None:
    """A clamped strip under a load along it; the shape goes across it, as far as all modes do at their tip."""
    system = cantilever()
    state = system.equilibrium()
    modes = system.buckling(increment={"A.x": -1.0}, count=1)
    scene = mode_data(state, modes)
    assert scene["title"] == "Buckling modes"
    assert scene["modes"][0]["text"] == f"buckling at {modes[0].multiplier:.4g}"
    moved = unpacked(parts(scene, "joint", "A")[0]["modes"], 3)[0]
    np.testing.assert_allclose(np.abs(moved), [0, 1, 0], atol=1e-6)


def test_a_point_that_touches_as_a_ball_is_drawn_as_one() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("ball", (0, 0, 0.3))
    m.point("ground", (0, 0, 0), fixed=True)
    m.frame("level", fixed=True)
    m.plane("floor", "ground", "level")
    m.point_mass("mass", "ball", 0.1)
    m.contact("bounce", "ball", "floor", fx.Contact(1e7), radius=0.02)
    rims = [shape for shape in shapes(m.build().initial) if shape.style == "rim"]
    places = np.concatenate([line for rim in rims for line in rim.lines])
    np.testing.assert_allclose(np.linalg.norm(places - [0, 0, 0.3], axis=1), 0.02, rtol=1e-12)
