"""The excitation of the slider-crank's rod by harmonics, and its nonlinear motions past the fold at 1 % damping."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples.slider_crank import (
    CONVERGED,
    amplitudes,
    deflection,
    family,
    largest,
    omega0,
    slider_crank,
    small_deflection,
)
from flexel.linear import periodic

RANGE = 190.0, 330.0  # speeds that are followed [rad/s]
HARMONICS = {0.01: 24, 0.02: 16}  # with 16 at 1 % damping a multiplier at the second fold is 1.008
STEP = 0.12  # along the branches
BOTH = 257.0  # a speed with two stable motions at 1 % damping [rad/s]
ORDERS = range(3, 9)  # of the harmonics whose excitation is listed
BALANCED = 14  # harmonics of the linearized equations
Motions = Sequence[fx.PeriodicSolution] | fx.PeriodicBranch


# -- excitation -----------------------------------------------------------------------------------


def excitation(elements: int, second_order: bool, zeta: float = 0.01) -> Array:
    """Compute the excitation of the first mode by each harmonic at its resonance, in rows as described in the table.

    Only the direct part is a force on the rod in its nominal motion.  The stiffness varies with the axial force, so
    that the vibration of other harmonics acts as a force in this one as well: what must be applied to the first mode
    so that it does not vibrate in this harmonic is the opposite of both together.
    """
    nominal, equations = family(elements, zeta, second_order)
    midpoint, first = small_deflection(nominal, elements), omega0(elements, second_order)
    rows = []
    for n in ORDERS:
        c = equations.at(first / n)
        direct, total = _forces(c, n)
        scale = _static(c, midpoint)
        speeds = first / n * np.linspace(0.95, 1.01, 31)
        found = max(_amplitude(equations.at(w), midpoint, n) for w in speeds)
        both = scale * float(np.hypot(*total))
        rows.append((n, scale * direct[1], scale * (total[1] - direct[1]), both, both / (2 * zeta), found))
    return np.array(rows)


def _first_mode(c: periodic.Coefficients) -> tuple[float, Array]:
    """Return the square of the frequency, and the shape of unit modal mass, of the first mode with mean values."""
    w2, shapes = eigh(c.K.mean(axis=0), c.M.mean(axis=0))
    return float(w2[0]), np.asarray(shapes[:, 0])


def _static(c: periodic.Coefficients, midpoint: Array) -> float:
    """Return the deflection of the midpoint over the length by a unit force on the first mode."""
    w2, shape = _first_mode(c)
    return abs(float((midpoint @ shape).mean())) / w2


def _forces(c: periodic.Coefficients, n: int) -> tuple[Array, Array]:
    """Return cosine and sine parts of harmonic n of the force on the first mode: direct, and together."""
    shape = _first_mode(c)[1]
    weighted = c.M.mean(axis=0) @ shape
    phase = 2 * np.pi * np.arange(c.samples) / c.samples
    units = [np.outer(wave(n * phase), weighted) for wave in (np.cos, np.sin)]
    motions = [
        periodic.fourier_sum(X, c.omega, phase / c.omega)[0] @ weighted
        for X in c.responses(BALANCED, c.F, *units)
    ]
    own, *by_units = (periodic.cosine_sine(motion, n)[n] for motion in motions)
    return periodic.cosine_sine(c.F @ shape, n)[n], np.linalg.solve(np.array(by_units).T, own)


def _amplitude(c: periodic.Coefficients, midpoint: Array, n: int) -> float:
    """Return the amplitude of harmonic n of the linearized midpoint deflection."""
    q = c.harmonic_balance(BALANCED).samples()[0]
    return float(amplitudes((midpoint * q).sum(axis=1), n)[n])


# -- branches -------------------------------------------------------------------------------------


def followed(
    zeta: float,
    ends: tuple[float, float] = RANGE,
    step: float = STEP,
    elements: int = CONVERGED,
    second_order: bool = True,
    harmonics: int | None = None,
) -> fx.PeriodicBranch:
    """Follow nonlinear periodic motions from one speed to another, by arc length."""
    first, last = (2 * np.pi / speed for speed in ends)
    system = slider_crank(ends[0], elements, zeta, second_order)
    return system.periodic_branch(period=first, end=last, harmonics=harmonics or HARMONICS[zeta], step=step)


def deflections(motions: Motions, elements: int = CONVERGED) -> Array:
    """Return the largest deflection (n,) of each motion."""
    return np.array([largest(deflection(solution.motion, elements)) for solution in motions])


def peaks(branch: fx.PeriodicBranch) -> Array:
    """Return speed and modulus (peaks, 2) where the largest multiplier has a maximum."""
    return np.column_stack([branch.omega, branch.modulus])[branch.peaks]


def simulated(branch: fx.PeriodicBranch, zeta: float, speed: float) -> Array:
    """Compare motions at a speed on the stable parts of a branch, in its order, with simulation."""
    system, found = slider_crank(speed, CONVERGED, zeta), []
    for part, stable in branch.stretches:
        w = branch.omega[part]
        if stable and w.min() < speed < w.max():
            near = branch[part.start + int(np.argmin(np.abs(w - speed)))]
            motion = system.periodic(near, period=2 * np.pi / speed, harmonics=HARMONICS[zeta])
            found.append(off_simulation(system, motion))
    return np.array(found)


def off_simulation(system: fx.System, solution: fx.PeriodicSolution, elements: int = CONVERGED) -> float:
    """Return the largest difference of the deflection after 1 to 5 simulated turns, over the largest deflection."""
    run = system.simulate(
        5 * solution.period, start=solution.motion[0], samples=6, method="Radau", rtol=1e-8, atol=1e-11
    )
    series = deflection(solution.motion, elements)
    return float(np.abs(deflection(run, elements) - series[0]).max()) / largest(series)


@dataclass(frozen=True)
class SweptBranches:
    """The results of this module, for the table and for the figures."""

    excited: Array
    excited_first_order: Array  # two elements
    followed: dict[float, fx.PeriodicBranch]
    deflections: dict[float, Array]
    fold_half_steps: float  # rad/s
    off_simulation: Array  # (2,)


def analyse_branches() -> SweptBranches:
    """Run the analyses of this module."""
    branches = {order: followed(order) for order in HARMONICS}
    fine = followed(0.01, (260.0, 265.0), step=STEP / 2)
    return SweptBranches(
        excited=excitation(CONVERGED, True),
        excited_first_order=excitation(2, False),
        followed=branches,
        deflections={order: deflections(branch) for order, branch in branches.items()},
        fold_half_steps=float(fine.omega[fine.folds[0]]),
        off_simulation=simulated(branches[0.01], 0.01, BOTH),
    )
