"""Results read back, and simulations continued from them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from flexel.base.arguments import path_of
from flexel.base.errors import FlexelError, ModelError
from flexel.results.flexure import Flexure, flexure_of
from flexel.results.motion import Motion
from flexel.results.periodic import PeriodicSolution, periodic_of
from flexel.results.saved.archive import motion_of
from flexel.results.saved.archive_linear import linearization_of
from flexel.results.saved.files import read
from flexel.results.saved.record import Record
from flexel.results.saved.spacar_entries import Entries, read_entries
from flexel.results.saved.spacar_motion import motion_of_sbd
from flexel.results.saved.spacar_records import SpacarRecords, records_of

if TYPE_CHECKING:
    from flexel.mechanics.linearization import Linearization


def load(path: str | Path) -> Motion | Linearization | PeriodicSolution | Flexure | SpacarRecords:
    """A result from a file that its `save` has written: .nc, .npz, .mat or .csv; or of SPACAR: .sbd, .sbm, .ltv.

    Nothing in the file is executed.  The result has the same names and units, without a model; `System.restore`
    attaches its states to a model again.  In SPACAR's `.sbd` positions are p1, p2 ..., orientations o1, o2 ..., nodes
    of warping w1, w2 ..., and beams in space beam1, beam2 ..., as in `fx.read_spacar`; the deformations of other
    elements are element7.e1 ..., in SPACAR's signs.

    Returns
    -------
    Motion, Linearization, PeriodicSolution, Flexure or SpacarRecords
        The saved result; of SPACAR, .sbd is a motion, .sbm and .ltv are records of matrices.

    Raises
    ------
    ModelError
        A file that is missing, damaged, or of another program.
    FlexelError
        If a package that the format needs is missing.

    Examples
    --------
    >>> motion = fx.load("bicycle.nc")  # doctest: +SKIP
    >>> more = system.simulate(5.0, start=system.restore(motion))  # doctest: +SKIP
    """
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
            "is damaged: take a copy of it, or compute it again"
        ) from error


SPACAR: dict[str, Callable[[Entries, Path], Motion | SpacarRecords]] = {
    ".sbd": motion_of_sbd,
    ".sbm": records_of,
    ".ltv": records_of,
}


def _result(record: Record, path: str | Path) -> Motion | Linearization | PeriodicSolution | Flexure:
    """The result in a record, by its kind."""
    if record.kind == "motion":
        return motion_of(record)
    if record.kind == "linearization":
        return linearization_of(record)
    if record.kind == "periodic":
        return periodic_of(record)
    if record.kind == "flexure":
        return flexure_of(record)
    raise ModelError(
        f"load '{path}': this version does not know results of kind '{record.kind}'; install a newer one"
    )
