"""Reads the folder of a sweep as one labelled dataset."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.apps.sweeps.points import Points
from flexel.apps.sweeps.store import DONE, FAILED, described, forms_of, messages_in
from flexel.base.arguments import path_of
from flexel.base.errors import ModelError
from flexel.results.saved.record import require

if TYPE_CHECKING:
    from xarray import Dataset

NOT_COMPUTED = "not computed"


def open_sweep(folder: str | Path) -> Dataset:
    """Open the results in the folder of a sweep, finished or not; they are read from disk as needed.

    Parameters
    ----------
    folder : path
        Written by `fx.sweep` or ``flexel sweep``.

    Returns
    -------
    xarray.Dataset
        See `fx.sweep`.
    """
    place = path_of(folder, "open_sweep")
    kept = described(place)
    if kept is None:
        raise ModelError(
            f"{folder} is not the folder of a sweep; give one written by fx.sweep or flexel sweep"
        )
    columns = {
        name: _array(place / "points" / f"{i}.npy") for i, name in enumerate(kept["points"]["parameters"])
    }
    return dataset_of(place, Points(columns, kept["points"]["grid"]))


def dataset_of(folder: Path, points: Points) -> Dataset:
    """Build the dataset of a folder whose points are known."""
    xarray = require("xarray", "xarray")
    kept = described(folder)
    assert kept is not None
    coordinates: dict[str, Any] = {
        name: (name if points.is_grid else "point", np.asarray(column))
        for name, column in points.values.items()
    }
    data: dict[str, Any] = {}
    for i, (name, form) in enumerate(forms_of(kept) or ()):
        values = _array(folder / "values" / f"{i}.npy", points.shape + form.shape)
        data[name] = (points.dims + form.dims, values, {"units": form.unit} if form.unit else {})
        coordinates |= {dim: (dim, list(labels)) for dim, labels in form.labels}
    status = _array(folder / "status.npy")
    data["failed"] = (points.dims, _failed(folder, status).reshape(points.shape))
    about = {"kind": "sweep", "message": message_of(folder, points, status)}
    found: Dataset = xarray.Dataset(data, coordinates, about)
    return found


def _failed(folder: Path, status: Any) -> Any:
    """Return a text for each point: empty if the point was computed."""
    texts = np.full(len(status), "", object)
    texts[(status != DONE) & (status != FAILED)] = NOT_COMPUTED
    for point, message in messages_in(folder).items():
        if status[point] == FAILED:
            texts[point] = message
    return texts


def message_of(folder: Path, points: Points, status: Any) -> str:
    """Describe how far a sweep is, and its first failure."""
    done, failed = (int(np.count_nonzero(status == code)) for code in (DONE, FAILED))
    text = f"{done} of {len(points)} points computed"
    if failed:
        first = int(np.argmax(status == FAILED))
        text += f", {failed} failed; the first, {points.shown(first)}: {messages_in(folder)[first]}"
    return text


def _array(path: Path, shape: tuple[int, ...] | None = None) -> Any:
    """Read an array of the folder, of the given shape if one is given; raise a ModelError if the file is damaged."""
    try:
        found = np.load(path, mmap_mode="r")
        return found if shape is None else found.reshape(shape)
    except Exception as error:  # a damaged file may raise anything
        raise ModelError(
            f"sweep '{path}': the file is missing or damaged ({error!s:.100}); use a backup of the folder, or "
            "delete it and call fx.sweep again"
        ) from error
