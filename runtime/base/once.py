"""Properties that are computed once, in whichever thread needs them first.

The locks are renewed in a forked child: a thread that was computing a property at that instant does not exist in the
child, so its lock would never be released.  Before Python 3.12 `cached_property` has such a lock per class too.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from functools import cached_property
from threading import RLock
from typing import Any, Generic, Self, TypeVar, overload

T_co = TypeVar("T_co", covariant=True)


class once(Generic[T_co]):  # noqa: N801 - used as a decorator, like cached_property
    """A `cached_property` that gives all threads the same object: the others wait for the first one.

    Since Python 3.12, two threads may each compute a cached property, which is enough if only its value matters.
    """

    def __init__(self, function: Callable[[Any], T_co]) -> None:
        self._function = function
        self._lock = RLock()
        self.__doc__ = function.__doc__

    def renew(self) -> None:
        """Create a new lock, in a forked child."""
        self._lock = RLock()

    def __set_name__(self, owner: type[Any], name: str) -> None:
        """Record the attribute that holds the value."""
        self._name = name

    @overload
    def __get__(self, instance: None, owner: type[Any] | None = None) -> Self: ...
    @overload
    def __get__(self, instance: object, owner: type[Any] | None = None) -> T_co: ...
    def __get__(self, instance: object, owner: type[Any] | None = None) -> Self | T_co:
        """Return the value, and store it in the instance, where later accesses find it directly."""
        if instance is None:
            return self
        with self._lock:
            if self._name not in instance.__dict__:
                instance.__dict__[self._name] = self._function(instance)
            found: T_co = instance.__dict__[self._name]
            return found


def _descriptors(kind: type[Any]) -> Iterator[Any]:
    """List the properties of this kind in flexel's classes."""
    package = __name__.split(".")[0]
    modules = [module for name, module in list(sys.modules.items()) if name.split(".")[0] == package]
    for module in modules:
        for defined in list(vars(module).values()):
            if isinstance(defined, type) and defined.__module__ == module.__name__:
                yield from (found for found in vars(defined).values() if isinstance(found, kind))


def _renew_locks() -> None:
    for found in _descriptors(once):
        found.renew()
    for found in _descriptors(cached_property):
        if hasattr(found, "lock"):
            found.lock = RLock()


if hasattr(os, "register_at_fork"):  # not on Windows, which does not fork
    os.register_at_fork(after_in_child=_renew_locks)
