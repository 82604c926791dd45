"""Forms of results: which numbers and arrays an analysis returns, with the names of their dimensions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexel.apps.sweeps.points import RESERVED_NAMES
from flexel.base.errors import ModelError

Labels = tuple[tuple[str, tuple[Any, ...]], ...]  # of dimensions that have labels
Numbers = NDArray[np.float64] | NDArray[np.complex128]


@dataclass(frozen=True)
class Form:
    """The form that one result has at every point.

    Attributes
    ----------
    shape : tuple of int
    dims : tuple of str
        Names of the dimensions.
    labels : tuple of (str, tuple)
        Labels along dimensions.
    unit : str
    """

    shape: tuple[int, ...] = ()
    dims: tuple[str, ...] = ()
    labels: Labels = ()
    unit: str = ""

    def as_json(self) -> dict[str, Any]:
        """Return the attributes, for JSON."""
        return asdict(self)

    @classmethod
    def from_json(cls, kept: Mapping[str, Any]) -> Form:
        """Return the form described by `as_json`."""
        labels = tuple((dim, tuple(values)) for dim, values in kept["labels"])
        return cls(tuple(kept["shape"]), tuple(kept["dims"]), labels, kept["unit"])

    def __str__(self) -> str:
        axes = ", ".join(f"{dim}: {size}" for dim, size in zip(self.dims, self.shape, strict=True))
        return f"an array ({axes})" if axes else "a number"


NUMBER = Form()
Forms = tuple[tuple[str, Form], ...]  # of all results, by name


def results_of(returned: Any, parameters: tuple[str, ...]) -> tuple[Forms, dict[str, Numbers]]:
    """Convert the results of an analysis to arrays; raise a ModelError if they cannot be stored."""
    if not isinstance(returned, Mapping) or not returned:
        raise ModelError(f"analyse returned {_brief(returned)}; return a dict of numbers or arrays")
    forms: list[tuple[str, Form]] = []
    values: dict[str, Numbers] = {}
    for name, value in returned.items():
        if not isinstance(name, str) or name in parameters or name in RESERVED_NAMES:
            raise ModelError(f"analyse returned {name!r}, a name in use or not a string; choose another")
        form, values[name] = _result(name, value)
        forms.append((name, form))
    _check(forms, (*parameters, *RESERVED_NAMES))
    return tuple(sorted(forms)), values


def _result(name: str, value: Any) -> tuple[Form, Numbers]:
    """Convert one number, array or labelled array."""
    if type(value) is float:
        return NUMBER, np.array(value)
    try:
        array = np.asarray(value)
    except ValueError:  # ragged nesting
        array = np.array(None)
    if array.dtype.kind not in "biufc":
        raise ModelError(f"analyse returned {_brief(value)} as '{name}'; return numbers or arrays of numbers")
    array = array.astype(complex if array.dtype.kind == "c" else float)
    dims = getattr(value, "dims", None)
    if dims is None:
        return (
            Form(array.shape, tuple(f"{name}_{i}" for i in range(array.ndim))) if array.ndim else NUMBER
        ), array
    labels = tuple((str(dim), tuple(_labels(value.coords[dim]))) for dim in dims if dim in value.coords)
    return Form(array.shape, tuple(map(str, dims)), labels, str(value.attrs.get("units", ""))), array


def _labels(coordinate: Any) -> list[Any]:
    """Return the labels along a dimension: numbers or strings."""
    values = np.asarray(coordinate)
    if values.dtype.kind not in "biufUO":
        raise ModelError(f"analyse returned labels {_brief(values)}; label with numbers or strings")
    return [str(value) for value in values] if values.dtype.kind == "O" else values.tolist()


def _check(forms: list[tuple[str, Form]], taken: tuple[str, ...]) -> None:
    """Check that dimensions of the same name have the same size and labels, and are not parameters."""
    known: dict[str, tuple[int, Any]] = {}
    for name, form in forms:
        labels = dict(form.labels)
        for dim, size in zip(form.dims, form.shape, strict=True):
            if dim in taken:
                raise ModelError(
                    f"analyse returned '{name}' with the dimension '{dim}', a name in use; rename it"
                )
            if known.setdefault(dim, (size, labels.get(dim))) != (size, labels.get(dim)):
                raise ModelError(
                    f"analyse returned '{name}' with a size or labels of '{dim}' unlike those of other results"
                )


def misfit(found: Forms, known: Forms) -> str | None:
    """Explain why results cannot be combined with those of other points; return None if they can."""
    if found == known:
        return None
    there, here = dict(known), dict(found)
    if there.keys() != here.keys():
        return f"analyse returned {', '.join(here)} here, and {', '.join(there)} at other points; return the same names"
    name = next(key for key in here if here[key] != there[key])
    if (here[name].shape, here[name].dims) != (there[name].shape, there[name].dims):
        return f"analyse returned {here[name]} as '{name}' here, and {there[name]} at other points; return the same"
    return f"the labels or units of '{name}' differ from those of other points; return the same"


def _brief(value: Any) -> str:
    text = repr(value)
    return text if len(text) < 80 else text[:76] + " …"
