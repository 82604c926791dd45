"""Motions of many variants: the variants of a thread run side by side in SIMD lanes where possible."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

from flexel.base.errors import FlexelError
from flexel.engine.lanes import LANES
from flexel.engine.variants import Variant
from flexel.integration.driver import Run
from flexel.integration.lane_motions import LaneMotions, suits
from flexel.integration.outcome import Said, gathered
from flexel.integration.simulation import Preparation
from flexel.results.analyses.variant_runs import Runner, Values, varied
from flexel.system import CoreSystem

T = TypeVar("T")


class MotionRunner(Runner[T]):
    """Motions of all variants, in threads, and in SIMD lanes within each thread.

    Parameters
    ----------
    system : CoreSystem
    values : Values
    begin : callable
        Begins the motion of a system that is variant number i, after another motion of the same system.
    end : callable
        Continues the motion of a system to its end, and returns what is kept of it.

    Attributes
    ----------
    said : dict of int to list
        Warnings of the motions, by number of the variant.
    """

    def __init__(
        self,
        system: CoreSystem,
        values: Values,
        begin: Callable[[Any, int, Run | None], Preparation],
        end: Callable[[Any, Preparation], T],
    ) -> None:
        super().__init__(system, values, self._whole)
        self._begin, self._end = begin, end
        self.said: dict[int, Said] = {}

    def _whole(self, system: Any, i: int) -> T:
        """Compute the motion of a system that is variant number i."""
        with self._gathering(i):
            return self._end(system, self._begin(system, i, None))

    @contextmanager
    def _gathering(self, i: int) -> Iterator[None]:
        """Gather what motions warn of for variant number i."""
        with gathered() as said:
            yield
        self.said.setdefault(i, []).extend(said)

    def _work(self) -> Iterator[None]:
        """Take variants as long as there are any; each lane has a separate system."""
        if self._values.anew is not None:
            yield from self._built(self._values.anew)
            return
        width = min(LANES, -(-self._values.count // self._threads))
        free, slots = list(range(width)), _Slots(self)
        while True:
            while free and (i := self._next()) is not None:
                if self._attempt(i, slots.begin, free[-1], i):
                    free.pop()
                else:
                    yield
            if len(free) == width:
                return
            for lane in slots.run():
                if not self._attempt(slots.number[lane], slots.goes_on, lane):
                    slots.drop(lane)
                    free.append(lane)
                    yield

    def _attempt(self, i: int, call: Callable[..., bool], *arguments: Any) -> bool:
        """Return what a call returns for a variant, or False if the variant fails."""
        try:
            with self._gathering(i):
                return call(*arguments)
        except FlexelError as error:
            self._fail(i, error)
            return False


class _Slots:
    """The lanes of one thread, with the systems and motions in them."""

    def __init__(self, runner: MotionRunner[Any]) -> None:
        self._runner = runner
        self._systems: dict[int, tuple[CoreSystem, Variant]] = {}
        self._begun: dict[int, Preparation] = {}
        self._lanes: LaneMotions | None = None
        self.number: dict[int, int] = {}  # the variant in each lane

    def begin(self, lane: int, i: int) -> bool:
        """Begin the motion of variant number i; returns whether it continues in a lane, or is already finished."""
        runner = self._runner
        if lane not in self._systems:
            self._systems[lane] = varied(runner._system, runner._values.places)
        system, variant = self._systems[lane]
        runner._set(system, variant, i)
        before = self._begun[lane].run if lane in self._begun else None
        self.number[lane], self._begun[lane] = i, runner._begin(system, i, before)
        run, watch = self._begun[lane].run, self._begun[lane].watch
        if self._lanes is None and suits(run):
            self._lanes = LaneMotions(run)
        if self._lanes is None or not self._lanes.takes(run):
            self._finish(lane)
            return False
        self._lanes.enter(lane, run, watch)
        return True

    def run(self) -> list[int]:
        """Take steps until lanes need attention; returns these lanes."""
        return self._lanes.run() if self._lanes else []

    def goes_on(self, lane: int) -> bool:
        """Process a lane; a motion that leaves it is continued to its end."""
        if self._lanes and not self._lanes.look(lane):
            return True
        self._finish(lane)
        return False

    def drop(self, lane: int) -> None:
        """Clear a lane."""
        if self._lanes:
            self._lanes.drop(lane)

    def _finish(self, lane: int) -> None:
        system, i = self._systems[lane][0], self.number[lane]
        self._runner.results[i] = self._runner._end(system, self._begun[lane])
