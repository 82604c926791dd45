"""Properties that are computed once, in whichever thread needs them first."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from threading import RLock
from typing import Any, Generic, Self, TypeVar, overload

T_co = TypeVar("T_co", covariant=True)


class once(Generic[T_co]):  # noqa: N801 - used as a decorator, like cached_property
    """A `cached_property` of which all threads get the same object: the others wait for the first one.

    Since Python 3.12 two threads may each compute a cached property; that is right where only its value matters.
    """

    def __init__(self, function: Callable[[Any], T_co]) -> None:
        self._cached = cached_property(function)
        self._lock = RLock()
        self.__doc__ = function.__doc__

    def __set_name__(self, owner: type[Any], name: str) -> None:
        """The attribute under which values are kept."""
        self._name = name
        self._cached.__set_name__(owner, name)

    @overload
    def __get__(self, instance: None, owner: type[Any] | None = None) -> Self: ...
    @overload
    def __get__(self, instance: object, owner: type[Any] | None = None) -> T_co: ...
    def __get__(self, instance: object, owner: type[Any] | None = None) -> Self | T_co:
        """The value; kept in the instance, where it is found without this method from then on."""
        if instance is None:
            return self
        with self._lock:
            if self._name in instance.__dict__:
                found: T_co = instance.__dict__[self._name]
                return found
            return self._cached.__get__(instance, owner)
