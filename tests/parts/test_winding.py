"""Deformations that wind: many turns, each counted, whatever the length after which they repeat."""

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose

import flexel as fx
from flexel.derive import Deformation, Element, Frame, Parameter, Point

pytestmark = pytest.mark.usefixtures("cache")


def screw() -> Element:
    """A nut that advances h for each radian of its turn about the x axis."""
    p, r, h = Point("p"), Frame("r"), Parameter("h", 1, "m", "advance per radian")
    turn = 2 * sp.atan2(r.x[1], r.x[0])
    return Element(
        name="screw",
        nodes=(p, r),
        parameters=(h,),
        deformations=(Deformation("advance", "m", p.x[0] - h.symbol * turn, period=2 * sp.pi * h.symbol),),
        doc="advance = x - h angle",
    )


def test_a_screw_of_ones_own_turns_many_times_without_slipping_a_thread() -> None:
    h, inertia, mass = 0.004, 0.002, 3.0
    m = fx.Model(gravity=(-9.81, 0, 0))
    m.point("P", (0, 0, 0))
    m.fix("P.y", "P.z")
    m.frame("ground", fixed=True)
    m.frame("R")
    m.hinge("guide", "ground", "R", axis=(1, 0, 0))
    m.body("nut", "P", "R", mass=mass, inertia=(inertia, inertia, inertia))
    m.element("screw", fx.compile_element(screw()), "P", "R", h=h)
    m.independent("guide.angle")
    m.initial("guide.angle", rate=-40.0)
    motion = m.build().simulate(2.0)
    turned = -40.0 * motion.t - h * mass * 9.81 / (inertia + mass * h**2) * motion.t**2 / 2
    assert abs(turned[-1]) > 24 * np.pi
    assert_allclose(motion["guide.angle"], turned, atol=1e-6)
    assert_allclose(motion["P.x"], h * motion["guide.angle"], atol=1e-11)


@pytest.mark.parametrize("radius", [0.04, 0.1, 0.16])
def test_a_belt_round_a_pulley_that_stands_still_turns_a_planet_many_times(radius: float) -> None:
    """Seen from the arm, the belt runs from one pulley to the other; equal radii only carry the planet round."""
    m = fx.Model(gravity=(0, 0))
    m.point("P", (0, 0), fixed=True)
    m.angle("sun", fixed=True)
    m.angle("arm")
    m.point("Q", (0.5, 0))
    m.angle("planet")
    m.beam("carrier", "P", "arm", "Q", rigid=True)
    m.planar_belt("belt", "P", "sun", "Q", "planet", radius_p=0.1, radius_q=radius)
    m.rotary_inertia("disc", "planet", 0.01)
    m.prescribe("arm.angle", lambda t: 5.0 * t)
    motion = m.build().simulate(4.0)
    assert_allclose(motion["planet.angle"], (1 - 0.1 / radius) * 5.0 * motion.t, atol=1e-10)


def test_an_elastic_belt_forgets_no_turn_of_its_line_of_centres() -> None:
    m = fx.Model(gravity=(0, 0))
    m.point("P", (0, 0), fixed=True)
    m.angle("sun", fixed=True)
    m.angle("arm")
    m.point("Q", (0.5, 0))
    m.angle("planet")
    m.beam("carrier", "P", "arm", "Q", rigid=True)
    m.planar_belt("belt", "P", "sun", "Q", "planet", radius_p=0.1, radius_q=0.04, stiffness=3e4)
    m.rotary_inertia("disc", "planet", 0.01)
    m.prescribe("arm.angle", lambda t: 5.0 * t)
    m.initial("planet.angle", rate=-7.5)
    motion = m.build().simulate(4.0)
    assert_allclose(motion["planet.angle"], -7.5 * motion.t, atol=1e-6)
    assert np.max(np.abs(motion["belt.elongation"])) < 1e-7
