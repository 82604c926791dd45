"""Provides workers: processes of joblib, any executor of `concurrent.futures`, workers of dask, or this process."""

from __future__ import annotations

import math
import os
import signal
import time
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from typing import Any

from flexel.base.arguments import whole
from flexel.base.errors import FlexelError, ModelError
from flexel.results.saved.record import require

THREAD_VARIABLES = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS")
IDLE_TIMEOUT_S = 60  # time after which an idle joblib worker ends [s]


class Serial(Executor):
    """Runs submitted calls immediately, in the calling thread."""

    def submit(self, function: Callable[..., Any], /, *args: Any, **options: Any) -> Future[Any]:
        """Return a completed future."""
        future: Future[Any] = Future()
        try:
            future.set_result(function(*args, **options))
        except Exception as error:
            future.set_exception(error)
        return future


class Cluster(Executor):
    """The workers of a dask cluster as an executor.

    Dask's executor loses a result if its worker dies while the result is fetched: the future never completes.
    """

    def __init__(self, client: Any) -> None:
        self.client = client
        self._known = (
            -math.inf,
            1,
        )  # time when the scheduler was last asked for its workers, and their number

    def threads(self) -> int:
        """Return the number of threads of all workers, updated once a second."""
        if time.monotonic() - self._known[0] > 1:
            self._known = (time.monotonic(), max(1, sum(self.client.nthreads().values())))
        return self._known[1]

    def submit(self, function: Callable[..., Any], /, *args: Any, **options: Any) -> Future[Any]:
        """Return a future that completes when the result has been fetched."""
        local: Future[Any] = Future()
        remote = self.client.submit(function, *args, pure=False, **options)
        remote.add_done_callback(partial(_fetch, local))
        local.add_done_callback(lambda future: remote.cancel() if future.cancelled() else None)
        return local


def _fetch(local: Future[Any], remote: Any) -> None:
    """Transfer the result or the error of a dask future to a local future."""
    if not local.set_running_or_notify_cancel():
        return
    try:
        local.set_result(remote.result())
    except Exception as error:
        local.set_exception(error)


def _end(executor: Executor, at_once: bool) -> None:
    """Let workers finish their current tasks; do not wait for this after an interrupt."""
    executor.shutdown(wait=not at_once, cancel_futures=True)


@dataclass
class Pool:
    """Workers, and a way to replace them.

    Attributes
    ----------
    executor : concurrent.futures.Executor
    slots : function
        Number of points computed at the same time, at present.
    deaths : tuple of exception types
        Raised for a chunk whose worker has died.
    make : function, optional
        Makes an executor to replace a broken one; None if the executor is the user's.
    ends : function
        Ends the workers of an executor made here; immediately, if the second argument is true.
    """

    executor: Executor
    slots: Callable[[], int]
    deaths: tuple[type[BaseException], ...] = (BrokenExecutor,)
    make: Callable[[], Executor] | None = None
    ends: Callable[[Executor, bool], None] = _end

    @property
    def shares_memory(self) -> bool:
        """Whether functions need not be pickled."""
        return isinstance(self.executor, Serial | ThreadPoolExecutor)

    def renew(self, cause: BaseException) -> None:
        """Replace an executor that broke down."""
        if self.make is None:
            raise FlexelError(
                f"the executor broke down ({str(cause).partition('.')[0]}); give another one, or a function that makes "
                "one, to be called again after a breakdown"
            ) from cause
        self.executor.shutdown(wait=False)
        self.executor = self.make()

    def close(self, at_once: bool) -> None:
        """End the workers, unless the executor is the user's."""
        if self.make is not None:
            self.ends(self.executor, at_once)


def pool_of(executor: Any, workers: int | None) -> Pool:
    """Return the pool for the executor given to `fx.sweep`."""
    if workers is not None:
        workers = whole(workers, "sweep", "workers")
    named = executor if isinstance(executor, str) else ""
    if executor is None or named == "joblib":
        return _joblib(workers)
    if named == "serial":
        return Pool(Serial(), lambda: 1)
    if isinstance(executor, Executor):
        return Pool(executor, _size(executor, workers))
    if hasattr(executor, "submit") and hasattr(executor, "nthreads"):
        return _dask(executor, workers)
    made = executor() if callable(executor) else None
    if isinstance(made, Executor):
        return Pool(made, _size(made, workers), make=executor)
    raise ModelError(
        f"sweep: executor is {executor!r}; give 'joblib', 'serial', an executor of concurrent.futures, a function "
        "that makes one, or a Client of dask.distributed"
    )


def _joblib(workers: int | None) -> Pool:
    """Return a pool of joblib processes: fresh interpreters with single-threaded BLAS, which the next sweep reuses."""
    require("joblib", "sweep")
    from joblib import cpu_count
    from joblib.externals.loky import get_reusable_executor

    number = workers or int(cpu_count())

    def make() -> Executor:
        environment = dict.fromkeys(THREAD_VARIABLES, "1")
        made: Executor = get_reusable_executor(
            number, timeout=IDLE_TIMEOUT_S, initializer=_begin, env=environment
        )
        return made

    def ends(executor: Any, at_once: bool) -> None:
        if at_once:  # otherwise they end when they have been idle
            executor.shutdown(wait=True, kill_workers=True)

    return Pool(make(), lambda: number, make=make, ends=ends)


def _begin() -> None:
    """Initialize a worker: Ctrl-C is handled by the process that drives the sweep."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _dask(client: Any, workers: int | None) -> Pool:
    """Return a pool of a cluster's workers, however many there are at a time."""
    from distributed.scheduler import KilledWorker

    cluster = Cluster(client)
    return Pool(cluster, lambda: workers or cluster.threads(), (BrokenExecutor, KilledWorker))


def _size(executor: Executor, workers: int | None) -> Callable[[], int]:
    """Return the number of workers: the given number, that known to the executor, or that of processors."""
    number = workers or getattr(executor, "_max_workers", None) or os.cpu_count() or 1
    return lambda: int(number)
