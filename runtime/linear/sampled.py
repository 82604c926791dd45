"""Sampled controllers in the linearized equations: the closed loop from one instant to the next."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.linalg import expm

from flexel.base.arrays import Array, ComplexArray
from flexel.base.copies import Portable
from flexel.base.errors import LinearizationError
from flexel.linear.sensors import state_space
from flexel.mechanics.linearization import Linearization
from flexel.structure.controllers import SAME, Controller


@dataclass(frozen=True)
class SampledLoop(Portable):
    """The linearized closed loop of sampled controllers, δs(t + period) = state_matrix δs(t), just before each instant.

    Attributes
    ----------
    state_matrix : ndarray (ns, ns)
    states : tuple of str (ns,)
        Those of the linearization: rates and values of the degrees of freedom, and internal states, among which are
        the outputs that are held or on their way and the controllers' own states.
    period : float
        [s]
    """

    state_matrix: Array = field(repr=False)
    states: tuple[str, ...]
    period: float

    def eigenvalues(self) -> ComplexArray:
        """Eigenvalues of one period, the largest first; the loop is stable if all are less than one in magnitude.

        An output that is replaced at each instant adds a zero.
        """
        found = np.linalg.eigvals(self.state_matrix).astype(complex)
        return np.asarray(found[np.lexsort((found.imag, -np.abs(found)))])

    @property
    def stable(self) -> bool:
        """Whether every small deviation dies out."""
        return bool(np.all(np.abs(np.linalg.eigvals(self.state_matrix)) < 1.0))


def sampled_loop(lin: Linearization) -> SampledLoop:
    """The loop of all sampled controllers of a linearization; see `Linearization.sampled`."""
    controllers = [c for c in lin.state.structure.controllers if c.period is not None]
    if not controllers:
        raise LinearizationError(
            "sampled: no controller has a period; eigenvalues() are those of the closed loop"
        )
    period = _common_period(controllers)
    size = len(lin.states)
    places = {name: size - len(lin.internal) + i for i, name in enumerate(lin.internal)}
    A, loop, t = lin.state_matrix, np.eye(size), 0.0
    for c in controllers:  # each changes rows of its own, from what was before the instant
        loop = loop + _sample(lin, c, places)
    for c in sorted((c for c in controllers if c.lag[1]), key=lambda c: c.lag[1]):
        rest = c.lag[1]
        later = np.eye(size)
        later[[places[z] for z in c.shown]] = np.eye(size)[[places[z] for z in c.waiting[: len(c.outputs)]]]
        loop, t = later @ expm(A * (rest - t)) @ loop, rest
    return SampledLoop(expm(A * (period - t)) @ loop, lin.states, period)


def _common_period(controllers: list[Controller]) -> float:
    first = controllers[0]
    assert first.period is not None
    for c in controllers:
        assert c.period is not None
        if abs(c.period - first.period) > SAME * first.period:
            raise LinearizationError(
                f"sampled: '{first.name}' has the period {first.period:g} s and '{c.name}' {c.period:g} s; the loop of "
                "several periods is not computed: simulate it, or give them one period"
            )
    return first.period


def _sample(lin: Linearization, c: Controller, places: dict[str, int]) -> Array:
    """What a controller changes at an instant, δs after less δs before, as a matrix."""
    size, nu, ny = len(lin.states), len(c.outputs), len(c.inputs)
    unit = np.eye(size)
    own, held, waiting = (
        np.array([places[z] for z in names], dtype=np.intp) for names in (c.own, c.shown, c.waiting)
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
