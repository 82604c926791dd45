"""Beams beyond the range of their deformations are named, with the error and the number of elements that would do."""

import warnings

import numpy as np
import pytest

import flexel as fx
from flexel.base.errors import RangeWarning

EI, GJ, LENGTH = 2.0, 3.0, 1.2


def cantilever(elements: int, planar: bool = True) -> fx.Model:
    """A straight beam, clamped at its first node, without weight."""
    m = fx.Model(gravity=(0, 0) if planar else (0, 0, 0))
    for i in range(elements + 1):
        place = LENGTH * i / elements
        if planar:
            m.point(f"P{i}", (place, 0.0), fixed=i == 0)
            m.angle(f"R{i}", fixed=i == 0)
        else:
            m.point(f"P{i}", (place, 0.0, 0.0), fixed=i == 0)
            m.frame(f"R{i}", fixed=i == 0)
    bending = {"EIz": EI} if planar else {"EIy": EI, "EIz": EI, "GJ": GJ}
    for i in range(elements):
        ends = f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"
        m.beam(f"b{i}", *ends, mass_per_length=0.1, EA=1e7, **bending)
    return m


def bent(elements: int, angle: float) -> fx.Model:
    """The cantilever under the end moment that bends a rod by an angle."""
    m = cantilever(elements)
    m.load(f"R{elements}", EI * angle / LENGTH)
    return m


def test_an_end_moment_that_bends_an_element_too_far_is_named_with_its_error() -> None:
    """Closed form: M = EI φ/l; that of the element is smaller by φ²/6, so it bends further."""
    with pytest.warns(
        RangeWarning, match=r"equilibrium: 'b0' is bent by 32°: .* 5 % too small; use 3 elements"
    ):
        state = bent(1, np.radians(30)).build().equilibrium()
    phi = state["R1.angle"]
    assert EI * phi / LENGTH * (1 - phi**2 / 6) == pytest.approx(EI * np.radians(30) / LENGTH, rel=2e-3)


@pytest.mark.parametrize(("elements", "angle"), [(1, 14.0), (3, 40.0), (7, 90.0)])
def test_elements_within_the_range_are_not_mentioned(elements: int, angle: float) -> None:
    state = bent(elements, np.radians(angle)).build().equilibrium()
    assert state[f"R{elements}.angle"] == pytest.approx(np.radians(angle), rel=0.02)


def test_a_twist_within_one_element_is_named_with_its_error() -> None:
    """The torsional moment is GJ/l times sin φ cos φ (closed form)."""
    m = cantilever(1, planar=False)
    moment, phi = 1.0, np.arcsin(2 * LENGTH / GJ) / 2
    m.load("R1", (moment, 0.0, 0.0))
    with pytest.warns(RangeWarning, match=r"'b0' is twisted by 27°: .* 14 % too small; use 2 elements"):
        state = m.build().equilibrium()
    assert state["b0.torsion"] == pytest.approx(LENGTH * np.sin(phi), rel=1e-9)


def test_a_column_that_folds_within_an_element_is_named() -> None:
    """Twelve times the buckling load of Euler's column: the path of eight elements is not that of the rod."""
    m = cantilever(8)
    m.load("P8", (lambda t: -12 * t * EI * (np.pi / 2 / LENGTH) ** 2, lambda t: 0.01 * t))
    with pytest.warns(RangeWarning, match=r"static_path: 'b\d' is bent by 2\d\d° .* more by more than 15°"):
        m.build().static_path(t_end=1.0)


def test_every_analysis_of_a_bent_state_says_it() -> None:
    m = bent(1, np.radians(30))
    s = m.build()
    with pytest.warns(RangeWarning):
        state = s.equilibrium()
    for name, analysis in {
        "linearize": lambda: s.linearize(state),
        "vibrations": lambda: s.vibrations(state),
        "buckling": lambda: s.buckling(state, increment={"P1.x": -1.0}),
        "compliance": lambda: s.compliance("P1", "R1", state),
        "simulate": lambda: s.simulate(0.01, start=state),
    }.items():
        with pytest.warns(RangeWarning, match=f"^{name}: 'b0' is bent") as caught:
            analysis()
        assert [w.filename for w in caught] == [__file__]


def test_a_loop_of_equilibria_says_it_once() -> None:
    """The text has no time, which differs in each: Python shows the same text once."""
    s = bent(1, np.radians(30)).build()
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("default")
        for time in np.linspace(0, 1, 20):
            s.equilibrium(t=time)
    assert len(caught) == 1


@pytest.mark.long
def test_a_motion_says_when_a_beam_is_bent_most() -> None:
    """Released from rest under a sudden moment a beam swings to about twice its static angle."""
    m = bent(2, np.radians(25))
    with pytest.warns(RangeWarning, match=r"simulate: 'b\d' is bent by \d+° at t = 0\.\d+ s"):
        m.build().simulate(0.5, samples=101)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        bent(8, np.radians(25)).build().simulate(0.5, samples=11)


def test_logarithmic_rotations_are_known_below_half_a_turn_and_say_so() -> None:
    """One element twisted by 200° has the torque of -160°, and warns; two have that of 100° each, and do not."""
    for elements in (1, 2):
        m = fx.Model()
        for i in range(elements + 1):
            m.point(f"P{i}", (LENGTH * i / elements, 0, 0), fixed=i == 0)
            m.frame(f"R{i}", fixed=i == 0)
        for i in range(elements):
            ends = f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"
            m.beam(f"b{i}", *ends, EA=1.0, GJ=GJ, EIy=EI, EIz=EI, rotations="logarithmic")
        m.hinge("turn", "R0", f"R{elements}", axis=(1, 0, 0))
        m.prescribe("turn.angle", fx.Polynomial((0.0, np.radians(200))))
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            s = m.build()
            state = s.equilibrium(t=1.0) if elements == 1 else s.static_path(t_end=1.0)[-1]
        expected = {1: -160, 2: 200}[elements]
        assert state.section_forces("b0")[0].T == pytest.approx(GJ * np.radians(expected) / LENGTH, rel=1e-9)
        found = [str(w.message) for w in said if issubclass(w.category, RangeWarning)]
        assert len(found) == 2 - elements
        assert all(
            "'b0' has ends that are turned by 160°" in w and "may be 200° the other way" in w for w in found
        )


@pytest.mark.parametrize("planar", [True, False])
def test_a_beam_that_is_sheared_too_far_is_named_with_its_remedy(planar: bool) -> None:
    """A short block under a force across leans by γ = V/GA (closed form)."""
    m = fx.Model(gravity=(0, 0) if planar else (0, 0, 0))
    ends = "P0", "R0", "P1", "R1"
    for i in range(2):
        m.point(f"P{i}", (0.02 * i, 0.0) if planar else (0.02 * i, 0.0, 0.0), fixed=i == 0)
        (m.angle if planar else m.frame)(f"R{i}", fixed=i == 0)
    stiff = {"EA": 1e7, "EIz": 10.0, "GAy": 100.0}
    stiff |= {} if planar else {"EIy": 10.0, "GJ": 10.0, "GAz": 1e4}
    m.beam("block", *ends, **stiff)
    m.load("P1", (0.0, 12.0) if planar else (0.0, 12.0, 0.0))
    with pytest.warns(
        RangeWarning, match=r"'block' is sheared by 6\.8°: .* 1\.4 % .*rotations='logarithmic'"
    ):
        m.build().equilibrium()
