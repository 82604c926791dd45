"""Flexible beams: frequencies, deflections and stability of straight beams against exact rods, with their orders.

Exact values: `examples/data/beam_frequencies.json`, `elastica_cantilever.json`, `buckling.json` (from the benchmark
collection, with their sources); frequencies that have a closed form stand here as such.  The bending frequencies
converge with the fourth order (cubic Hermite mass, exact static shapes), with shear with the second (the slopes of
the mass interpolation are those of the sections); large deflections with the second, because a bending deformation
is the sine of an angle.
"""

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
from chains import chain
from coarse import COARSE_MESH
from scipy.optimize import brentq

from flexel.base.arrays import Array
from flexel.base.errors import UnstableWarning
from flexel.examples.published import published
from flexel.parts.model import Model
from flexel.results.system_facade import System

FREQUENCIES: dict[str, Any] = published("beam_frequencies")


ELASTICA = {row["PL2_EI"]: row for row in published("elastica_cantilever")["vertical_tip_load"]}


LATERAL = float(published("buckling")["lateral_buckling_cantilever"]["constant_4_0126"])


ENDS = ("p", "frame_p", "q", "frame_q")


def frequencies(m: Model, count: int = 3) -> Array:
    """Lowest natural frequencies [rad/s] from the linearized equations of motion."""
    w = m.build().linearize().eigenvalues()
    assert np.max(np.abs(w.real)) < 1e-6 * np.max(np.abs(w))
    return np.sort(w.imag[w.imag > 0])[:count]


def errors(computed: Sequence[Array], exact: Any) -> Array:
    """Relative errors, a row for each mesh."""
    return np.abs(np.array(computed) / np.asarray(exact, dtype=float) - 1)


def orders(e: Array) -> Array:
    """Order of convergence between meshes of which each is twice as fine as the one before."""
    return np.asarray(np.log2(e[:-1] / e[1:]))


CLAMPED = np.array([float(value) for value in FREQUENCIES["euler_bernoulli_betaL"]["clamped-free"][:3]]) ** 2


WAVES = np.pi * np.arange(1, 4)


@pytest.mark.parametrize("plane", ["EIy", "EIz"])
def test_cantilever_frequencies_converge_to_euler_bernoulli_with_order_four(plane: str) -> None:
    found = [frequencies(chain(n, mass_per_length=1.0, **{plane: 1.0})) for n in (4, 8, 16)]
    e = errors(found, CLAMPED)
    assert np.max(e[-1]) < 4e-5
    assert np.all(np.abs(orders(e)[-1] - 4) < 0.1)


def test_pinned_beam_converges_to_euler_bernoulli_and_with_rotary_inertia_to_rayleigh() -> None:
    for rhoJ in (0.0, 0.01):
        exact = WAVES**2 / np.sqrt(1 + rhoJ * WAVES**2)
        beam = {"EIz": 1.0, "mass_per_length": 1.0, "inertia_per_length": (0, 0, rhoJ)}
        e = errors([frequencies(chain(n, pinned=True, **beam)) for n in (4, 8, 16)], exact)
        assert np.max(e[-1]) < 1e-4
        assert np.all(np.abs(orders(e)[-1] - 4) < 0.1)


@pytest.mark.parametrize("pinned", [False, True])
@pytest.mark.parametrize("case", FREQUENCIES["timoshenko_square_beam"]["cases"], ids=lambda c: f"h={c['h']}")
def test_thick_beam_converges_to_timoshenko(case: dict[str, Any], pinned: bool) -> None:
    h, E, nu, rho = float(case["h"]), 2.07e11, 0.3, 7850.0
    shear = 10 * (1 + nu) / (12 + 11 * nu) * E / (2 * (1 + nu)) * h**2
    beam = {
        "EIz": E * h**4 / 12,
        "GAy": shear,
        "mass_per_length": rho * h**2,
        "inertia_per_length": (0, 0, rho * h**4 / 12),
    }
    exact = np.array(case["pinned_Timoshenko" if pinned else "cantilever_Timoshenko"], dtype=float)
    e = errors([frequencies(chain(n, pinned=pinned, **beam)) for n in (8, 16, 32)], exact)
    assert np.max(e[-1]) < 9e-4
    assert (
        np.max(e[-1] / errors([frequencies(chain(32, pinned=pinned, **beam | {"GAy": 1e30}))], exact)) < 0.2
    )
    assert np.all(orders(e)[-1] > 1.95)


@pytest.mark.parametrize(
    "beam",
    [
        pytest.param({"GJ": 1.0, "mass_per_length": 1.0, "inertia_per_length": (1, 0, 0)}, id="torsion"),
        pytest.param({"EA": 1.0, "mass_per_length": 1.0}, id="elongation"),
    ],
)
def test_waves_along_a_bar_converge_with_order_two(beam: dict[str, Any]) -> None:
    e = errors([frequencies(chain(n, **beam)) for n in (8, 16, 32)], np.pi / 2 * np.array([1, 3, 5]))
    assert np.max(e[-1]) < 3e-3
    assert np.all(np.abs(orders(e)[-1] - 2) < 0.05)


def test_planes_of_a_beam_vibrate_apart() -> None:
    both = frequencies(chain(6, EIy=1.0, EIz=5.0, mass_per_length=1.0), 4)
    apart = [
        frequencies(chain(6, mass_per_length=1.0, **section), 4) for section in ({"EIy": 1.0}, {"EIz": 5.0})
    ]
    assert np.max(np.abs(both / np.sort(np.concatenate(apart))[:4] - 1)) < 1e-9


def tip(s: System, n: int) -> Array:
    """Displacement (3,) of the tip in equilibrium."""
    return s.equilibrium().position(f"p{n}") - [1, 0, 0]


@pytest.mark.parametrize("n", [1, 3])
def test_small_end_loads_are_met_exactly_by_any_number_of_elements(n: int) -> None:
    section = {"EA": 7.0, "GJ": 2.0, "EIy": 3.0, "EIz": 5.0, "GAy": 11.0, "GAz": 13.0}
    P = 1e-6
    inertia = {"mass_per_length": 1.0, "inertia_per_length": (1, 1, 1)}
    loads: dict[str, tuple[tuple[str, Sequence[float]], Sequence[float], Sequence[float]]] = {
        "force along": (("p", (P, 0, 0)), (P / 7, 0, 0), (0, 0, 0)),
        "force in y": (("p", (0, P, 0)), (0, P / 15 + P / 11, 0), (0, 0, P / 10)),
        "force in z": (("p", (0, 0, P)), (0, 0, P / 9 + P / 13), (0, -P / 6, 0)),
        "torque": (("r", (P, 0, 0)), (0, 0, 0), (P / 2, 0, 0)),
        "moment about y": (("r", (0, P, 0)), (0, 0, -P / 6), (0, P / 3, 0)),
        "moment about z": (("r", (0, 0, P)), (0, P / 10, 0), (0, 0, P / 5)),
    }
    for (node, load), displacement, turn in loads.values():
        m = chain(n, **section, **inertia)
        m.load(f"{node}{n}", load)
        state = m.build().equilibrium()
        assert np.max(np.abs(state.position(f"p{n}") - [1, 0, 0] - displacement)) < 1e-5 * P
        assert np.max(np.abs(2 * state.position(f"r{n}")[1:] - turn)) < 1e-5 * P


def test_own_weight_bends_a_cantilever_exactly_at_its_nodes() -> None:
    for n in (1, 4):
        m = chain(n, EIz=2e5, mass_per_length=3.0, gravity=(0, -9.81, 0))
        state = m.build().equilibrium()
        q = 3.0 * 9.81 / 2e5
        for i in range(n + 1):
            x = i / n
            w = q * (x**4 / 24 - x**3 / 6 + x**2 / 4)
            assert abs(state[f"p{i}.y"] + w) < 1e-6 * q
        assert abs(state.force("p0.y") - 3.0 * 9.81) < 1e-9


@COARSE_MESH
@pytest.mark.parametrize("load", ["1", "5"])
@pytest.mark.parametrize("second_order", [True, False])
def test_large_deflection_converges_to_the_elastica_with_order_two(load: str, second_order: bool) -> None:
    exact = ELASTICA[load]
    e = []
    for n in (4, 8, 16):
        m = chain(n, EIz=1.0, mass_per_length=1.0, second_order=second_order)
        m.load(f"p{n}", (0, float(load), 0))
        state = m.build().equilibrium()
        down, back = state[f"p{n}.y"], 1 - state[f"p{n}.x"]
        e.append([abs(down - float(exact["w_over_L"])), abs(back - float(exact["u_over_L"]))])
        assert abs(state.force("p0.y") + float(load)) < 1e-9
    assert np.max(e[-1]) < 1.1e-3
    assert np.all(orders(np.array(e))[-1] > 1.9)


def test_steady_motion_and_equilibrium_find_the_same_shape() -> None:
    m = chain(4, EIz=1.0, EIy=3.0, GJ=2.0, mass_per_length=1.0, inertia_per_length=(0.01, 0.01, 0.01))
    m.load("p4", (0.0, 0.6, 0.4))
    s = m.build()
    steady, rest = s.steady(), s.equilibrium()
    assert np.max(np.abs(steady.x - rest.x)) < 1e-10
    assert np.max(np.abs(s.linearize(steady).K - s.linearize(rest).K)) < 1e-8


STRIP = {"EIy": 1.0, "GJ": 1.0, "EIz": 1e4, "EA": 1e7, "mass_per_length": 1.0}


def softest(n: int, P: float, second_order: bool) -> float:
    """Lowest eigenvalue of M^-1 K of a strip on edge that carries a load P at its tip."""
    m = chain(n, **STRIP, inertia_per_length=(0.1, 0.1, 0.1), second_order=second_order)
    m.load(f"p{n}", (0, -P, 0))
    s = m.build()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UnstableWarning)  # the search looks on both sides
        lin = s.linearize(s.equilibrium())
    return float(np.min(np.linalg.eigvals(np.linalg.solve(lin.M, lin.K)).real))


@pytest.mark.parametrize(
    ("n", "second_order", "percent"),
    [(2, False, 22.1), (4, False, 4.6), (8, False, 1.13), (2, True, 6.9), (4, True, 1.55), (8, True, 0.40)],
)
def test_lateral_buckling_has_the_known_error_of_so_many_elements(
    n: int, second_order: bool, percent: float
) -> None:
    # where the stiffness of the preloaded strip vanishes, its bending before that included
    load = brentq(lambda P: softest(n, P, second_order), 3.9, 5.0, xtol=1e-6)
    digits = 0.05 if percent > 2 else 0.005
    assert abs(100 * (load / LATERAL - 1) - percent) < digits
    # without that bending, 1 / sqrt((1 - EIy/EIz) (1 - GJ/EIz)) less
    s = chain(n, **STRIP, inertia_per_length=(1, 1, 1), second_order=second_order).build()
    up, down = (mode.multiplier for mode in s.buckling(increment={f"p{n}.y": -1.0}, count=2))
    assert abs(up + down) < 1e-6
    assert abs(load / abs(up) - 1 / (1 - 1e-4)) < 4e-5


def rotor(n: int, speed: float, plane: str, second_order: bool) -> Model:
    """A cantilever on a hub that turns about z at constant speed; bending out of the plane (flap) or in it (lag)."""
    m = Model()
    for i in range(n + 1):
        m.point(f"p{i}", (i / n, 0, 0), fixed=i == 0)
        m.frame(f"r{i}")
    m.frame("ground", fixed=True)
    m.hinge("hub", "ground", "r0", axis=(0, 0, 1))
    section, modes = {"flap": ({"EIy": 1.0}, (1, 2)), "lag": ({"EIz": 1.0}, (3, 4))}[plane]
    for i in range(n):
        ends = dict(zip(ENDS, (f"p{i}", f"r{i}", f"p{i + 1}", f"r{i + 1}"), strict=True))
        m.beam(
            f"b{i}", **ends, direction=(0, 1, 0), mass_per_length=1.0, second_order=second_order, **section
        )
    m.prescribe("hub.angle", lambda t: speed * t)
    m.independent(*(f"b{i}.bend{k}" for i in range(n) for k in modes))
    return m


@pytest.mark.parametrize(("plane", "key"), [("flap", "flap"), ("lag", "lag_inextensible")])
@pytest.mark.parametrize(
    "row", [row for row in FREQUENCIES["rotating_cantilever"]["rows"] if not row["hub_radius_over_L"]][1::3]
)
def test_rotating_cantilever_stiffens(plane: str, key: str, row: dict[str, Any]) -> None:
    exact = [float(value) for value in row[key]]
    with_terms = errors([frequencies(rotor(n, row["eta"], plane, True)) for n in (8, 16)], exact)
    without = errors([frequencies(rotor(n, row["eta"], plane, False)) for n in (8, 16)], exact)
    assert np.max(with_terms[-1]) < 5e-5
    assert np.all(orders(with_terms)[-1] > 3.85)
    assert without[-1][0] > 50 * with_terms[-1][0]  # the second-order terms carry the centrifugal stiffening
