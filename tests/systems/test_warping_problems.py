"""Beams whose sections warp: the table of closed forms, and what it does not cover."""

from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.apps.view.drawing import shapes
from flexel.examples import warping as example
from flexel.examples import warping_exact as exact
from flexel.examples import warping_table


@pytest.mark.parametrize("part", ["leaf", "torsion", "lateral", "column", "vibration", "limits"])
def test_every_quantity_is_within_its_tolerance(part: str) -> None:
    rows = getattr(warping_table, part)()
    assert rows
    assert {row.name: row.error for row in rows if not row.ok} == {}


def test_the_restraint_of_a_leaf_depends_on_its_length_over_its_width_alone() -> None:
    """As the page says: 10 % at five times the width, 84 % at once the width, whatever the thickness."""
    for thickness in (0.1e-3, 0.5e-3):
        k = exact.decay(fx.Rectangle(20e-3, thickness))
        assert exact.restrained(5 * 20e-3 * k) == pytest.approx(1.10, abs=5e-3)
        assert exact.restrained(20e-3 * k) == pytest.approx(1.84, abs=1e-2)


def cantilever(length: float, **given: Any) -> fx.Model:
    """A beam that warps, clamped at one end."""
    m = fx.Model()
    m.point("P", (0, 0, 0), fixed=True)
    m.point("Q", (length, 0, 0))
    m.frame("R", fixed=True)
    m.frame("S")
    ends = m.warping("W", fixed=True), m.warping("V")
    m.beam("b", "P", "R", "Q", "S", direction=(0, 1, 0), warping=ends, **given)
    return m


def test_a_section_gives_what_its_numbers_give() -> None:
    """Frequencies of a leaf from its section, and from numbers with the same shear stiffness."""
    numbers = example.numbers(exact.LEAF, warping=True)
    k1, k2 = exact.LEAF.shear_factors(0.3)
    GA = exact.STEEL.shear_modulus * exact.LEAF.A
    found = []
    options = {"section": exact.LEAF, "material": exact.STEEL}, numbers | {"GAy": k1 * GA, "GAz": k2 * GA}
    for given in options:
        found.append([mode.omega for mode in cantilever(0.05, **given).build().vibrations()])
    assert found[0] == pytest.approx(found[1], rel=1e-10)
    assert len(found[0]) == 7


def dynamics(warping: bool) -> fx.System:
    """A leaf that swings and twists: on its clamp, with an eccentric mass at its tip."""
    m = example.clamped(exact.LEAF, 0.1, 2, held=(0, 2) if warping else (), warping=warping)
    m.body("tip", "P2", "R2", mass=0.05, inertia=(1e-5, 1e-5, 1e-5), offset=(0.0, 0.02, 0.01))
    m.load("P2", [0.0, 0.2, 0.5])
    return m.build()


@pytest.mark.long
def test_a_motion_keeps_its_energy() -> None:
    motion = dynamics(warping=True).simulate(0.05, samples=11, rtol=1e-9, progress=False)
    total = motion.energy["total"]  # with the potential of the loads
    assert np.ptp(motion["P2.z"]) > 8e-3
    assert np.ptp(total) < 1e-8 * np.ptp(motion.energy["kinetic"])


@pytest.mark.long
def test_the_implicit_method_follows_the_explicit_one() -> None:
    explicit, implicit = (
        dynamics(warping=True).simulate(0.02, samples=5, method=method, rtol=1e-8, progress=False)
        for method in ("DOP853", "generalized-alpha")
    )
    assert implicit["P2.z"] == pytest.approx(explicit["P2.z"], abs=1e-5 * np.max(np.abs(explicit["P2.z"])))


def test_bimoments_balance_across_a_shared_node_and_with_a_load_on_it() -> None:
    m = example.clamped(exact.BEAM, 2.0, 2, held=(0,))
    m.load("W1", 3.0)
    m.load("R2", [10.0, 0, 0])
    state = m.build().equilibrium()
    first, second = state.section_forces("b0"), state.section_forces("b1")
    assert first[1].B == pytest.approx(second[0].B + 3.0, rel=1e-9)
    assert second[1].B == pytest.approx(0.0, abs=1e-9)
    assert [first[0].T, first[1].T, second[0].T] == pytest.approx([10.0] * 3, rel=1e-9)


def test_the_stress_of_a_bimoment_is_that_of_bending_flanges() -> None:
    """At the clamp of an I beam: flanges bend sideways under B/h each, all of the torque by shear far from the end."""
    m = cantilever(0.2, section=exact.BEAM, material="steel")
    m.load("S", [100.0, 0, 0])
    state = m.build().equilibrium()
    b = state.section_forces("b")[0].B
    flange = exact.BEAM.flange * exact.BEAM.width**2 / 6
    tip = exact.BEAM.stresses(state.section_forces("b")[0])[0]
    assert tip.normal == pytest.approx(b / (exact.BEAM.height - exact.BEAM.flange) / flange, rel=1e-6)
    # k l is small: nearly all of the torque is carried by the flanges' bending, B = T l
    assert b == pytest.approx(100.0 * 0.2, rel=0.05)


def test_tension_stiffens_and_pressure_softens_torsion() -> None:
    """Wagner: an I column with warping free has the torsional stiffness (GJ + N Ip/A)/l; the linear one without N."""
    GJ = exact.stiffnesses(exact.BEAM)[0]
    polar = (exact.BEAM.Iy + exact.BEAM.Iz) / exact.BEAM.A
    for load in (-2e5, 2e5):
        m = example.clamped(exact.BEAM, 1.0, 2)
        m.load("P2.x", load)
        system = m.build()
        compliance = system.compliance("P2", "R2", system.equilibrium()).matrix[3, 3]
        # the beam's own length under load: l (1 + N/EA), of second order here
        assert 1 / compliance == pytest.approx(GJ + load * polar, rel=1e-3)


def test_a_relation_and_a_spring_hold_the_warping_of_an_end_elastically() -> None:
    """Between free (soft) and held plane (stiff)."""

    def stiffness(held: tuple[int, ...], spring: float) -> float:
        m = example.clamped(exact.BEAM, 1.0, 4, held=(0, *held))
        if spring:
            m.relation("end", {"W4.twist": 1.0})
            m.spring("end.relation", spring)
        return float(1 / m.build().compliance("P4", "R4").matrix[3, 3])

    EIw = exact.stiffnesses(exact.BEAM)[1]
    free, held = stiffness((), 0.0), stiffness((4,), 0.0)
    soft, stiff = stiffness((), 1e-6 * EIw), stiffness((), 1e6 * EIw)
    assert held > 1.5 * free
    assert soft == pytest.approx(free, rel=1e-4)
    assert stiff == pytest.approx(held, rel=1e-4)


def test_a_beam_that_warps_is_drawn_and_shows_the_strain_of_its_bimoment() -> None:
    m = cantilever(0.2, section=exact.BEAM, material="steel")
    m.load("S", [100.0, 0, 0])
    system = m.build()
    state = system.equilibrium()
    (shape,) = (shape for shape in shapes(state) if shape.name == "b")
    tip = exact.BEAM.stresses(state.section_forces("b")[0])[0].normal
    assert shape.values["strain"][0] == pytest.approx(tip / exact.STEEL.E, rel=1e-6)
    assert shape.lines[0][-1] == pytest.approx(state.position("Q"), abs=1e-12)


def test_stiffnesses_of_bending_and_of_warping_are_those_of_the_section() -> None:
    system = example.clamped(exact.BEAM, 1.0, 1).build()
    GJ, EIw = exact.stiffnesses(exact.BEAM)[:2]
    assert system.parameters["b0.GJ"] == pytest.approx(GJ) and system.parameters["b0.EIw"] == pytest.approx(
        EIw
    )
    with pytest.raises(fx.ModelError, match=r"'b0 warping.stiffness' follows from .*b0\.GJ.*b0\.EIw"):
        _ = system.parameters["b0 warping.stiffness"]
