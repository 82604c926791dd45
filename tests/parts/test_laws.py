"""Laws: springs by numbers and by formula, preload, damping, viscous slip; their stress, energy and tangents."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy
from mechanisms import slider

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, FlexelError, IncompleteWarning
from flexel.derive.check.joins import check_law_joins
from flexel.parts.model import Model


def test_duffing_spring_vibrates_with_its_tangent_stiffness_at_the_preloaded_state() -> None:
    k1, k3, mass = 200.0, 3e4, 2.0
    for force in (0.0, 10.0, -35.0):
        m = slider(mass, force)
        m.law("strut.elongation", lambda e, ed: k1 * e + k3 * e**3)
        s = m.build()
        rest = s.equilibrium()
        e = rest["strut.elongation"]
        assert abs(k1 * e + k3 * e**3 - force) < 1e-10
        assert abs(rest.force("strut.elongation") - force) < 1e-10
        w = s.linearize(rest).eigenvalues()
        assert np.max(np.abs(np.abs(w) - np.sqrt((k1 + 3 * k3 * e**2) / mass))) < 1e-10
        assert np.max(np.abs(s.steady().x - rest.x)) < 1e-11


def test_duffing_spring_conserves_energy() -> None:
    m = slider()
    m.law("strut.elongation", lambda e, ed: 200 * e + 3e4 * e**3)
    m.initial("strut.elongation", 0.1)
    motion = m.build().simulate(2.0, samples=41, rtol=1e-10, atol=1e-12)
    E, e = motion.energy, motion["strut.elongation"]
    assert np.max(np.abs(E["strain"] - (100 * e**2 + 7500 * e**4))) < 1e-11
    assert np.ptp(E["total"]) < 1e-8 * E["total"][0]
    assert np.max(E["kinetic"]) > 0.9 * E["total"][0]


def test_rate_in_a_formula_enters_damping_and_stiffness() -> None:
    """A progressive damper, σ = k e + c (1 + e²) ė: the tangents depend on the state."""
    k, c, mass = 50.0, 3.0, 2.0
    m = slider(mass)
    m.law("strut.elongation", lambda e, ed: k * e + c * (1 + 20 * e**2) * ed)
    s = m.build()
    state = s.state_at({"strut.elongation": 0.3}, {"strut.elongation": 0.7})
    lin = s.linearize(state)
    assert abs(lin.C[0, 0] - c * (1 + 20 * 0.09)) < 1e-12
    assert abs(lin.K[0, 0] - (k + c * 40 * 0.3 * 0.7)) < 1e-12
    assert abs(state.acceleration("strut.elongation") + (k * 0.3 + c * (1 + 20 * 0.09) * 0.7) / mass) < 1e-12


def test_formula_equals_the_linear_spring() -> None:
    found = []
    for formula in (True, False):
        m = slider()
        if formula:
            m.law("strut.elongation", lambda e, ed: 3 + 80 * e + 1.5 * ed)
        else:
            m.spring("strut.elongation", 80.0, 1.5, preload=3.0)
        m.initial("strut.elongation", 0.2, rate=-1.0)
        s = m.build()
        motion = s.simulate(1.0, samples=5)
        lin = s.linearize()
        found.append([*motion["strut.elongation"], *motion.energy["total"], lin.K[0, 0], lin.C[0, 0]])
    assert np.max(np.abs(np.array(found[0]) - found[1])) < 1e-10


def test_stop_by_piecewise_has_the_energy_of_its_spring() -> None:
    gap, k = 0.1, 5000.0
    m = slider()
    m.law("strut.elongation", lambda e, ed: sympy.Piecewise((k * (e - gap), e > gap), (0, True)))
    m.initial("strut.elongation", rate=1.0)
    motion = m.build().simulate(0.3, samples=31, rtol=1e-10, atol=1e-12)
    assert np.ptp(motion.energy["total"]) < 1e-6
    half = np.pi * np.sqrt(2.0 / k)  # in contact for half a period, then back with the same speed
    assert motion.t[-1] > gap + half
    assert abs(motion[-1].rate("strut.elongation") + 1.0) < 1e-6
    assert abs(motion[-1]["strut.elongation"] - (gap - (0.3 - gap - half))) < 1e-6


def test_stated_energy_is_used() -> None:
    m = slider()
    m.law(
        "strut.elongation", lambda e, ed: sympy.tanh(5 * e), energy=lambda e: sympy.log(sympy.cosh(5 * e)) / 5
    )
    m.initial("strut.elongation", 0.3)
    state = m.build().initial
    assert abs(state.energy.strain - np.log(np.cosh(1.5)) / 5) < 1e-14
    assert abs(state.force("strut.elongation") - np.tanh(1.5)) < 1e-14


def test_two_formulas_in_one_model_keep_apart() -> None:
    m = Model()
    m.point("O", (0, 0, 0), fixed=True)
    for i, name in enumerate(("A", "B", "C"), 1):
        m.point(name, (i, 0, 0))
        m.fix(f"{name}.y", f"{name}.z")
        m.point_mass(f"m{name}", name, 1.0)
    m.truss("t1", "O", "A")
    m.truss("t2", "A", "B")
    m.truss("t3", "B", "C")
    m.law("t1.elongation", lambda e, ed: 2 * e)
    m.law("t2.elongation", lambda e, ed: 3 * e + e**3)
    m.law("t3.elongation", lambda e, ed: 2 * e)
    m.independent("t1.elongation", "t2.elongation", "t3.elongation")
    m.initial("t1.elongation", 0.1)
    m.initial("t2.elongation", 0.2)
    m.initial("t3.elongation", -0.3)
    state = m.build().initial
    stress = [state.force(f"t{i}.elongation") for i in (1, 2, 3)]
    assert np.max(np.abs(np.array(stress) - [0.2, 0.608, -0.6])) < 1e-14


def test_formulas_are_compiled_and_verified_once(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    for number in (1.25, 1.25, 2.5):
        m = slider()
        m.law("strut.elongation", lambda e, ed, k=number: k * e + sympy.sin(e))
        m.build()
    assert len(list(tmp_path.rglob("*.so"))) == 1
    assert len(list(tmp_path.rglob("*.verified"))) == 2  # one for each number


@pytest.mark.parametrize("planar", [True, False])
def test_torsional_spring_counts_turns(planar: bool) -> None:
    """A wound spring: the energy after three turns is that of the whole angle."""
    m = Model()
    if planar:
        m.point("O", (0, 0), fixed=True)
        m.angle("R0", fixed=True)
        m.angle("R1")
        m.hinge("shaft", "R0", "R1", stiffness=0.2)
        m.body("rotor", "O", "R1", mass=1.0, inertia=0.5)
    else:
        m.point("O", (0, 0, 0), fixed=True)
        m.frame("R0", fixed=True)
        m.frame("R1")
        m.hinge("shaft", "R0", "R1", axis=(0, 0, 1), stiffness=0.2)
        m.body("rotor", "O", "R1", mass=1.0, inertia=(0.4, 0.3, 0.5))
    m.independent("shaft.angle")
    m.initial("shaft.angle", rate=12.0)
    motion = m.build().simulate(8.0, samples=33)
    w = np.sqrt(0.2 / 0.5)
    assert np.max(np.abs(motion["shaft.angle"] - 12.0 / w * np.sin(w * motion.t))) < 1e-6
    assert np.max(motion["shaft.angle"]) > 6 * np.pi - 1
    assert np.max(np.abs(motion.energy["strain"] - 0.1 * motion["shaft.angle"] ** 2)) < 1e-9
    assert np.ptp(motion.energy["total"]) < 1e-6


def test_coupled_linear_law_has_its_matrix() -> None:
    m = Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("R0", fixed=True)
    m.frame("R1")
    m.hinge("joint", "R0", "R1", axis=(0, 0, 1))
    m.body("plate", "O", "R1", mass=1.0, inertia=(0.4, 0.3, 0.5))
    names = ["joint.angle", "joint.bend1", "joint.bend2"]
    S = np.array([[5.0, 1.0, 0.5], [1.0, 4.0, -0.3], [0.5, -0.3, 6.0]])
    D = 0.01 * S @ S
    preload = np.array([0.3, -0.1, 0.2])
    m.spring(names, S, D, preload=preload)
    m.independent(*names)
    s = m.build()
    e, ed = np.array([0.1, 0.02, -0.03]), np.array([0.2, -0.1, 0.3])
    pairs = (dict(zip(names, values.tolist(), strict=True)) for values in (e, ed))
    state = s.state_at(*pairs)
    stress = np.array([state.force(name) for name in names])
    assert np.max(np.abs(stress - (preload + S @ e + D @ ed))) < 1e-12
    assert abs(state.energy.strain - (preload @ e + e @ S @ e / 2)) < 1e-13
    rest = s.equilibrium()
    found = np.array([rest[name] for name in names])
    assert np.max(np.abs(preload + S @ found)) < 1e-10


def test_a_law_outside_its_domain_is_named() -> None:
    m = slider()
    m.law("strut.elongation", lambda e, ed: sympy.sqrt(e + 0.05), energy=lambda e: (e + 0.05) ** 1.5 / 1.5)
    m.initial("strut.elongation", 0.2, rate=-3.0)
    s = m.build()
    with pytest.raises(FlexelError, match=r"force was not finite.*formulas \(on 'strut\.elongation'\)"):
        s.simulate(1.0)
    with pytest.raises(
        DynamicsError, match=r"stress of 'strut\.elongation'.*not finite.*start within its range"
    ):
        s.state_at({"strut.elongation": -0.1})


@pytest.mark.parametrize("analysis", ["linearize", "steady", "equilibrium", "vibrations"])
def test_a_law_without_a_tangent_is_named(analysis: str) -> None:
    m = slider()
    m.law("strut.elongation", lambda e, ed: 100 * sympy.sqrt(e))
    with pytest.raises(DynamicsError, match=r"tangent of the law on 'strut\.elongation'.*is not finite"):
        getattr(m.build(), analysis)()


def test_a_static_path_that_leads_to_where_a_law_has_no_tangent_keeps_what_it_reached() -> None:
    m = slider()
    m.load("A.x", lambda t: 10.0 * (1.0 - t))
    m.law("strut.elongation", lambda e, ed: 100 * sympy.sqrt(e))
    m.initial("strut.elongation", 0.01)
    with pytest.warns(IncompleteWarning, match=r"path stopped .*'strut\.elongation'"):
        motion = m.build().static_path(t_end=2.0)
    assert len(motion) > 2
    assert motion["strut.elongation"] == pytest.approx(((1 - motion.t) / 10) ** 2, abs=1e-9)


def test_a_law_that_is_infinite_at_the_start_is_named() -> None:
    m = slider()
    m.law("strut.elongation", lambda e, ed: sympy.log(e), energy=lambda e: e * sympy.log(e) - e)
    with pytest.raises(DynamicsError, match=r"stress of 'strut\.elongation' at t = 0 s is not finite"):
        m.build().simulate(0.1)


E, ED = sympy.symbols("e ed", real=True)


@pytest.mark.parametrize(
    "formula",
    [
        sympy.Piecewise((0, E < 0.07), (3e4 * E - 3e4 * 0.07, True)),  # joins up to rounding
        sympy.Piecewise((E, E < 0), (2 * E, E >= 0)),
        sympy.Piecewise((sympy.sqrt(E), E > 0), (0, True)),  # steep
        sympy.Piecewise((E, E < sympy.sqrt(2)), (2 * E - sympy.sqrt(2), True)),
        E * sympy.sign(E) + sympy.Heaviside(ED) * ED,
        sympy.log(E) + sympy.Piecewise((E, E < 0), (2 * E, True)),
    ],
)
def test_pieces_that_join_are_not_a_jump(formula: Any) -> None:
    check_law_joins("law on 'strut.elongation'", formula)


def history(m: Model) -> Array:
    values: Any = m.build().simulate(0.4, samples=5)["strut.elongation"]
    return np.asarray(values)


def test_dashpot_alone_makes_the_truss_free() -> None:
    m = slider()
    m.spring("strut.elongation", 0.0, damping=5.0)
    m.initial("strut.elongation", rate=1.0)
    t = np.linspace(0, 0.4, 5)
    assert np.max(np.abs(history(m) - 2 / 5 * (1 - np.exp(-2.5 * t)))) < 1e-9


@pytest.mark.parametrize("power", [1.5, sympy.Rational(3, 2)])
def test_a_stone_on_a_hertzian_contact_sinks_by_the_two_thirds_power_of_its_weight(power: Any) -> None:
    k = 1e4
    m = Model(gravity=(0, 0, -9.81))
    m.point("ground", (0, 0, 0), fixed=True)
    m.point("stone", (0, 0, 0.1))
    m.fix("stone.x", "stone.y")
    m.point_mass("mass", "stone", 1.0)
    m.truss("gap", "ground", "stone")
    m.law("gap.elongation", lambda e, ed: -k * sympy.Max(-e, 0) ** power)
    s = m.build()
    assert s.equilibrium()["stone.z"] == pytest.approx(0.1 - (9.81 / k) ** (2 / 3), rel=1e-13)
    apart = s.state_at({"gap.elongation": 0.01})
    assert apart.force("gap.elongation") == 0.0


def test_signs_of_parameters_of_elements_are_checked() -> None:
    """Of a bar with a negative mass, in a model and among variants."""
    m = fx.Model()
    m.point("A", (0, 0, 0), fixed=True)
    m.point_mass("x", m.point("B", (1, 0, 0)), 5.0)
    with pytest.raises(fx.ModelError, match=r"truss 'b': parameter rhoA -2 is negative"):
        m.element("b", "truss", "A", "B", l0=1.0, rhoA=-2.0)
        m.build()
    m = fx.Model()
    m.point("A", (0, 0, 0), fixed=True)
    m.element("b", "truss", "A", m.point("B", (1, 0, 0)), l0=1.0, rhoA=2.0)
    with pytest.raises(fx.ModelError, match=r"with_parameters.*'b': parameter rhoA -1 is negative"):
        m.build().with_parameters({"b.rhoA": -1.0})
