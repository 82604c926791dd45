"""The slider-crank of the talk, slides 23 to 30: two beams without second-order terms, damping 1 % and 2 %.

Transient, periodic and swept midpoint deflections, each from the linearized equations and from the full ones.  The
linearized equations hold about the nominal motion, in which the rod stays straight; their coefficients are
periodic.  Their periodic motion is found by harmonic balance, as in the talk, and again in the time domain, as a
reference.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import slider_crank_data as data
from flexel.examples.slider_crank import (
    HARMONICS,
    SHOWN_SPEEDS,
    TIMES,
    Sweep,
    deflection,
    family,
    largest,
    linear_maxima,
    linear_sweep,
    linearized,
    located_maxima,
    nominal_orbit,
    nonlinear,
    slider_crank,
    small_deflection,
    transient,
)
from flexel.examples.slider_crank_branch import Motions, deflections, followed, off_simulation
from flexel.linear import floquet, linear_steps, periodic

ELEMENTS = 2
# Speeds of the full equations [rad/s]: one by one, closer near a sixth and a fifth of the first frequency, where the
# motion is the only one; then followed by arc length, with a step along the curve.
SLOW_SPEEDS = (
    *np.arange(50.0, 125.0, 12.5),
    *np.arange(125.0, 134.0, 3.0),
    *np.arange(135.0, 144.0, 1.0),
    *np.arange(146.0, 160.0, 3.5),
    *np.arange(160.0, 172.0, 1.0),
    *np.arange(172.0, 191.0, 3.0),
)
FAST, FAST_STEP = (190.0, 330.0), 0.12
SPEED_TOLERANCE = 1e-3  # of the speed of a maximum [rad/s]; its deflection changes by the square of it
STEPS = 15  # of the linearized equations between two samples
SPARSE = 20  # times of the transients for each linearization that is stored


# -- linearized equations in the time domain ------------------------------------------------------


def linear_transient(speed: float, zeta: float) -> Array:
    """Return the midpoint deflection (nt,) of the linearized transient: straight rod, velocities of a rigid rod."""
    nominal = nominal_orbit(speed, ELEMENTS, zeta, second_order=False)
    system = slider_crank(speed, ELEMENTS, zeta, second_order=False)
    small = system.along(times=TIMES[::SPARSE]).transient(times=TIMES.tolist())
    midpoint = floquet.interpolated(small_deflection(nominal, ELEMENTS), speed * TIMES)
    q = np.column_stack([small[name] for name in nominal.coefficients.names])
    return np.asarray((midpoint * q).sum(axis=1))


def rate_matrices(c: periodic.Coefficients) -> Array:
    """Return A (ns, 2 nd + 1, 2 nd + 1) of y' = A y for y = (q', q, 1), with rates per radian of the phase."""
    nd, w = len(c.names), c.omega
    A = np.zeros((c.samples, 2 * nd + 1, 2 * nd + 1))
    A[:, :nd, :nd] = -np.linalg.solve(c.M, c.C) / w
    A[:, :nd, nd:-1] = -np.linalg.solve(c.M, c.K) / w**2
    A[:, :nd, -1] = np.linalg.solve(c.M, c.F[..., None])[..., 0] / w**2
    A[:, nd:-1, :nd] = np.eye(nd)
    return A


def transitions(c: periodic.Coefficients) -> Array:
    """Compute the transition matrices (ns, 2 nd + 1, 2 nd + 1) of (q', q, 1) from sample to sample of a period."""
    rates = rate_matrices(c)
    phases = np.linspace(0.0, 2 * np.pi, c.samples + 1)
    return linear_steps.transitions(lambda at: floquet.interpolated(rates, at), phases, STEPS)


def periodic_in_time(c: periodic.Coefficients) -> Array:
    """Return the degrees of freedom (ns, nd) of the periodic small vibration, from the transition over the period."""
    steps, nd = transitions(c), len(c.names)
    Y = np.eye(2 * nd + 1)
    for step in steps:
        Y = step @ Y
    y = [np.append(np.linalg.solve(np.eye(2 * nd) - Y[:-1, :-1], Y[:-1, -1]), 1.0)]
    for step in steps[:-1]:
        y.append(step @ y[-1])
    return np.array(y)[:, nd:-1]


def largest_in_time(c: periodic.Coefficients, midpoint: Array) -> float:
    """Return the largest deflection of the periodic motion, found in the time domain."""
    return largest((midpoint * periodic_in_time(c)).sum(axis=1))


# -- the full equations ---------------------------------------------------------------------------


def full_motion(zeta: float, speed: float, start: fx.PeriodicSolution | None = None) -> fx.PeriodicSolution:
    """Find the periodic motion of the talk's model at a speed, from that at a nearby one."""
    system = slider_crank(speed, ELEMENTS, zeta, second_order=False)
    return system.periodic(start, period=2 * np.pi / speed, harmonics=HARMONICS)


def full_motions(zeta: float, speeds: Sequence[float] = SLOW_SPEEDS) -> list[fx.PeriodicSolution]:
    """Find periodic motions of the talk's model from speed to speed."""
    found: list[fx.PeriodicSolution] = []
    for speed in speeds:
        found.append(full_motion(zeta, speed, found[-1] if found else None))
    return found


def full_branch(zeta: float, ends: tuple[float, float] = FAST, step: float = FAST_STEP) -> fx.PeriodicBranch:
    """Follow periodic motions of the talk's model from one speed to another."""
    return followed(zeta, ends, step, ELEMENTS, second_order=False, harmonics=HARMONICS)


def full_maxima(zeta: float, motions: Motions) -> Array:
    """Locate the maxima (n, 2) of the largest deflection over the speed, between the motions of a curve.

    Each is sought among motions at speeds between its neighbours, so that it does not depend on the steps.
    """

    def at(i: int, speed: float) -> float:
        return largest(deflection(full_motion(zeta, speed, motions[i]).motion, ELEMENTS))

    speeds = np.array([found.omega for found in motions])
    return located_maxima(speeds, deflections(motions, ELEMENTS), at, SPEED_TOLERANCE)


@dataclass(frozen=True)
class TalkResults:
    """The results of this module for one damping; deflections over the rod's length.

    `maxima` (n, 2) and `full_maxima` have rows of speed and largest deflection of the linearized and of the full
    equations.
    """

    linear_transient: Array
    transient: Array
    linear_periodic: Array
    linear_periodic_in_time: float
    periodic: Array
    swept: Sweep
    maxima: Array
    maxima_in_time: Array
    slow: list[fx.PeriodicSolution]  # full equations, at `SLOW_SPEEDS`
    fast: fx.PeriodicBranch
    full_maxima: Array


def analyse_talk(zeta: float) -> TalkResults:
    """Run the analyses of this module for one damping."""
    c = nominal_orbit(data.SPEED, ELEMENTS, zeta, second_order=False).coefficients
    nominal, equations = family(ELEMENTS, zeta, second_order=False)
    midpoint = small_deflection(nominal, ELEMENTS)
    swept = linear_sweep(zeta, ELEMENTS, SHOWN_SPEEDS, HARMONICS, second_order=False)
    maxima = linear_maxima(zeta, swept, ELEMENTS, second_order=False)
    slow, fast = full_motions(zeta), full_branch(zeta)
    return TalkResults(
        linear_transient=linear_transient(data.SPEED, zeta),
        transient=deflection(transient(zeta, ELEMENTS, second_order=False), ELEMENTS),
        linear_periodic=linearized(data.SPEED, ELEMENTS, zeta, second_order=False),
        linear_periodic_in_time=largest_in_time(c, midpoint),
        periodic=nonlinear(data.SPEED, ELEMENTS, zeta, second_order=False),
        swept=swept,
        maxima=maxima,
        maxima_in_time=np.array([largest_in_time(equations.at(w), midpoint) for w in maxima[:, 0]]),
        slow=slow,
        fast=fast,
        full_maxima=np.vstack([full_maxima(zeta, motions) for motions in (slow, fast)]),
    )


def simulated(found: TalkResults, zeta: float) -> float:
    """Compare the full periodic motion near the maximum at a fifth of the first frequency with simulation."""
    fifth = found.maxima[-3, 0]
    near = min(found.slow, key=lambda motion: abs(motion.omega - fifth))
    system = slider_crank(near.omega, ELEMENTS, zeta, second_order=False)
    motion = system.periodic(near, period=near.period, harmonics=HARMONICS)
    return off_simulation(system, motion, ELEMENTS)
