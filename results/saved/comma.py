"""Reads and writes records as .csv: tables with names and units in their first rows, other data in the first line."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.results.saved.header import header_of, parsed
from flexel.results.saved.record import Record, Variable
from flexel.results.saved.tables_of_runs import refuse_table

TITLES = {"value": "{}", "rate": "{}'", "acceleration": "{}''", "force": "force:{}"}


def write_csv(record: Record, path: Path) -> None:
    """Write one row for each time, or a table for each matrix; other data and the header as JSON in the first line."""
    tables, rest = [_histories(record)] if "time" in record.variables else list(_matrices(record)), {}
    written = {name for names, _ in tables for name in names}
    for name, variable in record.variables.items():
        if name not in written:
            rest[name] = np.asarray(variable.values).tolist()
    first = json.dumps({"result": header_of(record), "arrays": rest})
    with path.open("w", newline="", encoding="utf-8") as stream:
        stream.write(f"# {first}\n")
        table = csv.writer(stream, lineterminator="\n")
        for i, (_, rows) in enumerate(tables):
            stream.write("\n" * (i > 0))
            table.writerows(rows)


def _histories(record: Record) -> tuple[list[str], list[list[str]]]:
    """Return the variables over time, and their table."""
    over_time = {
        name: variable for name, variable in record.variables.items() if variable.dims[:1] == ("time",)
    }
    titles = [title for name, variable in over_time.items() for title in _titles(record, name, variable)]
    columns = [np.reshape(variable.values, (variable.values.shape[0], -1)) for variable in over_time.values()]
    return list(over_time), [titles, *(_cells(row) for row in np.hstack(columns).tolist())]


def _matrices(record: Record) -> Iterator[tuple[list[str], list[list[str]]]]:
    """Return each matrix with names along its rows and columns, and its table."""
    for name, variable in record.variables.items():
        if (
            variable.values.size
            and len(variable.dims) == 2
            and all(dim in record.labels for dim in variable.dims)
        ):
            rows, columns = (record.labels[dim] for dim in variable.dims)
            values = zip(rows, np.asarray(variable.values).tolist(), strict=True)
            yield [name], [[name, *columns], *([label, *_cells(row)] for label, row in values)]


def _cells(row: list[float]) -> list[str]:
    return ["" if value != value else repr(value) for value in row]


def _titles(record: Record, name: str, variable: Variable) -> list[str]:
    """Return the column titles ``name [unit]`` of one variable."""
    if len(variable.dims) == 1:
        return [f"{name} [{variable.unit}]" if variable.unit else name]
    labels = [record.labels[dim] for dim in variable.dims[1:]]
    pattern = TITLES.get(name, name + ":{}")
    titles = [pattern.format(",".join(parts)) for parts in product(*labels)]
    units = record.units.get(name, (variable.unit,) * len(titles))
    return [f"{title} [{unit}]" if unit else title for title, unit in zip(titles, units, strict=True)]


def read_csv(path: Path) -> tuple[dict[str, Any], dict[str, Array]]:
    """Read header and arrays of a file written by `write_csv`."""
    with path.open(encoding="utf-8", newline="") as stream:
        first = stream.readline()
        if not first.startswith("# {"):
            refuse_table(path, first.strip().split(","))
            raise ValueError("its first line is not the header, '# {…'")
        both = json.loads(first[2:])
        header = parsed(both["result"])
        rows = [row for row in csv.reader(stream) if row]
    arrays = {name: np.array(values) for name, values in both["arrays"].items()}
    missing = {name: entry["shape"] for name, entry in header["variables"].items() if name not in arrays}
    start = 0
    if "time" in missing:
        table = _numbers(rows[1:])
        for name, shape in missing.items():
            width = int(np.prod(shape[1:]))
            arrays[name] = table[:, start : start + width]
            start += width
        return header, arrays
    for name, shape in missing.items():
        arrays[name] = _numbers([row[1:] for row in rows[start + 1 : start + 1 + shape[0]]])
        start += 1 + shape[0]
    return header, arrays


def _numbers(rows: list[list[str]]) -> Array:
    return np.array([[float(cell) if cell else np.nan for cell in row] for row in rows])
