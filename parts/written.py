"""The written form of a value that a user gave: its constructor with arguments, or the name to import it by.

Programs (`flexel.parts.model_program`) and files (`flexel.parts.model_file`) write the same values.
"""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable
from dataclasses import MISSING, fields, is_dataclass
from functools import partial
from importlib import import_module
from re import fullmatch
from typing import Any

import numpy as np

import flexel
from flexel.base.errors import ModelError
from flexel.base.time_tables import Table
from flexel.model.part import is_same

CONSTRUCTED: dict[type, tuple[str, ...]] = {Table: ("t", "u", "kind")}  # other than dataclasses
SYSTEMS = {  # linear systems of controllers, and what their classes take by position
    "scipy.signal.StateSpace": ("A", "B", "C", "D"),
    "scipy.signal.TransferFunction": ("num", "den"),
    "scipy.signal.ZerosPolesGain": ("zeros", "poles", "gain"),
    "control.StateSpace": ("A", "B", "C", "D"),
    "control.TransferFunction": ("num_list", "den_list"),
}
SIGNALS = {
    "inputs": ("input_labels", "u"),
    "outputs": ("output_labels", "y"),
    "states": ("state_labels", "x"),
}


def constructor_of(value: object) -> str | None:
    """Return the name of a class whose arguments describe a value entirely; None for other values.

    It is the public name of a class of flexel, a name of `SYSTEMS` with its module, or that of a frozen dataclass of
    the user with its module.
    """
    kind = type(value)
    if system := _system_class(kind):
        return system
    name = kind.__name__
    if name in flexel.__all__ and getattr(flexel, name) is kind:
        return name if is_dataclass(value) or kind in CONSTRUCTED else None
    return f"{kind.__module__}.{name}" if _is_users(kind) else None


def constructor_named(name: str, owner: str) -> Any:
    """Return what makes an object of that class by named arguments; raise a ModelError for an unknown one."""
    if name in SYSTEMS:
        module, _, short = name.rpartition(".")
        return partial(_system, imported(module, short, owner), SYSTEMS[name])
    module, _, short = name.rpartition(".")
    if module:
        kind = imported(module, short, owner)
        known = isinstance(kind, type) and _is_users(kind)
    else:
        kind = getattr(flexel, name, None) if name in flexel.__all__ else None
        known = isinstance(kind, type) and (is_dataclass(kind) or kind in CONSTRUCTED)
    if not known:
        raise ModelError(
            f"{owner}: {name!r:.40} is not a flexel object; load the file with the version that wrote it"
        )
    return kind


def arguments_of(value: Any) -> dict[str, Any]:
    """Return the arguments of a value's constructor by name, without the defaults."""
    if type(value) in CONSTRUCTED:
        return {name: getattr(value, name) for name in CONSTRUCTED[type(value)]}
    if system := _system_class(type(value)):
        return {name: getattr(value, name) for name in SYSTEMS[system]} | _options(value)
    given = {item.name: (getattr(value, item.name), item.default) for item in fields(value) if item.init}
    return {
        name: found
        for name, (found, default) in given.items()
        if default is MISSING or not is_same(found, default)
    }


def split_arguments(value: Any) -> tuple[list[Any], dict[str, Any]]:
    """Return the arguments of a value's constructor: those without a default by position, the others by name."""
    given = arguments_of(value)
    if type(value) in CONSTRUCTED:
        return [], given
    if system := _system_class(type(value)):
        return [given.pop(name) for name in SYSTEMS[system]], given
    required = [item.name for item in fields(value) if item.default is MISSING and not item.kw_only]
    return [given.pop(name) for name in required], given


def listed(array: np.ndarray) -> Any:
    """Return an array as lists of lists; None if these lose its shape, which those of an array of no rows do."""
    found = array.tolist()
    return found if array.size or np.shape(found) == array.shape else None


def import_name(value: object, owner: str, what: str) -> tuple[str, str]:
    """Return module and name by which a function or another object of the user is imported.

    Raises
    ------
    ModelError
        A lambda, a function within a function, an object without a name in a module.
    """
    module, name = getattr(value, "__module__", None), getattr(value, "__qualname__", None)
    if not isinstance(name, str):  # an object, such as a compiled element: the variable that holds it
        module, name = _variable(value)
    if (
        isinstance(module, str)
        and isinstance(name, str)
        and module != "__main__"
        and _found(module, name) is value
    ):
        return module, name
    shown = name if isinstance(name, str) else f"{value!r:.60}"
    raise ModelError(
        f"{owner}: {what} {shown} cannot be imported by name, so a program or a file cannot refer to it; define it "
        "in a module, outside of functions and classes"
    )


def imported(module: str, name: str, owner: str) -> Any:
    """Import the object with that name; raise a ModelError that names the owner if there is none."""
    try:
        import_module(module)
    except ImportError as error:
        raise ModelError(
            f"{owner}: the module '{module}' of '{name}' cannot be imported ({error})"
        ) from error
    found = _found(module, name)
    if found is None:
        raise ModelError(f"{owner}: the module '{module}' has no '{name}'; use the version that has it")
    return found


def _is_users(kind: type) -> bool:
    """Whether a class is a frozen dataclass of a user's module: its fields are all that its objects hold."""
    module, parameters = kind.__module__, getattr(kind, "__dataclass_params__", None)
    if parameters is None or "__dataclass_params__" not in vars(kind) or not parameters.frozen:
        return False
    whole = all(item.init for item in fields(kind))
    inside = module == "__main__" or module.split(".")[0] == "flexel"
    return whole and not inside and _found(module, kind.__qualname__) is kind and "." not in kind.__qualname__


def _system_class(kind: type) -> str | None:
    """Return the name in `SYSTEMS` of the class of a linear system; its module is imported where there is one."""
    for name in SYSTEMS:
        module, _, short = name.rpartition(".")
        known = getattr(sys.modules.get(module), short, None)
        if isinstance(known, type) and issubclass(kind, known) and kind.__module__ == known.__module__:
            return name
    return None


def _system(kind: Callable[..., Any], positional: tuple[str, ...], **given: Any) -> Any:
    """Make a linear system, whose class takes its matrices by position only."""
    matrices = [given.pop(name) for name in positional]
    return kind(*matrices, **given)


def _options(system: Any) -> dict[str, Any]:
    """Return the time step of a linear system, and the names that python-control did not number itself."""
    found: dict[str, Any] = {}
    if system.dt is not None or not type(system).__module__.startswith("scipy."):
        found["dt"] = system.dt
    if not fullmatch(r"sys\[\d+\]", name := getattr(system, "name", "sys[0]")):
        found["name"] = name
    for option, (labels, letter) in SIGNALS.items():
        held = getattr(system, labels, [])
        if held != [f"{letter}[{i}]" for i in range(len(held))]:
            found[option] = held
    return found


def _variable(value: object) -> tuple[str | None, str | None]:
    """Find the first variable of a module, other than `__main__`, that holds an object."""
    for module in list(sys.modules.values()):
        if getattr(module, "__name__", "__main__") == "__main__" or not inspect.ismodule(module):
            continue
        for name, held in list(vars(module).items()):
            if held is value:
                return module.__name__, name
    return None, None


def _found(module: str, name: str) -> Any:
    found: Any = sys.modules.get(module)
    for step in name.split("."):
        found = getattr(found, step, None)
    return found
