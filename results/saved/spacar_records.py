"""Reads matrices and state-space models from SPACAR's `.sbm` and `.ltv` files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.arguments import index, text, unknown
from flexel.base.arrays import Array
from flexel.base.copies import Portable
from flexel.base.errors import ModelError
from flexel.base.outside import Dataset
from flexel.base.shown import counted, prints
from flexel.results.saved.record import require
from flexel.results.saved.spacar_entries import TaggedEntries


@dataclass(frozen=True)
class SpacarRecords(Portable):
    """Matrices at several times or load steps, from a file of SPACAR; ``records["M0"]`` is the series of one tag.

    Attributes
    ----------
    path : Path
        The file.
    t : ndarray (nt,)
        Times [s]; zero in load steps.
    matrices : mapping of str to ndarray (nt, rows, columns)
        `.sbm`: M0, C0, D0, K0, N0, G0 and, where there are inputs, B0, over the degrees of freedom in SPACAR's order.
        `.ltv`: A, B, C, D of the state-space model, M0, C0B, K0B, and the nominal inputs U0 and outputs Y0.
    constant : mapping of str to array or str
        The other entries: numbers of degrees of freedom, inputs and outputs.
    """

    path: Path
    t: Array
    matrices: Mapping[str, Array]
    constant: Mapping[str, Any]

    @prints
    def __repr__(self) -> str:
        return (
            f"SpacarRecords('{self.path.name}': {counted(len(self), 'record')} of {', '.join(self.matrices)})"
        )

    def __getitem__(self, tag: str) -> Array:
        """Return the matrices (nt, rows, columns) of a tag.

        Raises
        ------
        ModelError
            A tag that the file does not have.
        """
        tag = text(tag, f"'{self.path.name}'", "tag")
        if tag not in self.matrices:
            raise ModelError(f"'{self.path.name}': {unknown(tag, self.matrices, 'tag')}")
        return self.matrices[tag]

    def __len__(self) -> int:
        return len(self.t)

    def state_space(self, record: int = 0) -> tuple[Array, Array, Array, Array]:
        """Return A, B, C, D of one record of an `.ltv` file; D is zero if the file has none.

        Raises
        ------
        ModelError
            A file without these matrices, or a record that it does not have.
        """
        owner = f"'{self.path.name}'"
        record = index(record, owner, "record")
        missing = [name for name in "ABC" if name not in self.matrices]
        if missing:
            raise ModelError(
                f"{owner}: the matrices {', '.join(missing)} are missing; only an .ltv file has state-space models"
            )
        if not -len(self) <= record < len(self):
            raise ModelError(f"{owner}: record {record} does not exist; there are {len(self)}, from 0")
        A, B, C = (self.matrices[name][record] for name in "ABC")
        through = "D" in self.matrices and np.any(
            self.constant.get("DFT", 1)
        )  # otherwise no input acts on the outputs directly
        return A, B, C, self.matrices["D"][record] if through else np.zeros((C.shape[0], B.shape[1]))

    def to_xarray(self) -> Dataset:
        """Return all matrices as one xarray.Dataset over the records."""
        dims = {tag: ("record", f"{tag}_row", f"{tag}_column") for tag in self.matrices}
        data = {tag: (dims[tag], matrix) for tag, matrix in self.matrices.items()}
        return require("xarray", "xarray").Dataset({"t": ("record", self.t), **data})

    def to_control(self, record: int = 0) -> Any:
        """Return one record of an `.ltv` file as a state-space model of python-control; see `state_space`."""
        return require("control", "control").ss(*self.state_space(record))


def records_of(entries: TaggedEntries, path: Path) -> SpacarRecords:
    """Return the records in the entries of an `.sbm` or `.ltv` file.

    Raises
    ------
    ModelError
        A damaged file, or one without times.
    """
    if "T" not in entries.records:
        raise ModelError(f"load '{path}': the entry T is missing; it is not a complete {path.suffix} file")
    matrices = {tag: matrix for tag, matrix in entries.records.items() if tag != "T"}
    return SpacarRecords(path, entries.records["T"][:, 0, 0], matrices, entries.constant)
