"""Chains, and ropes with a free end that need bending stiffness."""

from typing import Any

import numpy as np
import pytest

import flexel as fx

G = 9.81


def hanging(n: int, EI: float, planar: bool = True) -> fx.Model:  # noqa: N803
    """A rope of 1 m and 0.1 kg/m that hangs from one end."""
    m = fx.Model(gravity=(0, -G) if planar else (0, 0, -G))
    ends = [(0, 0), (0, -1)] if planar else [(0, 0, 0), (0, 0, -1)]
    rope = m.cable_line("rope", ends, n, EA=1e5, EI=EI, mass_per_length=0.1)
    m.fix(rope.points[0])
    return m


@pytest.mark.parametrize("planar", [True, False])
@pytest.mark.parametrize("n", [1, 2, 8])
def test_a_free_end_is_stable_from_the_limit_on_and_refused_below(n: int, planar: bool) -> None:
    unit = 0.1 * G / n**3
    state = hanging(n, 0.0081 * unit, planar).build().equilibrium()
    assert state.position(f"rope_p{n}")[-1] == pytest.approx(-1.0, abs=1e-5)
    assert min(mode.omega for mode in hanging(n, 0.0081 * unit, planar).build().vibrations(count=4)) > 0
    with pytest.raises(fx.ModelError, match=rf"cable 'rope{n}': its end 'rope_p{n}' is free.*m\.chain"):
        hanging(n, 0.0079 * unit, planar).build()


def test_an_end_that_is_held_or_loaded_needs_no_bending_stiffness() -> None:
    for hold in ("fix", "mass", "load", "spring"):
        m = hanging(4, 0.0)
        if hold == "fix":
            m.fix("rope_p4")
        elif hold == "mass":
            m.point_mass("payload", "rope_p4", 1.0)
        elif hold == "load":
            m.load("rope_p4.y", -10.0)
        else:
            m.spring("rope_p4.y", 10.0)
        assert m.build().structure.n


@pytest.mark.parametrize("planar", [True, False])
def test_springs_on_the_curvatures_of_a_free_end_count_as_bending_stiffness(planar: bool) -> None:
    n, own = 2, 0.004 * 0.1 * G / 2**3  # half of what is needed
    points = (
        [f"curvature{i}" for i in (1, 2, 3)]
        if planar
        else [f"curvature{i}{c}" for i in (1, 2, 3) for c in "xyz"]
    )
    share = dict(zip("123", (5 / 18, 8 / 18, 5 / 18), strict=True))  # of Gauss' three points
    m = hanging(n, own, planar)
    for point in points[1:]:
        m.spring(f"rope{n}.{point}", 2 * own * share[point[9]] / n)
    with pytest.raises(fx.ModelError, match="is free"):
        m.build()
    m.spring(f"rope{n}.{points[0]}", 2 * own * share["1"] / n)
    state = m.build().equilibrium()
    assert state.position(f"rope_p{n}")[-1] == pytest.approx(-1.0, abs=1e-5)


def test_without_gravity_a_free_end_is_not_refused() -> None:
    m = fx.Model()
    m.cable_line("rope", [(0, 0), (1, 0)], 4, EA=1.0, EI=0.0, mass_per_length=1.0)
    m.build()


@pytest.mark.parametrize("EA", [None, 1e6])
def test_a_chain_with_a_payload_has_the_tension_of_what_hangs_below(EA: float | None) -> None:  # noqa: N803
    m = fx.Model(gravity=(0, 0, -G))
    chain = m.chain("chain", [(0, 0, 0), (0, 0, -2)], 10, mass_per_length=1.5, EA=EA, length=EA and 1.9999)
    m.fix(chain.points[0])
    m.point_mass("payload", chain.points[-1], 4.0)
    state = m.build().equilibrium()
    s, T = chain.tension(state)
    assert pytest.approx(G * (4.0 + 1.5 * (chain.s[-1] - s)), rel=1e-9) == T
    assert chain.tension([state, state])[1].shape == (2, 10)
    assert "10 bars" in repr(chain)


def test_a_curved_chain_between_points_of_a_body_is_as_long_as_it_is_reported() -> None:
    """A slack chain of rigid bars hangs in the shape of a catenary, to second order."""
    m = fx.Model(gravity=(0, -G))
    a, b = m.point("a", (0, 0), fixed=True), m.point("b", (1, 0), fixed=True)
    chain = m.chain("c", lambda u: (u, -0.4 * np.sin(np.pi * u)), 24, start=a, end=b, mass_per_length=1.0)
    state = m.build().equilibrium()
    length = float(chain.s[-1])
    from scipy.optimize import brentq

    c = brentq(lambda c: 2 * c * np.sinh(0.5 / c) - length, 0.05, 5)
    assert state.position("c_p12")[1] == pytest.approx(-c * (np.cosh(0.5 / c) - 1), rel=5e-3)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"length": 1.0}, "give EA"),
        ({"damping": 0.1}, "give EA"),
        ({"mass_per_length": -1.0}, "mass_per_length -1 is negative"),
        ({"EA": 0.0}, "EA 0 is not positive"),
        ({"n": None}, "either n, the number"),
    ],
)
def test_wrong_chains_are_refused_and_leave_the_model_alone(change: dict[str, Any], message: str) -> None:
    m = fx.Model()
    given = {"n": 4, "mass_per_length": 1.0} | change
    with pytest.raises(fx.ModelError, match=message):
        m.chain("chain", [(0, 0), (1, 0)], **given)
    assert not m.nodes


@pytest.mark.parametrize("n", [4, 16])
def test_an_unstrained_chain_finds_its_equilibrium_under_its_own_weight(n: int) -> None:
    """As drawn, nothing resists a motion across the bars, and nothing acts there either."""
    m = fx.Model(gravity=(0, -G))
    chain = m.chain("chain", [(0, 0), (0, -2)], n, mass_per_length=1.5, EA=1e6)
    m.fix(chain.points[0])
    s, T = chain.tension(m.build().equilibrium())
    assert pytest.approx(G * 1.5 * (2 - s), rel=1e-8) == T
