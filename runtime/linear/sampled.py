"""Linearizes the closed loop of sampled controllers from one instant to the next."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd, lcm

import numpy as np
from scipy.linalg import expm

from flexel.base.arrays import Array, ComplexArray
from flexel.base.callers import outside
from flexel.base.copies import Portable
from flexel.base.errors import LinearizationError, UnsteadyWarning
from flexel.base.shown import counted, listed, prints
from flexel.linear.sensors import state_space
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.mechanics.steadiness import UNSTEADY
from flexel.model.controller import SAME, Controller

CHANGE_TOLERANCE = 1e-6  # relative change of an output or state at an instant that counts as none
FREE = 1e-13  # what a deviation may change elsewhere in one period, relative to the largest entry: rounding
MAX_PERIODS = 1000  # of all controllers, until their instants repeat


@dataclass(frozen=True)
class SampledLoop(Portable):
    """The linearized closed loop of sampled controllers: δs(t + period) = state_matrix δs(t), just before an instant.

    Attributes
    ----------
    state_matrix : ndarray (ns, ns)
    states : tuple of str (ns,)
        Those of the linearization: rates and values of the degrees of freedom, and internal states, including held
        and delayed outputs and the controllers' states.
    period : float
        Time after which all instants repeat [s]: the period, or the least common multiple of several.
    dofs : tuple of str
        Those of the states that are degrees of freedom, dynamic and kinematic.
    """

    state_matrix: Array = field(repr=False)
    states: tuple[str, ...]
    period: float
    dofs: tuple[str, ...] = ()

    @prints
    def __repr__(self) -> str:
        said = f"{'' if self.stable else 'not '}stable"
        if self.free:
            said += f", with {counted(len(self.free), 'free motion')}: {listed(self.free)}"
        return f"SampledLoop(period {self.period:g} s, {counted(len(self.states), 'state')}; {said})"

    def eigenvalues(self) -> ComplexArray:
        """Compute the eigenvalues of one period, largest first; the loop is stable if all are below one in magnitude.

        An output that is replaced at each instant adds an eigenvalue 0, and each of `free` an eigenvalue 1.
        """
        found = np.linalg.eigvals(self.state_matrix).astype(complex)
        return np.asarray(found[np.lexsort((found.imag, -np.abs(found)))])

    @property
    def stable(self) -> bool:
        """Whether every small deviation decays, except those of `free`, which remain as they are."""
        kept = self._bound()
        return bool(np.all(np.abs(np.linalg.eigvals(self.state_matrix[np.ix_(kept, kept)])) < 1.0))

    @property
    def free(self) -> tuple[str, ...]:
        """Coordinates that no force depends on, such as the angle of a shaft in a speed loop: a deviation remains."""
        kept = set(self._bound())
        return tuple(name for i, name in enumerate(self.states) if i not in kept)

    def _bound(self) -> list[int]:
        """Return the states without the free coordinates: a deviation of one of these changes nothing else."""
        kept = list(range(len(self.states)))
        while True:
            A = self.state_matrix[np.ix_(kept, kept)]
            alone = np.abs(A - np.eye(len(kept))).max(axis=0, initial=0.0) <= FREE * np.abs(A).max(
                initial=0.0
            )
            free = [i for i, apart in zip(kept, alone, strict=True) if apart and self.states[i] in self.dofs]
            if not free:
                return kept
            kept = [i for i in kept if i not in free]


def sampled_loop(lin: LinearizedSystem) -> SampledLoop:
    """Build the loop of all sampled controllers of a linearization; see `Linearization.sampled`."""
    controllers = [c for c in lin.state.structure.controllers if c.period is not None]
    if not controllers:
        raise LinearizationError(
            "sampled: no controller has a period; eigenvalues() are those of the closed loop"
        )
    _check_fixed(lin, controllers)
    period, counts = _common_period(controllers)
    size = len(lin.states)
    places = {name: size - len(lin.internal) + i for i, name in enumerate(lin.internal)}
    changes: list[tuple[float, Array]] = []  # times, and the changes of a deviation at them
    for c, count in zip(controllers, counts, strict=True):
        sample, times = _sample(lin, c, places), [period * i / count for i in range(count)]
        changes += [(t, sample) for t in times]
        if c.lag[1]:
            release = _release(c, places, size)
            changes += [(t + c.lag[1], release) for t in times]
    return SampledLoop(
        _product(lin.state_matrix, changes, period, SAME * period / max(counts)), lin.states, period, lin.dofs
    )


def _check_fixed(lin: LinearizedSystem, controllers: list[Controller]) -> None:
    """Warn of a state that is not a fixed point: it accelerates, or a controller would change its outputs or state."""
    state, index = lin.state, lin.state.structure.internal
    change = "the state accelerates" if lin.acceleration > UNSTEADY else ""
    for c in controllers:
        names = (*c.shown, *c.own)
        now = np.array([state.z[index[name]] for name in names])
        after = np.concatenate(c.advanced(state.t, c.measured(state), c.remembered(state)))
        off = np.abs(after - now) - CHANGE_TOLERANCE * np.maximum(np.abs(after), np.abs(now))
        worst = int(np.argmax(off))
        if off[worst] > CHANGE_TOLERANCE:
            change = f"{c.owner} would change '{names[worst]}' from {now[worst]:.4g} to {after[worst]:.4g}"
    if change:
        warnings.warn(
            f"sampled: this is not a fixed point of the loop, because {change}: the eigenvalues are those of the "
            "motion only where the loop is linear; simulate until it settles, and linearize there",
            UnsteadyWarning,
            stacklevel=outside(),
        )


def _product(A: Array, changes: list[tuple[float, Array]], period: float, same: float) -> Array:
    """Compute the matrix of a period: changes at the same time add up, as all depend on the deviation before it."""
    flows: dict[int, Array] = {}
    unit = np.eye(len(A))
    loop, change, t = unit, np.zeros_like(A), 0.0
    for later, more in [*sorted(changes, key=lambda change: change[0]), (period, np.zeros_like(A))]:
        if later - t > same:
            step = round((later - t) / same)
            if step not in flows:
                flows[step] = expm(A * (later - t))
            loop, change, t = flows[step] @ (unit + change) @ loop, np.zeros_like(A), later
        change = change + more
    return loop


def _common_period(controllers: list[Controller]) -> tuple[float, list[int]]:
    """Return the time after which all instants repeat [s], and the periods of each controller within it."""
    periods = [c.period for c in controllers if c.period is not None]
    ratios = [Fraction(period / periods[0]).limit_denominator(MAX_PERIODS) for period in periods]
    whole = Fraction(
        lcm(*(ratio.numerator for ratio in ratios)), gcd(*(ratio.denominator for ratio in ratios))
    )
    counts = [int(whole / ratio) if ratio else 0 for ratio in ratios]
    exact = all(
        abs(float(ratio) * periods[0] - T) <= SAME * T for ratio, T in zip(ratios, periods, strict=True)
    )
    if not exact or sum(counts) > MAX_PERIODS:
        given = ", ".join(f"'{c.name}' {c.period:g} s" for c in controllers)
        raise LinearizationError(
            f"sampled: the periods ({given}) have no common multiple within {MAX_PERIODS} periods; give periods that "
            "are multiples of one, or simulate"
        )
    return float(whole) * periods[0], counts


def _sample(lin: LinearizedSystem, c: Controller, places: dict[str, int]) -> Array:
    """Return the change made by a controller at an instant, δs after less δs before, as a matrix."""
    size, nu, ny = len(lin.states), len(c.outputs), len(c.inputs)
    unit = np.eye(size)
    own, held, waiting = (
        np.array([places[name] for name in names], dtype=np.intp) for names in (c.own, c.shown, c.waiting)
    )
    slopes = c.slopes(lin.state)
    measured = state_space(lin, (), c.inputs)[2]
    found = slopes[:, :ny] @ measured + slopes[:, ny:] @ unit[own]
    after = unit.copy()
    after[own] = found[nu:]
    queue = np.vstack([unit[waiting], found[:nu]])
    if not c.lag[1]:
        after[held] = queue[:nu]
    if waiting.size:
        after[waiting] = queue[nu:]
    return after - unit


def _release(c: Controller, places: dict[str, int], size: int) -> Array:
    """Return the change when delayed outputs take effect, as a matrix."""
    found = np.zeros((size, size))
    for name, waiting in zip(c.shown, c.waiting[: len(c.outputs)], strict=True):
        found[places[name], places[waiting]] = 1.0
        found[places[name], places[name]] = -1.0
    return found
