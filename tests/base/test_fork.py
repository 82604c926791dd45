"""A child that is forked while another thread computes does not wait for that thread, which it does not have."""

import os
import signal
import warnings
from collections.abc import Callable
from threading import Event, Thread
from typing import Any

import pytest
from mechanisms import slider_crank
from tqdm import tqdm

from flexel.base.blas import LIMIT, one_thread
from flexel.engine import evaluate
from flexel.mechanics.saddle import Matrix

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
PATIENCE = 60  # seconds until a child counts as hung


class Held:
    """Work of another thread that has begun and does not end before it is released."""

    def __init__(self) -> None:
        self._began, self._released = Event(), Event()

    def wait(self) -> None:
        """In that thread: say that the work has begun, and wait."""
        self._began.set()
        self._released.wait(PATIENCE)

    def forked(self, work: Callable[[], object], task: Callable[[], object]) -> int:
        """The status of a child that runs `task`, forked while another thread is in `work`."""
        thread = Thread(target=work)
        thread.start()
        assert self._began.wait(PATIENCE)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeprecationWarning)  # of a fork with threads, since Python 3.12
            child = os.fork()
        if not child:
            signal.alarm(PATIENCE)  # ends a child that hangs
            try:
                task()
            finally:
                os._exit(1)
        status = os.waitpid(child, 0)[1]
        self._released.set()
        thread.join()
        return status


def done(task: Callable[[], object]) -> Callable[[], None]:
    """The task, after which the child ends well."""

    def run() -> None:
        task()
        os._exit(0)

    return run


def test_a_child_makes_tables_that_another_thread_was_making(monkeypatch: pytest.MonkeyPatch) -> None:
    held, make, parent = Held(), evaluate.Tables, os.getpid()
    system = slider_crank("B.x").build()

    def slow(structure: Any) -> evaluate.Tables:
        if os.getpid() == parent:
            held.wait()
        return make(structure)

    monkeypatch.setattr(evaluate, "Tables", slow)
    first, second = (evaluate.Evaluation(system.structure) for _ in range(2))
    assert held.forked(lambda: first.tables, done(lambda: second.tables)) == 0


def test_a_child_computes_a_property_that_another_thread_was_computing() -> None:
    """Before Python 3.12 a cached property has one lock for all instances of its class."""
    held, parent = Held(), os.getpid()

    class Pattern:
        def factorized(self, _: object) -> str:
            if os.getpid() == parent:
                held.wait()
            return "factors"

    first, second = (Matrix(None, Pattern(), None) for _ in range(2))  # type: ignore[arg-type]
    assert held.forked(lambda: first.factors, done(lambda: second.factors)) == 0


def test_a_child_simulates_while_another_thread_writes_a_progress_bar() -> None:
    held, system = Held(), slider_crank("B.x").build()

    def write() -> None:
        with tqdm.get_lock():
            held.wait()

    assert held.forked(write, done(lambda: system.simulate(1e-3))) == 0


def test_a_child_counts_only_its_thread_among_those_that_limit_blas() -> None:
    held = Held()

    def work() -> None:
        with one_thread():
            held.wait()

    def task() -> None:
        assert LIMIT._users == 1

    with one_thread():
        assert held.forked(work, done(task)) == 0
