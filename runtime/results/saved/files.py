"""Records in files: .npz, .nc, .mat and .csv, written so that they are read elsewhere and read back here.

Reading never executes anything: no pickle, no eval; the header is JSON.  Every format holds the same numbers to the
last digit.
"""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Callable, Iterator, Mapping
from itertools import product
from pathlib import Path
from typing import Any
from zipfile import is_zipfile

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError, ModelError
from flexel.results.saved.record import Record, Variable, require
from flexel.results.saved.tables_of_runs import refuse_table

FORMAT = "flexel result 2"
TITLES = {"value": "{}", "rate": "{}'", "acceleration": "{}''", "force": "force:{}"}
HEADER = "header"
LONGEST = 63  # letters in a name of a Matlab variable


def write(record: Record, path: str | Path) -> Path:
    """Write a record; the suffix tells the format.

    Raises
    ------
    ModelError
        A suffix that is none of .nc, .npz, .mat, .csv.
    FlexelError
        If an optional package is missing.
    """
    path = Path(path)
    _format(path, "save")[0](record, path)
    return path


def read(path: str | Path) -> Record:
    """The record in a file written by `write`.

    Raises
    ------
    ModelError
        A file that is missing, damaged, or not written by flexel.
    """
    path = Path(path)
    reader = _format(path, "load")[1]
    if not path.is_file():
        raise ModelError(f"load '{path}': there is no such file; give the path that was saved")
    try:
        header, arrays = reader(path)
    except FlexelError:
        raise
    except Exception as error:  # whatever a damaged file makes its reader raise
        raise ModelError(
            f"load '{path}': this is no result saved by flexel, or it is damaged ({error})"
        ) from error
    return _assembled(path, header, arrays)


def _format(path: Path, what: str) -> tuple[Writer, Reader]:
    if path.suffix not in FORMATS:
        raise ModelError(
            f"{what} '{path}': suffix '{path.suffix}' is unknown; use one of {', '.join(FORMATS)}"
        )
    return FORMATS[path.suffix]


# -- header ---------------------------------------------------------------------------------------


def _header(record: Record) -> str:
    """Everything but the arrays, as JSON; numbers are written so that they are read back to the last digit."""
    variables = {
        n: {"dims": z.dims, "shape": z.values.shape, "unit": z.unit, "doc": z.doc}
        for n, z in record.variables.items()
    }
    return json.dumps(
        {
            "format": FORMAT,
            "kind": record.kind,
            "variables": variables,
            "labels": record.labels,
            "units": record.units,
            "header": record.header,
        }
    )


def _parsed(text: str) -> dict[str, Any]:
    found = json.loads(text)
    if not isinstance(found, dict) or found.get("format") != FORMAT:
        raise ValueError(f"its header is not of the format '{FORMAT}'")
    return found


def _assembled(path: Path, header: Mapping[str, Any], arrays: Mapping[str, Array]) -> Record:
    owner = f"load '{path}'"
    missing = [name for name in header["variables"] if name not in arrays]
    if missing:
        raise ModelError(f"{owner}: the arrays {', '.join(missing)} are missing; the file is damaged")
    variables = {}
    for name, z in header["variables"].items():
        if arrays[name].dtype.kind not in "biuf":
            raise ModelError(f"{owner}: '{name}' holds no numbers; the file is damaged")
        if arrays[name].size != np.prod(z["shape"], dtype=int):
            raise ModelError(f"{owner}: '{name}' is not of the shape {z['shape']}; the file is damaged")
        variables[name] = Variable(tuple(z["dims"]), arrays[name].reshape(z["shape"]), z["unit"], z["doc"])
    labels, units = ({name: tuple(z) for name, z in header[key].items()} for key in ("labels", "units"))
    return Record(header["kind"], variables, labels, units, header["header"]).checked(owner)


# -- NumPy ----------------------------------------------------------------------------------------


def _write_npz(record: Record, path: Path) -> None:
    arrays: dict[str, Any] = {name: z.values for name, z in record.variables.items()}
    np.savez_compressed(path, allow_pickle=False, **arrays, **{HEADER: np.array(_header(record))})


def _read_npz(path: Path) -> tuple[dict[str, Any], dict[str, Array]]:
    if not is_zipfile(path):
        raise ValueError("it is no archive of arrays")  # np.load would take it for a pickle
    with path.open("rb") as stream, np.load(stream, allow_pickle=False) as file:
        if HEADER not in file.files:
            refuse_table(path, file.files)
        header = _parsed(str(file[HEADER]))
        return header, {name: file[name] for name in header["variables"] if name in file.files}


# -- netCDF ---------------------------------------------------------------------------------------


def _require_hdf5() -> None:
    for module in ("h5py", "h5netcdf"):
        require(module, "xarray")


def _write_nc(record: Record, path: Path) -> None:
    _require_hdf5()
    dataset = record.to_xarray()
    dataset[HEADER] = ((), _header(record))  # a variable: attributes of HDF5 end at 64 kB
    dataset.to_netcdf(path, engine="h5netcdf")


def _read_nc(path: Path) -> tuple[dict[str, Any], dict[str, Array]]:
    _require_hdf5()
    with require("xarray", "xarray").open_dataset(path, engine="h5netcdf", decode_times=False) as file:
        header = _parsed(str(file[HEADER].values))
        return header, {name: file[name].values for name in header["variables"] if name in file.variables}


# -- Matlab ---------------------------------------------------------------------------------------


def identifiers(labels: tuple[str, ...]) -> tuple[str, ...]:
    """Names that Matlab admits, as near as can be to the labels, each once.

    Examples
    --------
    >>> identifiers(("rod.bend1", "rod bend1", "2nd.x"))
    ('rod_bend1', 'rod_bend1_2', 'n2nd_x')
    """
    found: list[str] = []
    for label in labels:
        name = re.sub(r"[^0-9A-Za-z]+", "_", label).strip("_") or "n"
        name = base = (name if name[0].isalpha() else f"n{name}")[: LONGEST - 5]
        count = 1
        while name in found:
            count += 1
            name = f"{base}_{count}"
        found.append(name)
    return tuple(found)


def _write_mat(record: Record, path: Path) -> None:
    from scipy.io import savemat

    contents: dict[str, Any] = {HEADER: _header(record), "kind": record.kind}
    for dim, names in record.labels.items():
        contents[f"{dim}_names"] = np.array(names, dtype=object)
    for name, units in record.units.items():
        contents[f"{name}_units"] = np.array(units, dtype=object)
    for name, z in record.variables.items():
        if _fields(z.dims, record.labels):
            fields = identifiers(record.labels[z.dims[1]])
            contents[name] = {field: z.values[:, i : i + 1] for i, field in enumerate(fields)}
        else:
            contents[name] = z.values
    savemat(path, contents, long_field_names=True, do_compression=True, oned_as="column")


def _read_mat(path: Path) -> tuple[dict[str, Any], dict[str, Array]]:
    from scipy.io import loadmat

    contents = loadmat(path, appendmat=False, chars_as_strings=True)
    header = _parsed(str(contents[HEADER].item()))
    arrays = {}
    for name, z in header["variables"].items():
        values = contents[name]
        if _fields(tuple(z["dims"]), header["labels"]):
            fields = identifiers(tuple(header["labels"][z["dims"][1]]))
            values = np.hstack([values[0, 0][field] for field in fields])
        arrays[name] = values
    return header, arrays


def _fields(dims: tuple[str, ...], labels: Mapping[str, Any]) -> bool:
    """Whether an array becomes a structure with one column for each label: time histories do."""
    return len(dims) == 2 and dims[0] not in labels and bool(labels.get(dims[1]))


# -- tables ---------------------------------------------------------------------------------------


def _write_csv(record: Record, path: Path) -> None:
    """One row for each time, or a table for each matrix; the rest and the header as JSON in the first line."""
    tables, rest = [_histories(record)] if "time" in record.variables else list(_matrices(record)), {}
    written = {name for names, _ in tables for name in names}
    for name, z in record.variables.items():
        if name not in written:
            rest[name] = np.asarray(z.values).tolist()
    first = json.dumps({"result": _header(record), "arrays": rest})
    with path.open("w", newline="", encoding="utf-8") as stream:
        stream.write(f"# {first}\n")
        table = csv.writer(stream, lineterminator="\n")
        for i, (_, rows) in enumerate(tables):
            stream.write("\n" * (i > 0))
            table.writerows(rows)


def _histories(record: Record) -> tuple[list[str], list[list[str]]]:
    """The variables over time, and their table."""
    over_time = {name: z for name, z in record.variables.items() if z.dims[:1] == ("time",)}
    titles = [title for name, z in over_time.items() for title in _titles(record, name, z)]
    columns = [np.reshape(z.values, (z.values.shape[0], -1)) for z in over_time.values()]
    return list(over_time), [titles, *(_cells(row) for row in np.hstack(columns).tolist())]


def _matrices(record: Record) -> Iterator[tuple[list[str], list[list[str]]]]:
    """Each matrix with names along its rows and columns, and its table."""
    for name, z in record.variables.items():
        if z.values.size and len(z.dims) == 2 and all(dim in record.labels for dim in z.dims):
            rows, columns = (record.labels[dim] for dim in z.dims)
            values = zip(rows, np.asarray(z.values).tolist(), strict=True)
            yield [name], [[name, *columns], *([label, *_cells(row)] for label, row in values)]


def _cells(row: list[float]) -> list[str]:
    return ["" if value != value else repr(value) for value in row]


def _titles(record: Record, name: str, z: Variable) -> list[str]:
    """Column titles ``name [unit]`` of one variable."""
    if len(z.dims) == 1:
        return [f"{name} [{z.unit}]" if z.unit else name]
    labels = [record.labels[dim] for dim in z.dims[1:]]
    pattern = TITLES.get(name, name + ":{}")
    titles = [pattern.format(",".join(parts)) for parts in product(*labels)]
    units = record.units.get(name, (z.unit,) * len(titles))
    return [f"{title} [{unit}]" if unit else title for title, unit in zip(titles, units, strict=True)]


def _read_csv(path: Path) -> tuple[dict[str, Any], dict[str, Array]]:
    with path.open(encoding="utf-8", newline="") as stream:
        first = stream.readline()
        if not first.startswith("# {"):
            refuse_table(path, first.strip().split(","))
            raise ValueError("its first line is not the header, '# {…'")
        both = json.loads(first[2:])
        header = _parsed(both["result"])
        rows = [row for row in csv.reader(stream) if row]
    arrays = {name: np.array(values) for name, values in both["arrays"].items()}
    missing = {name: z["shape"] for name, z in header["variables"].items() if name not in arrays}
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
    return np.array([[float(z) if z else np.nan for z in row] for row in rows])


Writer = Callable[[Record, Path], None]
Reader = Callable[[Path], tuple[dict[str, Any], dict[str, Array]]]
FORMATS: dict[str, tuple[Writer, Reader]] = {
    ".nc": (_write_nc, _read_nc),
    ".npz": (_write_npz, _read_npz),
    ".mat": (_write_mat, _read_mat),
    ".csv": (_write_csv, _read_csv),
}
