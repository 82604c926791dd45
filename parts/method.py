"""A method of `Model` that declares a part: the part's class gives its signature and documentation."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any, Generic, ParamSpec, Protocol, TypeVar, overload

from flexel.model.part import Part
from flexel.parts.documentation import documentation

P = ParamSpec("P")
Made = TypeVar("Made")
Function = TypeVar("Function", bound=Callable[..., Any])
METHOD_OF: dict[type[Part[Any]], str] = {}  # names of the methods of `Model`, by the parts that they declare


def declares(kind: type[Part[Any]]) -> Callable[[Function], Function]:
    """Decorate a method of `Model` that takes any number of arguments and declares a part; it gets its docstring."""

    def named(method: Function) -> Function:
        METHOD_OF[kind] = method.__name__
        method.__doc__ = documentation(kind)
        return method

    return named


class Declaring(Protocol):
    """Interface of a model that its methods use."""

    def add(self, part: Part[Any]) -> Any:
        """Add a part, and return what it makes."""
        ...


class Method(Generic[P, Made]):
    """A row of the table of methods: ``beam = Method(Beam)`` makes ``m.beam(…)`` the same as ``m.add(Beam(…))``."""

    def __init__(self, kind: Callable[P, Part[Made]]) -> None:
        self.kind = kind

    def __set_name__(self, owner: type, name: str) -> None:
        kind: Any = self.kind

        def method(model: Declaring, *args: Any, **options: Any) -> Any:
            return model.add(kind(*args, **options))

        method.__name__, method.__qualname__ = name, f"{owner.__name__}.{name}"
        method.__module__, method.__doc__ = kind.__module__, documentation(kind)
        method.__signature__ = _signature(kind)  # type: ignore[attr-defined]
        kind.__init__.__qualname__ = method.__qualname__  # in Python's messages of missing arguments
        self.method = method
        METHOD_OF[kind] = name

    @overload
    def __get__(self, model: None, owner: type) -> Callable[..., Made]: ...
    @overload
    def __get__(self, model: Declaring, owner: type) -> Callable[P, Made]: ...
    def __get__(self, model: Declaring | None, owner: type) -> Callable[..., Made]:
        """Return the method, bound to a model."""
        return self.method.__get__(model, owner)  # type: ignore[no-any-return]


def _signature(kind: type[Part[Any]]) -> inspect.Signature:
    """Return the signature of the class, with the model before."""
    own = inspect.signature(kind)
    model = inspect.Parameter("self", inspect.Parameter.POSITIONAL_ONLY)
    made = inspect.signature(kind.lower).return_annotation
    return own.replace(parameters=[model, *own.parameters.values()], return_annotation=made)
