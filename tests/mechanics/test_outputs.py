"""Outputs of elements at arbitrary states, against closed forms: section forces, shear angles, lines, and a user's own.

The forces at both ends of a beam are in equilibrium for any coordinates and stresses, because its deformations do not
change when it moves as a rigid body; what a section transmits is work per displacement.
"""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy as sp

import flexel as fx
from flexel.base.quaternions import matrix, product
from flexel.derive import Deformation, Element, Frame, Let, Output, Parameter, Point, Slip
from flexel.derive.declare.rotation import triad
from flexel.model.state import State

LENGTH, EI = 0.7, {"EIy": 3.0, "EIz": 2.0}
SHEAR = {"GAy": 5.0, "GAz": 4.0}
BEAMS: dict[str, dict[str, Any]] = {
    "classic": {},
    "shear": SHEAR,
    "first order": {"second_order": False, **SHEAR},
    "logarithmic": {"rotations": "logarithmic", **SHEAR},
    "warping": {"EIw": 0.1, "warping": True, "warping_inertia_per_length": 0.3, **SHEAR},
}
PLANAR = ["classic", "shear", "first order", "logarithmic"]


def beam(kind: str, planar: bool = False) -> State:
    """An oblique beam at random coordinates, with random stresses."""
    m, options = fx.Model(), dict(BEAMS[kind])
    ends = np.zeros(3), LENGTH * np.array([0.6, 0.8, 0.0])
    if options.pop("warping", False):
        options["warping"] = m.warping("W"), m.warping("V")
    for i, end in enumerate(ends):
        m.point(f"P{i}", end[:2] if planar else end)
        (m.angle if planar else m.frame)(f"R{i}")
    if planar:
        options.pop("GAz", None)
    bending = {"EIz": EI["EIz"]} if planar else {**EI, "GJ": 1.5, "direction": (0, 0, 1)}
    m.beam("b", "P0", "R0", "P1", "R1", EA=20.0, **bending, **options, mass_per_length=1.0)
    m.body("end", "P1", "R1", mass=1.0, inertia=1.0 if planar else (1.0, 1.0, 1.0))
    m.body("start", "P0", "R0", mass=1.0, inertia=1.0 if planar else (1.0, 1.0, 1.0))
    return displaced(m.build().initial)


def displaced(state: State) -> State:
    """The state with other coordinates, their deformations, and other stresses; Euler parameters keep their norm."""
    rng = np.random.default_rng(7)
    x, s = state.x + 0.2 * rng.standard_normal(state.x.size), state.structure
    for node in s.nodes:
        if node.kind == "frame":
            x[s.places(node.name)] /= np.linalg.norm(x[s.places(node.name)])
    e, _ = state.evaluation.position(x)
    return replace(state, x=x, e=e, stresses=rng.standard_normal(state.stresses.size))


def axes(state: State, end: int) -> np.ndarray:
    """The section's axes (3, 3) at an end, in columns."""
    p, at = state.structure.element("b").parameters, state.position(f"R{end}")
    if at.size == 4:
        return matrix(product(at, p["tq" if end else "tp"]))
    angle = at[0] + p["alphaq0" if end else "alpha0"][0]
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def place(state: State, node: str) -> np.ndarray:
    return np.append(state.position(node), 0.0)[:3]


CASES = [(kind, False) for kind in BEAMS] + [(kind, True) for kind in PLANAR]


@pytest.mark.parametrize(("kind", "planar"), CASES)
def test_section_forces_at_both_ends_are_in_equilibrium(kind: str, planar: bool) -> None:
    """F_q = F_p and M_q + (x_q - x_p) x F = M_p, in global axes; statics."""
    state = beam(kind, planar)
    ends = state.section_forces("b")
    F = [axes(state, i) @ (end.N, end.Vy, end.Vz) for i, end in enumerate(ends)]
    M = [axes(state, i) @ (end.T, end.My, end.Mz) for i, end in enumerate(ends)]
    arm = place(state, "P1") - place(state, "P0")
    assert np.linalg.norm(F[0]) > 0.1
    np.testing.assert_allclose(F[1], F[0], rtol=0, atol=1e-13)
    np.testing.assert_allclose(M[1] + np.cross(arm, F[1]), M[0], rtol=0, atol=1e-13)


@pytest.mark.parametrize(("kind", "planar"), CASES)
def test_section_forces_do_the_work_of_the_stresses(kind: str, planar: bool) -> None:
    """De v . sigma of any rates v is the power of force and moment at q less that at p."""
    state, rng = beam(kind, planar), np.random.default_rng(3)
    s, ends = state.structure, state.section_forces("b")
    rows = [s.index[name] for name in s.element("b").deformations]
    v, power = np.zeros(state.x.size), 0.0
    for i, (end, sign) in enumerate(zip(ends, (-1, 1), strict=True)):
        velocity, spin = rng.standard_normal((2, 3))
        if planar:
            velocity[2], spin[:2] = 0.0, 0.0
        R, frame = axes(state, i), state.position(f"R{i}")
        v[s.places(f"P{i}")] = velocity[: state.position(f"P{i}").size]
        v[s.places(f"R{i}")] = spin[2:] if planar else product(np.append(0.0, spin), frame) / 2
        power += sign * (velocity @ R @ (end.N, end.Vy, end.Vz) + spin @ R @ (end.T, end.My, end.Mz))
        if kind == "warping":
            rate = rng.standard_normal()
            v[s.places("WV"[i])] = rate
            power += sign * rate * end.B
    assert state.stresses[rows] @ (state.J[rows] @ v) == pytest.approx(power, abs=1e-13)


@pytest.mark.parametrize(("end", "sign"), [(0, -1), (1, 1)])
def test_planar_section_forces_are_those_of_the_first_order_formula(end: int, sign: int) -> None:
    """e = (l - l0, l0 ey_p.el, -l0 ey_q.el), differentiated by hand."""
    state = beam("first order", planar=True)
    found, s = state.section_forces("b")[end], state.structure
    tension, *bends = (state.stresses[s.index[f"b.{name}"]] for name in ("elongation", "bend1", "bend2"))
    d = place(state, "P1") - place(state, "P0")
    length = np.linalg.norm(d)
    el, Rs = d / length, [axes(state, i) for i in (0, 1)]
    force = tension * el
    for bend, R, side in zip(bends, Rs, (1, -1), strict=True):
        force = force + side * bend * LENGTH / length * (R[:, 1] - (R[:, 1] @ el) * el)
    moment = LENGTH * bends[end] * (Rs[end][:, 0] @ el)
    expected = Rs[end].T @ force
    np.testing.assert_allclose((found.N, found.Vy, found.Vz), expected, rtol=0, atol=1e-13)
    assert (found.T, found.My, found.Mz) == pytest.approx((0, 0, moment), abs=1e-13)


@pytest.mark.parametrize(
    ("kind", "planar"), [(k, p) for k, p in CASES if k not in ("classic", "logarithmic")]
)
def test_the_shear_angle_is_the_shear_force_over_the_stiffness(kind: str, planar: bool) -> None:
    """Of the elastic stresses of bending, sigma_p - sigma_q is the shear force of a straight beam; both planes."""
    state = beam(kind, planar)
    s, numbers = state.structure, s_numbers(state)
    e, _ = state.evaluation.position(state.x)
    square = 0.0
    for first, second, EI_, GA in ((0, 1, "EIy", "GAz"), (2, 3, "EIz", "GAy")):
        if planar and GA == "GAz":
            continue
        first, second = (0, 1) if planar else (first, second)
        rows = [s.index[f"b.bend{k + 1}"] for k in (first, second)]
        P = 12 * numbers[EI_] / (numbers[GA] * LENGTH**2)
        V = 6 * numbers[EI_] / ((1 + P) * LENGTH**3) * (e[rows[0]] - e[rows[1]])
        square += (V / numbers[GA]) ** 2
    assert state.outputs("b")["shear_angle"][0] == pytest.approx(np.sqrt(square), rel=1e-13)


def s_numbers(state: State) -> dict[str, float]:
    """The parameters of the beam that are single numbers."""
    return {
        k: float(values[0])
        for k, values in state.structure.element("b").parameters.items()
        if values.size == 1
    }


def test_no_shear_is_no_angle() -> None:
    assert beam("classic").outputs("b")["shear_angle"][0] < 1e-140


@pytest.mark.parametrize(("kind", "planar"), CASES)
def test_the_axis_is_the_cubic_through_the_ends(kind: str, planar: bool) -> None:
    """Hermite's interpolation by another formula: Bernstein's polynomials of four control points."""
    state = beam(kind, planar)
    found = state.outputs("b")
    p, q = place(state, "P0"), place(state, "P1")
    ex = [LENGTH / 3 * axes(state, i)[:, 0] for i in (0, 1)]
    xi = np.linspace(0, 1, 17)[:, None]
    rest = 1 - xi
    line = rest**3 * p + 3 * rest**2 * xi * (p + ex[0]) + 3 * rest * xi**2 * (q - ex[1]) + xi**3 * q
    size = 2 if planar else 3
    np.testing.assert_allclose(found["axis"], line[:, :size], rtol=0, atol=1e-15)
    np.testing.assert_allclose(
        found["across"], [axes(state, i)[:size, 1] for i in (0, 1)], rtol=0, atol=1e-15
    )


def test_many_states_give_the_same_bits_as_each_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """In calls of any size."""
    state = beam("shear")
    s, rng = state.structure, np.random.default_rng(5)
    x, e = state.x + 0.1 * rng.standard_normal((23, s.n)), rng.standard_normal((23, s.m))
    stresses = rng.standard_normal((23, s.m + s.k))
    elements = [s.element("b")] * 3
    whole = state.evaluation.outputs(elements, x, e, stresses)
    monkeypatch.setattr("flexel.engine.outputs.AT_ONCE", 5)
    parts = state.evaluation.outputs(elements, x, e, stresses)
    for i in (0, 11, 22):
        alone = replace(state, x=x[i], e=e[i], stresses=stresses[i]).outputs("b")
        for name, values in alone.items():
            assert np.array_equal(whole[name][i, 2], values)
            assert np.array_equal(parts[name][i, 0], values)


def own_element() -> Element:
    """A guide with a slider: reports the force across, the place of a tip on the body, and a line there."""
    p, r = Point("p"), Frame("r")
    arm = Parameter("arm", 1, "m", "length of the arm")
    let = Let()
    ex = let.vector("ex", triad(r.x)[0])
    tip = p.x + arm.symbol * ex
    height = Deformation("height", "m", tip[2])
    slip = Slip("along", "m/s", p.v.dot(ex), free=True)
    return Element(
        "own_guide",
        (p, r),
        (arm,),
        let.entries,
        (height,),
        (slip,),
        doc="height of a tip",
        outputs=(
            Output("tip", "m", sp.Matrix([tip]).reshape(1, 3), draws="mass"),
            Output("arm_line", "m", sp.Matrix.hstack(p.x, tip).T, draws="rim"),
            Output("lever", "N m", height.stress * arm.symbol * sp.sqrt(ex[0] ** 2 + ex[1] ** 2)),
            Output("pull", "N", p.f),
        ),
    )


def test_a_users_element_reports_what_it_declares() -> None:
    """Forces on its node are De' sigma + V' tau: sigma upwards, tau along the arm; closed form."""
    compiled = fx.compile_element(own_element())
    m = fx.Model()
    m.point("P", (0.1, 0.2, 0.0))
    m.frame("R")
    m.element("mine", compiled, "P", "R", arm=0.5)
    m.body("body", "P", "R", mass=1.0, inertia=(1.0, 1.0, 1.0))
    state = displaced(m.build().initial)
    found, s = state.outputs("mine"), state.structure
    sigma, tau = (state.stresses[s.index[f"mine.{name}"]] for name in ("height", "along"))
    ex = matrix(state.position("R"))[:, 0]
    np.testing.assert_allclose(found["tip"], [state.position("P") + 0.5 * ex], rtol=0, atol=1e-15)
    np.testing.assert_allclose(
        found["arm_line"], [state.position("P"), state.position("P") + 0.5 * ex], rtol=0, atol=1e-15
    )
    assert found["lever"] == pytest.approx([0.5 * sigma * np.hypot(*ex[:2])], rel=1e-14)
    np.testing.assert_allclose(found["pull"], sigma * np.array([0, 0, 1]) + tau * ex, rtol=0, atol=1e-15)


def test_an_element_without_outputs_reports_nothing_and_an_unknown_one_is_named() -> None:
    state = beam("classic")
    assert state.outputs("R0") == {}
    with pytest.raises(fx.ModelError, match="unknown element 'bb'; did you mean b"):
        state.outputs("bb")
