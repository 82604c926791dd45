"""Laws with internal states: a Maxwell element beside the solution of its linear equations."""

import numpy as np
import pytest
from scipy.linalg import expm

import flexel as fx
from flexel.derive import TIME, Internal, Law, Parameter, symbol
from flexel.derive.compiled import CompiledLaw
from flexel.derive.user_definitions import compile_law
from flexel.linear.orbits import orbit
from flexel.mechanics.modes import sort_eigenvalues

K, LAG, MASS = 50.0, 0.3, 2.0


pytestmark = pytest.mark.usefixtures("cache")


def maxwell(cubic: float = 0.0, driven: float = 0.0) -> CompiledLaw:
    """Spring and dashpot in series; z is the length that the dashpot has taken."""
    e, ed, z = symbol("e"), symbol("ed"), symbol("creep")
    k, lag = Parameter("k", 1, "N/m", "stiffness"), Parameter("lag", 1, "s", "relaxation time")
    d = e - z
    sigma = k.symbol * (d + cubic * d**3) + driven * TIME
    state = Internal("creep", "m", d / lag.symbol + cubic * ed * z)
    U = k.symbol * (d**2 / 2 + cubic * d**4 / 4)
    return compile_law(
        Law(
            "maxwell",
            "in series",
            (k, lag),
            (e,),
            (ed,),
            (),
            (sigma,),
            (),
            U,
            "Maxwell",
            states=(state,),
        )
    )


def oscillator(law: CompiledLaw, initial: float = 0.0) -> fx.Model:
    """A mass on a Maxwell element along x."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.fix("A.y", "A.z")
    m.truss("bar", "O", "A")
    m.point_mass("mass", "A", MASS)
    m.law(["bar.elongation"], law, name="damper", k=K, lag=LAG, initial={"creep": initial})
    return m


STATE_MATRIX = np.array([[0, -K / MASS, K / MASS], [1, 0, 0], [0, 1 / LAG, -1 / LAG]])


def test_eigenvalues_of_a_maxwell_element_are_those_of_its_third_order_equation() -> None:
    lin = oscillator(maxwell()).build().linearize()
    assert lin.states[-1] == "damper.creep"
    assert lin.eigenvalues() == pytest.approx(sort_eigenvalues(np.linalg.eigvals(STATE_MATRIX)), abs=1e-13)


def test_the_motion_is_that_of_the_linear_equations_and_the_lost_energy_is_accounted_for() -> None:
    m = oscillator(maxwell(), initial=0.02)
    m.initial("A.x", 1.1)
    s = m.build()
    motion = s.simulate(2.0, rtol=1e-11, atol=1e-13, samples=401)
    exact = np.array([expm(STATE_MATRIX * t) @ [0.0, 0.1, 0.02] for t in motion.t])
    assert motion["damper.creep"] == pytest.approx(exact[:, 2], abs=1e-10)
    assert motion["A.x"] - 1 == pytest.approx(exact[:, 1], abs=1e-10)
    lost = np.array([state.dissipated for state in motion])
    total = np.array([state.energy.total for state in motion])
    h = motion.t[1] - motion.t[0]
    simpson = h / 3 * (lost[:-2:2] + 4 * lost[1:-1:2] + lost[2::2]).sum()
    assert total[0] - total[-1] == pytest.approx(simpson, rel=1e-7)


def test_a_linearization_with_internal_states_is_the_derivative_of_the_motion() -> None:
    m = oscillator(maxwell(cubic=3.0, driven=2.0), initial=0.1)
    m.initial("A.x", 1.2, 0.7)
    s = m.build()
    state = s.initial
    y = np.concatenate([state.q, state.qd, state.z])

    def rhs(y: np.ndarray) -> np.ndarray:
        return s.rhs(state.t, y)

    h = 1e-6
    A = np.array([(rhs(y + h * d) - rhs(y - h * d)) / (2 * h) for d in np.eye(3)]).T
    swap = [1, 0, 2]  # rhs has (q, q', z), the linearization (q', q, z)
    assert s.linearize(state).state_matrix == pytest.approx(A[np.ix_(swap, swap)], rel=1e-8, abs=1e-8)


def test_a_state_space_model_carries_the_internal_states() -> None:
    s = oscillator(maxwell()).build()
    A, B, C, D = s.linearize().state_space(["A.x"], ["A.x", "damper.creep", "force:bar.elongation"])
    assert A == pytest.approx(STATE_MATRIX, abs=1e-13)
    assert B[:, 0] == pytest.approx([1 / MASS, 0, 0])
    assert C == pytest.approx(np.array([[0, 1, 0], [0, 0, 1], [0, K, -K]]), abs=1e-12)
    assert D == pytest.approx(np.zeros((3, 1)), abs=1e-13)


def test_steady_motion_brings_internal_states_to_rest() -> None:
    m = oscillator(maxwell(), initial=0.02)
    m.spring("A.x", 30.0)
    m.load("A.x", 6.0)
    state = m.build().steady()
    assert state["A.x"] - 1 == pytest.approx(0.2, rel=1e-12)
    assert state["damper.creep"] == pytest.approx(0.2, rel=1e-12)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"k": None}, "parameters are missing: k"),
        ({"stiffness": 3.0}, "unknown parameter 'stiffness'"),
        ({"initial": {"crep": 1.0}}, "unknown internal state 'crep'"),
    ],
)
def test_what_is_missing_or_unknown_is_named(change: dict[str, object], message: str) -> None:
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.truss("bar", "O", "A")
    given: dict[str, object] = {"k": K, "lag": LAG} | change
    given = {name: value for name, value in given.items() if value is not None}
    with pytest.raises(fx.ModelError, match=message):
        m.law(["bar.elongation"], maxwell(), **given)  # type: ignore[arg-type]


def test_periodic_motion_says_that_it_has_no_place_for_internal_states() -> None:
    s = oscillator(maxwell()).build()
    with pytest.raises(fx.LinearizationError, match=r"damper\.creep"):
        orbit(s, 1.0, 8)


def test_an_internal_state_cannot_have_the_name_of_a_coordinate() -> None:
    e, ed, x = symbol("e"), symbol("ed"), symbol("x")
    law = compile_law(
        Law("lag", "lag", (), (e,), (ed,), (), (e - x,), (), states=(Internal("x", "m", e - x),))
    )
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("hub", (1, 0, 0))
    m.truss("bar", "O", "hub")
    m.law(["bar.elongation"], law, name="hub")
    with pytest.raises(
        fx.ModelError, match=r"law 'hub': its internal state 'hub.x' has the same name as a coord"
    ):
        m.build()


def test_an_internal_state_whose_rate_is_not_finite_is_named() -> None:
    m = oscillator(maxwell())
    m.law(["bar.elongation"], maxwell(), name="empty", k=1.0, lag=0.0)
    with pytest.raises(fx.DynamicsError, match=r"rate of 'empty.creep' at t = 0 s is not finite"):
        _ = m.build().initial


@pytest.mark.parametrize(
    ("method", "tolerance"), [("auto", 1e-9), ("Radau", 1e-9), ("generalized-alpha", 5e-7)]
)
def test_states_are_integrated_where_every_motion_is_prescribed(method: str, tolerance: float) -> None:
    """The creep follows a harmonic elongation with the amplitude and phase of a first-order lag."""
    m = oscillator(maxwell())
    m.prescribe("A.x", lambda t: 1 + 0.1 * np.sin(5 * t))
    s = m.build()
    assert not s.dynamic
    motion = s.simulate(1.0, samples=11, method=method, rtol=1e-10)
    w = 5 * LAG
    t = motion.t
    exact = 0.1 / (1 + w * w) * (np.sin(5 * t) - w * np.cos(5 * t) + w * np.exp(-t / LAG))
    assert motion["damper.creep"] == pytest.approx(exact, abs=tolerance)
    stress = K * (0.1 * np.sin(5 * t) - exact)
    assert motion["force:bar.elongation"] == pytest.approx(stress, abs=2 * K * tolerance)
