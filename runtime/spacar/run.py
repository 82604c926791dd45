"""The command `flexel run model.dat`: SPACAR's modes of analysis, a report as text, results as files."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, ModelError
from flexel.base.files import replacing
from flexel.results.motion import Motion
from flexel.results.saved.tables_of_runs import motion_beside
from flexel.spacar.linear import Matrices
from flexel.spacar.reading import Spacar, read_spacar
from flexel.structure.state import State

Results = dict[str, Array]
Analysis = tuple[list[str], Results, Motion | None]
SHOWN = 8  # most rows and columns of a printed matrix


@dataclass(frozen=True)
class Outcome:
    """The report of an analysis, and its motion, if there is one."""

    report: str
    motion: Motion | None

    def __str__(self) -> str:
        return self.report


def run_spacar(
    path: str | Path, out: Path | None = None, *, mode: int | None = None, dialect: str | None = None
) -> Outcome:
    """Run a SPACAR file and report.

    Parameters
    ----------
    path : str or Path
    out : Path, optional
        Directory for the results: time histories as .csv, everything as .npz, and a motion, for `flexel view` and
        `flexel.load`, as ``<name>_motion.npz``; without it no files are written.
    mode : int, optional
        1 forward dynamics, 2 inverse dynamics, 4 linearization along the motion, 7 equilibrium, frequencies and
        buckling, 8 state space in equilibrium, 9 state space along the motion, 10 static load steps.  By default
        1 if the file has TIMESTEP, 10 if it has load steps, else 7.
    dialect : "delft" or "twente", optional

    Returns
    -------
    Outcome

    Raises
    ------
    FlexelError
        An invalid file, an unknown mode, an analysis that fails.
    """
    file = read_spacar(path, dialect)
    if mode is None:
        mode = 1 if file.duration is not None else 10 if file.load_steps else 7
    if mode not in MODES:
        known = ", ".join(map(str, MODES))
        raise ModelError(
            f"{file.path.name}: mode {mode} does not exist; modes are {known} (for small motions about a nominal one, "
            "mode 3 of UT SPACAR, use mode 4 or `flexel.linear.periodic`)"
        )
    lines, results, motion = MODES[mode](file)
    head = [
        f"{file.path.name}: SPACAR, {file.dialect} dialect, mode {mode}",
        *(f"note: {z}" for z in file.notes),
    ]
    dofs = ", ".join(file.system.dynamic + file.system.kinematic) or "none"
    ended = [] if motion is None else [motion.message]
    report = [*head, f"degrees of freedom: {dofs}", *ended, "", *lines]
    if out is not None:
        report += ["", *(f"wrote {z}" for z in _write(file, out, results, motion))]
    return Outcome("\n".join(report), motion)


def _write(file: Spacar, out: Path, results: Results, motion: Motion | None) -> list[Path]:
    """Results as arrays, and the time histories among them as a table."""
    out.mkdir(parents=True, exist_ok=True)
    arrays = out / f"{file.path.stem}.npz"
    with replacing(arrays, "run") as part:
        np.savez(part, allow_pickle=False, **results)
    moved = [] if motion is None else [motion.save(motion_beside(arrays))]
    histories = {key: z for key, z in results.items() if key == "t" or key[:2] in ("x_", "e_", "s_")}
    if "t" not in results:
        return [arrays, *moved]
    table = out / f"{file.path.stem}.csv"
    columns = np.column_stack(list(histories.values()))
    with replacing(table, "run") as part:
        np.savetxt(part, columns, delimiter=",", header=",".join(histories), comments="", fmt="%.12e")
    return [arrays, table, *moved]


def _simulated(file: Spacar) -> Motion:
    if file.duration is None:
        raise ModelError(f"{file.path.name}: the duration of the simulation is missing; add a line TIMESTEP")
    return file.system.simulate(file.duration, samples=file.steps + 1, max_step=file.max_step or np.inf)


def _histories(file: Spacar, states: Motion | list[State], t: Array) -> Results:
    """All coordinates, deformations and stresses in SPACAR's numbers and signs."""
    found = {"t": t}
    found |= {f"x_{n}_{i}": np.array([s[name] for s in states]) for (n, i), name in file.coordinates.items()}
    for e, i in file.deformations:
        found[f"e_{e}_{i}"] = np.array([file.deformation(s, e, i) for s in states])
        found[f"s_{e}_{i}"] = np.array([file.stress(s, e, i) for s in states])
    return found


def _state_lines(file: Spacar, state: State) -> list[str]:
    lines = [f"coordinates at t = {state.t:g}"]
    for n in dict.fromkeys(node for node, _ in file.coordinates):
        values = [state[name] for (node, _), name in file.coordinates.items() if node == n]
        lines.append(f"  X {n:<4} " + " ".join(f"{z: .6e}" for z in values))
    lines.append("deformations (of slips: their rates)")
    for e in dict.fromkeys(element for element, _ in file.deformations):
        values = [file.deformation(state, e, i) for element, i in file.deformations if element == e]
        lines.append(f"  E {e:<4} " + " ".join(f"{z: .6e}" for z in values))
    return lines


def _matrix_lines(found: Mapping[str, Array]) -> list[str]:
    lines = []
    for name, A in found.items():
        if max(A.shape) > SHOWN:
            lines.append(f"{name}: {A.shape[0]} by {A.shape[1]}, written with --out")
            continue
        rows = [" ".join(f"{z: .9e}" for z in row) for row in A]
        lines += [f"{name} =", *(f"  {row}" for row in rows or ["(empty)"])]
    return lines


def _linear_lines(found: Matrices) -> list[str]:
    return [f"linearized in {', '.join(found.coordinates)}", *_matrix_lines(found.as_dict())]


def _forward(file: Spacar) -> Analysis:
    motion = _simulated(file)
    results = _histories(file, motion, motion.t)
    lines = _state_lines(file, motion[-1])
    if file.linearized:
        found = file.matrices()
        lines += ["", "at the start", *_linear_lines(found)]
        results |= found.as_dict()
    return lines, results, motion


def _inverse(file: Spacar) -> Analysis:
    left = file.system.dynamic + file.system.kinematic
    if left:
        raise ModelError(
            f"{file.path.name}: inverse dynamics needs all motions prescribed; {', '.join(left)} is free; make it "
            "an input, or use mode 1"
        )
    motion = _simulated(file)
    driven = [file.system.structure.names[i] for i in file.system.roles.prescribed]
    lines = ["driving forces at the end", *(f"  {z}: {-motion[-1].force(z): .9e}" for z in driven)]
    return [*_state_lines(file, motion[-1]), *lines], _histories(file, motion, motion.t), motion


def _along(file: Spacar) -> Analysis:
    motion = _simulated(file)
    every = [file.matrices(state) for state in motion]
    stacked = {name: np.array([z.as_dict()[name] for z in every]) for name in every[0].as_dict()}
    lines = ["at the start", *_linear_lines(every[0]), "", "at the end", *_linear_lines(every[-1])]
    return lines, _histories(file, motion, motion.t) | stacked, motion


def _static(file: Spacar) -> Analysis:
    state = file.system.equilibrium()
    lines, results = _state_lines(file, state), _histories(file, [state], np.array([state.t]))
    modes = file.frequencies(state)
    results["frequencies"] = np.array([z.omega for z in modes])
    lines += ["natural frequencies [rad/s]", *(f"  {z.omega: .9e}" for z in modes)]
    if file.model.loads:
        results["multipliers"] = np.array([z.multiplier for z in file.buckling()])
        lines += ["load multipliers of buckling", *(f"  {z: .9e}" for z in results["multipliers"])]
    try:
        found = file.matrices(state)
    except DynamicsError as error:  # equilibria and frequencies need no mass for every degree of freedom
        return [*lines, f"no matrices: {error}"], results, None
    return [*lines, *_linear_lines(found)], results | found.as_dict(), None


def _space(file: Spacar) -> Analysis:
    state = file.system.equilibrium()
    found = dict(zip("ABCD", file.state_space(state), strict=True))
    return [*_state_lines(file, state), *_matrix_lines(found)], found, None


def _space_along(file: Spacar) -> Analysis:
    motion = _simulated(file)
    every = [file.state_space(state) for state in motion]
    stacked = {name: np.array([z[i] for z in every]) for i, name in enumerate("ABCD")}
    lines = ["at the start", *_matrix_lines(dict(zip("ABCD", every[0], strict=True)))]
    return lines, _histories(file, motion, motion.t) | stacked, motion


def _load_steps(file: Spacar) -> Analysis:
    system, states = file.static_steps()
    results = _histories(file, states, np.array([z.t for z in states]))
    lines = _state_lines(file, states[-1])
    try:
        every = [file.matrices(state, system=system) for state in states]
    except DynamicsError as error:
        return [*lines, f"no matrices: {error}"], results, None
    stacked = {name: np.array([z.as_dict()[name] for z in every]) for name in every[0].as_dict()}
    return [*lines, *_linear_lines(every[-1])], results | stacked, None


MODES: dict[int, Callable[[Spacar], Analysis]] = {
    1: _forward,
    2: _inverse,
    4: _along,
    7: _static,
    8: _space,
    9: _space_along,
    10: _load_steps,
}
