"""Distributes points among workers: chunk sizes, the order of the first results, and workers that die."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from dataclasses import dataclass, replace
from typing import Any

from flexel.apps.sweeps.executors import Pool
from flexel.apps.sweeps.points import Points
from flexel.apps.sweeps.store import Store
from flexel.apps.sweeps.work import Job, Outcome, work
from flexel.base.errors import FlexelError

log = logging.getLogger("flexel.sweep")
# Least computing time of a chunk [s]: sending one costs this process 0.5 ms, or 5 ms with dask.
MIN_CHUNK_TIME_S = 0.2
# Time between two chunks [s]; chunks take longer with many workers, so that this process keeps up.
CHUNK_INTERVAL_S = 0.01
MAX_CHUNK_POINTS = 20_000  # points of a chunk
MAX_CHUNK_BYTES = 1 << 24  # results of a chunk
CHUNKS_PER_WORKER = 2  # chunks submitted per worker, so that none waits
CHUNK_PARTS = 16  # of a chunk containing a point that kills its worker
MAX_KILLERS = 3  # points that may kill their workers before any other point has been computed


@dataclass(frozen=True)
class Chunk:
    """Points `begin` to `end` (excluded), how often their workers have died, and whether they are computed alone."""

    begin: int
    end: int
    deaths: int = 0

    @property
    def alone(self) -> bool:
        """Whether nothing else may run at the same time: after a second death, so that the cause is known."""
        return self.deaths > 1

    def parts(self) -> list[Chunk]:
        """Split the points into a few parts of at least one point."""
        share = -(-(self.end - self.begin) // CHUNK_PARTS)
        starts = range(self.begin, self.end, share)
        return [replace(self, begin=begin, end=min(begin + share, self.end)) for begin in starts]


class Drive:
    """A running sweep.

    Until the form of the results is known, each worker gets one chunk at a time, and nothing is stored before all of
    these chunks have returned: the first successful point sets the form, whichever worker is faster.
    """

    def __init__(self, job: Job, points: Points, store: Store, pool: Pool, bar: Any) -> None:
        self.job, self.points, self.store, self.pool, self.bar = job, points, store, pool, bar
        self.pending: dict[Future[Outcome], Chunk] = {}
        self.again: deque[Chunk] = deque()  # their workers died
        self.held: list[Outcome] = []
        self.seconds: float | None = None  # recent time per point
        self.succeeded = False
        self.killers = self.failed = 0

    def run(self, retry_failed: bool, size: int | None) -> None:
        """Compute all missing points, in chunks of a given size or of a size found during the sweep."""
        runs = deque(self.store.missing(retry_failed))
        self.left = sum(end - begin for begin, end in runs)
        try:
            while True:
                self._hand_out(runs, size)
                if not (self.pending or self.again or self.held or runs):
                    return
                for future in self._done():
                    if future in self.pending:  # a breakdown ends all of them at once
                        self._settle(future)
                self._store()
        finally:
            for future in self.pending:
                future.cancel()

    def salvage(self) -> None:
        """Keep the chunks that workers have finished, after an interrupt."""
        for future in self.pending:
            if future.done() and not future.cancelled() and future.exception() is None:
                self.held.append(future.result())
        self.pending.clear()
        self._store()

    def _done(self) -> set[Future[Outcome]]:
        """Wait for results, and return them."""
        return wait(self.pending, return_when=FIRST_COMPLETED).done if self.pending else set()

    def _hand_out(self, runs: deque[tuple[int, int]], size: int | None) -> None:
        """Submit chunks until every worker has enough."""
        known, slots = self.store.forms is not None, self.pool.slots()
        if self.pending and (not known or any(chunk.alone for chunk in self.pending.values())):
            return
        for chunk in self._chunks(runs, size, slots):
            columns = self.points.columns(chunk.begin, chunk.end)
            try:
                future = self.pool.executor.submit(work, self.job, chunk.begin, columns)
            except self.pool.deaths as error:  # the pool broke down before the futures reported it
                self._broken(error)
                self._blame(chunk, error)
                return
            except RuntimeError as error:
                raise FlexelError(
                    f"sweep: the executor accepts no work: {error}; give an open one"
                ) from error
            self.pending[future] = chunk
            if chunk.alone or len(self.pending) >= slots * (CHUNKS_PER_WORKER if known else 1):
                return

    def _chunks(self, runs: deque[tuple[int, int]], size: int | None, slots: int) -> Iterator[Chunk]:
        """Return the next chunk: one to be repeated, or new points."""
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
        """Return the number of points for the time of a chunk; fewer towards the end, so that workers end together."""
        if self.seconds is None:
            return 1
        target = max(MIN_CHUNK_TIME_S, CHUNK_INTERVAL_S * slots)
        wanted = int(target / max(self.seconds, target / MAX_CHUNK_POINTS))
        room = MAX_CHUNK_BYTES // max(self.store.row_bytes, 1)
        return max(1, min(wanted, room, self.left // (CHUNKS_PER_WORKER * slots)))

    def _settle(self, future: Future[Outcome]) -> None:
        """Store the result of a chunk, or handle its failure."""
        try:
            outcome = future.result()
        except self.pool.deaths as error:
            self._died(future, error)
            return
        except Exception as error:  # an error outside the point and its worker
            raise FlexelError(
                f"sweep: the executor failed with {type(error).__name__}: {error}; what workers import must be "
                "installed on their machines"
            ) from error
        chunk = self.pending.pop(future)
        log.debug("points %d to %d in %.3g s", chunk.begin, chunk.end - 1, outcome.seconds)
        self.succeeded = True
        each = outcome.seconds / outcome.count
        self.seconds = each if self.seconds is None else (self.seconds + each) / 2
        self.held.append(outcome)

    def _store(self) -> None:
        """Store results; while their form is unknown, in the order of the points."""
        if self.store.forms is None and self.pending:
            return
        for outcome in sorted(self.held, key=lambda outcome: outcome.begin):
            self.store.keep(outcome)
            self.failed += len(outcome.failed)
            self.bar.set_postfix_str(f"{self.failed} failed" if self.failed else "", refresh=False)
            self.bar.update(outcome.count)
        self.held.clear()

    def _died(self, future: Future[Outcome], error: BaseException) -> None:
        """Handle the death of a chunk's worker; a pool of processes has then lost all its chunks."""
        if isinstance(error, BrokenExecutor):
            self._broken(error)
        else:
            self._blame(self.pending.pop(future), error)

    def _broken(self, error: BaseException) -> None:
        """Replace the executor, and repeat the chunks in progress."""
        lost = {
            future: chunk
            for future, chunk in self.pending.items()
            if not (future.done() and future.exception() is None)
        }
        for future in [future for future in self.pending if future not in lost]:
            self._settle(future)
        self.pending.clear()
        self.pool.renew(error)
        for chunk in lost.values():
            self._blame(chunk, error)

    def _blame(self, chunk: Chunk, error: BaseException) -> None:
        """Repeat a chunk: first unchanged, then alone and in parts, until one point is left."""
        log.info("the worker of points %d to %d died: %s", chunk.begin, chunk.end - 1, error)
        died = replace(chunk, deaths=chunk.deaths + 1)
        if chunk.alone and chunk.end - chunk.begin == 1:
            self._give_up(chunk, error)
        elif died.alone:
            self.again.extend(died.parts())
        else:
            self.again.append(died)

    def _give_up(self, chunk: Chunk, error: BaseException) -> None:
        """Record a point that kills its worker as failed; if nothing ever succeeded, the executor does not work."""
        self.killers += 1
        if not self.succeeded and self.killers >= MAX_KILLERS:
            raise FlexelError(
                f"sweep: all workers die, the last at {self.points.shown(chunk.begin)} "
                f"({str(error).partition('.')[0]}); try executor='serial', or give them more memory"
            ) from error
        message = "its worker died each time, even when it ran alone; it may need more memory"
        self.held.append(Outcome(chunk.begin, 1, [], {0: message}, 0.0))
