"""A hydraulic cylinder that moves a boom, driven and free."""

import numpy as np
import pytest

from flexel.base.errors import PositionError
from flexel.model import Model


def cylinder(free: bool = False) -> Model:
    """A boom on a hinge lifted by a hydraulic cylinder, a truss whose elongation moves."""
    m = Model(gravity=(0, 0, -9.81))
    O, P, T = m.point("O", (0, 0, 0), fixed=True), m.point("P", (1, 0, 0)), m.point("T", (3, 0, 0))
    G = m.point("G", (0, 0, -1), fixed=True)
    ground, boom = m.frame("ground", fixed=True), m.frame("boom")
    m.hinge("hinge", ground, boom, axis=(0, -1, 0))
    m.beam("inner", O, boom, P)
    m.beam("outer", O, boom, T, mass_per_length=4.0)
    m.truss("cylinder", G, P)
    if free:
        m.independent("cylinder.elongation")
    return m


def boom(e: float, ed: float, edd: float) -> tuple[float, float, float, float]:
    """Angle, rates and force of the cylinder by the law of cosines and virtual work."""
    L = np.sqrt(2.0) + e
    phi = np.arccos((2 - L * L) / 2) - np.pi / 2  # angle at O between OG and OP is φ + 90°
    slope = L / np.cos(phi)  # dφ/dL: L = sqrt(2 + 2 sin φ), L dL = cos φ dφ
    bend = (1 + slope**2 * np.sin(phi)) / np.cos(phi)  # d²φ/dL²: 1 = cos φ φ'' - sin φ φ'²
    rate, acceleration = slope * ed, slope * edd + bend * ed**2
    J, moment = 4.0 * 27 / 3, 12.0 * 9.81 * 1.5 * np.cos(phi)
    return phi, rate, acceleration, (J * acceleration + moment) * slope


def test_hydraulic_cylinder_moves_the_boom_and_its_force_follows_from_virtual_work() -> None:
    m = cylinder()
    m.prescribe("cylinder.elongation", lambda t: 0.25 * np.sin(2 * t) * t)
    motion = m.build().simulate(1.2, samples=25)
    for state in motion:
        t = state.t
        e = 0.25 * t * np.sin(2 * t)
        ed = 0.25 * (np.sin(2 * t) + 2 * t * np.cos(2 * t))
        edd = 0.25 * (4 * np.cos(2 * t) - 4 * t * np.sin(2 * t))
        phi, rate, acceleration, force = boom(e, ed, edd)
        assert abs(state["hinge.angle"] - phi) < 1e-12
        assert abs(state.rate("hinge.angle") - rate) < 1e-11
        assert abs(state.acceleration("hinge.angle") - acceleration) < 1e-10
        assert abs(-state.force("cylinder.elongation") - force) < 1e-9


def test_hydraulic_cylinder_as_a_dof_falls_as_the_boom_does() -> None:
    m = cylinder(free=True)
    m.initial("cylinder.elongation", 0.1, rate=0.0)
    by_cylinder = m.build()
    assert by_cylinder.dynamic == ("cylinder.elongation",)
    state = by_cylinder.initial
    phi = boom(0.1, 0, 0)[0]
    assert abs(state.acceleration("hinge.angle") + 1.5 * 9.81 * np.cos(phi) / 3) < 1e-12
    # oil as a spring: the frequency about equilibrium from the effective stiffness of the cylinder
    m = cylinder()
    m.release("cylinder.elongation")
    m.spring("cylinder.elongation", 1e5)
    s = m.build()
    rest = s.steady()
    force = -rest.force("cylinder.elongation")
    assert abs(force - boom(rest["cylinder.elongation"], 0, 0)[3]) < 1e-8
    w = s.linearize(rest).eigenvalues()
    e, phi = rest["cylinder.elongation"], rest["hinge.angle"]
    arm = np.cos(phi) / (np.sqrt(2.0) + e)  # dL/dφ
    second = (-np.sin(phi) - arm**2) / (np.sqrt(2.0) + e)  # d²L/dφ²
    stiffness = 1e5 * arm**2 - force * second - 12 * 9.81 * 1.5 * np.sin(phi)
    assert abs(np.max(w.imag) / np.sqrt(stiffness / 36.0) - 1) < 1e-11


def test_a_cylinder_cannot_be_driven_farther_than_the_boom_reaches() -> None:
    m = cylinder()
    m.prescribe("cylinder.elongation", lambda t: 0.5 * t)  # the boom points straight up at e = 2 - √2
    with pytest.raises(PositionError, match=r"cylinder\.elongation|hinge|position"):
        m.build().simulate(2.0)
