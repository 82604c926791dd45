"""A case with everything that its properties share: the system, a state, the oracle and its answer."""

from collections.abc import Callable, Hashable
from dataclasses import replace
from functools import cached_property
from typing import Any, TypeVar

import numpy as np

import flexel as fx
from campaign.case import Case, drawn_nodes
from campaign.changes import Inapplicable
from campaign.oracle import Answer, Oracle
from campaign.parts import twins_of
from flexel.base.arrays import Array

Made = TypeVar("Made")
STRETCH = 1e-3  # of the offsets, over which it is seen how coordinates turn back
ACCURATE = {"rtol": 1e-10, "atol": 1e-12}  # of motions that are compared with each other


class Trial:
    """A case under trial.

    Attributes
    ----------
    case : Case
    nodes : dict of str to Node
    oracle : Oracle
    released : tuple of str
        Redundant conditions that were released as flexel's report says, so that the model could be built.
    """

    def __init__(self, case: Case) -> None:
        self.case, self.nodes = case, drawn_nodes(case)
        self.oracle = Oracle(self.nodes, twins_of(case))
        self.released: tuple[str, ...] = ()
        self._kept: dict[Hashable, Any] = {}

    @cached_property
    def drawn(self) -> Answer:
        """What the oracle says about the configuration as drawn, at rest."""
        x = self.oracle.drawn
        return self.oracle.solve(x, np.zeros(x.size), dict.fromkeys(self.oracle.states, 0.0), 0.0)

    def keep(self, key: Hashable, make: Callable[[], Made]) -> Made:
        """What several properties share, made once."""
        if key not in self._kept:
            self._kept[key] = make()
        found: Made = self._kept[key]
        return found

    @property
    def singular(self) -> bool:
        """Whether flexel may refuse the configuration, as drawn or as it moves."""
        change_point = bool(self.drawn.redundant) and "redundant" not in self.case.known
        if self.drawn.singular or change_point:
            return True
        return "start" in self.__dict__ and (self.answer.singular or self.ends_singular)

    @cached_property
    def beyond_reach(self) -> bool:
        """Whether the offsets lead beyond where the model turns back, such as a rod beyond its length.

        Up to there, coordinates go with the square root of what is missing: over the last stretch they move by as much
        as over the three stretches before, not by a third of it.
        """
        low, high = 0.0, 1.0
        while high - low > 1e-3 * STRETCH:
            middle = (low + high) / 2
            low, high = (low, middle) if self._with(middle) is None else (middle, high)
        last, before, first = (self._with(low - back * STRETCH) for back in (0, 1, 4))
        if last is None or before is None or first is None:
            return False
        near, far = (float(np.linalg.norm(a - b)) for a, b in ((last, before), (before, first)))
        return near > 2 / 3 * far

    def _with(self, share: float) -> Array | None:
        """All coordinates with a share of the offsets; None if flexel refuses them."""
        offsets = tuple(share * offset for offset in self.case.offsets)
        try:
            return self.x(replace(self.case, offsets=offsets).start(self.system))
        except fx.PositionError:
            return None

    @cached_property
    def ends_singular(self) -> bool:
        """Whether flexel gives the motion up, and where the oracle finds the configuration singular, too."""
        try:
            assert self.motion
        except fx.DynamicsError as error:
            return error.motion is not None and self.solved(error.motion[-1]).singular
        except Inapplicable:
            pass  # nothing moves
        return False

    def model(self) -> fx.Model:
        """The model; of a redundant family without its redundant conditions."""
        m = self.case.model()
        if "redundant" in self.case.known:
            self.released = tuple(m.constraint_report().release)
            m.release(*self.released)
        return m

    @cached_property
    def system(self) -> fx.System:
        """The system in the degrees of freedom that flexel chooses."""
        return self.model().build()

    @cached_property
    def start(self) -> fx.State:
        """The state that is examined."""
        return self.case.start(self.system)

    def x(self, state: fx.State) -> Array:
        """All coordinates in the oracle's order."""
        return self.oracle.vector(lambda name: state[name])

    def v(self, state: fx.State) -> Array:
        """Their rates."""
        return self.oracle.vector(state.rate, held=False)

    def a(self, state: fx.State) -> Array:
        """Their second rates."""
        return self.oracle.vector(state.acceleration, held=False)

    def z(self, state: fx.State) -> dict[str, float]:
        """Internal states."""
        return {name: state[name] for name in self.oracle.states}

    @cached_property
    def answer(self) -> Answer:
        """What the oracle finds in the state that is examined."""
        return self.solved(self.start)

    def solved(self, state: fx.State) -> Answer:
        """What the oracle finds in a state."""
        return self.oracle.solve(self.x(state), self.v(state), self.z(state), state.t)

    def energy(self, state: fx.State) -> float:
        """Energy by the oracle [J]."""
        return self.oracle.energy(self.x(state), self.v(state))

    @property
    def moving(self) -> bool:
        """Whether there is a motion to be integrated."""
        return bool(self.system.dynamic)

    @cached_property
    def motion(self) -> fx.Motion:
        """The motion from the state."""
        return self.moved(self.system, self.start, self.case.duration)

    def moved(self, system: fx.System, start: fx.State, duration: float) -> fx.Motion:
        """An accurate motion; only its end matters."""
        if not system.dynamic:
            raise Inapplicable("nothing moves freely")
        return system.simulate(duration, start=start, samples=2, method="DOP853", progress=False, **ACCURATE)


def off(found: Array, reference: Array, least: float = 1e-6) -> float:
    """Largest difference, relative to the largest entry of the reference."""
    if not np.size(reference):
        return 0.0
    return float(np.max(np.abs(found - reference)) / max(float(np.max(np.abs(reference))), least))
