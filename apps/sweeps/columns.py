"""Stores one result of all points as an array in a file, written in pieces and read as needed."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexel.apps.sweeps.forms import Numbers

PIECE_BYTES = 1 << 22  # bytes written at a time when a file is filled


@dataclass
class ColumnFile:
    """A .npy file with one row for each point, filled with NaN."""

    path: Path
    descriptor: int
    offset: int
    shape: tuple[int, ...]
    dtype: np.dtype[Any]

    @classmethod
    def made(cls, path: Path, count: int, shape: tuple[int, ...], dtype: type = float) -> ColumnFile:
        """Create a file."""
        np.lib.format.open_memmap(path, "w+", dtype, (count, *shape))
        file = cls.opened(path)
        rows = max(1, PIECE_BYTES // max(file.row_bytes, 1))
        empty: NDArray[Any] = np.full((rows, *shape), math.nan, dtype)
        for begin in range(0, count, rows):
            file._put(begin, empty[: count - begin])
        return file

    @classmethod
    def opened(cls, path: Path) -> ColumnFile:
        """Open an existing file."""
        header = np.load(path, mmap_mode="r")
        return cls(path, os.open(path, os.O_RDWR), int(header.offset), header.shape, header.dtype)

    @property
    def row_bytes(self) -> int:
        """The size of one row."""
        return math.prod(self.shape[1:]) * self.dtype.itemsize

    def write(self, begin: int, count: int, parts: Iterable[tuple[list[int], Numbers]]) -> None:
        """Write the rows `begin` to `begin + count`: parts with row numbers counted from `begin`, NaN elsewhere."""
        parts = list(parts)
        if self.dtype.kind == "f" and any(values.dtype.kind == "c" for _, values in parts):
            self._become_complex()
        rows = np.full((count, *self.shape[1:]), math.nan, self.dtype)
        for places, values in parts:
            rows[places] = values
        self._put(begin, rows)

    def _put(self, begin: int, rows: NDArray[Any]) -> None:
        """Write rows, without a copy that would stay in memory."""
        if not rows.nbytes:  # empty arrays have no bytes to view
            return
        data = memoryview(np.ascontiguousarray(rows).data).cast("B")
        place = self.offset + begin * self.row_bytes
        while data:
            written = os.pwrite(self.descriptor, data, place)
            data, place = data[written:], place + written

    def _become_complex(self) -> None:
        """Add imaginary parts, which may first appear now, such as in eigenvalues that have all been real so far."""
        old = np.load(self.path, mmap_mode="r")
        new = self.made(self.path.with_suffix(".new"), self.shape[0], self.shape[1:], complex)
        rows = max(1, PIECE_BYTES // new.row_bytes)
        for begin in range(0, self.shape[0], rows):
            new._put(begin, old[begin : begin + rows].astype(complex))
        new.sync()
        new.path.replace(self.path)
        self.close()
        self.descriptor, self.offset, self.dtype = new.descriptor, new.offset, new.dtype

    def sync(self) -> None:
        """Wait until all data are on the disk."""
        os.fsync(self.descriptor)

    def close(self) -> None:
        """Close the file."""
        os.close(self.descriptor)
