"""Cables at rest: the elastic catenary, quadrature, and how cables are joined to bodies."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.engine.single import law_stiffness
from flexel.examples import rope_hanging as hanging
from flexel.examples.rope_exact import CATENARY, Catenary
from flexel.generated.table import LAWS
from flexel.parts.cable_results import cable_tension

DATA = json.loads((Path(__file__).parents[1] / "data" / "rope_analytic.json").read_text())
CATENARIES = DATA["elastic_catenary"]["cases"]
KEYS = {"l": "l", "h": "h", "L0": "L0", "w": "w", "EA": "EA", "H": "H", "V": "VA"}
G = 9.81


def catenary(case: dict[str, Any]) -> Catenary:
    """The case with its closed form."""
    return Catenary(**{key: float(case[column]) for key, column in KEYS.items()})


@pytest.mark.parametrize("case", CATENARIES, ids=lambda c: f"l{c['l']} h{c['h']} L{c['L0']} EA{c['EA']:g}")
def test_catenary_has_the_sag_and_the_end_tensions_of_the_closed_form(case: dict[str, Any]) -> None:
    n = 24
    state = hanging.catenary(catenary(case), n)
    exact = np.array([float(case[column]) for column in ("H", "TA", "TB")])
    assert hanging.end_forces(state, n) == pytest.approx(exact, rel=1e-5)
    middle = state.position(f"rope_p{n // 2}")
    assert middle == pytest.approx(
        [float(component) for component in case["mid_material_point"]], abs=1e-5 * case["l"]
    )


def test_convergence_is_measured_with_a_case_of_the_table() -> None:
    """Supports at different heights, sag of a tenth of the span."""
    assert CATENARY == catenary(CATENARIES[2])
    given = np.array([CATENARY.H, float(CATENARIES[2]["TA"]), float(CATENARIES[2]["TB"])])
    assert CATENARY.forces == pytest.approx(given, rel=1e-12)


def test_tension_along_the_cable_is_that_of_the_catenary() -> None:
    case, n = CATENARIES[3], 16
    state = hanging.catenary(catenary(case), n)
    H, V, w = float(case["H"]), float(case["VA"]), float(case["w"])
    for i in range(n):
        s, T = cable_tension(state, f"rope{i + 1}")
        exact = np.hypot(H, V - w * (s + i * float(case["L0"]) / n))
        assert pytest.approx(exact, rel=5e-4) == T


@pytest.mark.parametrize("arc", [0.0, np.pi / 2])
@pytest.mark.parametrize("planar", [True, False])
def test_a_rope_without_bending_stiffness_has_the_free_motions_of_a_chain(arc: float, planar: bool) -> None:
    """Eight elements have 24 strains and 36 coordinates in the plane, 54 in space: none locks, none is missing.

    17 independent strains leave 19 motions in the plane: as many as an inextensible cubic has.
    """
    n, size = 8, 2 if planar else 3
    m = fx.Model()

    def curve(u: float) -> list[float]:
        flat = [u, 0.0] if arc == 0 else [np.sin(arc * u) / arc, (1 - np.cos(arc * u)) / arc]
        return [*flat, 0.0][:size]

    rope = m.cable_line("rope", curve, n, EA=1.0, EI=0.0, mass_per_length=1.0)
    m.independent(*(f"{node.name}.{c}" for node in (*rope.points, *rope.slopes) for c in "xyz"[:size]))
    values = np.linalg.eigvalsh(m.build().linearize().K)
    free = int((abs(values) < 1e-4 * values[-1]).sum())
    assert free == {2: 19, 3: 37}[size]


def test_three_strains_hold_the_energy_of_a_stretched_and_bent_element() -> None:
    """The slopes at the ends and the length of an arc whose ends are stretched by 1 and 0 %, to second order."""

    def energies(h: float) -> tuple[float, float]:
        p, q = np.array([0.0, 0.0]), 1.005 * np.array([np.sin(h), 1 - np.cos(h)])
        dp, dq = 1.01 * np.array([1.0, 0.0]), np.array([np.cos(h), np.sin(h)])
        place, weight = np.polynomial.legendre.leggauss(12)
        xi, d = (1 + place[:, None]) / 2, (q - p) / h
        r1 = 6 * xi * (1 - xi) * d + (1 - xi) * (1 - 3 * xi) * dp + xi * (3 * xi - 2) * dq
        full = weight / 2 @ (np.linalg.norm(r1, axis=1) - 1) ** 2
        mean = weight / 2 @ np.linalg.norm(r1, axis=1) - 1
        ends = 0.01, 0.0
        slope, bow = (ends[1] - ends[0]) / 2, (ends[0] + ends[1]) / 2 - mean
        return float(mean**2 + slope**2 / 3 + bow**2 / 5), float(full)

    errors = [abs(np.subtract(*energies(h))) / energies(h)[1] for h in (0.4, 0.2)]
    assert errors[0] < 0.01
    assert errors[0] > 3.9 * errors[1]


def test_weights_are_the_rope_stiffness() -> None:
    K = law_stiffness(
        LAWS["cable_stiffness"], {"l0": 0.5, "EA": 3.0, "EI": 7.0, "damping": 0.0, "bending_damping": 0.0}
    )
    S = K.diagonal()
    assert np.array_equal(K, np.diag(S))
    assert S[:3] == pytest.approx([1.5, 0.5, 0.3])
    assert S[3::3].sum() == pytest.approx(3.5)
    assert S.shape == (12,)


def cantilever(n: int, load: float) -> fx.State:
    """A stiff cable of length 1 and EI = 1, clamped at one end, loaded across at the other."""
    m = fx.Model()
    rope = m.cable_line("rope", [(0, 0, 0), (1, 0, 0)], n, EA=1e5, EI=1.0, mass_per_length=1.0)
    wall = m.frame("wall", fixed=True)
    m.fix(rope.points[0])
    m.clamp("clamp", wall, rope.slopes[0])
    m.load(rope.points[-1], (0, 0, load))
    return m.build().equilibrium()


def test_clamped_cable_bends_like_a_beam() -> None:
    """P L³/3EI for small loads; the elastica for large ones (P L²/EI = 2: 0.4935 L across, 0.8394 L along)."""
    assert cantilever(2, 1e-3).position("rope_p2")[2] == pytest.approx(1e-3 / 3, rel=1e-5)
    tip = cantilever(16, 2.0).position("rope_p16")
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
    m.clamp("joint", turn, rope.slopes[0])
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
        ({"n": 0}, "elements n 0|elements 0"),
        ({"at": [0, 0.5, 1]}, "either n, the number"),
        ({"material": "steel"}, "without a section"),
        ({"start": "A"}, "node 'A' at .* is not at the end of the path"),
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


@pytest.mark.parametrize("planar", [True, False])
def test_a_cable_and_a_beam_that_end_in_one_point_share_its_load(planar: bool) -> None:
    """A cantilever whose tip hangs on a cable: 3 EI/L³ and EA/l side by side, except for the strain of 1e-5."""
    m, EI, EA, length, load = fx.Model(), 30.0, 50.0, 2.0, 1e-3
    places = {"O": (0, 0, 0), "tip": (1, 0, 0), "top": (1, length, 0)}
    for name, place in places.items():
        m.point(name, place[:2] if planar else place, fixed=name != "tip")
    for name in ("wall", "end"):
        (m.angle if planar else m.frame)(name, fixed=name == "wall")
    bending = {"EIz": EI} if planar else {"GJ": 1.0, "EIy": EI, "EIz": EI}
    m.beam("arm", "O", "wall", "tip", "end", **bending)
    ends = [places[name][: 2 if planar else 3] for name in ("top", "tip")]
    m.cable_line("rope", ends, 4, start="top", end="tip", EA=EA, EI=1e-3)
    m.load("tip.y", -load)
    state = m.build().equilibrium()
    assert state["tip.y"] == pytest.approx(-load / (3 * EI + EA / length), rel=1e-4)
