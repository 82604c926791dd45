"""The content of a saved result: labelled arrays and a header of plain text and numbers.

A record is independent of mechanisms and file formats; `flexel.results.saved.archive` converts results to records and
back, `flexel.results.saved.record_files` writes and reads them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError, ModelError
from flexel.base.outside import Dataset


@dataclass(frozen=True)
class Variable:
    """A real array with the names of its dimensions, its unit, and its description."""

    dims: tuple[str, ...]
    values: Array | NDArray[np.int64]
    unit: str = ""
    doc: str = ""


@dataclass(frozen=True)
class Record:
    """Labelled arrays of one result.

    Attributes
    ----------
    kind : str
        motion, linearization, periodic or flexure.
    variables : mapping of str to Variable
    labels : mapping of str to tuple of str
        Names along a dimension; dimensions that are only counted have none.
    units : mapping of str to tuple of str
        Units along the last dimension of a variable, where they differ.
    header : mapping
        All other data of the result: text, numbers, lists and mappings of these.
    """

    kind: str
    variables: Mapping[str, Variable]
    labels: Mapping[str, tuple[str, ...]]
    units: Mapping[str, tuple[str, ...]]
    header: Mapping[str, Any]

    def checked(self, owner: str) -> Record:
        """Return the record, or raise a ModelError if its arrays and labels have inconsistent sizes."""
        sizes = {dim: len(names) for dim, names in self.labels.items()}
        for name, variable in self.variables.items():
            if len(variable.dims) != variable.values.ndim:
                raise ModelError(f"{owner}: '{name}' has shape {variable.values.shape}; the file is damaged")
            for dim, size in zip(variable.dims, variable.values.shape, strict=True):
                if sizes.setdefault(dim, size) != size:
                    raise ModelError(
                        f"{owner}: '{name}' has {size} entries along '{dim}', not {sizes[dim]}; the file is damaged"
                    )
        return self

    def to_xarray(self) -> Dataset:
        """Return all arrays as one xarray.Dataset, with labels and units as coordinates."""
        xarray = require("xarray", "xarray")
        coordinates: dict[str, Any] = {dim: np.array(names, dtype=str) for dim, names in self.labels.items()}
        for name, units in self.units.items():
            coordinates[f"{name}_unit"] = (self.variables[name].dims[-1], list(units))
        data = {}
        for name, variable in self.variables.items():
            attributes = {
                key: text for key, text in (("units", variable.unit), ("long_name", variable.doc)) if text
            }
            if variable.dims == (name,):
                coordinates[name] = (name, variable.values, attributes)
            else:
                data[name] = (variable.dims, variable.values, attributes)
        return xarray.Dataset(data, coordinates, {"kind": self.kind})


def require(module: str, extra: str) -> Any:
    """Import an optional package, or raise a FlexelError with the command that installs it."""
    from importlib import import_module

    try:
        return import_module(module)
    except ImportError as error:
        raise FlexelError(
            f"this needs {module}, which is not installed; pip install 'flexel[{extra}]'"
        ) from error
