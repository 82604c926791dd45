"""Public functions, methods and classes with more than three arguments have a numpydoc section for them."""

import inspect
from collections.abc import Callable, Iterator
from typing import Any

import flexel
import flexel.derive

MOST = 3  # arguments without a section


def public() -> list[Any]:
    """What users import from flexel and flexel.derive."""
    return [getattr(module, name) for module in (flexel, flexel.derive) for name in module.__all__]


def functions() -> Iterator[tuple[str, Callable[..., Any]]]:
    """Public functions, and the methods of public classes that are written in flexel, by their full names."""
    for value in public():
        if inspect.isfunction(value):
            yield f"{value.__module__}.{value.__name__}", value
        for base in inspect.getmro(value) if inspect.isclass(value) else ():
            members = (
                getattr(member, "__func__", member)
                for key, member in vars(base).items()
                if not key.startswith("_")
            )
            yield from (
                (f"{member.__module__}.{member.__qualname__}", member)
                for member in members
                if inspect.isfunction(member) and member.__module__.startswith("flexel.")
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


def test_classes_with_more_than_three_arguments_have_a_section_parameters_or_attributes() -> None:
    """In their own docstring, or in that of a base class that holds their fields."""
    classes = [value for value in public() if inspect.isclass(value) and not issubclass(value, BaseException)]
    assert len(classes) > 50
    missing = [
        value.__name__
        for value in classes
        if len(inspect.signature(value).parameters) > MOST
        and not any(
            f"{section}\n{'-' * len(section)}\n" in inspect.cleandoc(base.__doc__ or "")
            for base in inspect.getmro(value)
            for section in ("Parameters", "Attributes")
        )
    ]
    assert missing == []
