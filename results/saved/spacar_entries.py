"""Reads the entries of SPACAR's binary results: `.sbd`, `.sbm` and `.ltv` files of UT SPACAR.

An entry is a header of 20 bytes (a tag of four letters, then type, bytes of an item, rows and columns as integers of 32
bits, little-endian) and its data, row by row.  After the entry TDEF there are headers alone, up to TDAT: they describe
one record, and the records follow one after another until the file ends.
"""

from __future__ import annotations

import struct
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.callers import outside
from flexel.base.errors import IncompleteWarning, ModelError

HEADER = struct.Struct("<4s4i")
TYPES = {(1, 4): "<i4", (2, 8): "<f8", (3, 1): "S1"}  # type and bytes of an item
BEGIN, DATA = "TDEF", "TDAT"
MAX_ENTRY_BYTES = 1 << 31  # bytes of one entry; a header with more counts as damaged


@dataclass(frozen=True)
class TaggedEntries:
    """The contents of a file.

    Attributes
    ----------
    constant : mapping of str to array or str
        Entries before the records, by their tags.
    records : mapping of str to ndarray (nt, rows, columns)
        Entries of all records, by their tags.
    """

    constant: Mapping[str, Any]
    records: Mapping[str, Array]


@dataclass(frozen=True)
class _Header:
    tag: str
    dtype: str
    rows: int
    columns: int

    @property
    def size(self) -> int:
        return self.rows * self.columns * np.dtype(self.dtype or "V0").itemsize


class _EntryReader:
    """Reads a file from its beginning, and reports where it is damaged."""

    def __init__(self, path: Path) -> None:
        self.path, self.data, self.at = path, path.read_bytes(), 0

    def error(self, what: str) -> ModelError:
        return ModelError(
            f"load '{self.path}': {what} at byte {self.at}; the file is damaged, or not a result of SPACAR: let "
            "SPACAR write it again"
        )

    def header(self) -> _Header:
        if self.at + HEADER.size > len(self.data):
            raise self.error("it ends within the header of an entry")
        raw, kind, item, rows, columns = HEADER.unpack_from(self.data, self.at)
        tag = raw.decode("latin-1").strip()
        dtype = "" if tag in (BEGIN, DATA) else TYPES.get((kind, item))
        if dtype is None or not tag.isalnum() or min(rows, columns) < 0:
            raise self.error(f"there is no entry (tag {tag!r}, type {kind}, {rows} rows, {columns} columns)")
        found = _Header(tag, dtype, rows, columns)
        if found.size > MAX_ENTRY_BYTES:
            raise self.error(f"the entry {tag!r} would have {found.size} bytes")
        self.at += HEADER.size
        return found

    def values(self, header: _Header) -> Any:
        """Read the data of an entry: text, or an array (rows, columns)."""
        if self.at + header.size > len(self.data):
            raise self.error(f"it ends within the data of '{header.tag}'")
        raw = self.data[self.at : self.at + header.size]
        self.at += header.size
        if header.dtype == TYPES[3, 1]:
            return raw.decode("latin-1").strip()
        return np.frombuffer(raw, header.dtype).reshape(header.rows, header.columns)

    def records(self, announced: int) -> dict[str, Array]:
        """Read the records, after their headers."""
        headers = []
        while (header := self.header()).tag != DATA:
            if header.dtype != TYPES[2, 8]:
                raise self.error(f"'{header.tag}' in the records does not hold real numbers")
            headers.append(header)
        size, left = sum(header.size for header in headers), len(self.data) - self.at
        whole = left // size if size else 0
        if not whole or left > announced * size:
            raise self.error(f"{announced} records of {size} bytes are declared, but {left} bytes follow")
        if whole < announced:  # SPACAR was interrupted
            warnings.warn(
                f"load '{self.path}': it ends after {whole} of the {announced} records that it declares; "
                "these are read",
                IncompleteWarning,
                stacklevel=outside(),
            )
        rows = np.frombuffer(self.data, "<f8", whole * (size // 8), self.at).reshape(whole, size // 8)
        ends = np.cumsum([0, *(header.rows * header.columns for header in headers)])
        return {
            header.tag: rows[:, a:b].reshape(whole, header.rows, header.columns)
            for header, a, b in zip(headers, ends[:-1], ends[1:], strict=True)
        }


def read_entries(path: Path) -> TaggedEntries:
    """Read the entries of a file.

    Raises
    ------
    ModelError
        A file that is missing, damaged, or not one of SPACAR's results.
    """
    if not path.is_file():
        raise ModelError(f"load '{path}': the file does not exist; give the path of a saved result")
    reader, constant = _EntryReader(path), dict[str, Any]()
    while reader.at < len(reader.data):
        header = reader.header()
        if header.tag == BEGIN:
            return TaggedEntries(constant, reader.records(header.rows))
        constant[header.tag] = reader.values(header)
    raise reader.error("it ends before its records")
