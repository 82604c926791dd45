"""Models of very different sizes, masses and times give the same dimensionless results, or are refused by name."""

from collections.abc import Callable

import numpy as np
import pytest
from longer import longer

import flexel as fx
from flexel.base.arrays import Array

Units = tuple[float, float, float]  # of length, mass and time
Maker = Callable[[float, float, float], tuple[fx.Model, str]]


def pendulum(L: float, M: float, T: float) -> tuple[fx.Model, str]:
    m = fx.Model(gravity=(0, 0, -9.81 * L / T**2))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (L, 0, 0))
    m.frame("R0", fixed=True)
    m.frame("R1")
    m.hinge("pivot", "R0", "R1", axis=(0, 1, 0))
    m.beam("rod", "O", "R1", "A", mass_per_length=2 * M / L)
    return m, "A.z"


def four_bar(L: float, M: float, T: float) -> tuple[fx.Model, str]:
    m = fx.Model(gravity=(0, -9.81 * L / T**2))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (0, 0.1 * L))
    m.point("B", (0.4 * L, 0.25 * L))
    m.point("C", (0.45 * L, 0), fixed=True)
    for name, ends in {"crank": "OA", "coupler": "AB", "rocker": "CB"}.items():
        m.angle(name)
        m.beam(f"{name} bar", ends[0], name, ends[1], mass_per_length=M / L)
    m.independent("crank.angle")
    m.spring("crank.angle", 3.5 * M * L**2 / T**2)
    m.initial("crank.angle", 0.3)
    return m, "B.y"


def truss(L: float, M: float, T: float) -> tuple[fx.Model, str]:
    F = M * L / T**2
    m = fx.Model(gravity=(0, -9.81 * L / T**2))
    m.point("O", (0, 0), fixed=True)
    m.point("C", (2 * L, 0), fixed=True)
    m.point("A", (L, 0.3 * L))
    for name, ends in {"a": "OA", "b": "CA"}.items():
        m.truss(name, *ends, stiffness=1e4 * F / L, mass_per_length=M / L)
    m.load("A.y", -20 * F)
    return m, "A.y"


def arm(L: float, M: float, T: float) -> tuple[fx.Model, str]:
    F = M * L / T**2
    m = fx.Model(gravity=(0, 0, -9.81 * L / T**2))
    m.point("P0", (0, 0, 0), fixed=True)
    m.frame("R0", fixed=True)
    EI, J = 100 * F * L**2, 1e-2 * M * L
    for i in (1, 2):
        m.point(f"P{i}", (i * L / 2, 0, 0))
        m.frame(f"R{i}")
        ends = f"P{i - 1}", f"R{i - 1}", f"P{i}", f"R{i}"
        mass = {"mass_per_length": M / L, "inertia_per_length": (J, J, J)}
        m.beam(f"b{i}", *ends, direction=(0, 1, 0), EA=1e4 * F, GJ=EI, EIy=EI, EIz=EI, **mass)
    return m, "P2.z"


def rope(L: float, M: float, T: float) -> tuple[fx.Model, str]:
    m = fx.Model(gravity=(0, -9.81 * L / T**2))
    m.point("q0", (0, 0), fixed=True)
    for i in range(1, 9):
        m.point(f"q{i}", (i * L / 8, -0.3 * L * np.sin(np.pi * i / 8)), fixed=i == 8)
        stiffness = 8e4 * M / T**2
        m.truss(f"t{i}", f"q{i - 1}", f"q{i}", stiffness=stiffness, mass_per_length=M / L)
    return m, "q4.y"


def wheel(L: float, M: float, T: float) -> tuple[fx.Model, str]:
    m = fx.Model(gravity=(0, 0, -9.81 * L / T**2))
    m.point("hub", (0, 0, 0.4 * L))
    m.frame("rim")
    m.point("contact", (0, 0, 0))
    m.wheel("w", "hub", "rim", "contact", radius=0.4 * L, axle=(0, 1, 0))
    m.body("tyre", "hub", "rim", mass=2 * M, inertia=tuple(share * M * L**2 for share in (0.1, 0.2, 0.1)))
    m.load("hub.x", M * L / T**2)
    return m, "hub.x"


MAKERS: dict[str, Maker] = {
    "pendulum": pendulum,
    "four-bar": four_bar,
    "truss": truss,
    "arm": arm,
    "rope": rope,
    "wheel": wheel,
}
SCALES: list[Units] = [
    (1e-4, 1, 1),
    (1e4, 1, 1),
    (1, 1e-12, 1),
    (1, 1e12, 1),
    (1, 1, 1e-6),
    (1, 1, 1e6),
    (1e-4, 1e-12, 1e-4),
]


def results(make: Maker, units: Units) -> Array:
    """Dimensionless equilibrium, frequencies, eigenvalues, and the ends of an explicit and an implicit motion."""
    L, _, T = units
    m, name = make(*units)
    system, found = m.build(), []
    if make is not wheel:
        rest = system.equilibrium()
        found += [rest[name] / L, *(mode.omega * T for mode in system.vibrations(count=2))]
        found += sorted(abs(system.linearize(rest).eigenvalues()) * T)[:2]
    found.append(system.simulate(0.3 * T, method="DOP853", samples=2, progress=False)[-1][name] / L)
    options = {"method": "generalized-alpha", "step": 0.01 * T}
    found.append(system.simulate(0.3 * T, **options, samples=2, progress=False)[-1][name] / L)
    return np.array(found)


@pytest.mark.filterwarnings("ignore:build.*lengths are in metres:flexel.ModelWarning")
# the steps of the implicit method damp the vibrations along the rope, in all units alike
@pytest.mark.filterwarnings("ignore:simulate. generalized-alpha has removed:flexel.DampingWarning")
@pytest.mark.parametrize("name", longer(MAKERS, "arm"))
def test_results_do_not_depend_on_the_units(name: str) -> None:
    expected = results(MAKERS[name], (1, 1, 1))
    for units in SCALES:
        np.testing.assert_allclose(
            results(MAKERS[name], units), expected, rtol=2e-6, err_msg=f"units {units}"
        )


@pytest.mark.parametrize("name", MAKERS)
@pytest.mark.parametrize(("length", "words"), [(1e-9, "a smaller unit"), (1e9, "a larger unit")])
def test_what_is_too_small_or_too_large_is_refused(name: str, length: float, words: str) -> None:
    with pytest.raises(fx.ModelError, match=rf"the model measures .*e[+-]\d+ m; .*{words} of length"):
        MAKERS[name](length, 1, 1)[0].build()
