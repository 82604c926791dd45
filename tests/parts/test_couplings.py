"""Belts, gears, surfaces, bearings and wheels of the plane, and rotary inertia, in models that move."""

import numpy as np
import pytest

import flexel as fx


def drive() -> fx.Model:
    """Two discs on fixed centres; the first is turned at 2 rad/s, the second has an inertia."""
    m = fx.Model(gravity=(0, 0))
    m.point("P", (0, 0), fixed=True)
    m.point("Q", (0.5, 0.2), fixed=True)
    m.angle("p", 0.3)
    m.angle("q", -0.4)
    m.rotary_inertia("disc p", "p", 0.02)
    m.rotary_inertia("disc q", "q", 0.05)
    return m


def test_belt_and_gears_turn_the_second_disc_in_the_ratio_of_the_radii() -> None:
    for method, sign in (("planar_belt", 1.0), ("planar_gear", -1.0)):
        m = drive()
        getattr(m, method)("pair", "P", "p", "Q", "q", radius_p=0.1, radius_q=0.25)
        m.prescribe("p.angle", fx.Harmonic(4.0, 3.0, offset=0.3))
        end = m.build().simulate(2.0)[-1]
        turn = end["p.angle"] - 0.3
        assert abs(end["q.angle"] + 0.4 - sign * turn * 0.1 / 0.25) < 1e-12
        # the moment that turns the second disc comes from the pair alone
        driven = 0.05 * sign * 0.4 * end.acceleration("p.angle")
        assert abs(end.force("p.angle") - (0.02 * end.acceleration("p.angle") + sign * 0.4 * driven)) < 1e-9


def test_crossed_belt_turns_the_other_way() -> None:
    m = drive()
    m.planar_belt("pair", "P", "p", "Q", "q", radius_p=0.1, radius_q=-0.2)
    m.prescribe("p.angle", lambda t: 0.3 + t)
    assert abs(m.build().simulate(2.0)[-1]["q.angle"] + 0.4 + 1.0) < 1e-12


def test_elastic_belt_swings_at_its_frequency() -> None:
    m = drive()
    m.planar_belt("pair", "P", "p", "Q", "q", radius_p=0.1, radius_q=0.25, stiffness=300.0)
    lowest = m.build().vibrations()
    w2 = 300.0 * (0.1**2 / 0.02 + 0.25**2 / 0.05)
    assert abs(lowest[-1].omega - np.sqrt(w2)) < 1e-9


def test_elastic_belt_keeps_the_energy_while_its_centres_move() -> None:
    """The point of contact wanders around pulleys of different size; the tension does the work it stores."""
    m = drive()
    m.nodes.pop("Q")
    m.point("Q", (0.5, 0.2))
    m.point_mass("centre", "Q", 1.5)
    m.spring("Q.x", 200.0)
    m.spring("Q.y", 80.0)
    m.planar_belt("pair", "P", "p", "Q", "q", radius_p=0.1, radius_q=0.25, stiffness=300.0)
    m.initial("p.angle", rate=6.0)
    m.initial("q.angle", rate=0.0)
    motion = m.build().simulate(1.0)
    total = motion.energy["total"]
    assert np.ptp(motion["Q.y"]) > 0.05
    assert np.ptp(total) < 1e-8 * total[0]


def test_planetary_gear_counts_any_number_of_turns_of_its_arm() -> None:
    m = fx.Model(gravity=(0, 0))
    m.point("sun", (0, 0), fixed=True)
    m.point("pin", (0.3, 0))
    m.angle("still", fixed=True)
    m.angle("arm")
    m.angle("planet")
    m.angle("ring")
    m.beam("link", "sun", "arm", "pin", rigid=True)
    m.planar_gear("inner", "sun", "still", "pin", "planet", radius_p=20, radius_q=10)
    m.planar_gear("outer", "sun", "ring", "pin", "planet", radius_p=40, radius_q=-10)
    m.prescribe("arm.angle", lambda t: 5.0 * t)
    end = m.build().simulate(6.0)[-1]
    assert abs(end["planet.angle"] - 30.0 * (1 + 20 / 10)) < 1e-10
    assert abs(end["ring.angle"] - 30.0 * (1 + 20 / 40)) < 1e-10  # Willis


def test_point_on_a_sphere_is_a_spherical_pendulum() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("A", (0.6, 0, -0.8))
    m.point_mass("bob", "A", 2.0)
    m.quadric("sphere", "A", quadratic=np.eye(3), constant=-1.0)
    m.initial("A.y", rate=np.sqrt(9.81 / 0.8) * 0.6)  # conical: w² = g / (L cos)
    motion = m.build().simulate(2.0)
    assert np.max(np.abs(motion["A.z"] + 0.8)) < 1e-8
    assert np.max(np.abs(motion["sphere.height"])) < 1e-12


def test_a_point_drawn_off_a_quadric_moves_onto_it() -> None:
    """The surface is where the polynomial is zero, wherever the point is drawn."""
    m = fx.Model()
    m.point("A", (0.7, 0, 0.7))
    m.point_mass("bob", "A", 2.0)
    m.quadric("sphere", "A", quadratic=np.eye(3), constant=-1.0)
    with pytest.warns(fx.AssemblyWarning, match=r"'sphere\.height' is -0\.02 m"):
        s = m.build()
    assert np.linalg.norm(s.initial.position("A")) == pytest.approx(1.0, abs=1e-14)


def test_skate_on_a_plane_is_chaplygins_sleigh() -> None:
    """A knife edge with its mass centre ahead: it ends up running straight, with all its energy."""
    m = fx.Model(gravity=(0, 0))
    m.point("P", (0, 0))
    m.angle("heading")
    m.angle("spin", fixed=True)
    m.body("sleigh", "P", "heading", mass=2.0, inertia=0.1, offset=(0.3, 0))
    m.planar_wheel("edge", "P", "heading", "spin", radius=1.0)
    m.release("edge.longitudinal")
    m.initial("heading.angle", rate=3.0)
    m.initial("P.x", rate=0.2)
    motion = m.build().simulate(8.0)
    total = motion.energy["total"]
    assert np.ptp(total) < 1e-7 * total[0]
    end = motion[-1]
    assert abs(end.rate("heading.angle")) < 1e-3
    assert abs(end.rate("edge.longitudinal") - np.sqrt(2 * total[0] / 2.0)) < 1e-5


def test_planar_bearing_on_springs_has_the_frequencies_of_its_springs() -> None:
    m = fx.Model(gravity=(0, 0))
    m.point("P", (0.2, 0.1), fixed=True)
    m.angle("p", 0.5, fixed=True)
    m.point("Q", (0.3, 0.1))
    m.angle("q", 0.2)
    m.body("block", "Q", "q", mass=2.0, inertia=0.1)
    m.bearing("mount", "P", "p", "Q", "q")
    m.spring(["mount.along", "mount.across", "mount.angle"], np.diag([800.0, 200.0, 2.5]))
    found = [mode.omega for mode in m.build().vibrations()]
    assert np.allclose(found, [5.0, 10.0, 20.0], rtol=1e-12)
    along = m.build().initial
    assert abs(along["mount.along"]) < 1e-14


def test_rotary_inertia_is_that_of_a_body_without_mass() -> None:
    def top(lone: bool) -> fx.State:
        m = fx.Model()
        m.frame("R0", fixed=True)
        m.frame("R")
        m.point("P", (0, 0, 0), fixed=True)
        six = (0.3, 0.4, 0.5, 0.05, -0.02, 0.01)
        if lone:
            m.rotary_inertia("top", "R", six)
        else:
            m.body("top", "P", "R", mass=1.0, inertia=six)
        m.hinge("joint", "R0", "R", axis=(1, 0, 0))
        m.release("joint.bend1", "joint.bend2")
        spin = m.angular_velocity("R", body_axes=True)
        for axis, rate in zip(("wx", "wy", "wz"), (1.0, 0.1, -0.2), strict=True):
            m.initial(f"{spin}.{axis}", rate=rate)
        return m.build().simulate(0.8)[-1]

    assert np.max(np.abs(top(True).position("R") - top(False).position("R"))) < 1e-9


def test_fixed_point_in_body_axes_measures_along_them() -> None:
    m = fx.Model()
    m.point("P", (0, 0, 0), fixed=True)
    m.frame("R", fx.turn((0, 0, 1), np.pi / 2), fixed=True)
    m.point("Q", (0.3, 0.4, 0.1))
    m.point_mass("bob", "Q", 1.0)
    m.body_point("place", "P", "R", "Q", body_axes=True)
    m.prescribe("place.along", lambda t: 0.1 * t)
    m.prescribe("place.across1", lambda t: 0.2 * t)
    end = m.build().simulate(1.0)[-1]
    assert np.max(np.abs(end.position("Q") - (0.3 - 0.2, 0.4 + 0.1, 0.1))) < 1e-12


def test_wrong_couplings_are_refused_by_name() -> None:
    m = drive()
    with pytest.raises(
        fx.ModelError, match="planar belt 'b': the centres are .* have no common tangent; move them"
    ):
        m.planar_belt("b", "P", "p", "Q", "q", radius_p=0.9, radius_q=0.1)
    with pytest.raises(fx.ModelError, match="planar belt 'b': damping has no effect without a stiffness"):
        m.planar_belt("b", "P", "p", "Q", "q", radius_p=0.1, radius_q=0.1, damping=1.0)
    with pytest.raises(fx.ModelError, match="planar gear 'g': pitch radii 0.1 and -0.1 do not mesh"):
        m.planar_gear("g", "P", "p", "Q", "q", radius_p=0.1, radius_q=-0.1)
    with pytest.raises(
        fx.ModelError, match="planar belt 'c': node 'p' is a planar_angle; it needs a planar_point"
    ):
        m.planar_belt("c", "p", "p", "Q", "q", radius_p=0.1, radius_q=0.1)
    space = fx.Model()
    space.point("A", (0, 0, 0))
    space.frame("R")
    with pytest.raises(fx.ModelError, match="quadric 's': all its coefficients are zero"):
        space.quadric("s", "A")
    with pytest.raises(fx.ModelError, match="rotary inertia 'J': a principal moment .* is negative"):
        space.rotary_inertia("J", "R", (1, -1, 1, 0, 0, 0))
