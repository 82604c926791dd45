"""Small vibrations of cables: hanging chain, taut string, axial vibration with a payload, sagging cable."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import flexel as fx
from flexel.examples.rope_exact import chain_frequencies, loaded_chain_frequencies, stretched_frequencies

DATA = json.loads((Path(__file__).parents[1] / "data" / "rope_analytic.json").read_text())
G = 9.81


def test_closed_forms_are_those_of_the_tables() -> None:
    chain = [float(value) for value in DATA["hanging_chain"]["values_over_sqrt_g_L"]]
    assert chain_frequencies(2.0, 4) == pytest.approx(np.array(chain) * np.sqrt(G / 2.0), rel=1e-12)
    for row in DATA["rope_with_mass_and_payload"]["rows"]:
        exact = np.array(row["beta_1_2_3"]) / np.sqrt(row["mu"])
        assert stretched_frequencies(row["mu"], 3) == pytest.approx(exact, rel=2e-12)  # of the table
        assert 1 / np.sqrt(1 + row["mu"] / 3) == pytest.approx(row["Rayleigh"], rel=1e-12)


def test_closed_form_of_the_loaded_chain_has_its_limits() -> None:
    """A heavy payload makes a pendulum and taut strings of the chain, a light one leaves the chain alone."""
    string = np.arange(1, 4) * np.pi / 2.0 * np.sqrt(G * 2.0 / 1e-6)
    heavy = loaded_chain_frequencies(2.0, 1e-6, 4)
    assert heavy[0] == pytest.approx(np.sqrt(G / 2.0), rel=1e-6)
    assert heavy[1:] == pytest.approx(string, rel=1e-6)
    assert loaded_chain_frequencies(2.0, 1e4, 3) == pytest.approx(chain_frequencies(2.0, 3), rel=1e-3)


def taut(n: int, tension: float, EI: float, L: float = 3.0, mass: float = 0.5) -> np.ndarray:
    """Frequencies across of a taut string in space, each twice, between points that hold it."""
    EA = 1e7
    strain = brentq(lambda e: EA * e * np.sqrt(1 + 2 * e) - tension, 0, 0.1, xtol=1e-16)
    m = fx.Model()
    rope = m.cable_line(
        "rope",
        [(0, 0, 0), (L, 0, 0)],
        n,
        length=L / np.sqrt(1 + 2 * strain),
        EA=EA,
        EI=EI,
        mass_per_length=mass,
    )
    m.fix(rope.points[0], rope.points[-1])
    return np.array([mode.omega for mode in m.build().vibrations(count=6)])


@pytest.mark.parametrize("EI", [0.0, 2.0])
def test_taut_string_with_bending_stiffness(EI: float) -> None:
    L, T, mass = 3.0, 200.0, 0.5
    order = np.arange(1, 4)
    exact = order * np.pi / L * np.sqrt(T / mass) * np.sqrt(1 + order**2 * np.pi**2 * EI / (T * L**2))
    found = taut(8, T, EI)
    assert found[::2] == pytest.approx(found[1::2], rel=1e-8)  # both planes alike
    assert found[::2] == pytest.approx(exact, rel=2e-4)


@pytest.mark.parametrize("row", DATA["rope_with_mass_and_payload"]["rows"], ids=lambda row: f"mu{row['mu']}")
def test_axial_vibration_with_a_payload(row: dict[str, Any]) -> None:
    """beta tan beta = rope's mass over payload: three frequencies, with 4 elements."""
    L, EA, rhoA = 10.0, 1e6, 0.8
    m = fx.Model()
    rope = m.cable_line("rope", [(0, 0), (L, 0)], 4, EA=EA, EI=1e-3, mass_per_length=rhoA)
    m.fix(rope.points[0])
    m.fix(*(f"{node.name}.y" for node in (*rope.points[1:], *rope.slopes)))  # along the line only
    m.point_mass("payload", rope.points[-1], rhoA * L / row["mu"])
    found = [mode.omega for mode in m.build().vibrations(count=3)]
    exact = np.array(row["beta_1_2_3"]) * np.sqrt(EA / rhoA) / L
    assert found == pytest.approx(exact, rel=2e-4)
    assert found[0] == pytest.approx(exact[0], rel=1e-8)


@pytest.mark.parametrize(
    "row",
    DATA["irvine_sagging_cable_symmetric_inplane"]["rows"],
    ids=lambda row: f"lambda2 {row['lambda2']:.4g}",
)
def test_sagging_cable_has_irvines_symmetric_frequency(row: dict[str, Any]) -> None:
    """Sag of 1 % of the span, where Irvine's parabola holds; EA follows from his parameter lambda²."""
    l, rhoA, sag = 100.0, 1.0, 0.01
    w = rhoA * G
    H = w * l / (8 * sag)
    Le = l * (1 + 8 * sag**2)
    EA = row["lambda2"] * H * Le / (l * (w * l / H) ** 2)
    length = l * (1 + 8 / 3 * sag**2) - H * Le / EA

    def parabola(u: float) -> tuple[float, float]:
        return u * l, -4 * sag * l * u * (1 - u)

    m = fx.Model(gravity=(0, -G))
    rope = m.cable_line("rope", parabola, 12, length=length, EA=EA, EI=0.0, mass_per_length=rhoA)
    m.fix(rope.points[0], rope.points[-1])
    system = m.build()
    state = system.equilibrium()
    H = -state.force("rope_p0.x")
    lambda2 = (w * l / H) ** 2 * l * EA / (H * Le)
    modes = [mode.omega for mode in system.vibrations(state, count=3)]

    def irvine(X: float) -> float:
        return float((X / 2 - (4 / lambda2) * (X / 2) ** 3) * np.cos(X / 2) - np.sin(X / 2))

    X = brentq(irvine, np.pi * 1.0001, 2.9999 * np.pi)
    assert (
        min(abs(omega / (X * np.sqrt(H / rhoA) / l) - 1) for omega in modes) < 2e-3 + H / EA
    )  # and Green's strain
