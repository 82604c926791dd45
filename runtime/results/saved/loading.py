"""Results read back, and simulations continued from them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from flexel.base.errors import FlexelError, ModelError
from flexel.results.motion import Motion
from flexel.results.periodic import PeriodicSolution, periodic_of
from flexel.results.saved.archive import motion_of
from flexel.results.saved.archive_linear import linearization_of
from flexel.results.saved.files import read
from flexel.results.saved.record import Record

if TYPE_CHECKING:
    from flexel.mechanics.linearization import Linearization


def load(path: str | Path) -> Motion | Linearization | PeriodicSolution:
    """A result from a file that its `save` has written: .nc, .npz, .mat or .csv.

    Nothing in the file is executed.  The result has the same names and units, without a model; `System.restore`
    attaches its states to a model again.

    Returns
    -------
    Motion, Linearization or PeriodicSolution
        The saved result.

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
    record = read(path)
    try:
        return _result(record, path)
    except (KeyError, TypeError, ValueError, IndexError, AttributeError) as error:
        if isinstance(error, FlexelError):
            raise
        raise ModelError(
            f"load '{path}': a part of a {record.kind} is missing in it or has another form ({error!r:.100}); the file "
            "is damaged: take a copy of it, or compute it again"
        ) from error


def _result(record: Record, path: str | Path) -> Motion | Linearization | PeriodicSolution:
    """The result in a record, by its kind."""
    if record.kind == "motion":
        return motion_of(record)
    if record.kind == "linearization":
        return linearization_of(record)
    if record.kind == "periodic":
        return periodic_of(record)
    raise ModelError(f"load '{path}': a result of kind '{record.kind}' is unknown here; use a newer flexel")
