"""The flexible slider-crank of Song and Haug: a rigid crank at constant speed drives a slender elastic rod.

Planar rod of any even number of beam elements, axially rigid, or the same in space.  `reproduce` compares transient,
periodic and swept midpoint deflections, linearized and nonlinear, with reference numbers; the general functions are
those of `flexel.linear.periodic`.  The pictures are in `slider_crank_figures`,
the rows of the table in `slider_crank_table`.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import slider_crank_data as data
from flexel.linear import periodic
from flexel.results.report import Report
from flexel.structure.nodes import Node

CONVERGED = 4  # elements with second-order terms: the periodic deflection changes by 0.02 % with 8
HARMONICS = 16
SAMPLES = 4 * HARMONICS + 4
DAMPING = (0.01, 0.02)
SPEEDS = np.linspace(50.0, 330.0, 200)  # of the linearized sweep [rad/s]
MORE_SPEEDS = (
    110.0,
    138.0,
    145.0,
    195.0,
    203.5,
    230.0,
    250.0,
    255.0,
    262.0,
    264.0,
    265.0,
    267.0,
    273.0,
    315.0,
)
NONLINEAR_SPEEDS = tuple(sorted({row[0] for row in data.SWEEP} | set(MORE_SPEEDS)))  # followed upwards
SECONDS = 0.1
p = data.DATA


# -- models ---------------------------------------------------------------------------------------


def bends(elements: int, spatial: bool = False) -> list[str]:
    """Names of the bending deformations in the plane of motion."""
    return [f"rod{i}.bend{j}" for i in range(1, elements + 1) for j in ((3, 4) if spatial else (1, 2))]


def slider_crank(
    speed: float, elements: int = 2, zeta: float = 0.02, second_order: bool = True, spatial: bool = False
) -> fx.System:
    """The mechanism with its crank at angle speed·t, Kelvin–Voigt damping 2 zeta/ω₀ of the model's own ω₀."""
    m, z = fx.Model(), (0.0,) if spatial else ()
    O, A = m.point("O", (0, 0, *z), fixed=True), m.point("A", (p["r"], 0, *z))
    orient: Callable[..., Node] = m.frame if spatial else m.angle
    axis = {"axis": (0, 0, 1)} if spatial else {}
    ground, crank, first = orient("ground", fixed=True), orient("crank arm"), orient("r0")
    m.hinge("crank", ground, crank, **axis)
    m.beam("arm", O, crank, A)
    if spatial:
        m.hinge("pin", crank, first, **axis)
    _rod(m, elements, 2 * zeta / omega0(elements, second_order), second_order, spatial)
    m.fix(f"p{elements}.y")
    m.point_mass("slider", f"p{elements}", p["slider"])
    m.prescribe("crank.angle", fx.Polynomial((0.0, speed)))
    m.independent(*bends(elements, spatial))
    return m.build()


def _rod(m: fx.Model, elements: int, damping: float, second_order: bool, spatial: bool) -> None:
    """Beams from node A with orientation r0 to p1, p2, … along x, flexible in bending about z alone."""
    last, orientation, z = "A", "r0", (0.0,) if spatial else ()
    for i in range(1, elements + 1):
        point, angle = f"p{i}", f"r{i}"
        m.point(point, (p["r"] + p["l"] * i / elements, 0, *z))
        (m.frame if spatial else m.angle)(angle)
        m.beam(
            f"rod{i}", last, orientation, point, angle,
            EIz=p["EI"], damping=damping, mass_per_length=p["rhoA"], second_order=second_order,
            direction=(0, 1, 0) if spatial else None,
        )  # fmt: skip
        last, orientation = point, angle


@cache
def omega0(elements: int, second_order: bool = True) -> float:
    """First natural frequency of the pinned rod alone [rad/s]."""
    m = fx.Model()
    m.point("A", (p["r"], 0), fixed=True)
    m.angle("r0")
    _rod(m, elements, 0.0, second_order, spatial=False)
    m.fix(f"p{elements}.y")
    return m.build().vibrations(count=1)[0].omega


# -- the midpoint ---------------------------------------------------------------------------------


def chord(A: Array, B: Array) -> Array:
    """Unit vectors (ns, 2) of the plane from the crank pin to the slider."""
    e = (B - A)[:, :2]
    return np.asarray(e / np.linalg.norm(e, axis=1)[:, None])


def deflection(motion: fx.Motion | periodic.Orbit, elements: int = CONVERGED) -> Array:
    """Deflection of the midpoint over the rod's length (ns,), exact in large displacements."""
    place = motion.coordinates if isinstance(motion, periodic.Orbit) else motion.position
    A, B, mid = (place(z) for z in ("A", f"p{elements}", f"p{elements // 2}"))
    e, r = chord(A, B), (mid - A)[:, :2]
    return np.asarray((e[:, 0] * r[:, 1] - e[:, 1] * r[:, 0]) / p["l"])


def small_deflection(nominal: periodic.Orbit, elements: int) -> Array:
    """Derivatives (ns, nd) of the same with respect to the degrees of freedom, about the nominal motion."""
    end, middle = f"p{elements}", f"p{elements // 2}"
    e = chord(nominal.coordinates("A"), nominal.coordinates(end))
    d = nominal.sensitivity(middle) - nominal.sensitivity(end) / 2
    return np.asarray((e[:, :1] * d[:, 1] - e[:, 1:] * d[:, 0]) / p["l"])


def largest(series: Array) -> float:
    """Largest magnitude over the continuous period."""
    return float(np.abs(periodic.refined(series)).max())


def amplitudes(series: Array, count: int = 6) -> Array:
    """Amplitudes (count + 1,) of the harmonics."""
    return np.asarray(np.hypot(*periodic.cosine_sine(series, count).T))


# -- analyses -------------------------------------------------------------------------------------


def nominal_orbit(speed: float, elements: int = 2, zeta: float = 0.02, **options: bool) -> periodic.Orbit:
    """The rigid-body motion over one turn of the crank, linearized along it."""
    return periodic.orbit(slider_crank(speed, elements, zeta, **options), 2 * np.pi / speed, SAMPLES)


def linearized(speed: float, elements: int = 2, zeta: float = 0.02, **options: bool) -> Array:
    """Midpoint deflection (ns,) over one turn by harmonic balance of the linearized equations."""
    nominal = nominal_orbit(speed, elements, zeta, **options)
    vibration = nominal.coefficients.harmonic_balance(HARMONICS)
    return np.asarray((small_deflection(nominal, elements) * vibration.samples()[0]).sum(axis=1))


def nonlinear(speed: float, elements: int = 2, zeta: float = 0.02, **options: bool) -> Array:
    """Midpoint deflection (ns,) over one turn of the full nonlinear periodic motion."""
    system = slider_crank(speed, elements, zeta, **options)
    return deflection(periodic.periodic_motion(system, 2 * np.pi / speed, HARMONICS)[0], elements)


def transient(zeta: float, elements: int = CONVERGED) -> fx.Motion:
    """Motion from the straight rod at 150 rad/s, with the velocities of a rigid rod."""
    times = np.linspace(0.0, SECONDS, 2001)
    system = slider_crank(data.SPEED, elements, zeta)
    return system.simulate(SECONDS, times=times, method="LSODA", rtol=1e-6, atol=1e-9, progress=False)


def family(
    elements: int, zeta: float, second_order: bool = True
) -> tuple[periodic.Orbit, periodic.SpeedFamily]:
    """A nominal orbit, and the linearized equations at every speed."""
    orbits = [
        nominal_orbit(speed, elements, zeta, second_order=second_order) for speed in (100.0, 200.0, 300.0)
    ]
    return orbits[0], periodic.SpeedFamily.through(orbits)


@dataclass(frozen=True)
class Sweep:
    """Over speeds [rad/s]: largest deflection, and amplitudes of harmonics 0…6.

    `neglected` is the share of the harmonics left out, `message` where the range ended early and why.
    """

    speeds: Array
    largest: Array
    harmonics: Array
    quasi_static: Array
    neglected: float
    message: str


def linear_sweep(zeta: float, elements: int = 2, speeds: Array = SPEEDS, harmonics: int = 12) -> Sweep:
    """Linearized: harmonic balance at every speed, with the quasi-static solution beside it."""
    nominal, equations = family(elements, zeta)
    midpoint = small_deflection(nominal, elements)

    def at(speed: float) -> tuple[Array, Array, float]:
        c = equations.at(speed)
        found = c.harmonic_balance(harmonics)
        q = found.samples()[0]
        return (midpoint * q).sum(axis=1), (midpoint * c.quasi_static()).sum(axis=1), found.error

    found = periodic.speed_range(at, speeds)
    series = [z[0] for z in found.results]
    return Sweep(
        found.speeds,
        np.array([largest(z) for z in series]),
        np.array([amplitudes(z) for z in series]),
        np.array([amplitudes(z[1]) for z in found.results]),
        max(z[2] for z in found.results),
        found.message,
    )


def nonlinear_sweep(
    zeta: float, elements: int = CONVERGED, speeds: tuple[float, ...] = NONLINEAR_SPEEDS
) -> Sweep:
    """Nonlinear periodic motions from speed to speed."""

    def measure(motion: periodic.Orbit, vibration: periodic.PeriodicVibration) -> tuple[Array, float]:
        return deflection(motion, elements), vibration.error

    system = lambda speed: slider_crank(speed, elements, zeta)  # noqa: E731
    found = periodic.nonlinear_range(system, speeds, HARMONICS, measure)
    return Sweep(
        found.speeds,
        np.array([largest(z) for z, _ in found.results]),
        np.array([amplitudes(z) for z, _ in found.results]),
        np.zeros((0, 0)),
        max(z[1] for z in found.results),
        found.message,
    )


@dataclass(frozen=True)
class Results:
    """Everything that is computed, for the table and for the pictures."""

    transients: dict[float, fx.Motion]
    periodic: dict[float, Array]  # nonlinear, two elements without second-order terms
    linearized: Array  # the same, 2 %, linearized
    converged: dict[float, Array]
    converged_linearized: Array
    second_order: Array  # two elements, 2 %
    spatial: Array  # the same in space
    swept: dict[float, Sweep]
    swept_linearized: dict[float, Sweep]
    rows_linearized: dict[float, Array]  # largest deflections of the converged model at the nonlinear speeds
    seconds: float


def analyse() -> Results:
    """Run all analyses."""
    first = {"second_order": False}
    omega0(2)
    started = time.perf_counter()
    two = linear_sweep(0.02)
    seconds = time.perf_counter() - started
    speeds = np.array(NONLINEAR_SPEEDS)
    return Results(
        transients={z: transient(z) for z in DAMPING},
        periodic={z: nonlinear(data.SPEED, 2, z, **first) for z in DAMPING},
        linearized=linearized(data.SPEED, 2, 0.02, **first),
        converged={z: nonlinear(data.SPEED, CONVERGED, z) for z in DAMPING},
        converged_linearized=linearized(data.SPEED, CONVERGED, 0.02),
        second_order=nonlinear(data.SPEED),
        spatial=nonlinear(data.SPEED, spatial=True),
        swept={z: nonlinear_sweep(z) for z in DAMPING},
        swept_linearized={0.02: two, 0.01: linear_sweep(0.01)},
        rows_linearized={z: linear_sweep(z, CONVERGED, speeds, HARMONICS).largest for z in DAMPING},
        seconds=seconds,
    )


# -- the table ------------------------------------------------------------------------------------


def reproduce(out: Path | None = None) -> Report:
    """All quantities beside their reference values; figures in `out`, if given."""
    from flexel.examples.slider_crank_branch import analyse_branches
    from flexel.examples.slider_crank_table import branches, single, sweeps

    results, followed = analyse(), analyse_branches()
    files: list[Path] = []
    if out is not None:
        from flexel.examples.slider_crank_figures import pictures

        files = pictures(results, followed, out)
    return Report("slider-crank", [*single(results), *sweeps(results), *branches(followed)], files)
