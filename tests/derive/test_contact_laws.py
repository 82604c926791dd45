"""Laws of contact: closed forms of impact and friction, from the definitions themselves."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from flexel.derive.declare import Law
from flexel.derive.laws.contact_laws import CONTACT

DATA = json.loads((Path(__file__).parents[1] / "data" / "rope_analytic.json").read_text())["hertz_bounce"]
BY_NAME = {law.name: law for law in CONTACT}
every_law = pytest.mark.parametrize("law", CONTACT, ids=lambda law: law.name)


class Numbers:
    """A law with numbers: sigma, tau, dz/dt, U as functions of (e, ed, s, z), and the dissipated power."""

    def __init__(self, law: Law, **values: float) -> None:
        z = [state.symbol for state in law.states]
        self.k, self.nz = len(law.s), len(z)
        outputs = [*law.sigma, *law.tau, *(state.rate for state in law.states), law.energy]
        for name, expr in reversed(law.let):
            outputs = [o.xreplace({name: expr}) for o in outputs]
        known = {p.symbol: sp.Float(values.get(p.name, 0.0)) for p in law.parameters}
        arguments = [*law.e, *law.ed, *law.s, *z]
        self._function = sp.lambdify(arguments, [o.xreplace(known) for o in outputs], "math")

    def __call__(self, e: float, ed: float, s: Any = (), z: Any = ()) -> tuple[float, Any, Any, float]:
        values = self._function(e, ed, *s, *z)
        k = self.k
        return values[0], np.array(values[1 : 1 + k]), np.array(values[1 + k : -1]), values[-1]


def bounce(law: Numbers, mass: float, speed: float) -> Any:
    """Motion of a mass from the first touch, gap zero, until it leaves."""

    def leaves(t: float, y: Any) -> float:
        return float(y[0] - 1e-15)

    leaves.terminal, leaves.direction = True, 1  # type: ignore[attr-defined]

    def deepest(t: float, y: Any) -> float:
        return float(y[1])

    def motion(t: float, y: Any) -> Any:
        return [y[1], -law(y[0], y[1])[0] / mass]

    return solve_ivp(
        motion, (0, 1), [0, -speed], "DOP853", events=(leaves, deepest), rtol=1e-11, atol=1e-18, max_step=5e-6
    )


@every_law
def test_open_gap_carries_nothing_and_contact_only_pushes(law: Law) -> None:
    values = {"stiffness": 3.0, "exponent": 1.5, "dissipation": 2.0, "friction": 0.3, "slip_speed": 0.1}
    numbers = Numbers(law, **values, bristle_stiffness=5.0, bristle_damping=0.1, release=1.0)
    s, z = [0.4, -0.2][: numbers.k], [0.01, 0.03][: numbers.nz]
    sigma, tau, _, _ = numbers(0.2, -1.0, s, z)
    assert sigma == 0
    assert not np.any(tau)
    for rate in (-3.0, 0.0, 3.0):
        assert numbers(-0.2, rate, s, z)[0] <= 0


@every_law
def test_force_and_its_tangent_are_finite_at_the_first_touch(law: Law) -> None:
    z = [state.symbol for state in law.states]
    sigma, n = law.sigma[0], next(p.symbol for p in law.parameters if p.name == "exponent")
    for name, expr in reversed(law.let):
        sigma = sigma.xreplace({name: expr})
    slope = sp.diff(sigma.subs(law.ed[0], 0), law.e[0])
    others = {p.symbol: 1.0 for p in law.parameters if p.symbol != n} | dict.fromkeys([*law.s, *z], 0.1)
    for exponent in (1.0, 1.5, 2.0):
        for gap in (-1e-300, 0.0, 1.0):
            assert 0 <= abs(float(slope.subs(others).subs({n: exponent, law.e[0]: gap}))) <= 1.0


def test_hertz_impact_has_the_closed_form() -> None:
    data = DATA["data"]
    law = Numbers(BY_NAME["hertz"], stiffness=data["K"], exponent=1.5)
    solution = bounce(law, data["m"], data["v"])
    deepest = solution.y_events[1][0, 0]
    assert -deepest == pytest.approx(DATA["delta_max"], rel=1e-8)
    assert -law(deepest, 0.0)[0] == pytest.approx(DATA["F_max"], rel=1e-8)
    assert solution.t_events[0][0] == pytest.approx(DATA["t_contact"], rel=1e-8)
    assert solution.y[1, -1] == pytest.approx(data["v"], rel=1e-9)


FACTORS: dict[str, Callable[[float], float]] = {
    "LankaraniNikravesh": lambda e: 3 * (1 - e**2) / 4,
    "HuntCrossley": lambda e: 3 * (1 - e) / 2,
}


@pytest.mark.parametrize("model", sorted(FACTORS))
def test_restitution_is_that_of_the_dissipation_factor(model: str) -> None:
    data = DATA["data"]
    for row in DATA["restitution_of_damped_models"]["rows"][::3]:
        a = FACTORS[model](row["e_in"]) / data["v"]
        law = Numbers(BY_NAME["hertz"], stiffness=data["K"], exponent=1.5, dissipation=a)
        solution = bounce(law, data["m"], data["v"])
        assert solution.y[1, -1] / data["v"] == pytest.approx(row[model], rel=1e-6)


@pytest.mark.parametrize("k", [1, 2])
def test_coulomb_friction_opposes_the_slip_and_reaches_its_limit(k: int) -> None:
    law = Numbers(BY_NAME[f"hertz_coulomb_{k}"], stiffness=2.0, exponent=1.0, friction=0.3, slip_speed=1e-3)
    s = np.array([3.0, -4.0][:k])
    sigma, tau, _, _ = law(-0.5, 0.0, s)
    assert sigma == -1.0
    assert tau == pytest.approx(0.3 * s / np.linalg.norm(s), rel=1e-6)


def test_bristles_stick_like_a_spring_and_slide_at_the_limit() -> None:
    """Dahl's model: tau = mu N (1 - exp(-k x/mu)) after a slide x in one direction, whatever the speed."""
    mu, k, N = 0.3, 200.0, 5.0
    values = {"friction": mu, "bristle_stiffness": k}
    law = Numbers(BY_NAME["hertz_bristle_1"], stiffness=N, exponent=1.0, **values)
    for speed in (0.1, 3.0):
        for x in (1e-5, 1e-3, 1.0):
            solution = solve_ivp(
                lambda t, z, v=speed: law(-1.0, 0.0, [v], z)[2], (0, x / speed), [0.0], rtol=1e-10, atol=1e-14
            )
            tau = law(-1.0, 0.0, [speed], solution.y[:, -1])[1][0]
            assert tau == pytest.approx(mu * N * (1 - np.exp(-k * x / mu)), rel=1e-6)


def test_bristles_hold_at_rest_and_straighten_when_open() -> None:
    law = Numbers(
        BY_NAME["hertz_bristle_2"],
        stiffness=1.0,
        exponent=1.0,
        friction=0.3,
        bristle_stiffness=9.0,
        release=4.0,
    )
    z = [0.01, -0.02]
    assert not np.any(law(-1.0, 0.0, [0.0, 0.0], z)[2])
    assert law(-1.0, 0.0, [0.0, 0.0], z)[1] == pytest.approx([0.09, -0.18])
    assert law(1.0, 0.0, [1.0, 1.0], z)[2] == pytest.approx([-0.04, 0.08])


def test_friction_of_bristles_is_isotropic() -> None:
    law = Numbers(
        BY_NAME["hertz_bristle_2"], stiffness=1.0, exponent=1.0, friction=0.3, bristle_stiffness=9.0
    )
    c, s = np.cos(0.7), np.sin(0.7)
    R = np.array([[c, -s], [s, c]])
    slip, z = np.array([0.3, 0.5]), np.array([0.004, -0.01])
    one, other = law(-1.0, 0.2, slip, z), law(-1.0, 0.2, R @ slip, R @ z)
    assert other[1] == pytest.approx(R @ one[1], rel=1e-12)
    assert other[2] == pytest.approx(R @ one[2], rel=1e-12)


@pytest.mark.parametrize("name", ["hertz", "hertz_coulomb_1", "hertz_coulomb_2"])
def test_energy_is_the_work_of_the_elastic_force_and_the_rest_is_lost(name: str) -> None:
    law = Numbers(BY_NAME[name], stiffness=3.0, exponent=1.5, dissipation=0.4, friction=0.3, slip_speed=0.01)
    s = [0.5, 0.1][: law.k]
    for gap in (-0.3, -0.01, 0.2):
        h = 1e-6
        slope = (law(gap + h, 0.0, s)[3] - law(gap - h, 0.0, s)[3]) / (2 * h)
        assert slope == pytest.approx(law(gap, 0.0, s)[0], abs=1e-9)
        for rate in (-5.0, -0.5, 0.5, 5.0):
            sigma, tau, _, _ = law(gap, rate, s)
            assert sigma * rate + float(tau @ np.array(s)) - slope * rate >= -1e-9
