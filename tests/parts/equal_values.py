"""Differences between two values, bit by bit, for tests: tables of models, parts, results."""

import struct
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from re import fullmatch
from types import BuiltinFunctionType, FunctionType, MethodType
from typing import Any

import numpy as np
from scipy.sparse import issparse

import flexel as fx
from flexel.model.part import Part


def assert_same(a: Any, b: Any) -> None:
    """Two values are equal in kind, shape and every bit."""
    found = list(differences(a, b))
    assert not found, "\n".join(found[:10])


def assert_same_model(a: fx.Model, b: fx.Model) -> None:
    """Two models have the same parts and the same tables: nodes, elements, laws, loads, roles and initial values."""
    assert_same(a.lowering, b.lowering)
    assert len(a.parts) == len(b.parts)
    for own, other in zip(a.parts, b.parts, strict=True):
        assert type(own) is type(other)
        assert_same_part(own, other)


def assert_same_part(a: Part[Any], b: Part[Any]) -> None:
    """Two parts were declared with the same; a program and a file may turn NumPy's numbers and arrays into Python's."""
    for item in fields(a):
        assert_same(plain(getattr(a, item.name)), plain(getattr(b, item.name)))


def plain(value: Any) -> Any:
    """NumPy's numbers and arrays as those of Python, in all containers."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if type(value) in (list, tuple):
        return type(value)(map(plain, value))
    if isinstance(value, Mapping):
        return {plain(key): plain(item) for key, item in value.items()}
    return value


def differences(a: Any, b: Any, where: str = "") -> Iterator[str]:
    """What is different, by its place in the value."""
    a, b = (value.item() if isinstance(value, np.generic) else value for value in (a, b))
    if a is b:
        return
    if type(a) is not type(b):
        yield f"{where}: {a!r:.80} and {b!r:.80} are of different kinds"
    elif isinstance(a, float):
        if struct.pack("d", a) != struct.pack("d", b):
            yield f"{where}: {a!r} and {b!r}"
    elif isinstance(a, np.ndarray) and a.dtype != object:
        if (a.dtype, a.shape, a.tobytes()) != (b.dtype, b.shape, b.tobytes()):
            yield f"{where}: {a!r:.200} and {b!r:.200}"
    elif isinstance(a, (list, tuple)) or (isinstance(a, np.ndarray) and a.dtype == object):
        if len(a) != len(b):
            yield f"{where}: {len(a)} and {len(b)} entries"
        for i, pair in enumerate(zip(a, b, strict=False)):
            yield from differences(*pair, f"{where}[{i}]")
    elif isinstance(a, Mapping):
        if list(a) != list(b):
            yield f"{where}: keys {list(a)} and {list(b)}"
        for key in a.keys() & b.keys():
            yield from differences(a[key], b[key], f"{where}[{key!r}]")
    elif isinstance(a, (str, int, set, frozenset)):
        if a != b:
            yield f"{where}: {a!r:.80} and {b!r:.80}"
    elif isinstance(a, (FunctionType, MethodType, BuiltinFunctionType, type)):
        yield f"{where}: {a!r:.80} and {b!r:.80} are two functions"
    elif issparse(a):
        yield from differences(a.toarray(), b.toarray(), where)
    elif is_dataclass(a):
        for item in fields(a):
            yield from differences(getattr(a, item.name), getattr(b, item.name), f"{where}.{item.name}")
    else:
        yield from differences(*map(contents, (a, b)), where)


def contents(value: Any) -> dict[str, Any]:
    """What an object holds, except what python-control makes of it: functions, and the number of a system."""
    numbered = fullmatch(r"sys\[\d+\]", str(getattr(value, "name", "")))
    made = (
        {"updfcn", "outfcn", "name" if numbered else ""}
        if type(value).__module__.startswith("control.")
        else set()
    )
    return {name: held for name, held in vars(value).items() if name not in made}
