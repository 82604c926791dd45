"""Exports results to other packages: xarray datasets and pandas frames."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from flexel.base.outside import DataFrame, Dataset
from flexel.results.saved.archive import record_of
from flexel.results.saved.record import require

if TYPE_CHECKING:
    from flexel.integration.trajectory import Trajectory


def motion_dataset(motion: Trajectory, names: Sequence[str]) -> Dataset:
    """Return named quantities of a motion, or all of it, as an xarray.Dataset; see `Motion.to_xarray`."""
    if not names:
        return record_of(motion).to_xarray()
    xarray = require("xarray", "xarray")
    series = {name: motion.series(name) for name in names}
    data = {name: ("time", values, {"units": unit}) for name, (values, unit) in series.items()}
    return xarray.Dataset(data, {"time": ("time", motion.t, {"units": "s"})})


def motion_frame(motion: Trajectory, names: Sequence[str]) -> DataFrame:
    """Return the named quantities of a motion as a pandas.DataFrame; see `Motion.to_pandas`."""
    pandas = require("pandas", "xarray")
    structure = motion.structure
    slips = structure.names[structure.m : structure.m + structure.k]
    series = {
        name: motion.series(name) for name in names or [name for name in structure.names if name not in slips]
    }
    frame = pandas.DataFrame(
        {name: values for name, (values, _) in series.items()}, index=pandas.Index(motion.t, name="time")
    )
    frame.attrs["units"] = {"time": "s"} | {name: unit for name, (_, unit) in series.items()}
    return frame
