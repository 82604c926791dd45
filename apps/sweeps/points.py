"""The points of a sweep: the values of parameters, on a grid or one by one."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexel.base.arguments import whole
from flexel.base.errors import ModelError

Column = NDArray[Any]  # float64, int64, bool or text, one-dimensional
OWNER = "points of a sweep"
RESERVED_NAMES = ("point", "failed")  # names used in the dataset
BLOCK_POINTS = 10_000  # points converted to Python numbers at a time


@dataclass(frozen=True)
class Points:
    """Points of a sweep; made by `grid`, `listed` or `sample`.

    Attributes
    ----------
    values : mapping of str to ndarray
        Of each parameter: along its axis of a grid, else at each point.
    is_grid : bool
        Whether the points are all combinations; the last parameter varies fastest.
    """

    values: Mapping[str, Column]
    is_grid: bool

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters."""
        return tuple(self.values)

    @property
    def dims(self) -> tuple[str, ...]:
        """Dimensions of results in the dataset."""
        return self.names if self.is_grid else ("point",)

    @property
    def shape(self) -> tuple[int, ...]:
        """Sizes of these dimensions."""
        sizes = tuple(len(column) for column in self.values.values())
        return sizes if self.is_grid else sizes[:1]

    def __len__(self) -> int:
        return math.prod(self.shape)

    def columns(self, begin: int, end: int) -> dict[str, list[Any]]:
        """Return the values of each parameter at the points `begin` to `end` (excluded)."""
        if not self.is_grid:
            return {name: column[begin:end].tolist() for name, column in self.values.items()}
        places = np.unravel_index(np.arange(begin, end), self.shape)
        return {
            name: column[i].tolist() for i, (name, column) in zip(places, self.values.items(), strict=True)
        }

    def point(self, index: int) -> dict[str, Any]:
        """Return one point."""
        i = whole(index, OWNER, "number of the point", 0, len(self) - 1)
        return {name: column[0] for name, column in self.columns(i, i + 1).items()}

    def shown(self, index: int) -> str:
        """Return a point as text."""
        return ", ".join(f"{name} = {value!r}" for name, value in self.point(index).items())

    def described(self) -> dict[str, Any]:
        """Return the identity of these points, for JSON: sizes and digests of the values by name."""
        return {
            "grid": self.is_grid,
            "parameters": {name: [len(column), _digest(column)] for name, column in self.values.items()},
        }

    def difference(self, other: Mapping[str, Any]) -> str | None:
        """Explain how points differ from those described; return None if they do not."""
        there, here = other["parameters"], self.described()["parameters"]
        if list(there) != list(here):
            return f"its parameters are {', '.join(there)}, not {', '.join(here)}"
        if other["grid"] != self.is_grid:
            return "its points are " + ("a grid, not a list" if other["grid"] else "a list, not a grid")
        for name, (size, digest) in here.items():
            if there[name][0] != size:
                return f"'{name}' has {there[name][0]} values in it, not {size}"
            if there[name][1] != digest:
                return f"'{name}' has other values in it"
        return None


def grid(axes: Mapping[str, Iterable[Any]]) -> Points:
    """Combine the values of parameters in all possible ways, as points for `fx.sweep`.

    Parameters
    ----------
    axes : mapping of str to sequence
        Numbers, strings or booleans by parameter of ``build``. The last parameter varies fastest.

    Examples
    --------
    >>> len(fx.grid({"speed": [4.0, 5.0, 6.0], "tyre": ["soft", "hard"]}))
    6
    """
    return Points(_columns(axes), True)


def listed(points: Mapping[str, Iterable[Any]] | Iterable[Mapping[str, Any]]) -> Points:
    """Return points for `fx.sweep`, given one by one.

    Parameters
    ----------
    points : mapping of str to sequence, or iterable of mappings
        The values of each parameter at all points, equally many; or all parameters at each point. A generator is read
        once, and kept as arrays of numbers.

    Examples
    --------
    >>> fx.listed({"length": [0.1, 0.2], "load": [5.0, 2.5]}).point(1)
    {'length': 0.2, 'load': 2.5}
    """
    columns = _columns(points) if isinstance(points, Mapping) else _gathered(points)
    sizes = {name: len(column) for name, column in columns.items()}
    if len(set(sizes.values())) > 1:
        given = ", ".join(f"'{name}' {size}" for name, size in sizes.items())
        raise ModelError(
            f"{OWNER}: the lists differ in length: {given}; give equally many values, or fx.grid for all combinations"
        )
    return Points(columns, False)


def points_of(given: Any) -> Points:
    """Convert the points given to `fx.sweep`: ready-made, axes of a grid, or one by one."""
    if isinstance(given, Points):
        return given
    if isinstance(given, Mapping):
        return grid(given)
    if isinstance(given, Iterable) and not isinstance(given, str | bytes):
        return listed(given)
    raise ModelError(
        f"{OWNER}: {given!r} is not a set of points; give {{'parameter': [values…]}}, a list of points, or a sample"
    )


def _columns(given: Mapping[str, Iterable[Any]]) -> dict[str, Column]:
    """Return checked values by name."""
    if not isinstance(given, Mapping) or not given:
        raise ModelError(f"{OWNER}: {given!r} names no parameter; give {{'parameter': [values…]}}")
    for name in given:
        if not isinstance(name, str) or name in RESERVED_NAMES:
            raise ModelError(f"{OWNER}: {name!r} cannot be a parameter; choose another name")
    return {name: _column(name, values) for name, values in given.items()}


def _column(name: str, given: Any) -> Column:
    """Return the values of one parameter: all numbers, all strings or all booleans."""
    if isinstance(given, str | bytes) or not isinstance(given, Iterable):
        raise ModelError(f"{OWNER}: '{name}' is {given!r}; give a list of values")
    values = given if isinstance(given, np.ndarray) else list(given)
    kinds = (
        {_kind(value) for value in values}
        if isinstance(values, list)
        else {values.dtype.kind.replace("u", "i")}
    )
    if not len(values):
        raise ModelError(f"{OWNER}: '{name}' has no values; give at least one")
    if kinds == {"i", "f"}:
        kinds = {"f"}
    if len(kinds) > 1 or not kinds <= set("bifU") or np.ndim(values) != 1:
        raise ModelError(
            f"{OWNER}: the values of '{name}' are not all numbers, all strings or all booleans; "
            "give such values, and let build look up the objects"
        )
    column = np.array(values, {"b": bool, "i": np.int64, "f": float, "U": str}[kinds.pop()])
    if column.dtype.kind == "f" and not np.isfinite(column).all():
        raise ModelError(f"{OWNER}: '{name}' has values that are not finite; give finite numbers")
    return column


def _kind(value: Any) -> str:
    """Return the kind of one value: b, i, f, U or another one."""
    kind = np.asarray(value).dtype.kind if np.ndim(value) == 0 else "O"
    return kind.replace("u", "i")


def _gathered(points: Iterable[Mapping[str, Any]]) -> dict[str, Column]:
    """Convert points given one by one to columns."""
    if not isinstance(points, Iterable):
        raise ModelError(
            f"{OWNER}: {points!r:.60} is not a set of points; give a mapping, or a list of mappings"
        )
    source, names, parts, total = iter(points), None, [], 0
    while block := list(islice(source, BLOCK_POINTS)):
        for i, point in enumerate(block, start=total):
            if not isinstance(point, Mapping):
                raise ModelError(f"{OWNER}: point {i} is {point!r}; give {{'parameter': value}}")
            names = set(point) if names is None else names
            if set(point) != names:
                odd = ", ".join(repr(key) for key in sorted(names ^ set(point), key=str))
                raise ModelError(
                    f"{OWNER}: point {i} differs from point 0 in {odd}; give the same names in each"
                )
        total += len(block)
        parts.append(_columns({name: [point[name] for point in block] for name in block[0]}))
    if not parts:
        raise ModelError(f"{OWNER}: there are none; give at least one point")
    joined = {name: [part[name] for part in parts] for name in parts[0]}
    return _columns({name: _joined(name, columns) for name, columns in joined.items()})


def _joined(name: str, columns: list[Column]) -> Column:
    """Join the parts of a column; integers and fractions may be mixed, other kinds may not."""
    if len({column.dtype.kind.replace("i", "f") for column in columns}) > 1:
        raise ModelError(f"{OWNER}: the values of '{name}' are not all numbers, all strings or all booleans")
    return np.concatenate(columns)


def _digest(column: Column) -> str:
    """Return a short digest of values; strings have the same digest at any width."""
    data = "\0".join(column.tolist()).encode() if column.dtype.kind == "U" else column.tobytes()
    return hashlib.sha256(column.dtype.kind.encode() + data).hexdigest()[:16]
