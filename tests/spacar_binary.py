"""Writes files in the format of SPACAR's binary results, for tests."""

import struct
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np


def entry(tag: str, value: Any) -> bytes:
    """One entry: its header and its data."""
    if isinstance(value, str):
        return header(tag, 3, 1, len(value), 1) + value.encode("latin-1")
    values = np.atleast_2d(np.asarray(value))
    kind, item = (1, 4) if values.dtype.kind == "i" else (2, 8)
    return header(tag, kind, item, *values.shape) + values.astype("<i4" if kind == 1 else "<f8").tobytes()


def header(tag: str, kind: int, item: int, rows: int, columns: int) -> bytes:
    """The twenty bytes before the data of an entry."""
    return struct.pack("<4s4i", tag.ljust(4).encode("latin-1"), kind, item, rows, columns)


def write(path: Path, constant: Mapping[str, Any], records: Mapping[str, Any]) -> Path:
    """A file with entries, and with records (nt, rows, columns)."""
    arrays = {tag: np.asarray(values, dtype=float) for tag, values in records.items()}
    count = len(next(iter(arrays.values())))
    parts = [entry(tag, value) for tag, value in constant.items()] + [header("TDEF", 0, 0, count, 1)]
    parts += [header(tag, 2, 8, *array.shape[1:]) for tag, array in arrays.items()] + [
        header("TDAT", 0, 0, 0, 0)
    ]
    parts += [array[i].astype("<f8").tobytes() for i in range(count) for array in arrays.values()]
    path.write_bytes(b"".join(parts))
    return path


def ltv(path: Path) -> Path:
    """A state-space model of an oscillator at two times."""
    A = np.array([[[0.0, 1.0], [-4.0, -0.1]], [[0.0, 1.0], [-9.0, -0.1]]])
    B, C, D = np.array([[[0.0], [2.0]]] * 2), np.array([[[1.0, 0.0]]] * 2), np.zeros((2, 1, 1))
    records = {"T": np.array([0.0, 0.5]).reshape(2, 1, 1), "A": A, "B": B, "C": C, "D": D}
    return write(path, {"LTV": "LTV version 0.0", "NX": [[2]], "NU": [[1]], "NY": [[1]]}, records)


def sbd(path: Path) -> Path:
    """A motion of a planar bar between a fixed and a moving point, with an element of unknown type."""
    constant = {
        "SBD": "SBD version 0.0",
        "NXP": [[2, 1, 0, 1, 0]],
        "NEP": [[0, 1, 0, 0, 0]],
        "LNP": [[1, 2, 0, 0], [3, 4, 0, 0]],
        "LE": [[1, 0, 0, 0, 0, 0, 0, 0]],
        "LN": [[1, 2, 0, 0, 0, 0]],
        "IT": [[77]],
        "RL0": [[1.0]],
        "RXYZ": np.zeros((1, 9)),
    }
    t = np.array([0.0, 0.1, 0.2])
    x = np.column_stack([0 * t, 0 * t, 1 + 0.1 * t, 0.2 * t])
    zero, e = np.zeros((3, 4, 1)), 0.1 * t[:, None, None]
    records = {
        "T": t[:, None, None],
        "X": x[:, :, None],
        "XD": zero,
        "XDD": zero,
        "E": e,
        "ED": 0 * e,
        "EDD": 0 * e,
    }
    return write(path, constant, records | {"FXT": zero, "SIG": 50 * e})
