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
from scipy.optimize import minimize_scalar

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import slider_crank_data as data
from flexel.linear import periodic
from flexel.model.node import Node
from flexel.results.reproduction import Report

CONVERGED = 4  # elements with second-order terms: the periodic deflection changes by 0.02 % with 8
HARMONICS = 16
SAMPLES = 4 * HARMONICS + 4
DAMPING = (0.01, 0.02)
SPEEDS = np.linspace(50.0, 330.0, 200)  # of the linearized sweep whose time is taken [rad/s]
PEAKS = (133.0, 144.0), (158.0, 172.0), (199.0, 211.0), (260.0, 280.0)
SHOWN_SPEEDS = np.unique(  # of the linearized sweeps: closer near their maxima
    np.concatenate([np.linspace(50.0, 330.0, 113), *(np.arange(*ends, 0.5) for ends in PEAKS)])
)
MORE_SPEEDS = (
    110.0,
    131.0,
    134.0,
    136.0,
    138.0,
    139.0,
    140.0,
    142.0,
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
SPEED_TOLERANCE = 1e-4  # of the speed of a maximum [rad/s]
TIMES = np.linspace(0.0, SECONDS, 2001)  # of the transients [s]
p = data.DATA


# -- models ---------------------------------------------------------------------------------------


def bends(elements: int, spatial: bool = False) -> list[str]:
    """Return the names of the bending deformations in the plane of motion."""
    return [f"rod{i}.bend{j}" for i in range(1, elements + 1) for j in ((3, 4) if spatial else (1, 2))]


def slider_crank(
    speed: float, elements: int = 2, zeta: float = 0.02, second_order: bool = True, spatial: bool = False
) -> fx.System:
    """Build the mechanism with its crank at angle speed·t, Kelvin–Voigt damping 2 zeta/ω₀ of the model's ω₀."""
    m, height = fx.Model(), (0.0,) if spatial else ()
    O, A = m.point("O", (0, 0, *height), fixed=True), m.point("A", (p["r"], 0, *height))
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
    """Add beams from node A with orientation r0 to p1, p2, … along x, flexible in bending about z alone."""
    last, orientation, height = "A", "r0", (0.0,) if spatial else ()
    for i in range(1, elements + 1):
        point, angle = f"p{i}", f"r{i}"
        m.point(point, (p["r"] + p["l"] * i / elements, 0, *height))
        (m.frame if spatial else m.angle)(angle)
        m.beam(
            f"rod{i}", last, orientation, point, angle,
            EIz=p["EI"], damping=damping, mass_per_length=p["rhoA"], second_order=second_order,
            direction=(0, 1, 0) if spatial else None,
        )  # fmt: skip
        last, orientation = point, angle


@cache
def omega0(elements: int, second_order: bool = True) -> float:
    """Return the first natural frequency of the pinned rod alone [rad/s]."""
    m = fx.Model()
    m.point("A", (p["r"], 0), fixed=True)
    m.angle("r0")
    _rod(m, elements, 0.0, second_order, spatial=False)
    m.fix(f"p{elements}.y")
    return m.build().vibrations(count=1)[0].omega


# -- the midpoint ---------------------------------------------------------------------------------


def chord(A: Array, B: Array) -> Array:
    """Return unit vectors (ns, 2) of the plane from the crank pin to the slider."""
    e = (B - A)[:, :2]
    return np.asarray(e / np.linalg.norm(e, axis=1)[:, None])


def deflection(motion: fx.Motion | periodic.Orbit, elements: int = CONVERGED) -> Array:
    """Return the deflection of the midpoint over the rod's length (ns,), exact in large displacements."""
    place = motion.coordinates if isinstance(motion, periodic.Orbit) else motion.position
    A, B, mid = (place(name) for name in ("A", f"p{elements}", f"p{elements // 2}"))
    e, r = chord(A, B), (mid - A)[:, :2]
    return np.asarray((e[:, 0] * r[:, 1] - e[:, 1] * r[:, 0]) / p["l"])


def small_deflection(nominal: periodic.Orbit, elements: int) -> Array:
    """Return its derivatives (ns, nd) by the degrees of freedom, about the nominal motion."""
    end, middle = f"p{elements}", f"p{elements // 2}"
    e = chord(nominal.coordinates("A"), nominal.coordinates(end))
    d = nominal.sensitivity(middle) - nominal.sensitivity(end) / 2
    return np.asarray((e[:, :1] * d[:, 1] - e[:, 1:] * d[:, 0]) / p["l"])


def largest(series: Array) -> float:
    """Return the largest magnitude over the continuous period."""
    return float(np.abs(periodic.refined(series)).max())


def amplitudes(series: Array, count: int = 6) -> Array:
    """Return the amplitudes (count + 1,) of the harmonics."""
    return np.asarray(np.hypot(*periodic.cosine_sine(series, count).T))


# -- analyses -------------------------------------------------------------------------------------


def nominal_orbit(speed: float, elements: int = 2, zeta: float = 0.02, **options: bool) -> periodic.Orbit:
    """Return the rigid-body motion over one turn of the crank, linearized along it."""
    return periodic.orbit(slider_crank(speed, elements, zeta, **options), 2 * np.pi / speed, SAMPLES)


def linearized(speed: float, elements: int = 2, zeta: float = 0.02, **options: bool) -> Array:
    """Return the midpoint deflection (ns,) over a turn by harmonic balance of the linearized equations."""
    nominal = nominal_orbit(speed, elements, zeta, **options)
    vibration = nominal.coefficients.harmonic_balance(HARMONICS)
    return np.asarray((small_deflection(nominal, elements) * vibration.samples()[0]).sum(axis=1))


def nonlinear(speed: float, elements: int = 2, zeta: float = 0.02, **options: bool) -> Array:
    """Return the midpoint deflection (ns,) over a turn of the full nonlinear periodic motion."""
    system = slider_crank(speed, elements, zeta, **options)
    return deflection(periodic.periodic_motion(system, 2 * np.pi / speed, HARMONICS)[0], elements)


def transient(zeta: float, elements: int = CONVERGED, second_order: bool = True) -> fx.Motion:
    """Simulate from the straight rod at 150 rad/s, with the velocities of a rigid rod."""
    system = slider_crank(data.SPEED, elements, zeta, second_order)
    return system.simulate(SECONDS, times=TIMES, method="Radau", rtol=1e-6, atol=1e-9, progress=False)


def family(
    elements: int, zeta: float, second_order: bool = True
) -> tuple[periodic.Orbit, periodic.SpeedFamily]:
    """Return a nominal orbit, and the linearized equations at every speed."""
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


def linear_sweep(
    zeta: float, elements: int = 2, speeds: Array = SPEEDS, harmonics: int = 12, second_order: bool = True
) -> Sweep:
    """Solve the linearized equations: harmonic balance at every speed, with the quasi-static solution."""
    nominal, equations = family(elements, zeta, second_order)
    midpoint = small_deflection(nominal, elements)

    def at(speed: float) -> tuple[Array, Array, float]:
        c = equations.at(speed)
        found = c.harmonic_balance(harmonics)
        q = found.samples()[0]
        return (midpoint * q).sum(axis=1), (midpoint * c.quasi_static()).sum(axis=1), found.error

    found = periodic.speed_range(at, speeds)
    series = [result[0] for result in found.results]
    return Sweep(
        found.speeds,
        np.array([largest(motion) for motion in series]),
        np.array([amplitudes(motion) for motion in series]),
        np.array([amplitudes(result[1]) for result in found.results]),
        max(result[2] for result in found.results),
        found.message,
    )


def located_maxima(
    speeds: Array, deflections: Array, at: Callable[[int, float], float], tolerance: float
) -> Array:
    """Locate the maxima of a curve between its points: rows (n, 2) of speed and largest deflection.

    Parameters
    ----------
    speeds, deflections : ndarray (n,)
        Points of the curve.
    at : callable
        The deflection at a speed near the point of a number.
    tolerance : float
        Of the speed [rad/s].
    """
    rows = []
    for i in (
        np.flatnonzero((deflections[1:-1] > deflections[:-2]) & (deflections[1:-1] >= deflections[2:])) + 1
    ):

        def negative(speed: float, i: int = int(i)) -> float:
            return -at(i, speed)

        bounds = min(speeds[i - 1], speeds[i + 1]), max(speeds[i - 1], speeds[i + 1])
        found = minimize_scalar(negative, bounds=bounds, method="bounded", options={"xatol": tolerance})
        rows.append((found.x, -found.fun))
    return np.array(rows)


def linear_maxima(zeta: float, swept: Sweep, elements: int, second_order: bool = True) -> Array:
    """Locate the maxima of a linearized sweep between its speeds: rows (n, 2) of speed and largest deflection."""
    nominal, equations = family(elements, zeta, second_order)
    midpoint = small_deflection(nominal, elements)

    def at(_: int, speed: float) -> float:
        vibration = equations.at(speed).harmonic_balance(HARMONICS)
        return largest((midpoint * vibration.samples()[0]).sum(axis=1))

    return located_maxima(swept.speeds, swept.largest, at, SPEED_TOLERANCE)


def nonlinear_sweep(
    zeta: float,
    elements: int = CONVERGED,
    speeds: tuple[float, ...] = NONLINEAR_SPEEDS,
    second_order: bool = True,
) -> Sweep:
    """Find nonlinear periodic motions from speed to speed."""

    def measure(motion: periodic.Orbit, vibration: periodic.PeriodicVibration) -> tuple[Array, float]:
        return deflection(motion, elements), vibration.error

    system = lambda speed: slider_crank(speed, elements, zeta, second_order)  # noqa: E731
    found = periodic.nonlinear_range(system, speeds, HARMONICS, measure)
    return Sweep(
        found.speeds,
        np.array([largest(series) for series, _ in found.results]),
        np.array([amplitudes(series) for series, _ in found.results]),
        np.zeros((0, 0)),
        max(result[1] for result in found.results),
        found.message,
    )


@dataclass(frozen=True)
class SliderCrankResults:
    """All computed results, for the table and for the figures."""

    transients: dict[float, fx.Motion]
    converged: dict[float, Array]
    converged_linearized: dict[float, Array]
    second_order: Array  # two elements, 2 %
    spatial: Array  # the same in space
    swept: dict[float, Sweep]
    swept_linearized: dict[float, Sweep]  # converged
    maxima: dict[float, Array]  # of these sweeps
    rows_linearized: dict[float, Array]  # largest deflections of the converged model at the nonlinear speeds
    seconds: float


def analyse() -> SliderCrankResults:
    """Run all analyses."""
    omega0(2)
    started = time.perf_counter()
    linear_sweep(0.02)
    seconds = time.perf_counter() - started
    speeds = np.array(NONLINEAR_SPEEDS)
    swept = {ratio: linear_sweep(ratio, CONVERGED, SHOWN_SPEEDS) for ratio in DAMPING}
    return SliderCrankResults(
        transients={ratio: transient(ratio) for ratio in DAMPING},
        converged={ratio: nonlinear(data.SPEED, CONVERGED, ratio) for ratio in DAMPING},
        converged_linearized={ratio: linearized(data.SPEED, CONVERGED, ratio) for ratio in DAMPING},
        second_order=nonlinear(data.SPEED),
        spatial=nonlinear(data.SPEED, spatial=True),
        swept={ratio: nonlinear_sweep(ratio) for ratio in DAMPING},
        swept_linearized=swept,
        maxima={ratio: linear_maxima(ratio, swept[ratio], CONVERGED) for ratio in DAMPING},
        rows_linearized={
            ratio: linear_sweep(ratio, CONVERGED, speeds, HARMONICS).largest for ratio in DAMPING
        },
        seconds=seconds,
    )


# -- the table ------------------------------------------------------------------------------------


def reproduce(out: Path | None = None) -> Report:
    """Compute all quantities with their reference values; write figures to `out`, if given."""
    from flexel.examples.slider_crank_branch import analyse_branches
    from flexel.examples.slider_crank_table import branches, single, sweeps, talk
    from flexel.examples.slider_crank_talk import analyse_talk

    results, followed = analyse(), analyse_branches()
    slides = {zeta: analyse_talk(zeta) for zeta in DAMPING}
    files: list[Path] = []
    if out is not None:
        from flexel.examples.slider_crank_figures import pictures

        files = pictures(results, followed, slides, out)
    rows = [*single(results), *talk(results, slides), *sweeps(results), *branches(followed)]
    return Report("slider-crank", rows, files)
