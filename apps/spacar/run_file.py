"""Implements `flexel run model.dat`: SPACAR's modes of analysis, a report as text, results as files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from flexel.apps.spacar.analysis_modes import HISTORIES, MODES, Results
from flexel.apps.spacar.comparison import comparison_lines, results_of_spacar
from flexel.apps.spacar.keywords import WARPING
from flexel.apps.spacar.log import log_lines
from flexel.apps.spacar.matfile import write_mat
from flexel.apps.spacar.reading import Spacar, read_spacar
from flexel.base.errors import ModelError
from flexel.base.files import replacing
from flexel.base.shown import prints
from flexel.mechanics.ranges import warn_beyond, warned_together
from flexel.results.motion import Motion
from flexel.results.saved.tables_of_runs import motion_beside

COUNT_MODE = 0  # mode of analysis


@dataclass(frozen=True)
class RunReport:
    """The report of an analysis, and its motion, if there is one."""

    report: str
    motion: Motion | None

    @prints
    def __str__(self) -> str:
        return self.report


def run_spacar(
    path: str | Path,
    out: Path | None = None,
    *,
    mode: int | None = None,
    dialect: str | None = None,
    compare: Sequence[str | Path] = (),
    log: bool = False,
    mat: bool = False,
    warping: str = WARPING[0],
) -> RunReport:
    """Run a SPACAR file and report.

    Parameters
    ----------
    path : str or Path
    out : Path, optional
        Directory for the results: time histories as .csv, everything as .npz, and a motion, for `flexel view` and
        `flexel.load`, as ``<name>_motion.npz``; without it no files are written, and
        `log` and `mat` are refused.
    mode : int, optional
        0 count of constraints and degrees of freedom, 1 forward dynamics, 2 inverse dynamics, 3 small motions about
        the nominal motion, 4 linearization along the motion, 7 equilibrium, frequencies and buckling, 8 state space
        in equilibrium, 9 state space along the motion, or in equilibrium for a file without TIMESTEP, 10 static
        load steps.  By default 1 if the file has TIMESTEP, 10 if it has load steps, else 7.
    dialect : "delft" or "twente", optional
    compare : sequence of str or Path
        Results of SPACAR, .sbd, .sbm or .ltv: the report has their differences from these.
    log : bool
        Write ``<name>.log`` as well: counts, degrees of freedom, fixed and dependent quantities.
    mat : bool
        Write ``<name>.mat`` as well, with SPACAR's names of variables.
    warping : "spacar" or "vlasov"
        What a BEAMW is; see `read_spacar`.

    Returns
    -------
    RunReport

    Raises
    ------
    FlexelError
        An invalid file, an unknown mode, an analysis that fails.
    """
    if (log or mat) and out is None:
        raise ModelError("run_spacar: log and mat write files; give out, the directory for results")
    file = read_spacar(path, dialect, warping=warping)
    mode = usual_mode(file) if mode is None else mode
    if mode not in MODES:
        raise ModelError(
            f"{file.path.name}: mode {mode} does not exist; modes are {', '.join(map(str, MODES))}"
        )
    others = [results_of_spacar(path) for path in compare]  # before the computation, which may be long
    with warned_together():
        found = MODES[mode](file)
    if found.states:
        times = [state.t for state in found.states]
        e, x = (np.array([getattr(state, array) for state in found.states]) for array in "ex")
        warn_beyond(file.system.evaluation, times, e, x, file.path.name)
    motion = found.motion
    head = [
        f"{file.path.name}: SPACAR, {file.dialect} dialect, mode {mode}",
        *(f"note: {note}" for note in file.notes),
    ]
    if mode != COUNT_MODE:  # which may find that they do not determine a motion
        head.append(f"degrees of freedom: {', '.join(file.system.dynamic + file.system.kinematic) or 'none'}")
    report = [*head, *([] if motion is None else [motion.message]), "", *found.lines]
    for other in others:
        report += ["", *comparison_lines(file, found, other)]
    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
        written = _write(file, out, found.results, motion)
        written += [write_mat(file, found, out / f"{file.path.stem}.mat")] if mat else []
        written += [_write_log(file, mode, out)] if log else []
        report += ["", *(f"wrote {path}" for path in written)]
    return RunReport("\n".join(report), motion)


def usual_mode(file: Spacar) -> int:
    """Return the mode of analysis of a file for which none is named."""
    return 1 if file.duration is not None else 10 if file.load_steps else 7


def _write_log(file: Spacar, mode: int, out: Path) -> Path:
    path = out / f"{file.path.stem}.log"
    with replacing(path, "run") as part:
        part.write_text("\n".join(log_lines(file, mode)) + "\n", encoding="utf-8")
    return path


def _write(file: Spacar, out: Path, results: Results, motion: Motion | None) -> list[Path]:
    """Return results as arrays, and the time histories among them as a table."""
    arrays = out / f"{file.path.stem}.npz"
    with replacing(arrays, "run") as part:
        np.savez(part, allow_pickle=False, **results)
    moved = [] if motion is None else [motion.save(motion_beside(arrays))]
    histories = {key: array for key, array in results.items() if key == "t" or key.startswith(HISTORIES)}
    if "t" not in results:
        return [arrays, *moved]
    table = out / f"{file.path.stem}.csv"
    columns = np.column_stack(list(histories.values()))
    with replacing(table, "run") as part:
        np.savetxt(part, columns, delimiter=",", header=",".join(histories), comments="", fmt="%.12e")
    return [arrays, table, *moved]
