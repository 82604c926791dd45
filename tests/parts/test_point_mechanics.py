"""Points, balls and discs in contact with surfaces: the laws of mechanics, invariance, and errors."""

from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.apps.view.drawing import shapes
from flexel.base.arrays import Array
from flexel.base.quaternions import matrix, turn

A = 0.1

SURFACES = ["plane", "cylinder", "v groove", "round groove"]


def two_bodies(
    surface: str, turned: Array | None = None, shift: Array | None = None, rolls: bool = True
) -> fx.Model:
    """A ball, off its body's point, pressed askew into a surface of another free body; both turn.

    The whole model may be turned and shifted. Where it does not roll, it is a point of its body with a radius.
    """
    q = np.array([1.0, 0.0, 0.0, 0.0]) if turned is None else turned
    R, d = matrix(q), np.zeros(3) if shift is None else shift
    m = fx.Model()
    m.point("C", d)
    m.frame("F", q)
    m.body(
        "wheel", "C", "F", mass=3.0, inertia=(0.3, 0.2, 0.35, 0.01, 0.02, -0.03), offset=(0.02, 0.05, 0.01)
    )
    at = {"plane": (0.02, 0.03, 0.06), "cylinder": (0.1, 0.2, 0.47), "v groove": (0.1, 0.01, 0.47)}
    at["round groove"] = (0.1, 0.06, 0.49)
    m.point("P", d + R @ ((0.05, 0.1, 0.42) if rolls else at[surface]))
    m.frame("R", q)
    m.body("ball", "P", "R", mass=1.0, inertia=(0.004, 0.005, 0.006), offset=(0.01, 0, 0))
    if surface == "plane":
        m.plane("S", "C", "F", normal=R @ (0.1, 0.2, 1.0))
    else:
        grooves = {"v groove": fx.VGroove(1.2), "round groove": fx.RoundGroove(0.15)}
        m.sheave("S", "C", "F", radius=0.4, axle=R @ (0, 1, 0), groove=grooves.get(surface))
    contact = fx.Contact(1e5, dissipation=0.5, friction=0.3)
    more: dict[str, Any] = {"frame": "R", "at": d + R @ at[surface]} if rolls else {}
    m.contact("touch", "P", "S", contact, radius=A, **more)
    for name, v in (("P", (0.2, -0.1, -0.6)), ("C", (0.0, 0.3, 0.1))):
        for axis, rate in zip("xyz", R @ v, strict=True):
            m.initial(f"{name}.{axis}", rate=rate)
    for name, w in (("F", (1.0, 2.0, -0.5)), ("R", (-3.0, 1.0, 2.0))):
        omega = m.angular_velocity(name)
        for axis, rate in zip("xyz", R @ w, strict=True):
            m.initial(f"{omega}.w{axis}", rate=rate)
    return m


def momentum(state: fx.State) -> Array:
    """Linear and angular momentum (6,) of both bodies about the origin."""
    total = np.zeros(6)
    for point, frame, body in (("C", "F", "wheel"), ("P", "R", "ball")):
        parameters = state.structure.instances[
            [i.name for i in state.structure.instances].index(body)
        ].parameters
        R, p, v = matrix(state.position(frame)), state.position(point), state.velocity(point)
        omega = np.array([state.rate(f"{frame}.omega.w{axis}") for axis in "xyz"])
        xx, yy, zz, xy, xz, yz = parameters["J"]
        J = R @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ R.T
        centre, mass = p + R @ parameters["c"], parameters["mass"][0]
        velocity = v + np.cross(omega, R @ parameters["c"])
        total += [*(mass * velocity), *(J @ omega + mass * np.cross(centre, velocity))]
    return total


@pytest.mark.parametrize("rolls", [True, False])
@pytest.mark.parametrize("surface", SURFACES)
def test_action_is_reaction(surface: str, rolls: bool) -> None:
    """Linear and angular momentum of two free bodies do not change while they touch, slide and part.

    Neither with a ball fixed in its body, nor with a point of the body that slides as its centre does.
    """
    motion = (
        two_bodies(surface, rolls=rolls)
        .build()
        .simulate(0.1, samples=11, rtol=1e-10, atol=1e-12, progress=False)
    )
    before, after = momentum(motion[0]), momentum(motion[-1])
    first = "touch.gap1" if surface == "v groove" else "touch.gap"
    assert motion.force(first).min() < -50
    assert motion.force(first)[-1] == 0
    assert after == pytest.approx(before, abs=1e-8)
    ball = motion.velocity("P")
    assert np.linalg.norm(ball[-1] - ball[0]) > 0.1


@pytest.mark.parametrize("surface", SURFACES)
def test_a_model_that_is_turned_and_shifted_as_a_whole_has_the_same_forces(surface: str) -> None:
    """Gaps, normal forces and friction; the directions of a plane's slips are those of the global axes."""
    plain = two_bodies(surface).build().initial
    moved = two_bodies(surface, turn((1, -2, 0.5), 0.8), np.array([3.0, -2.0, 5.0])).build().initial
    gaps = ("gap1", "gap2") if surface == "v groove" else ("gap",)
    slips = [
        name.removeprefix("touch.")
        for name in plain.structure.index
        if name.startswith("touch.") and name[6:] not in gaps
    ]
    for gap in gaps:
        assert moved[f"touch.{gap}"] == pytest.approx(plain[f"touch.{gap}"], abs=1e-14)
        assert moved.force(f"touch.{gap}") == pytest.approx(plain.force(f"touch.{gap}"), rel=1e-9)
    assert plain.force(f"touch.{gaps[0]}") < -1
    friction = [np.array([state.force(f"touch.{s}") for s in slips]) for state in (plain, moved)]
    if surface == "plane":
        friction = [np.linalg.norm(force, keepdims=True) for force in friction]
    assert abs(friction[0]).max() > 1
    assert friction[1] == pytest.approx(friction[0], rel=1e-9)


@pytest.mark.parametrize("frame", [True, False])
@pytest.mark.parametrize("kind", ["circle", "line"])
def test_a_planar_contact_moves_as_the_spatial_one(kind: str, frame: bool) -> None:
    """A disc, or a point, on a turning circle or line; off the point of its body."""
    motions = []
    for planar in (True, False):

        def vector(x: float, y: float, flat: bool = planar) -> tuple[float, ...]:
            return (x, y) if flat else (x, y, 0.0)

        m = fx.Model(gravity=vector(0, -9.81))
        m.point("C", vector(0, 0), fixed=True)
        node = m.angle if planar else m.frame
        node("ground", fixed=True), node("F"), node("R")
        m.hinge("axle", "ground", "F", axis=None if planar else (0, 0, 1))
        m.hinge("turn", "ground", "R", axis=None if planar else (0, 0, 1))
        m.point("P", vector(0.05, 0.42))
        if not planar:
            m.fix("P.z")
        for name, point, body, J in (("wheel", "C", "F", 0.3), ("ball", "P", "R", 0.005)):
            m.body(name, point, body, mass=1.0, inertia=J if planar else (J, J, J), offset=vector(0.02, 0.01))
        if kind == "circle":
            m.sheave("S", "C", "F", radius=0.3) if planar else m.sheave(
                "S", "C", "F", radius=0.3, axle=(0, 0, 1)
            )
        else:
            m.plane("S", "C", "F", normal=vector(0.1, 1.0))
        more: dict[str, Any] = {"frame": "R", "at": vector(0.03, 0.41)} if frame else {}
        contact = fx.Contact(1e6, dissipation=0.2, friction=0.3)
        m.contact("touch", "P", "S", contact, radius=A, **more)
        m.initial("axle.angle", rate=4.0)
        m.initial("turn.angle", rate=-7.0)
        m.initial("P.x", rate=0.0)
        m.initial("P.y", rate=-2.0)
        motions.append(m.build().simulate(0.5, samples=51, rtol=1e-10, atol=1e-12, progress=False))
    flat, space = motions
    assert flat.force("touch.gap").min() < -100
    for coordinate in ("P.x", "P.y", "axle.angle", "turn.angle"):
        assert flat[coordinate] == pytest.approx(space[coordinate], abs=1e-6)
    slip = "tangential" if kind == "circle" else "x"
    assert flat.force("touch.gap") == pytest.approx(space.force("touch.gap"), abs=1e-3)
    assert flat.force("touch.tangential") == pytest.approx(space.force(f"touch.{slip}"), abs=1e-3)


def test_the_energy_balance_closes() -> None:
    """A ball that bounces, slides and rolls: what it loses is the work of dissipation and friction."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("ground", fixed=True)
    m.plane("floor", "O", "ground")
    m.point("ball", (0, 0, 0.15))
    m.frame("R")
    m.body("mass", "ball", "R", mass=1.0, inertia=[0.4 * A**2] * 3)
    m.contact("touch", "ball", "floor", fx.Contact(1e5, dissipation=0.3, friction=0.3), frame="R", radius=A)
    m.initial("ball.x", rate=1.0)
    motion = m.build().simulate(
        0.5, method="generalized-alpha", step=1e-4, spectral_radius=0.9, samples=501, progress=False
    )
    balance = motion.energy_balance()
    assert balance["contact"].max() > 0.1
    assert balance["dissipated"][-1] > 0.1
    assert abs(balance["error"]).max() < 1e-3 * balance["dissipated"][-1]


# --- pictures and errors --------------------------------------------------------------------------------------


def test_a_body_that_is_a_ball_is_drawn_without_a_box() -> None:
    """But one that has a ball elsewhere keeps its box."""
    for at, count in (((0, 0, 1), 0), ((0.2, 0, 1), 1)):
        m = fx.Model()
        m.point("O", (0, 0, 0), fixed=True)
        m.frame("ground", fixed=True)
        m.plane("floor", "O", "ground")
        m.point("P", (0, 0, 1))
        m.frame("R")
        m.body("mass", "P", "R", mass=1.0, inertia=(0.004, 0.004, 0.004))
        m.contact("touch", "P", "floor", fx.Contact(1e6), frame="R", at=at, radius=A)
        assert [shape.style for shape in shapes(m.build().initial)].count("box") == count


def test_a_ball_is_drawn_with_the_force_on_it_and_its_sheave() -> None:
    state = two_bodies("cylinder").build().initial
    found = [shape for shape in shapes(state) if shape.name == "touch"]
    assert [shape.style for shape in found] == ["rim", "valve", "rim", "force"]
    centre = (0.1, 0.2, 0.47)
    for ring in (*found[0].lines, *found[2].lines):
        assert np.allclose(np.linalg.norm(ring - centre, axis=1), A)
    force = found[-1].force
    assert force is not None
    normal = -state.force("touch.gap")
    friction = [state.force(f"touch.{slip}") for slip in ("tangential", "axial")]
    assert np.linalg.norm(force) == pytest.approx(np.hypot(normal, np.hypot(*friction)), rel=1e-9)
    assert np.array([0.1, 0, 0.47]) @ force / np.hypot(0.1, 0.47) == pytest.approx(normal, rel=1e-9)
    assert np.allclose(found[-1].lines[0], [centre])
    (sheave,) = (shape for shape in shapes(state) if shape.style == "sheave")
    assert sheave.outline is not None and np.allclose(np.linalg.norm(sheave.outline, axis=1), 0.4)


GOOD = fx.Contact(1e6)
MISTAKES: list[tuple[dict[str, Any], str]] = [
    ({"surface": "flor"}, "contact 'touch': unknown sheave or plane 'flor'; did you mean floor"),
    ({"surface": 3}, "contact 'touch': unknown sheave or plane '3'"),
    (
        {"point": "flat"},
        "contact 'touch' with 'floor': 'flat' lies in a planar model, the surface in space; use one",
    ),
    ({"point": "R"}, "contact 'touch' with 'floor': node 'R' is a frame; it needs a point"),
    ({"frame": "ball"}, "contact 'touch' with 'floor': node 'ball' is a point; it needs a frame"),
    ({"point": "bal"}, "contact 'touch' with 'floor': unknown node 'bal'; did you mean ball"),
    (
        {"radius": -0.1},
        "contact 'touch' with 'floor': radius -0.1 is negative; give zero or a positive value",
    ),
    ({"radius": "big"}, "contact 'touch' with 'floor': radius 'big' is not numeric"),
    (
        {"surface": "groove", "radius": 0.1},
        "contact 'touch' with 'groove': the sphere of radius 0.1 m does not fit",
    ),
    (
        {"surface": "groove", "at": (0, 5, 0)},
        "contact 'touch' with 'groove': as drawn, its centre lies on the axle",
    ),
    ({"contact": 1e6}, "contact 'touch' with 'floor': contact 1000000.0 is not a Contact; give fx.Contact"),
    (
        {"contact": fx.Contact(1e6, per="length")},
        "contact 'touch' with 'floor': its stiffness is per length of a rope",
    ),
    ({"at": (0, 0)}, r"contact 'touch' with 'floor': at \(0, 0\) has shape"),
    (
        {"frame": None, "at": (0, 0, 1)},
        r"contact 'touch' with 'floor': a position at=\(0, 0, 1\) needs the body",
    ),
    (
        {"point": "O", "frame": "ground"},
        "contact 'touch' with 'floor': the surface is fixed in the same body",
    ),
    ({"point": "O", "frame": None}, "contact 'touch' with 'floor': the surface is fixed in the same body"),
    ({"name": "ball"}, "'ball': this name is taken"),
]


@pytest.mark.parametrize(("change", "message"), MISTAKES)
def test_mistakes_are_named_and_leave_the_model_unchanged(change: dict[str, Any], message: str) -> None:
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("ball", (0, 0, 1))
    m.point("flat", (0, 0))
    m.frame("ground", fixed=True)
    m.frame("R")
    m.plane("floor", "O", "ground")
    m.sheave("groove", "O", "ground", radius=0.3, axle=(0, 1, 0), groove=fx.RoundGroove(0.1))
    given: dict[str, Any] = {
        "name": "touch",
        "point": "ball",
        "surface": "floor",
        "contact": GOOD,
        "frame": "R",
    }
    given |= change
    places = [given.pop(key) for key in ("name", "point", "surface", "contact")]
    with pytest.raises(fx.ModelError, match=message):
        m.contact(*places, **given)
    assert not m.instances and not m.laws


def test_a_point_on_a_planar_surface_must_be_planar() -> None:
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.plane("floor", "O", "ground", normal=(0, 1))
    m.point("P", (0, 0, 1))
    with pytest.raises(fx.ModelError, match="'P' lies in space, the surface in a planar model; use one kind"):
        m.contact("touch", "P", "floor", GOOD)


def test_a_contact_per_point_means_the_same_as_one_that_leaves_it_open() -> None:
    forces = []
    for contact in (fx.Contact(1e6), fx.Contact(1e6, per="point")):
        m = fx.Model()
        m.point("O", (0, 0, 0), fixed=True)
        m.frame("ground", fixed=True)
        m.plane("floor", "O", "ground")
        m.point("P", (0, 0, -1e-3))
        m.point_mass("mass", "P", 1.0)
        m.contact("touch", "P", "floor", contact)
        forces.append(m.build().initial.force("touch.gap"))
    assert forces == pytest.approx([-1e6 * 1e-3**1.5] * 2)
