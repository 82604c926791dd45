"""Runs variants of a system with other values of parameters, one after another in each thread.

All variants share the tables and the choice of degrees of freedom; each thread has separate arrays and parameters.
Every variant begins from the same pivot orders, so that its digits depend neither on the others nor on the threads.
"""

from __future__ import annotations

import logging
import os
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from copy import copy
from dataclasses import dataclass, replace
from threading import Lock
from typing import Any, Generic, TypeVar

import numpy as np

from flexel.base.arguments import array, mapping, whole
from flexel.base.arrays import Array
from flexel.base.blas import one_thread
from flexel.base.callers import outside
from flexel.base.errors import FlexelError, IncompleteWarning, ModelError
from flexel.base.progress import progress_bar, seen
from flexel.engine.variants import Variant
from flexel.model.parameters import ParameterPlace, Parameters
from flexel.model.signs import check_signs
from flexel.model.structure import Structure
from flexel.results.analyses.lowered_values import Rebuilt, lowered_values
from flexel.system import CoreSystem

log = logging.getLogger("flexel.variants")
C = TypeVar("C", bound=CoreSystem)
T = TypeVar("T")
INTERRUPTED = "interrupted before it was done"
PROGRESS_INTERVAL_S = 0.1  # time between two checks of the progress [s]


def varied(
    system: C, places: Sequence[ParameterPlace], structure: Structure | None = None
) -> tuple[C, Variant]:
    """Copy a system so that its parameters can be changed without changing the system's."""
    variant = Variant(system.evaluation, places, structure)
    found = copy(system)
    found.forget_start()
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
    numbers : dict of str to ndarray (count, size)
        The same by the full names of the numbers of parts.
    units : dict of str to str
    anew : Rebuilt or None
        Rebuilds the system of a variant, where the geometry changes.
    """

    def __init__(
        self, system: CoreSystem, given: Mapping[str, Any] | None, initial: Mapping[str, Any], owner: str
    ) -> None:
        self._owner = owner
        parameters = Parameters(system.structure, system.origin)
        given = mapping(given, owner, "parameters")
        asked = [parameters.find(name, owner) for name in given]
        self.units = {place.name: parameters.unit(place) for place in asked}
        rows = [_rows(place, given[place.name], owner) for place in asked]
        starts = {name: _column(name, value, owner) for name, value in initial.items()}
        self.count = self._count(
            {**{place.name: row for place, row in zip(asked, rows, strict=True)}, **starts}
        )
        rows = [np.broadcast_to(row, (self.count, row.shape[1])) for row in rows]
        self.initial = {name: np.broadcast_to(value, self.count) for name, value in starts.items()}
        self.given = {
            place.name: row[:, 0] if place.size == 1 else row for place, row in zip(asked, rows, strict=True)
        }
        _check_once(asked, owner)
        self.numbers = {place.full_name: row for place, row in zip(asked, rows, strict=True)}
        lowered = lowered_values(system, parameters, asked, rows, owner)
        self.places, self.rows, self.anew = lowered.places, lowered.rows, lowered.anew
        self._profiles = lowered.profiles
        self._check_signs(parameters)

    def _check_signs(self, parameters: Parameters) -> None:
        """Check the signs of the parameters of laws; a wrong one of an element fails its variant alone."""
        if not any(target.law for place in self.places for target in place.targets):
            return
        for i in range(self.count):
            owners = parameters.owners(self.places, self.of(i))
            for law in (owner for (is_law, _), owner in owners.items() if is_law):
                self._check_part(law, i)

    def check_elements(self, system: CoreSystem) -> None:
        """Check the signs of the parameters of the elements of the only variant."""
        for part in Parameters(system.structure, system.origin).owners(self.places, self.of(0)).values():
            self._check_part(part, 0)

    def _check_part(self, part: Any, i: int) -> None:
        check_signs(part.spec.parameters, part.parameters, f"{self._owner}: variant {i}: '{part.name}'")

    def _count(self, columns: Mapping[str, Array]) -> int:
        sizes = {name: len(rows) for name, rows in columns.items() if len(rows) != 1}
        if empty := [name for name, size in sizes.items() if not size]:
            raise ModelError(f"{self._owner}: no values of '{empty[0]}' are given; give at least one")
        if len(set(sizes.values())) > 1:
            listed = ", ".join(f"'{name}' {size}" for name, size in sizes.items())
            raise ModelError(
                f"{self._owner}: numbers of values differ: {listed}; give the same number for each, or one for all"
            )
        return next(iter(sizes.values()), 1)

    def structure(self, system: CoreSystem, i: int) -> Structure:
        """Return the structure of variant number i."""
        found = Parameters(system.structure).changed(self.places, self.of(i))
        other = self._profiles[i] if self._profiles else {}
        if not other:
            return found
        elements = enumerate(found.instances)
        return replace(
            found,
            instances=tuple(
                replace(element, profile=other.get(k, element.profile)) for k, element in elements
            ),
        )

    def of(self, i: int) -> list[Array]:
        """Return the values of variant number i, for `Variant.set`."""
        return [rows[i] for rows in self.rows]


def _check_once(asked: Sequence[ParameterPlace], owner: str) -> None:
    """Raise a ModelError for a number of a part that is given twice, by two names."""
    names: dict[tuple[str, int | None], str] = {}
    for place in asked:
        if place.declared is None:
            continue
        other = names.setdefault((place.declared, place.entry), place.name)
        if other != place.name:
            raise ModelError(
                f"{owner}: '{other}' and '{place.name}' are the same parameter; give one of them"
            )


def _rows(place: ParameterPlace, given: Any, owner: str) -> Array:
    """Return the values (variants, numbers) of a parameter; a single value for all is one row."""
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
    """Return variant number i as a separate system."""
    if values.anew is not None:
        built: C = values.anew(i)
        return built
    row = values.of(i)
    found, variant = varied(system, values.places, values.structure(system, i))
    variant.set(row)
    if system.origin is not None:
        found.origin = system.origin.changed({name: rows[i] for name, rows in values.numbers.items()})
    return found


@dataclass(frozen=True)
class Recomputation(Generic[C, T]):
    """Repeats the task of one variant, as a separate system."""

    system: C
    values: Values
    task: Callable[..., T]

    def __call__(self, i: int, *others: int) -> T:
        """Compute the task for variant number i."""
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

    def __init__(self, system: CoreSystem, values: Values, task: Callable[[Any, int], T]) -> None:
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
        show = seen(progress, "variants")
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
                    done, running = wait(running, PROGRESS_INTERVAL_S)
                    for future in done:
                        future.result()
                    bar.update(len(self.results) + len(self.failed) - bar.n)
            finally:
                self._left = iter(())  # the threads finish the variants that they have begun

    def _work(self) -> Iterator[None]:
        """Take variants as long as there are any."""
        if self._values.anew is not None:
            yield from self._built(self._values.anew)
            return
        system, variant = varied(self._system, self._values.places)
        while (i := self._next()) is not None:
            try:
                self._one(system, variant, i)
            except FlexelError as error:
                self._fail(i, error)
            yield

    def _built(self, anew: Rebuilt) -> Iterator[None]:
        """Build variants of other geometry, each as a separate system."""
        while (i := self._next()) is not None:
            try:
                self.results[i] = self._task(anew(i), i)
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
            warnings.warn(message, IncompleteWarning, stacklevel=outside())
        elif first in self._errors:
            error = self._errors[first]
            raise type(error)(message if count > 1 else f"{owner}: {error}") from error
        else:
            raise KeyboardInterrupt(message)

    def _next(self) -> int | None:
        """Return the next variant, which no other thread takes."""
        with self._lock:
            return next(self._left, None)

    def _one(self, system: Any, variant: Variant, i: int) -> None:
        self._set(system, variant, i)
        self.results[i] = self._task(system, i)

    def _set(self, system: Any, variant: Variant, i: int) -> None:
        """Turn a system into variant number i."""
        variant.set(self._values.of(i))
        system.forget_start()


def _threads(given: int | None) -> int:
    if given is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return whole(given, "variants", "threads")
