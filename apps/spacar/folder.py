"""Implements `flexel run FOLDER`: runs all SPACAR files of a folder and compares them with the results next to them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from flexel.apps.spacar.analysis_modes import MODES, Analysis
from flexel.apps.spacar.comparison import comparison, results_of_spacar
from flexel.apps.spacar.reading import Spacar, read_spacar
from flexel.apps.spacar.run_file import usual_mode
from flexel.base.errors import FlexelError, ModelError
from flexel.base.shown import PrintedTable, prints
from flexel.mechanics.ranges import warned_together
from flexel.results.saved.loading import SPACAR

SPACE, SPACE_ALONG = 8, 9  # modes that give state-space models
MATRICES_ALONG = 4
HEAD = ("model", "results", "mode", "records", "largest ratio", "of", "where")


@dataclass(frozen=True)
class FolderReport:
    """The agreement of the models in a folder with SPACAR's results.

    Attributes
    ----------
    rows : list of tuple of str
        Model, results, mode, number of records that were compared, largest difference relative to the largest entry
        of its table, that table, and where.
    remarks : list of str
        Models without results, results without a model, what is not compared, and errors.
    failed : bool
        Whether a model or a result could not be read or computed.
    """

    rows: list[tuple[str, ...]]
    remarks: list[str]
    failed: bool

    @prints
    def __str__(self) -> str:
        table = PrintedTable("", HEAD, self.rows).text if self.rows else "nothing to compare"
        return "\n".join([table, *self.remarks])


def run_folder(folder: str | Path, dialect: str | None = None) -> FolderReport:
    """Run each SPACAR file that has results of the same name next to it (.sbd, .sbm, .ltv), and compare.

    Parameters
    ----------
    folder : str or Path
    dialect : "delft" or "twente", optional

    Raises
    ------
    ModelError
        A folder without SPACAR files.
    """
    folder = Path(folder)
    files = sorted(path for path in folder.iterdir() if path.is_file())
    models = [path for path in files if path.suffix.lower() == ".dat"]
    results = [path for path in files if path.suffix.lower() in SPACAR]
    if not models:
        raise ModelError(
            f"run '{folder}': there is no SPACAR file (.dat) in the folder; give one with models"
        )
    stems = {path.stem.lower() for path in models}
    remarks = [
        f"{path.name}: there is no model of this name" for path in results if path.stem.lower() not in stems
    ]
    rows: list[tuple[str, ...]] = []
    failed = False
    for path in models:
        own = [result for result in results if result.stem.lower() == path.stem.lower()]
        if not own:
            remarks.append(f"{path.name}: there are no SPACAR results next to it; not run")
            continue
        try:
            for row, more in _compared(path, own, dialect):
                rows.append(row)
                remarks += more
        except FlexelError as error:
            remarks.append(f"{path.name}: {error}")
            failed = True
    return FolderReport(rows, remarks, failed)


def _compared(
    path: Path, results: list[Path], dialect: str | None
) -> Iterator[tuple[tuple[str, ...], list[str]]]:
    """Return a row for each of a model's results, and remarks; each mode of analysis is run once."""
    file = read_spacar(path, dialect)
    theirs = {result: results_of_spacar(result) for result in results}
    found: dict[int, Analysis] = {}
    for result in results:
        mode = _mode_for(file, result)
        if mode not in found:
            with warned_together():
                found[mode] = MODES[mode](file)
        both = comparison(file, found[mode], theirs[result])
        worst = both.worst
        numbers = ("-", "-", "-") if worst is None else (f"{worst.ratio:.1e}", worst.title, worst.place)
        row = (path.name, result.name, str(mode), f"{both.records} of {len(theirs[result].time)}", *numbers)
        yield row, [f"{result.name}: {remark}" for remark in both.remarks]


def _mode_for(file: Spacar, result: Path) -> int:
    """Return the mode of analysis that gives what a file of results holds."""
    if result.suffix.lower() == ".ltv":
        return SPACE if file.duration is None else SPACE_ALONG
    if result.suffix.lower() == ".sbm" and file.duration is not None:
        return MATRICES_ALONG
    return usual_mode(file)
