"""Who computes which points: chunks of the right size, the order of the first results, workers that die."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from dataclasses import dataclass, replace
from typing import Any

from tqdm import tqdm

from flexel.base.errors import FlexelError
from flexel.sweeps.executors import Pool
from flexel.sweeps.points import Points
from flexel.sweeps.store import Store
from flexel.sweeps.work import Job, Outcome, work

log = logging.getLogger("flexel.sweep")
TARGET = 0.2  # time that a chunk is to take [s], at least: handing one out costs 0.5 ms of this process, 5 with dask
# Time between two chunks [s], which take longer with many workers, so that this process keeps up.
APART = 0.01
LARGEST = 20_000  # points of a chunk
MOST_BYTES = 1 << 24  # results of a chunk
AHEAD = 2  # chunks submitted for each worker, so that none waits
PARTS = 16  # of a chunk in which a point kills its worker
PATIENCE = 3  # points that may kill their workers before any other has been computed


@dataclass(frozen=True)
class Chunk:
    """Points `begin` to `end` (left out), how often their workers have died, and whether they are computed alone."""

    begin: int
    end: int
    deaths: int = 0

    @property
    def alone(self) -> bool:
        """After a second death nothing else is computed at the same time, so that the cause is known."""
        return self.deaths > 1

    def parts(self) -> list[Chunk]:
        """The points in a few shares, of one point at least."""
        share = -(-(self.end - self.begin) // PARTS)
        starts = range(self.begin, self.end, share)
        return [replace(self, begin=begin, end=min(begin + share, self.end)) for begin in starts]


class Drive:
    """A running sweep.

    Until the form of the results is known, each worker gets one chunk at a time, and nothing is stored before all of
    them have come back: the form is that of the first point that succeeds, whichever worker is faster.
    """

    def __init__(self, job: Job, points: Points, store: Store, pool: Pool, bar: tqdm[Any]) -> None:
        self.job, self.points, self.store, self.pool, self.bar = job, points, store, pool, bar
        self.pending: dict[Future[Outcome], Chunk] = {}
        self.again: deque[Chunk] = deque()  # their workers died
        self.held: list[Outcome] = []
        self.seconds: float | None = None  # time that a point takes, of late
        self.succeeded = False
        self.killers = self.failed = 0

    def run(self, retry_failed: bool, size: int | None) -> None:
        """Compute all points that are missing, in chunks of a given size or of one that is found on the way."""
        runs = deque(self.store.missing(retry_failed))
        self.left = sum(end - begin for begin, end in runs)
        try:
            while True:
                self._hand_out(runs, size)
                if not (self.pending or self.again or self.held or runs):
                    return
                for future in self._done():
                    if future in self.pending:  # a breakdown takes all of them at once
                        self._settle(future)
                self._store()
        finally:
            for future in self.pending:
                future.cancel()

    def salvage(self) -> None:
        """After an interrupt: keep what workers have finished."""
        for future in self.pending:
            if future.done() and not future.cancelled() and future.exception() is None:
                self.held.append(future.result())
        self.pending.clear()
        self._store()

    def _done(self) -> set[Future[Outcome]]:
        """What has come back, when something has."""
        return wait(self.pending, return_when=FIRST_COMPLETED).done if self.pending else set()

    def _hand_out(self, runs: deque[tuple[int, int]], size: int | None) -> None:
        """Submit chunks until every worker has enough."""
        known, slots = self.store.forms is not None, self.pool.slots()
        if self.pending and (not known or any(z.alone for z in self.pending.values())):
            return
        for chunk in self._chunks(runs, size, slots):
            columns = self.points.columns(chunk.begin, chunk.end)
            try:
                future = self.pool.executor.submit(work, self.job, chunk.begin, columns)
            except self.pool.deaths as error:  # it broke down before the futures reported it
                self._broken(error)
                self._blame(chunk, error)
                return
            except RuntimeError as error:
                raise FlexelError(
                    f"sweep: the executor takes no work: {error}; give one that is open"
                ) from error
            self.pending[future] = chunk
            if chunk.alone or len(self.pending) >= slots * (AHEAD if known else 1):
                return

    def _chunks(self, runs: deque[tuple[int, int]], size: int | None, slots: int) -> Iterator[Chunk]:
        """What comes next: what has to be done again, then new points."""
        while self.again and not (self.again[0].alone and self.pending):
            yield self.again.popleft()
        while runs and not self.again:
            begin, end = runs.popleft()
            middle = min(end, begin + (size or self._size(slots)))
            if middle < end:
                runs.appendleft((middle, end))
            self.left -= middle - begin
            yield Chunk(begin, middle)

    def _size(self, slots: int) -> int:
        """Points that take about as long as a chunk should; towards the end fewer, for all workers to end together."""
        if self.seconds is None:
            return 1
        target = max(TARGET, APART * slots)
        wanted = int(target / max(self.seconds, target / LARGEST))
        room = MOST_BYTES // max(self.store.row_bytes, 1)
        return max(1, min(wanted, room, self.left // (AHEAD * slots)))

    def _settle(self, future: Future[Outcome]) -> None:
        """Take the result of a chunk."""
        try:
            outcome = future.result()
        except self.pool.deaths as error:
            self._died(future, error)
            return
        except Exception as error:  # what reaches neither a point nor its worker
            raise FlexelError(
                f"sweep: the executor failed with {type(error).__name__}: {error}; what workers import must be "
                "installed where they are"
            ) from error
        chunk = self.pending.pop(future)
        log.debug("points %d to %d in %.3g s", chunk.begin, chunk.end - 1, outcome.seconds)
        self.succeeded = True
        each = outcome.seconds / outcome.count
        self.seconds = each if self.seconds is None else (self.seconds + each) / 2
        self.held.append(outcome)

    def _store(self) -> None:
        """Store what came back, in the order of the points while the form of the results is not known."""
        if self.store.forms is None and self.pending:
            return
        for outcome in sorted(self.held, key=lambda z: z.begin):
            self.store.keep(outcome)
            self.failed += len(outcome.failed)
            self.bar.set_postfix_str(f"{self.failed} failed" if self.failed else "", refresh=False)
            self.bar.update(outcome.count)
        self.held.clear()

    def _died(self, future: Future[Outcome], error: BaseException) -> None:
        """The worker of a chunk has died; an executor of processes has then lost all that it had."""
        if isinstance(error, BrokenExecutor):
            self._broken(error)
        else:
            self._blame(self.pending.pop(future), error)

    def _broken(self, error: BaseException) -> None:
        """Replace the executor, and do again what was under way."""
        lost = {z: chunk for z, chunk in self.pending.items() if not (z.done() and z.exception() is None)}
        for future in [z for z in self.pending if z not in lost]:
            self._settle(future)
        self.pending.clear()
        self.pool.renew(error)
        for chunk in lost.values():
            self._blame(chunk, error)

    def _blame(self, chunk: Chunk, error: BaseException) -> None:
        """Do a chunk again: at first as before, then alone and in parts, until one point is left."""
        log.info("the worker of points %d to %d died: %s", chunk.begin, chunk.end - 1, error)
        died = replace(chunk, deaths=chunk.deaths + 1)
        if chunk.alone and chunk.end - chunk.begin == 1:
            self._give_up(chunk, error)
        elif died.alone:
            self.again.extend(died.parts())
        else:
            self.again.append(died)

    def _give_up(self, chunk: Chunk, error: BaseException) -> None:
        """A point that kills its worker fails; if nothing else ever came back, the executor does not work."""
        self.killers += 1
        if not self.succeeded and self.killers >= PATIENCE:
            raise FlexelError(
                f"sweep: all workers die, the last one at {self.points.shown(chunk.begin)} "
                f"({str(error).partition('.')[0]}); try executor='serial', or give them more memory"
            ) from error
        message = "its worker died each time, also with nothing else under way; it may need more memory"
        self.held.append(Outcome(chunk.begin, 1, [], {0: message}, 0.0))
