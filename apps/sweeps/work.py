"""Performs the task of a worker: building and analysing the points it receives, one after another.

Everything here is pickled by name, so any executor can run it; the user's functions are sent as bytes of
`cloudpickle`, which also supports functions of scripts and notebooks.
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
import scipy.linalg  # noqa: F401 - loads its BLAS before the number of threads is set

from flexel.apps.sweeps.forms import Forms, Numbers, results_of
from flexel.base.blas import one_thread
from flexel.base.errors import FlexelError, ModelError
from flexel.results.saved.record import require

Functions = tuple[Callable[..., Any], Callable[[Any], Any]]


@dataclass(frozen=True)
class Job:
    """The functions of a sweep, as bytes for other processes, their files, and the process that drives it."""

    functions: bytes | Functions
    files: tuple[str, ...]
    home: int

    @classmethod
    def of(cls, build: Callable[..., Any], analyse: Callable[[Any], Any], pickled: bool) -> Job:
        """Make a job for workers in this process, or pickled for others."""
        files = tuple(_file(function) for function in (build, analyse))
        if not pickled:
            return cls((build, analyse), files, os.getpid())
        try:
            return cls(require("cloudpickle", "sweep").dumps((build, analyse)), files, os.getpid())
        except (PicklingError, TypeError, AttributeError, ValueError, RecursionError) as error:
            raise ModelError(
                f"sweep: build or analyse cannot be sent to other processes: {error}; create what cannot be pickled "
                "inside them, or run with executor='serial'"
            ) from error


@dataclass(frozen=True)
class ResultBlock:
    """Results of points with the same form; `rows` counts from the first point of the chunk."""

    forms: Forms
    rows: list[int]
    values: dict[str, Numbers]


@dataclass(frozen=True)
class Outcome:
    """The outcome of a chunk of points: results, messages by row of failed points, and the time taken [s]."""

    begin: int
    count: int
    blocks: list[ResultBlock]
    failed: dict[int, str]
    seconds: float


def work(job: Job, begin: int, columns: Mapping[str, list[Any]]) -> Outcome:
    """Build and analyse a chunk of points, starting at `begin`, whose parameters are columns."""
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
            except Exception as error:  # any error: the other points are computed, and the message is kept
                failed[row] = _message(error, functions, job.files)
                continue
            rows, results = groups.setdefault(forms, ([], []))
            rows.append(row)
            results.append(found)
    blocks = [
        ResultBlock(forms, rows, {name: np.array([result[name] for result in results]) for name, _ in forms})
        for forms, (rows, results) in groups.items()
    ]
    return Outcome(begin, count, blocks, failed, time.perf_counter() - start)


@lru_cache(maxsize=4)
def _loaded(functions: bytes) -> Functions:
    """Return the functions, unpickled once per process."""
    found: Functions = require("cloudpickle", "sweep").loads(functions)
    return found


def _built(model: Any) -> Any:
    """Build the system of a model; pass anything else to the analysis unchanged."""
    if model is None:
        raise ModelError("build returned None; return the fx.Model")
    module = sys.modules.get(
        "flexel.parts.model"
    )  # takes a second to import; if it is not imported, there is no model
    return model.build() if module is not None and isinstance(model, module.Model) else model


@contextmanager
def _uninterrupted(job: Job) -> Iterator[None]:
    """Leave Ctrl-C to the driving process: here it would end a motion early, as if that were its regular end."""
    if os.getpid() == job.home or threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _file(function: Callable[..., Any]) -> str:
    """Return the name of the file with the code of a function; empty where it has none."""
    code = getattr(function, "__code__", None)
    return os.path.basename(code.co_filename) if code else ""


def _message(error: Exception, functions: Functions, files: tuple[str, ...]) -> str:
    """Return the message of a failed point; for errors other than flexel's, with their kind and the user's line.

    `files` are the names as the driving process knows them: what cloudpickle loads may have lost them (3.1.3).
    """
    if isinstance(error, FlexelError):
        return str(error)
    frames = [(frame.f_code, line) for frame, line in traceback.walk_tb(error.__traceback__)]
    codes = [getattr(function, "__code__", None) for function in functions]
    file, line = os.path.basename(frames[-1][0].co_filename), frames[-1][1]
    called = next((codes.index(code) for code, _ in frames if code in codes), None)
    if called is not None:
        own = functions[called].__code__.co_filename
        file, line = files[called], [line for code, line in frames if code.co_filename == own][-1]
    return f"{type(error).__name__}: {error} ({file}, line {line})"
