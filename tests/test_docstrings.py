"""What is public with more than three arguments explains them: a numpydoc section Parameters."""

import inspect
from collections.abc import Callable, Iterator
from typing import Any

import flexel

MOST = 3  # arguments without a section


def functions() -> Iterator[tuple[str, Callable[..., Any]]]:
    """Public functions, and the methods of public classes that are written in flexel, by their full names."""
    for name in flexel.__all__:
        value = getattr(flexel, name)
        if inspect.isfunction(value):
            yield f"{value.__module__}.{name}", value
        for base in inspect.getmro(value) if inspect.isclass(value) else ():
            members = (getattr(z, "__func__", z) for key, z in vars(base).items() if not key.startswith("_"))
            yield from (
                (f"{z.__module__}.{z.__qualname__}", z)
                for z in members
                if inspect.isfunction(z) and z.__module__.startswith("flexel.")
            )


def arguments(function: Callable[..., Any]) -> list[str]:
    return [name for name in inspect.signature(function).parameters if name not in ("self", "cls")]


def test_functions_with_more_than_three_arguments_have_a_section_parameters() -> None:
    missing = {
        name
        for name, function in functions()
        if len(arguments(function)) > MOST
        and "Parameters\n----------\n" not in (inspect.getdoc(function) or "")
    }
    assert sorted(missing) == []
