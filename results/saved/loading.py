"""Loads results and continues simulations from them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from flexel.base.arguments import path_of
from flexel.base.errors import FlexelError, ModelError
from flexel.results.flexure_result import Flexure, flexure_of
from flexel.results.linearization import Linearization, as_linearization
from flexel.results.motion import Motion
from flexel.results.periodic_motion import PeriodicSolution, periodic_of
from flexel.results.saved.archive import integration_of
from flexel.results.saved.archive_linear import linearization_of
from flexel.results.saved.record import Record
from flexel.results.saved.record_files import read
from flexel.results.saved.spacar_entries import TaggedEntries, read_entries
from flexel.results.saved.spacar_motion import motion_of_sbd
from flexel.results.saved.spacar_records import SpacarRecords, records_of


def load_result(path: str | Path) -> Motion | Linearization | PeriodicSolution | Flexure | SpacarRecords:
    """Load a result from a file; see `flexel.load`."""
    path = path_of(path, "load")
    if path.suffix.lower() in SPACAR:
        return SPACAR[path.suffix.lower()](read_entries(path), path)
    record = read(path)
    try:
        return _result(record, path)
    except (KeyError, TypeError, ValueError, IndexError, AttributeError) as error:
        if isinstance(error, FlexelError):
            raise
        raise ModelError(
            f"load '{path}': a part of a {record.kind} is missing or malformed ({error!r:.100}); the file "
            "is damaged: use a backup of it, or compute it again"
        ) from error


SPACAR: dict[str, Callable[[TaggedEntries, Path], Motion | SpacarRecords]] = {
    ".sbd": motion_of_sbd,
    ".sbm": records_of,
    ".ltv": records_of,
}


def _result(record: Record, path: str | Path) -> Motion | Linearization | PeriodicSolution | Flexure:
    """Return the result in a record, by its kind."""
    if record.kind == "motion":
        return Motion(None, integration_of(record))
    if record.kind == "linearization":
        return as_linearization(linearization_of(record))
    if record.kind == "periodic":
        return periodic_of(record)
    if record.kind == "flexure":
        return flexure_of(record)
    raise ModelError(
        f"load '{path}': this version cannot read results of kind '{record.kind}'; install a newer one"
    )
