"""Cables at rest: the elastic catenary, quadrature, and how cables are joined to bodies."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import fsolve

import flexel as fx
from flexel.cables import cable_tension, weights

DATA = json.loads((Path(__file__).parents[1] / "data" / "rope_analytic.json").read_text())
CATENARIES = DATA["elastic_catenary"]["cases"]
G = 9.81


def hanging(case: dict[str, Any], n: int, EI: float = 0.0) -> fx.State:
    """Equilibrium of a cable between two fixed points, started from the closed form."""
    L0, w, EA, H, V = (float(case[z]) for z in ("L0", "w", "EA", "H", "VA"))

    def closed_form(u: float) -> tuple[float, float]:
        s = u * L0
        x = H * s / EA + H / w * (np.arcsinh(V / H) - np.arcsinh((V - w * s) / H))
        y = w * s / EA * (V / w - s / 2) + (np.hypot(H, V) - np.hypot(H, V - w * s)) / w
        return x, -y

    m = fx.Model(gravity=(0, -G))
    rope = m.cable_line("rope", closed_form, n, length=L0, EA=EA, EI=EI, mass_per_length=w / G)
    m.fix(rope.points[0], rope.points[-1])
    return m.build().equilibrium()


def end_forces(state: fx.State, n: int) -> np.ndarray:
    """Forces of the supports: horizontal at the first end, tensions at both."""
    a, b = ([state.force(f"rope_p{i}.{c}") for c in "xy"] for i in (0, n))
    return np.array([-a[0], np.hypot(*a), np.hypot(*b)])


@pytest.mark.parametrize("case", CATENARIES, ids=lambda c: f"l{c['l']} h{c['h']} L{c['L0']} EA{c['EA']:g}")
def test_catenary_has_the_sag_and_the_end_tensions_of_the_closed_form(case: dict[str, Any]) -> None:
    """The strain of the closed form is the relative elongation, ours is Green's: they differ by 3/2 strain."""
    n, strain = 16, float(case["TB"]) / float(case["EA"])
    state = hanging(case, n)
    exact = np.array([float(case[z]) for z in ("H", "TA", "TB")])
    assert end_forces(state, n) == pytest.approx(exact, rel=2e-6 + strain)
    middle = state.position(f"rope_p{n // 2}")
    assert middle == pytest.approx(
        [float(z) for z in case["mid_material_point"]], abs=(2e-6 + strain) * case["l"]
    )


def greens_catenary(case: dict[str, Any]) -> np.ndarray:
    """Horizontal force and end tensions for Green's strain, T = EA λ (λ² - 1)/2, by quadrature and root finding."""
    l, h, L0, w, EA = (float(case[z]) for z in ("l", "h", "L0", "w", "EA"))

    def stretch(T: float) -> float:
        return float(max(np.roots([0.5, 0, -0.5, -T / EA]).real))

    def miss(unknown: Any) -> list[float]:
        H, V = unknown

        def slope(s: float, force: Callable[[float], float]) -> float:
            T = float(np.hypot(H, V - w * s))
            return stretch(T) * force(s) / T

        x = quad(lambda s: slope(s, lambda s: H), 0, L0, epsabs=1e-13, epsrel=1e-13)[0]
        y = quad(lambda s: slope(s, lambda s: w * s - V), 0, L0, epsabs=1e-13, epsrel=1e-13)[0]
        return [x - l, y - h]

    H, V = fsolve(miss, [float(case["H"]), float(case["VA"])], xtol=1e-14)
    return np.array([H, np.hypot(H, V), np.hypot(H, V - w * L0)])


def test_catenary_converges_with_the_fourth_order() -> None:
    case = CATENARIES[2]  # supports at different heights, sag of a tenth of the span
    exact = greens_catenary(case)
    errors = [abs(end_forces(hanging(case, n), n) / exact - 1).max() for n in (6, 12, 24)]
    assert np.log2(errors[0] / errors[1]) > 3.5
    assert np.log2(errors[1] / errors[2]) > 3.5
    assert errors[2] < 1e-6


def test_tension_along_the_cable_is_that_of_the_catenary() -> None:
    case, n = CATENARIES[3], 16
    state = hanging(case, n)
    H, V, w = float(case["H"]), float(case["VA"]), float(case["w"])
    for i in range(n):
        s, T = cable_tension(state, f"rope{i + 1}")
        exact = np.hypot(H, V - w * (s + i * float(case["L0"]) / n))
        assert pytest.approx(exact, rel=5e-4) == T


def test_four_axial_and_three_bending_points_are_enough() -> None:
    """The work of the Gauss points against that of many points, in an element bent over one radian and stretched.

    More points change the energy by less than the interpolation itself is wrong, and the better the shorter the
    element is: by the order of at least six.
    """

    def energies(h: float, points: tuple[int, int]) -> np.ndarray:
        """Of a circular arc of radius 1 and length h, not quite in equilibrium: end slopes 1 % apart."""
        p, q = np.array([0.0, 0.0]), np.array([np.sin(h), 1 - np.cos(h)])
        dp, dq = 1.01 * np.array([1.0, 0.0]), np.array([np.cos(h), np.sin(h)])
        found = []
        for k, axial in zip(points, (True, False), strict=True):
            place, weight = np.polynomial.legendre.leggauss(k)
            xi, d = (1 + place[:, None]) / 2, (q - p) / h
            r1 = 6 * xi * (1 - xi) * d + (1 - xi) * (1 - 3 * xi) * dp + xi * (3 * xi - 2) * dq
            r2 = ((6 - 12 * xi) * d + (6 * xi - 4) * dp + (6 * xi - 2) * dq) / h
            square = (r1**2).sum(axis=1)
            value = (square - 1) / 2 if axial else (r1[:, 0] * r2[:, 1] - r1[:, 1] * r2[:, 0]) / square**1.5
            found.append(h / 2 * weight @ value**2)
        return np.array(found)

    for h in (1.0, 0.5):
        error = abs(energies(h, (4, 3)) / energies(h, (12, 12)) - 1)
        fewer = abs(energies(h, (3, 2)) / energies(h, (12, 12)) - 1)
        assert error[0] < 1e-6
        assert error[1] < 2e-4 * h**4
        assert np.all(error <= 0.1 * fewer + 1e-15)


def test_weights_are_the_rope_stiffness() -> None:
    S = weights(0.5, 3.0, 7.0, planar=False)
    assert S[:4].sum() == pytest.approx(1.5)
    assert S[4::3].sum() == pytest.approx(3.5)
    assert S.shape == (13,)


def cantilever(n: int, load: float) -> fx.State:
    """A stiff cable of length 1 and EI = 1, clamped at one end, loaded across at the other."""
    m = fx.Model()
    rope = m.cable_line("rope", [(0, 0, 0), (1, 0, 0)], n, EA=1e5, EI=1.0, mass_per_length=1.0)
    wall = m.frame("wall", fixed=True)
    m.fix(rope.points[0])
    m.clamp_slope("clamp", wall, rope.slopes[0])
    m.load(rope.points[-1], (0, 0, load))
    return m.build().equilibrium()


def test_clamped_cable_bends_like_a_beam() -> None:
    """P L³/3EI for small loads; the elastica for large ones (P L²/EI = 2: 0.4935 L across, 0.8394 L along)."""
    assert cantilever(2, 1e-3).position("rope_p2")[2] == pytest.approx(1e-3 / 3, rel=1e-5)
    tip = cantilever(8, 2.0).position("rope_p8")
    assert tip == pytest.approx([1 - 0.16064, 0, 0.49346], abs=3e-5)


def test_distributed_load_is_consistent() -> None:
    """A cable loaded evenly across like its own weight hangs as under gravity."""
    states = []
    for gravity in (True, False):
        m = fx.Model(gravity=(0, 0, -G if gravity else 0))
        rope = m.cable_line(
            "rope", [(0, 0, 0), (10, 0, 0)], 6, length=9.99, EA=1e6, EI=1.0, mass_per_length=2.0
        )
        m.fix(rope.points[0], rope.points[-1])
        if not gravity:
            for element in rope.elements:
                m.distributed_load(element, (0, 0, -2.0 * G))
        states.append(m.build().equilibrium())
    for node in ("rope_p3", "rope_d0"):
        assert states[0].position(node) == pytest.approx(states[1].position(node), abs=1e-12)


def test_anchor_holds_place_and_direction_in_a_turned_body() -> None:
    """A drum turned by 0.3 takes the anchored end of the rope along, tangentially; the rest follows stiffly."""
    m = fx.Model()
    axle, drum = m.point("axle", (0, 0, 0), fixed=True), m.frame("drum", fx.turn((0, 1, 0), 0.3), fixed=True)
    rope = m.cable_line("rope", [(1, 0, 0), (1, 0, -2)], 3, EA=1e5, EI=100.0, mass_per_length=1.0)
    m.anchor("end", axle, drum, rope.points[0], rope.slopes[0])
    m.load(rope.points[-1], (0.5, 0, 0))
    state = m.build().equilibrium()
    assert state.position("rope_p0") == pytest.approx([1, 0, 0], abs=1e-12)
    direction = state.position("rope_d0")
    assert direction / np.linalg.norm(direction) == pytest.approx([0, 0, -1], abs=1e-12)
    deflection = state.position("rope_p3")[0] - 1
    assert deflection == pytest.approx(0.5 * 2**3 / 300, rel=1e-3)


def test_planar_anchor_and_beam_share_the_rope_with_a_beam() -> None:
    """A rope clamped to the free end of a cantilever beam continues it: a beam of twice the length."""
    m = fx.Model()
    wall, P, Q = m.point("wall", (0, 0), fixed=True), m.point("P", (1, 0)), m.point("Q", (2, 0))
    still, turn = m.angle("still", fixed=True), m.angle("turn")
    m.beam("beam", wall, still, P, turn, EIz=1.0)
    rope = m.cable_line("rope", [(1, 0), (2, 0)], 2, start=P, end=Q, EA=1e6, EI=1.0, mass_per_length=1.0)
    m.clamp_slope("joint", turn, rope.slopes[0])
    m.load(Q, (0, 1e-4))
    assert m.build().equilibrium().position("Q")[1] == pytest.approx(1e-4 * 8 / 3, rel=1e-4)


def test_wire_rope_gives_the_numbers_of_its_section() -> None:
    rope = fx.WireRope(0.02)
    m = fx.Model(gravity=(0, 0, -G))
    line = m.cable_line("rope", [(0, 0, 0), (0, 0, -10)], 4, section=rope, material="wire rope")
    m.fix(line.points[0])
    m.point_mass("load", line.points[-1], 1000.0)
    state = m.build().equilibrium()
    assert rope.A == pytest.approx(184e-6, rel=2e-3)
    T = cable_tension(state, "rope1")[1][0]
    weight = 8900 * rope.A * (10 - cable_tension(state, "rope1")[0][0])
    assert pytest.approx((1000 + weight) * G, rel=1e-9) == T
    elongation = -state.position("rope_p4")[2] - 10
    assert elongation == pytest.approx((1000 + 8900 * rope.A * 5) * G * 10 / (100e9 * rope.A), rel=2e-3)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"EA": -1.0}, "EA -1 is not positive"),
        ({"EI": None}, "EA or EI is missing"),
        ({"damping": -0.1}, "damping -0.1 is negative"),
        ({"length": 0.0}, "length 0 is not positive"),
        ({"n": 0}, "n = 0 elements"),
        ({"at": [0, 0.5, 1]}, "either n, the number"),
        ({"material": "steel"}, "without a section"),
        ({"start": "A"}, "node 'A' at .* is not where the path ends"),
    ],
)
def test_wrong_cables_are_refused_by_name(change: dict[str, Any], message: str) -> None:
    m = fx.Model()
    m.point("A", (5, 0, 0))
    given = {"n": 2, "EA": 1.0, "EI": 1.0, "mass_per_length": 1.0} | change
    n = given.pop("n")
    with pytest.raises(fx.ModelError, match=message):
        m.cable_line("rope", [(0, 0, 0), (1, 0, 0)], n, **given)


def test_slope_needs_a_direction() -> None:
    with pytest.raises(fx.ModelError, match="has no length"):
        fx.Model().slope("d", (0, 0, 0))
