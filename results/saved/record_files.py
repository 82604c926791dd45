"""Reads and writes records: .npz, .nc, .mat and .csv, readable by other programs and by flexel.

Reading never executes anything: no pickle, no eval; the header is JSON.  Every format holds the same numbers to the
last digit.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from io import BytesIO
from pathlib import Path
from typing import Any
from zipfile import is_zipfile

import numpy as np

from flexel.base.arguments import path_of
from flexel.base.arrays import Array
from flexel.base.errors import FlexelError, ModelError
from flexel.base.files import replacing
from flexel.derive.checksum_trailer import has_trailer, is_whole, trailer_of
from flexel.results.saved.comma import read_csv, write_csv
from flexel.results.saved.header import HEADER, digest, header_of, parsed
from flexel.results.saved.record import Record, Variable, require
from flexel.results.saved.tables_of_runs import refuse_table

MAX_NAME_LENGTH = 63  # largest number of characters in the name of a Matlab variable


def write(record: Record, path: str | Path, *, owner: str = "save", trial: bool = False) -> Path:
    """Write a record; the suffix determines the format.  The file is written completely, or the old one remains.

    Parameters
    ----------
    record : Record
    path : str or Path
    owner : str
        The operation, for messages.
    trial : bool
        Whether the new file is removed again: to learn whether it can be written.

    Raises
    ------
    ModelError
        A suffix other than .nc, .npz, .mat, .csv.
    FlexelError
        If an optional package is missing, or the file cannot be written.
    """
    path = path_of(path, owner)
    writer = _format(path, owner)[0]
    with replacing(path, owner, trial=trial) as part:
        writer(record, part)
    return path


def read(path: str | Path) -> Record:
    """Read the record in a file written by `write`.

    Raises
    ------
    ModelError
        A file that is missing, damaged, or not written by flexel.
    """
    path = path_of(path, "load")
    reader = _format(path, "load")[1]
    if not path.is_file():
        raise ModelError(f"load '{path}': the file does not exist; give the path of a saved result")
    try:
        return _assembled(path, *reader(path))
    except FlexelError:
        raise
    except Exception as error:  # a damaged file may raise anything
        raise ModelError(
            f"load '{path}': this is not a result saved by flexel, or it is damaged ({error})"
        ) from error


def _format(path: Path, what: str) -> tuple[Writer, Reader]:
    if path.suffix not in FORMATS:
        raise ModelError(
            f"{what} '{path}': suffix '{path.suffix}' is unknown; use one of {', '.join(FORMATS)}"
        )
    return FORMATS[path.suffix]


def _assembled(path: Path, header: Mapping[str, Any], arrays: Mapping[str, Array]) -> Record:
    owner = f"load '{path}'"
    missing = [name for name in header["variables"] if name not in arrays]
    if missing:
        raise ModelError(f"{owner}: the arrays {', '.join(missing)} are missing; the file is damaged")
    variables = {}
    for name, entry in header["variables"].items():
        if arrays[name].dtype.kind not in "biuf":
            raise ModelError(f"{owner}: '{name}' does not hold numbers; the file is damaged")
        if arrays[name].size != np.prod(entry["shape"], dtype=int):
            raise ModelError(
                f"{owner}: '{name}' does not have the shape {entry['shape']}; the file is damaged"
            )
        variables[name] = Variable(
            tuple(entry["dims"]), arrays[name].reshape(entry["shape"]), entry["unit"], entry["doc"]
        )
    if "digest" in header and header["digest"] != digest(
        header, [variable.values for variable in variables.values()]
    ):
        raise ModelError(
            f"{owner}: its numbers or names are not those that were saved; the file is damaged: use a backup of it, or "
            "compute it again"
        )
    labels, units = (
        {name: tuple(words) for name, words in header[key].items()} for key in ("labels", "units")
    )
    return Record(header["kind"], variables, labels, units, header["header"]).checked(owner)


# -- NumPy ----------------------------------------------------------------------------------------


MAX_HEADER_BYTES = 2**26  # bytes of the description of a result
MOST_BYTES, ARRAY_HEADER = 16, 2**10  # of a number, and of what precedes the numbers of an array


def _write_npz(record: Record, path: Path) -> None:
    arrays: dict[str, Any] = {name: variable.values for name, variable in record.variables.items()}
    np.savez_compressed(path, allow_pickle=False, **arrays, **{HEADER: np.array(header_of(record))})


def _read_npz(path: Path) -> tuple[dict[str, Any], dict[str, Array]]:
    if not is_zipfile(path):
        raise ValueError("it is not an archive of arrays")  # np.load would treat it as a pickle
    with path.open("rb") as stream, np.load(stream, allow_pickle=False) as file:
        if HEADER not in file.files:
            refuse_table(path, file.files)
        sizes = {info.filename.removesuffix(".npy"): info.file_size for info in file.zip.infolist()}
        if sizes[HEADER] > MAX_HEADER_BYTES:
            raise ValueError(f"its description of {sizes[HEADER]} bytes is not that of a result")
        header = parsed(str(file[HEADER]))
        for name in header["variables"]:
            stated = MOST_BYTES * int(np.prod(header["variables"][name]["shape"], dtype=float)) + ARRAY_HEADER
            if sizes.get(name, 0) > stated:  # before it is unpacked
                raise ValueError(f"'{name}' is larger than its description says")
        return header, {name: file[name] for name in header["variables"] if name in file.files}


# -- netCDF ---------------------------------------------------------------------------------------


def _require_hdf5() -> None:
    for module in ("h5py", "h5netcdf"):
        require(module, "xarray")


def _write_nc(record: Record, path: Path) -> None:
    _require_hdf5()
    from h5netcdf import File
    from xarray.backends import H5NetCDFStore

    dataset = record.to_xarray()
    dataset[HEADER] = ((), header_of(record))  # a variable: attributes of HDF5 end at 64 kB
    with BytesIO() as buffer:  # on a full disk the HDF5 library aborts the interpreter
        with File(buffer, "w") as file:
            dataset.dump_to_store(H5NetCDFStore(file))
        data = buffer.getvalue()
    with path.open("wb") as stream:
        stream.write(data)
        stream.write(trailer_of(data))  # after the end of the data, where no reader looks


def _read_nc(path: Path) -> tuple[dict[str, Any], dict[str, Array]]:
    _require_hdf5()
    _check_trailer(path)
    with require("xarray", "xarray").open_dataset(path, engine="h5netcdf", decode_times=False) as file:
        header = parsed(str(file[HEADER].values))
        return header, {name: file[name].values for name in header["variables"] if name in file.variables}


def _check_trailer(path: Path) -> None:
    """Raise a ValueError for damage, before the library of HDF5 sees it; other programs may drop the trailer."""
    data = path.read_bytes()
    if has_trailer(data) and not is_whole(data):
        raise ValueError("its bytes are not those that were written")


# -- Matlab ---------------------------------------------------------------------------------------


def identifiers(labels: tuple[str, ...]) -> tuple[str, ...]:
    """Return valid Matlab names, as close as possible to the labels, and unique.

    Examples
    --------
    >>> identifiers(("rod.bend1", "rod bend1", "2nd.x"))
    ('rod_bend1', 'rod_bend1_2', 'n2nd_x')
    """
    found: list[str] = []
    for label in labels:
        name = re.sub(r"[^0-9A-Za-z]+", "_", label).strip("_") or "n"
        name = base = (name if name[0].isalpha() else f"n{name}")[: MAX_NAME_LENGTH - 5]
        count = 1
        while name in found:
            count += 1
            name = f"{base}_{count}"
        found.append(name)
    return tuple(found)


def _write_mat(record: Record, path: Path) -> None:
    from scipy.io import savemat

    contents: dict[str, Any] = {HEADER: header_of(record), "kind": record.kind}
    for dim, names in record.labels.items():
        contents[f"{dim}_names"] = np.array(names, dtype=object)
    for name, units in record.units.items():
        contents[f"{name}_units"] = np.array(units, dtype=object)
    for name, variable in record.variables.items():
        if _fields(variable.dims, record.labels):
            fields = identifiers(record.labels[variable.dims[1]])
            contents[name] = {field: variable.values[:, i : i + 1] for i, field in enumerate(fields)}
        else:
            contents[name] = variable.values
    savemat(path, contents, long_field_names=True, do_compression=True, oned_as="column")


def _read_mat(path: Path) -> tuple[dict[str, Any], dict[str, Array]]:
    from scipy.io import loadmat

    contents = loadmat(path, appendmat=False, chars_as_strings=True)
    header = parsed(str(contents[HEADER].item()))
    arrays = {}
    for name, entry in header["variables"].items():
        values = contents[name]
        if _fields(tuple(entry["dims"]), header["labels"]):
            fields = identifiers(tuple(header["labels"][entry["dims"][1]]))
            values = np.hstack([values[0, 0][field] for field in fields])
        arrays[name] = values
    return header, arrays


def _fields(dims: tuple[str, ...], labels: Mapping[str, Any]) -> bool:
    """Whether an array becomes a structure with one column for each label: time histories do."""
    return len(dims) == 2 and dims[0] not in labels and bool(labels.get(dims[1]))


Writer = Callable[[Record, Path], None]
Reader = Callable[[Path], tuple[dict[str, Any], dict[str, Array]]]
FORMATS: dict[str, tuple[Writer, Reader]] = {
    ".nc": (_write_nc, _read_nc),
    ".npz": (_write_npz, _read_npz),
    ".mat": (_write_mat, _read_mat),
    ".csv": (write_csv, read_csv),
}
