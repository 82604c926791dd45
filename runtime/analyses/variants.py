"""Variants of a system side by side: other values of parameters, one after another in each thread.

All variants share the tables and the choice of degrees of freedom; each thread has arrays and parameters of its own.
Every variant begins from the same pivot orders, so that its digits depend neither on the others nor on the threads.
"""

from __future__ import annotations

import logging
import os
import sys
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from copy import copy
from dataclasses import dataclass
from threading import Lock
from typing import Any, Generic, TypeVar

import numpy as np

from flexel.base.arguments import array, flag, mapping, whole
from flexel.base.arrays import Array
from flexel.base.blas import one_thread
from flexel.base.errors import FlexelError, IncompleteWarning, ModelError
from flexel.base.progress import progress_bar
from flexel.declare.signs import check_signs
from flexel.engine.variants import Variant, check_variable
from flexel.mechanics.core import Core
from flexel.structure.parameters import Parameters, Place
from flexel.structure.structure import Structure

log = logging.getLogger("flexel.variants")
C = TypeVar("C", bound=Core)
T = TypeVar("T")
INTERRUPTED = "interrupted before it was done"
WAIT = 0.1  # time between two checks of the progress [s]


def varied(system: C, places: Sequence[Place], structure: Structure | None = None) -> tuple[C, Variant]:
    """A copy of a system whose parameters can be changed without changing those of the system."""
    variant = Variant(system.evaluation, places, structure)
    found = copy(system)
    _forget(found)
    found._prepare(variant.evaluation, system.loads, system.roles)
    return found, variant


class Values:
    """Values of some parameters for a number of variants.

    Attributes
    ----------
    count : int
        Number of variants.
    given : dict of str to ndarray (count, …)
        By name.
    units : dict of str to str
    """

    def __init__(
        self, system: Core, given: Mapping[str, Any] | None, initial: Mapping[str, Any], owner: str
    ) -> None:
        self._owner = owner
        parameters = Parameters(system.structure)
        given = mapping(given, owner, "parameters")
        self.places = [parameters.find(name, owner) for name in given]
        self.units = {z.name: parameters.unit(z) for z in self.places}
        rows = [_rows(z, given[z.name], owner) for z in self.places]
        starts = {name: _column(name, z, owner) for name, z in initial.items()}
        self.count = self._count({**{z.name: r for z, r in zip(self.places, rows, strict=True)}, **starts})
        self.rows = [np.broadcast_to(z, (self.count, z.shape[1])) for z in rows]
        self.initial = {name: np.broadcast_to(z, self.count) for name, z in starts.items()}
        self.given = {
            z.name: r[:, 0] if z.size == 1 else r for z, r in zip(self.places, self.rows, strict=True)
        }
        for place, row in zip(self.places, self.rows, strict=True):
            other = np.flatnonzero((row != parameters.owner(place).p[place.numbers]).any(axis=1))
            if other.size:
                check_variable(system.evaluation, place, row[other[0]], owner)
                self._check_stiffness(system.structure, place)
        self._check_signs(parameters)

    def _check_stiffness(self, structure: Structure, place: Place) -> None:
        """Check that a stiffness leaves nothing behind that the declaration of its element computed with it."""
        parameters = Parameters(structure)
        element = parameters.owner(place).name
        named = any(instance.name == element for instance in structure.instances)
        if not (place.law and place.parameter == "S" and named):
            return
        also = [f"{element}.{part}" for part in ("phi_y", "phi_z", "preload", "damping")]
        given = {p.name for p in self.places}
        left = [name for name in also if name in parameters and name not in given and parameters[name].any()]
        if left:
            raise ModelError(
                f"{self._owner}: '{place.name}' alone leaves {', '.join(left)} behind, which '{element}' computed from "
                "the same section: build the model for each value, with fx.sweep, or give values for these too"
            )

    def _check_signs(self, parameters: Parameters) -> None:
        if not any(place.law for place in self.places):
            return
        for i in range(self.count):
            owners = parameters.owners(self.places, self.of(i))
            for law in (owner for (is_law, _), owner in owners.items() if is_law):
                check_signs(law.spec, law.parameters, f"{self._owner}: variant {i}: '{law.name}'")

    def _count(self, columns: Mapping[str, Array]) -> int:
        sizes = {name: len(z) for name, z in columns.items() if len(z) != 1}
        if len(set(sizes.values())) > 1:
            listed = ", ".join(f"'{name}' {size}" for name, size in sizes.items())
            raise ModelError(
                f"{self._owner}: numbers of values differ: {listed}; give the same number for each, or one for all"
            )
        return next(iter(sizes.values()), 1)

    def of(self, i: int) -> list[Array]:
        """The values of variant number i, for `Variant.set`."""
        return [z[i] for z in self.rows]


def _rows(place: Place, given: Any, owner: str) -> Array:
    """Values (variants, numbers) of a parameter; a single value for all is one row."""
    values = array(given, owner, f"parameter '{place.name}'")
    if place.size == 1 and values.ndim <= 1:
        return values.reshape(-1, 1)
    if values.shape == (place.size,):
        return values.reshape(1, -1)
    if values.ndim == 2 and values.shape[1] == place.size:
        return values
    entry = f"; name one entry as '{place.name}[0]'" if place.size > 1 else ""
    raise ModelError(
        f"{owner}: parameter '{place.name}' has values of shape {values.shape}; give (variants, {place.size}){entry}"
    )


def _column(name: str, given: Any, owner: str) -> Array:
    values = np.atleast_1d(array(given, owner, f"initial value '{name}'"))
    if values.ndim != 1:
        raise ModelError(
            f"{owner}: initial values of '{name}' have shape {values.shape}; give one number for each variant"
        )
    return values


def variant_of(system: C, values: Values, i: int) -> C:
    """Variant number i as a separate system."""
    row = values.of(i)
    found, variant = varied(system, values.places, Parameters(system.structure).changed(values.places, row))
    variant.set(row)
    return found


@dataclass(frozen=True)
class Again(Generic[C, T]):
    """Repeats the task of one variant, as a separate system."""

    system: C
    values: Values
    task: Callable[..., T]

    def __call__(self, i: int, *others: int) -> T:
        """The task for variant number i."""
        return self.task(variant_of(self.system, self.values, i), i, *others)


class Runner(Generic[T]):
    """Runs the same task for all variants, in threads.

    Attributes
    ----------
    results : dict of int to result
        By number of the variant.
    failed : dict of int to str
        Messages of those that failed.
    """

    def __init__(self, system: Core, values: Values, task: Callable[[Any, int], T]) -> None:
        self._system, self._values, self._task = system, values, task
        self.results: dict[int, T] = {}
        self.failed: dict[int, str] = {}
        self._errors: dict[int, FlexelError] = {}
        self._lock, self._left = Lock(), iter(range(values.count))
        self._threads = 1

    def run(self, threads: int | None, progress: bool | None) -> None:
        """Run the tasks; an interrupt (Ctrl-C) keeps the finished ones."""
        count = self._threads = min(_threads(threads), self._values.count)
        log.info("%d variants in %d threads", self._values.count, count)
        show = sys.stderr.isatty() if progress is None else flag(progress, "variants", "progress")
        bar = progress_bar(show, self._values.count, "variant")
        try:
            with one_thread():
                self._alone(bar) if count < 2 else self._together(count, bar)
        except KeyboardInterrupt:
            pass
        finally:
            self._left = iter(())
            bar.close()
        for i in range(self._values.count):
            if i not in self.results:
                self.failed.setdefault(i, INTERRUPTED)
        log.info("%d variants computed, %d failed", len(self.results), len(self.failed))

    def _alone(self, bar: Any) -> None:
        for _ in self._work():
            bar.update()

    def _together(self, count: int, bar: Any) -> None:
        with ThreadPoolExecutor(count) as pool:
            try:
                running = {pool.submit(lambda: sum(1 for _ in self._work())) for _ in range(count)}
                while running:
                    done, running = wait(running, WAIT)
                    for z in done:
                        z.result()
                    bar.update(len(self.results) + len(self.failed) - bar.n)
            finally:
                self._left = iter(())  # the threads finish the variants that they have begun

    def _work(self) -> Iterator[None]:
        """Variants, as long as there are any."""
        system, variant = varied(self._system, self._values.places)
        while (i := self._next()) is not None:
            try:
                self._one(system, variant, i)
            except FlexelError as error:
                self._fail(i, error)
            yield

    def _fail(self, i: int, error: FlexelError) -> None:
        self.failed[i], self._errors[i] = str(error), error

    def report(self, owner: str) -> None:
        """Warn of variants without a result.

        Parameters
        ----------
        owner : str
            The analysis, for messages.

        Raises
        ------
        FlexelError
            If there is no result at all and no interrupt: the error of the first variant, of its kind.
        KeyboardInterrupt
            If an interrupt has left no result.

        Warns
        -----
        IncompleteWarning
            How many have none, and the reason of the first.
        """
        if not self.failed:
            return
        first, count = min(self.failed), self._values.count
        message = (
            f"{owner}: {len(self.failed)} of {count} variants failed; number {first}: {self.failed[first]}"
        )
        if self.results:
            warnings.warn(message, IncompleteWarning, stacklevel=4)
        elif first in self._errors:
            error = self._errors[first]
            raise type(error)(message if count > 1 else f"{owner}: {error}") from error
        else:
            raise KeyboardInterrupt(message)

    def _next(self) -> int | None:
        """The next variant, which no other thread takes."""
        with self._lock:
            return next(self._left, None)

    def _one(self, system: Any, variant: Variant, i: int) -> None:
        self._set(system, variant, i)
        self.results[i] = self._task(system, i)

    def _set(self, system: Any, variant: Variant, i: int) -> None:
        """Turn a system into variant number i."""
        variant.set(self._values.of(i))
        _forget(system)


def _forget(system: Core) -> None:
    """Discard what a system keeps of its start, which depends on the parameters."""
    for kept in ("initial", "at_rest"):
        system.__dict__.pop(kept, None)


def _threads(given: int | None) -> int:
    if given is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return whole(given, "variants", "threads")
