"""Planar models: the same mechanics as spatial ones in the plane z = 0, and the flexible slider-crank of SPACAR.

The slider-crank is `tests/data/slider_crank.dat`, the example of the SPACAR manual (2000), section 5.7, built by hand.
Its state at t = 5 s was computed once more with tight tolerances (an independent program, eight digits).
"""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from flexel.base.arrays import Array
from flexel.base.errors import UnsteadyWarning
from flexel.base.quaternions import turn
from flexel.parts.model import Model
from flexel.results.system_facade import System

DATA = Path(__file__).parent.parent / "data"
PLANAR_MODES = {"elongation": "elongation", "bend1": "bend3", "bend2": "bend4"}  # e1, e2, e3 are e1, e5, e6


def place(planar: bool, *xy: float) -> tuple[float, ...]:
    """A point of the plane, in the plane or in space."""
    return xy if planar else (*xy, 0.0)


def frame(m: Model, planar: bool, name: str, angle: float = 0.0, fixed: bool = False) -> None:
    """An orientation node, turned about z."""
    if planar:
        m.angle(name, angle, fixed=fixed)
    else:
        m.frame(name, turn((0, 0, 1), angle), fixed=fixed)


def hinge(m: Model, planar: bool, name: str, p: str, q: str, **options: Any) -> None:
    m.hinge(name, p, q, **options) if planar else m.hinge(name, p, q, axis=(0, 0, 1), **options)


def vector(planar: bool, *xy: float) -> tuple[float, ...]:
    return place(planar, *xy)


def arm(planar: bool, second_order: bool = True) -> System:
    """A flexible arm of two elements on a sprung hinge, with a body at its tip: every planar element but the truss."""
    m = Model(gravity=vector(planar, 2.0, -9.0))
    m.point("O", place(planar, 0.1, 0.2), fixed=True)
    m.point("A", place(planar, 0.6, 0.5))
    m.point("B", place(planar, 1.0, 1.0))
    m.point("C", place(planar, 1.3, 0.8))
    frame(m, planar, "ground", 0.3, fixed=True)
    for i, angle in enumerate((-0.4, 0.2, 1.1)):
        frame(m, planar, f"r{i}", angle)
    hinge(m, planar, "hub", "ground", "r0", stiffness=30.0, damping=0.4)
    inertia = {"mass_per_length": 2.0, "inertia_per_length": 0.03 if planar else (0.05, 0.04, 0.03)}
    section = {"EA": 900.0, "EIz": 20.0, "GAy": 300.0, "damping": 0.001}
    for i, (p, q) in enumerate((("O", "A"), ("A", "B"))):
        ends, lie = (p, f"r{i}", q, f"r{i + 1}"), in_plane(m, planar, p, q)
        m.beam(f"b{i}", *ends, **section, **inertia, **lie, second_order=second_order)
    heavy = {"mass_per_length": 1.5, "inertia_per_length": 0.02 if planar else (0.1, 0.3, 0.02)}
    m.beam("link", "B", "r2", "C", **heavy, **in_plane(m, planar, "B", "C"))
    J = 0.3 if planar else (0.2, 0.15, 0.3)
    m.body("tool", "C", "r2", mass=0.7, inertia=J, offset=vector(planar, 0.1, -0.05))
    m.point_mass("nut", "A", 0.4)
    m.load("C", vector(planar, 3.0, 5.0))
    m.load("hub.angle", lambda t: 2.0 * np.sin(5 * t))
    modes = PLANAR_MODES if planar else {mode: mode for mode in PLANAR_MODES.values()}
    m.independent("hub.angle", *(f"b{i}.{mode}" for i in range(2) for mode in modes))
    m.initial("hub.angle", rate=1.5)
    return m.build()


def in_plane(m: Model, planar: bool, p: str, q: str) -> dict[str, Array]:
    """Direction of the section's y axis for a spatial beam: in the plane, so that its z axis is the normal."""
    return {} if planar else {"direction": np.cross([0, 0, 1], m.nodes[q].x0 - m.nodes[p].x0)}


@pytest.fixture(scope="module", params=[True, False], ids=["second order", "first order"])
def arms(request: pytest.FixtureRequest) -> tuple[System, System]:
    return arm(True, request.param), arm(False, request.param)


def test_planar_arm_has_the_equations_of_the_spatial_one(arms: tuple[System, System]) -> None:
    plane, space = arms
    one, other = plane.linearize(), space.linearize()
    for a, b in ((one.M, other.M), (one.C, other.C), (one.K, other.K)):
        assert np.max(np.abs(a - b)) < 1e-12 * np.max(np.abs(b))
    assert abs(plane.initial.energy.total - space.initial.energy.total) < 1e-12


def test_planar_arm_moves_as_the_spatial_one(arms: tuple[System, System]) -> None:
    shapes = (
        {"b0.elongation": 0.002, "b0.bend1": 0.05, "b1.bend2": -0.03},
        {"b0.elongation": 0.002, "b0.bend3": 0.05, "b1.bend4": -0.03},
    )
    start = [s.state_at(shape) for s, shape in zip(arms, shapes, strict=True)]
    plane, space = (s.simulate(0.1, start=initial, samples=4) for s, initial in zip(arms, start, strict=True))
    for node in "ABC":
        assert np.max(np.abs(plane.position(node) - space.position(node)[:, :2])) < 1e-8
        assert np.max(np.abs(space.position(node)[:, 2])) < 1e-12
    for i in range(2):
        for flat, solid in PLANAR_MODES.items():
            e = plane[f"b{i}.{flat}"] - space[f"b{i}.{solid}"]
            assert np.max(np.abs(e)) < 1e-8, (flat, solid)
            stress = plane.force(f"b{i}.{flat}") - space.force(f"b{i}.{solid}")
            assert np.max(np.abs(stress)) < 1e-5
    for component in "xy":
        assert np.max(np.abs(plane.force(f"O.{component}") - space.force(f"O.{component}"))) < 1e-5
    assert np.max(np.abs(plane["hub.angle"] - space["hub.angle"])) < 1e-8


@pytest.mark.parametrize("planar", [True, False])
def test_bending_is_positive_towards_the_normal_of_the_plane(planar: bool) -> None:
    """Both ends turned by +a about z: e_y^p·e_l = -sin a, so the first bending mode is -sin a, the second +sin a."""
    m = Model()
    m.point("P", place(planar, 0, 0), fixed=True)
    m.point("Q", place(planar, 2, 0), fixed=True)
    frame(m, planar, "RP")
    frame(m, planar, "RQ")
    inertia = {"mass_per_length": 1.0, "inertia_per_length": 0.1 if planar else (0.1, 0.1, 0.1)}
    section = {"EA": 1.0, "EIz": 1.0} | ({} if planar else {"GJ": 1.0, "EIy": 1.0})
    ends = ("P", "RP", "Q", "RQ")
    m.beam("b", *ends, **section, **inertia, **in_plane(m, planar, "P", "Q"), second_order=False)
    s = m.build()
    x = s.initial.x.copy()
    for name in ("RP", "RQ"):
        x[s.structure.places(name)] = 0.1 if planar else turn((0, 0, 1), 0.1)
    e = s.evaluation.position(x)[0]
    first, second = (
        s.structure.find(f"b.{mode}") for mode in (("bend1", "bend2") if planar else ("bend3", "bend4"))
    )
    assert abs(e[first] + 2 * np.sin(0.1)) < 1e-14
    assert abs(e[second] - 2 * np.sin(0.1)) < 1e-14


@pytest.mark.parametrize("planar", [True, False])
def test_four_bar_of_rigid_links_and_a_prescribed_truss(planar: bool) -> None:
    """A crane: an arm lifted by a cylinder; the angle follows from the triangle's sides."""
    m = Model(gravity=vector(planar, 0, -9.81))
    m.point("O", place(planar, 0, 0), fixed=True)
    m.point("G", place(planar, 1, 0), fixed=True)
    m.point("T", place(planar, 0, 1.2))
    frame(m, planar, "ground", fixed=True)
    frame(m, planar, "arm")
    hinge(m, planar, "pivot", "ground", "arm")
    m.beam("boom", "O", "arm", "T", mass_per_length=3.0)
    m.truss("cylinder", "G", "T")
    drawn = np.hypot(1, 1.2)
    m.prescribe("cylinder.elongation", lambda t: -0.3 * t)
    s = m.build()
    assert s.counts["degrees_of_freedom"] == 0
    motion = s.simulate(1.0, samples=11)
    length = drawn - 0.3 * motion.t
    cosine = (1 + 1.2**2 - length**2) / (2 * 1.2)  # angle of the boom at O
    angle = np.pi / 2 - np.arccos(cosine)
    assert np.max(np.abs(motion["pivot.angle"] + angle)) < 1e-12
    rate = -(length * -0.3) / (1.2 * np.sqrt(1 - cosine**2))
    assert np.max(np.abs(motion.rate("pivot.angle") + rate)) < 1e-12
    # virtual work: force times elongation rate = change of kinetic energy + lifting of the boom
    E = motion.energy["total"]
    power = motion.force("cylinder.elongation") * -0.3  # stress of the cylinder, drawn in
    h = motion.t[1]
    work = h / 3 * (power[0] + power[-1] + 4 * power[1:-1:2].sum() + 2 * power[2:-1:2].sum())
    assert abs(E[-1] - E[0] + work) < 1e-4 * abs(work)


# Reference [D]: state at t = 5 s; the file's beams have no second-order terms, and SPACAR's planar bending modes have
# the opposite sign of ours.
SLIDER_CRANK = {
    "2.angle": 7.5,
    "5.angle": -0.44431899,
    "7.angle": -0.4902879,
    "8.x": 0.31683785,
    "9.angle": -0.52788673,
    "2.bend1": -2.66778e-3,
    "2.bend2": -4.22686e-3,
    "3.bend1": -3.64299e-3,
    "3.bend2": -1.99642e-3,
}
PRINTED = {"3.x": 5.199e-2, "3.y": 1.407e-1, "6.x": 1.863e-1, "6.y": 7.383e-2}


def slider_crank(second_order: bool = False) -> System:
    """The file's three beams: a rigid crank and a rod of two flexible elements; nodes keep their numbers."""
    rows = [line.split() for line in (DATA / "slider_crank.dat").read_text().splitlines() if line[0] != "*"]
    number = {(w[0], w[1]): [float(word) for word in w[2:]] for w in rows if len(w) > 2}
    at = {w[1]: (float(w[2]), float(w[3])) for w in rows if w[0] == "X"}
    m = Model()
    m.point("n1", (0, 0), fixed=True)
    for node in ("3", "6", "8"):
        m.point(f"n{node}", at.get(node, (0, 0)))
    m.fix("n8.y")
    for node in "24579":
        m.angle(f"n{node}")
    for w in rows:
        if w[0] != "PLBEAM":
            continue
        stiff = number.get(("ESTIFF", w[1]))
        bend = {"rigid": True} if stiff is None else {"EIz": stiff[1]}
        ends = [f"n{word}" for word in w[2:]]
        rhoA = number["EMASS", w[1]][0]
        m.beam(f"e{w[1]}", *ends, **bend, mass_per_length=rhoA, second_order=second_order)
    m.point_mass("slider", "n8", number["MASS", "8"][0])
    m.prescribe("n2.angle", lambda t: number["XD", "2"][1] * t)
    m.independent("e2.bend1", "e2.bend2", "e3.bend1", "e3.bend2")
    return m.build()


def ours(name: str) -> str:
    """Our name of a quantity: nodes n1…n9, elements e1…e3."""
    return ("e" if "bend" in name else "n") + name


def test_flexible_slider_crank_reaches_the_reference_at_5s() -> None:
    motion = slider_crank().simulate(5.0, samples=2, rtol=1e-8, atol=1e-11)
    end = motion[-1]
    for name, value in SLIDER_CRANK.items():
        digits = 1e-8 if "bend" in name else 5e-8
        assert abs(end[ours(name)] - value) < digits, name
    for name, value in PRINTED.items():
        assert abs(end[ours(name)] / value - 1) < 5e-4, name
    assert motion.drift[-1] < 1e-12


def test_slider_crank_rod_has_the_two_element_frequency() -> None:
    """Song and Haug's rod, time scaled by 100: 832.5 rad/s with two elements, exact 829.2 (pinned, no tip mass)."""
    s = slider_crank()
    EI, rhoA, L = 0.0012723, 0.2225, 0.3
    exact = np.pi**2 * np.sqrt(EI / (rhoA * L**4))
    with pytest.warns(UnsteadyWarning, match="prescribed motions change that"):  # it passes a dead centre
        w = s.linearize(s.state_at(rates=dict.fromkeys(s.dynamic, 0.0), t=0.0)).eigenvalues()
    assert abs(exact * 100 - 829.25) < 0.05
    assert len(w) == 8
    # at a dead centre with the crank held, the rod is pinned at both ends
    held = Model()
    held.point("A", (0.15, 0), fixed=True)
    held.point("M", (0.3, 0))
    held.point("B", (0.45, 0))
    held.fix("B.y")
    for k in range(3):
        held.angle(f"r{k}")
    for k, (p, q) in enumerate((("A", "M"), ("M", "B"))):
        held.beam(f"b{k}", p, f"r{k}", q, f"r{k + 1}", EIz=EI, mass_per_length=rhoA, second_order=False)
    lowest = np.min(np.abs(held.build().linearize().eigenvalues()))
    assert abs(100 * lowest - 832.5) < 0.05
