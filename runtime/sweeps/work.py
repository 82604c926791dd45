"""The task of a worker: it builds and analyses the points that it receives, one after another.

Everything here goes through `pickle` by name, so any executor can run it; the user's functions go along as bytes of
`cloudpickle`, which takes functions of scripts and notebooks too.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pickle import PicklingError
from typing import Any

import numpy as np
import scipy.linalg  # noqa: F401 - so that its BLAS is there when the number of threads is set

from flexel.base.blas import one_thread
from flexel.base.errors import FlexelError, ModelError
from flexel.results.saved.record import require
from flexel.sweeps.forms import Forms, Numbers, results_of

Functions = tuple[Callable[..., Any], Callable[[Any], Any]]


@dataclass(frozen=True)
class Job:
    """The functions of a sweep, as bytes for other processes, and the process that drives it."""

    functions: bytes | Functions
    home: int

    @classmethod
    def of(cls, build: Callable[..., Any], analyse: Callable[[Any], Any], pickled: bool) -> Job:
        """A job for workers in this process, or pickled for others."""
        if not pickled:
            return cls((build, analyse), os.getpid())
        try:
            return cls(require("cloudpickle", "sweep").dumps((build, analyse)), os.getpid())
        except (PicklingError, TypeError, AttributeError, ValueError, RecursionError) as error:
            raise ModelError(
                f"sweep: build or analyse cannot be sent to other processes: {error}; make what cannot be pickled "
                "inside them, or run with executor='serial'"
            ) from error


@dataclass(frozen=True)
class Block:
    """Results of points with the same form; `rows` counts from the first point of the chunk."""

    forms: Forms
    rows: list[int]
    values: dict[str, Numbers]


@dataclass(frozen=True)
class Outcome:
    """What came out of a chunk of points: results, messages by row of points that failed, and the time taken [s]."""

    begin: int
    count: int
    blocks: list[Block]
    failed: dict[int, str]
    seconds: float


def work(job: Job, begin: int, columns: Mapping[str, list[Any]]) -> Outcome:
    """Build and analyse a chunk of points, those from `begin` on, whose parameters are columns."""
    start, names = time.perf_counter(), tuple(columns)
    functions = _loaded(job.functions) if isinstance(job.functions, bytes) else job.functions
    build, analyse = functions
    groups: dict[Forms, tuple[list[int], list[dict[str, Numbers]]]] = {}
    failed: dict[int, str] = {}
    count = len(columns[names[0]])
    with one_thread(), _uninterrupted(job):
        for row, values in enumerate(zip(*columns.values(), strict=True)):
            try:
                returned = analyse(_built(build(**dict(zip(names, values, strict=True)))))
                forms, found = results_of(returned, names)
            except (
                Exception
            ) as error:  # whatever it is: the other points are computed, and the message is kept
                failed[row] = _message(error, functions)
                continue
            rows, results = groups.setdefault(forms, ([], []))
            rows.append(row)
            results.append(found)
    blocks = [
        Block(forms, rows, {name: np.array([z[name] for z in results]) for name, _ in forms})
        for forms, (rows, results) in groups.items()
    ]
    return Outcome(begin, count, blocks, failed, time.perf_counter() - start)


@lru_cache(maxsize=4)
def _loaded(functions: bytes) -> Functions:
    """The functions, unpickled once in a process."""
    found: Functions = require("cloudpickle", "sweep").loads(functions)
    return found


def _built(model: Any) -> Any:
    """The system of a model; anything else goes to the analysis as it is."""
    if model is None:
        raise ModelError("build returned None; return the fx.Model")
    module = sys.modules.get("flexel.model")  # a second to import: where it has not been, there is no model
    return model.build() if module is not None and isinstance(model, module.Model) else model


@contextmanager
def _uninterrupted(job: Job) -> Iterator[None]:
    """Leave Ctrl-C to the process that drives the sweep: here it would end a motion early, as if that were its end."""
    if os.getpid() == job.home or threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _message(error: Exception, functions: Functions) -> str:
    """The message of a point that failed; for an error that is not flexel's, with its kind and the user's line."""
    if isinstance(error, FlexelError):
        return str(error)
    files = {code.co_filename for z in functions if (code := getattr(z, "__code__", None))}
    frames = traceback.extract_tb(error.__traceback__)
    last = next((z for z in reversed(frames) if z.filename in files), frames[-1])
    return f"{type(error).__name__}: {error} ({os.path.basename(last.filename)}, line {last.lineno})"
