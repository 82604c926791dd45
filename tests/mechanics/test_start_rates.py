"""Rates at the start that nobody gave: elastic parts move rigidly, and the choice of coordinates changes nothing."""

from collections.abc import Sequence

import numpy as np
import pytest

import flexel as fx


def slider_crank(elements: int, independent: Sequence[str] = ()) -> fx.System:
    """A straight elastic rod on a crank that turns at 150 rad/s, drawn in its dead centre."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.angle("crank")
    m.hinge("shaft", "ground", "crank")
    m.point("A", (0.15, 0))
    m.beam("arm", "O", "crank", "A", rigid=True)
    m.angle("r0")
    last = "A"
    for i in range(elements):
        m.point(f"B{i}", (0.15 + 0.3 * (i + 1) / elements, 0))
        m.angle(f"r{i + 1}")
        m.beam(
            f"rod{i}",
            last,
            f"r{i}",
            f"B{i}",
            f"r{i + 1}",
            EA=1e6,
            EIz=10.0,
            mass_per_length=0.2,
            damping=1e-3,
        )
        last = f"B{i}"
    m.fix(f"{last}.y")
    m.point_mass("slider", last, 0.03)
    m.prescribe("shaft.angle", lambda t: 150 * t)
    if independent:
        m.independent(*independent)
    return m.build()


@pytest.mark.parametrize("elements", [1, 2, 4, 8])
def test_the_rod_of_a_slider_crank_starts_without_bending(elements: int) -> None:
    """Closed form: it turns at -75 rad/s, rigidly (bending rates of 22.5 m/s before)."""
    start = slider_crank(elements).initial
    bending = [start.rate(name) for name in start.structure.names if name.startswith("rod")]
    assert np.max(np.abs(bending)) < 1e-12 * 22.5
    turning = [start.rate(f"r{i}.angle") for i in range(elements + 1)]
    assert turning == pytest.approx([-75.0] * (elements + 1), rel=1e-12)


def test_the_rates_do_not_depend_on_the_coordinates() -> None:
    one = slider_crank(1, ["rod0.elongation", "rod0.bend1", "rod0.bend2"]).initial
    other = slider_crank(1, ["B0.x", "r0.angle", "r1.angle"]).initial
    assert one.v == pytest.approx(other.v, abs=1e-11)


def test_a_free_joint_keeps_its_angle_and_turns_with_its_body() -> None:
    """A double pendulum whose first arm is given 2 rad/s: the second follows as if the joint were locked."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    for i, (p, x) in enumerate((("O", 1.0), ("A", 2.0))):
        m.angle(f"arm{i}")
        m.point("AB"[i], (x, 0))
        m.hinge(f"joint{i}", ("ground", "arm0")[i], f"arm{i}")
        m.beam(f"beam{i}", p, f"arm{i}", "AB"[i], rigid=True)
        m.point_mass(f"mass{i}", "AB"[i], 1.0)
    start = m.build().state_at(rates={"joint0.angle": 2.0})
    assert [start.rate(name) for name in ("joint1.angle", "A.y", "B.y")] == pytest.approx(
        [0, 2, 4], abs=1e-12
    )


def test_what_is_left_has_the_least_kinetic_energy() -> None:
    """Closed form: one end of a rigid bar moves along it; the other follows, and nothing turns."""
    m = fx.Model()
    m.point("A", (0, 0))
    m.point("B", (1, 0))
    m.truss("bar", "A", "B")
    m.rigid("bar.elongation")
    m.point_mass("mass A", "A", 1.0)
    m.point_mass("mass B", "B", 2.0)
    start = m.build().state_at(rates={"A.x": 3.0})
    assert [start.rate(name) for name in ("B.x", "A.y", "B.y")] == pytest.approx([3, 0, 0], abs=1e-12)


def test_a_suspension_starts_at_rest_on_its_axle() -> None:
    """A mass on a spring between guides, whose base is prescribed to move: no rate of the spring."""
    m = fx.Model()
    for name in "AB":
        m.point(name, (0, float(name == "B")))
        m.fix(f"{name}.x")
        m.point_mass(f"mass {name}", name, 1.0)
    m.truss("spring", "A", "B")
    m.spring("spring.elongation", stiffness=100.0)
    m.prescribe("A.y", lambda t: 2 * t)
    assert m.build().initial.rate("B.y") == pytest.approx(2.0, abs=1e-12)
