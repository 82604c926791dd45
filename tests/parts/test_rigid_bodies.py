"""Rigid bodies as one thing, and the joints between them: degrees of freedom, their names, motion in closed form."""

from collections.abc import Callable

import numpy as np
import pytest
from differences import numerical_matrices, worst
from joined import AT, AXIS, two_bodies

import flexel as fx

G = 9.81
SPATIAL: dict[str, tuple[Callable[[fx.Model], object], tuple[str, ...]]] = {
    "revolute": (lambda m: m.revolute("j", "a", "b", AT, AXIS), ("j.angle",)),
    "prismatic": (lambda m: m.prismatic("j", "a", "b", AXIS), ("j.axial",)),
    "cylindrical": (lambda m: m.cylindrical("j", "a", "b", AT, AXIS), ("j.angle", "j.axial")),
    "screw": (lambda m: m.screw("j", "a", "b", AT, AXIS, pitch=0.01), ("j.angle",)),
    "planar_joint": (lambda m: m.planar_joint("j", "a", "b", AXIS), ("j.angle", "j.radial1", "j.radial2")),
    "universal": (lambda m: m.universal("j", "a", "b", AT, (0, 0, 1), (0, 1, 1)), ("j_1.angle", "j_2.angle")),
    "weld": (lambda m: m.weld("j", "a", "b", AT), ()),
}


@pytest.mark.parametrize("kind", SPATIAL)
def test_a_joint_leaves_its_coordinates_free_and_no_others(kind: str) -> None:
    """Six of the first body, and the named ones; these serve as independent coordinates."""
    joint, names = SPATIAL[kind]
    m = two_bodies(joint)
    m.fix("a", "a_frame")
    m.independent(*names)
    s = m.build()
    assert s.dynamic == names
    floating = two_bodies(joint).build()
    assert floating.counts["degrees_of_freedom"] == 6 + len(names)


def test_a_ball_leaves_three_turns() -> None:
    m = two_bodies(lambda m: m.spherical("j", "a", "b", AT))
    assert m.build().counts["degrees_of_freedom"] == 9
    m = two_bodies(lambda m: m.spherical("j", "a", "b", AT))
    m.fix("a", "a_frame")
    m.cardan_chain("yaw", "lean", "pitch", body="b", base="a")
    m.independent("yaw.angle", "lean.angle", "pitch.angle")
    assert m.build().dynamic == ("yaw.angle", "lean.angle", "pitch.angle")


@pytest.mark.parametrize("kind", [*SPATIAL, "spherical"])
def test_bodies_in_free_flight_keep_momentum_and_energy(kind: str) -> None:
    """Whatever the joint between them is; and the linearization is that of the motion."""
    joint = SPATIAL[kind][0] if kind in SPATIAL else lambda m: m.spherical("j", "a", "b", AT)
    rates = 0.5 * np.random.default_rng(3).normal(size=9)
    m = two_bodies(joint)
    for name, rate in zip(m.build().dynamic, rates, strict=False):
        m.initial(name, rate=rate)
    s = m.build()
    motion = s.simulate(1.0, samples=5, rtol=1e-11, atol=1e-12)
    for axis in "xyz":
        momentum = 2.0 * motion.rate(f"a.{axis}") + 1.5 * motion.rate(f"b.{axis}")
        assert momentum == pytest.approx(momentum[0], abs=1e-9)
    assert motion.energy["kinetic"] == pytest.approx(motion.energy["kinetic"][0], rel=1e-9)
    lin, (M, C, K) = s.linearize(), numerical_matrices(s, s.initial)
    assert max(worst(lin.M, M), worst(lin.C, C), worst(lin.K, K)) < 1e-6


PLANAR: dict[str, tuple[Callable[[fx.Model], object], tuple[str, ...]]] = {
    "revolute": (lambda m: m.revolute("j", "a", "b", (0.1, 0.2)), ("j.angle",)),
    "prismatic": (lambda m: m.prismatic("j", "a", "b", (3, 4)), ("j.along",)),
    "weld": (lambda m: m.weld("j", "a", "b"), ()),
}


@pytest.mark.parametrize("kind", PLANAR)
def test_a_planar_joint_leaves_its_coordinates_free(kind: str) -> None:
    joint, names = PLANAR[kind]
    m = fx.Model()
    m.rigid_body("a", (0, 0), 0.3, mass=2.0, inertia=0.1)
    m.rigid_body("b", (0.4, 0.1), -0.2, mass=1.0, inertia=0.2)
    joint(m)
    m.fix("a", "a_frame")
    m.independent(*names)
    assert m.build().dynamic == names


def test_a_physical_pendulum_swings_at_its_frequency() -> None:
    """About a pin away from its mass centre, in the plane and in space about a horizontal axis."""
    mass, inertia, arm = 2.0, 0.3, 0.7
    omega = np.sqrt(mass * G * arm / (inertia + mass * arm**2))
    plane = fx.Model(gravity=(0, -G))
    plane.rigid_body("rod", (0, -arm), mass=mass, inertia=inertia)
    plane.revolute("pivot", "ground", "rod", at=(0, 0))
    space = fx.Model(gravity=(0, 0, -G))
    space.rigid_body("rod", (1, 0, -arm), fx.turn((0, 0, 1), 0.4), mass=mass, inertia=(inertia, inertia, 0.1))
    space.revolute("pivot", "ground", "rod", at=(1, 0, 0), axis=(3, 4, 0))
    for m in (plane, space):
        s = m.build()
        assert s.dynamic == ("pivot.angle",)
        assert s.vibrations()[0].omega == pytest.approx(omega, rel=1e-12)
        across = ("along", "across") if m is plane else ("radial1", "radial2")
        weight = np.hypot(*(s.initial.force(f"pivot.{direction}") for direction in across))
        assert weight == pytest.approx(mass * G, rel=1e-12)


def test_points_of_a_body_are_used_where_a_joint_lies_on_them() -> None:
    m = fx.Model()
    rod = m.rigid_body("rod", (0.5, 0), mass=1.0, inertia=0.1, points={"tip": (1, 0)})
    assert rod.points["tip"].name == "rod_tip" and not rod.still
    m.rigid_body("arm", (1, 0), mass=1.0, inertia=0.1)
    m.revolute("elbow", rod, "arm", at=(1, 0))
    assert m.instances["elbow"].nodes == ("rod_tip", "rod_frame", "arm", "arm_frame")
    assert not {"elbow_p", "elbow_q"} & m.nodes.keys()


def test_a_body_may_be_a_pair_of_nodes_such_as_the_end_of_a_beam() -> None:
    """A rod hinged to the tip of a cantilever: the tip deflects by half its weight times l³/3EI at rest."""
    m = fx.Model(gravity=(0, -G))
    m.point("O", (0, 0), fixed=True)
    m.angle("o", fixed=True)
    m.point("A", (1, 0))
    m.angle("a")
    m.beam("leaf", "O", "o", "A", "a", EIz=400.0)
    m.rigid_body("rod", (1, -0.5), mass=1.0, inertia=0.02)
    m.revolute("pin", ("A", "a"), "rod", at=(1, 0))
    s = m.build()
    rest = s.equilibrium()
    assert rest["A.y"] == pytest.approx(-G / (3 * 400.0), rel=1e-3)
    assert s.counts["degrees_of_freedom"] == 3


def test_a_slider_moves_freely_down_its_guide() -> None:
    for planar in (True, False):
        m = fx.Model(gravity=(0, -G) if planar else (0, 0, -G))
        if planar:
            m.rigid_body("block", (2, 1), 0.2, mass=3.0, inertia=0.1)
            m.prismatic("guide", "ground", "block", axis=(4, -3))
        else:
            m.rigid_body("block", (2, 1, 0), mass=3.0, inertia=(0.1, 0.1, 0.1))
            m.prismatic("guide", "ground", "block", axis=(0, 4, -3), at=(0, 0, 0))
        motion = m.build().simulate(2.0, samples=5)
        slid = motion["guide.along" if planar else "guide.axial"]
        assert slid == pytest.approx(0.5 * 0.6 * G * motion.t**2, abs=1e-10)


def test_a_screw_falls_as_its_thread_lets_it() -> None:
    m = fx.Model(gravity=(0, 0, -G))
    m.rigid_body("nut", (0, 0, 0.3), mass=2.0, inertia=(0.1, 0.1, 0.02))
    m.screw("thread", "ground", "nut", at=(0, 0, 0), axis=(0, 0, 1), pitch=0.05 * 2 * np.pi)
    motion = m.build().simulate(4.0, samples=9)
    acceleration = -2.0 * G * 0.05 / (0.02 + 2.0 * 0.05**2)
    assert motion["thread.angle"] == pytest.approx(acceleration * motion.t**2 / 2, rel=1e-9, abs=1e-9)
    assert motion["thread.axial"] == pytest.approx(0.05 * motion["thread.angle"], abs=1e-10)


def test_a_universal_joint_turns_unevenly() -> None:
    """tan(output) = cos(angle between the shafts) tan(input), from the fork at right angles to their plane."""
    beta = 0.5
    second = np.array([np.cos(beta), np.sin(beta), 0])
    m = fx.Model()
    m.rigid_body("in", (-1, 0, 0), mass=1.0, inertia=(0.1, 0.1, 0.1))
    m.rigid_body("out", second, mass=1.0, inertia=(0.1, 0.1, 0.1))
    m.revolute("drive", "ground", "in", at=(-1, 0, 0), axis=(1, 0, 0))
    m.universal("joint", "in", "out", at=(0, 0, 0), axis_p=(0, 0, 1), axis_q=np.cross(second, (0, 0, 1)))
    m.cylindrical("shaft", "ground", "out", at=second, axis=second)
    m.release("shaft.radial1", "shaft.radial2")  # the joint holds the shaft's place already
    m.prescribe("drive.angle", lambda t: t)
    motion = m.build().simulate(3.0, samples=31)
    a, b = motion["drive.angle"], motion["shaft.angle"]
    assert np.tan(b) == pytest.approx(np.cos(beta) * np.tan(a), rel=1e-9, abs=1e-9)


def test_a_body_that_slides_on_a_plane_keeps_to_it() -> None:
    m = fx.Model(gravity=(0, 0, -G))
    m.rigid_body("puck", (0, 0, 0.5), mass=1.0, inertia=(0.1, 0.1, 0.2))
    m.planar_joint("ice", "ground", "puck", normal=(0, 3, 4))
    m.initial("ice.angle", rate=2.0)
    end = m.build().simulate(1.0)[-1]
    assert end["ice.angle"] == pytest.approx(2.0, rel=1e-12)
    assert np.hypot(end["ice.radial1"], end["ice.radial2"]) == pytest.approx(0.5 * 0.6 * G, rel=1e-10)


def test_a_weld_makes_one_body() -> None:
    """Two welded bodies swing like one with the sum of their inertias."""
    m = fx.Model(gravity=(0, -G))
    m.rigid_body("a", (0, -0.5), mass=1.0, inertia=0.1)
    m.rigid_body("b", (0.3, -0.5), mass=2.0, inertia=0.2)
    m.weld("joint", "a", "b")
    m.revolute("pivot", "ground", "a", at=(0, 0))
    inertia = 0.1 + 0.25 + 0.2 + 2.0 * (0.3**2 + 0.5**2)
    assert m.build().initial.acceleration("pivot.angle") == pytest.approx(-2.0 * G * 0.3 / inertia, rel=1e-12)


def test_angles_of_a_cardan_chain_make_up_the_orientation() -> None:
    m = fx.Model()
    m.rigid_body("bike", (0, 0, 1), mass=1.0, inertia=(1, 2, 2.5))
    m.cardan_chain("yaw", "lean", "pitch", body="bike")
    angles = {"yaw": 0.7, "lean": -0.3, "pitch": 0.4}
    for name, value in angles.items():
        m.initial(f"{name}.angle", value)
    s = m.build()
    assert s.counts["degrees_of_freedom"] == 6
    q = np.array([s.initial[f"bike_frame.lambda{i}"] for i in range(4)])
    expected = np.eye(3)
    for axis, value in zip(((0, 0, 1), (1, 0, 0), (0, 1, 0)), angles.values(), strict=True):
        expected = expected @ _matrix(fx.turn(axis, value))
    assert _matrix(q) == pytest.approx(expected, abs=1e-12)


def _matrix(q: np.ndarray) -> np.ndarray:
    from flexel.base.quaternions import matrix

    return matrix(q)


def test_a_skate_leaves_the_motion_along_its_blade_and_the_turns() -> None:
    """In space: along the blade, three turns; across the blade a kinematic coordinate."""
    m = fx.Model()
    m.rigid_body("sled", (0, 0, 0.2), mass=1.0, inertia=(1, 1, 1))
    m.skate("blade", "sled", at=(0, 0, 0), direction=(1, 0, 0))
    s = m.build()
    assert (s.roles.nd, s.roles.nq) == (4, 5)
