"""Performs SPACAR's modes of analysis: lines of a report, results as arrays, and a motion if there is one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from flexel.apps.spacar.count import count_lines
from flexel.apps.spacar.listing import frequency_lines, linear_lines, matrix_lines, state_lines
from flexel.apps.spacar.reading import Spacar
from flexel.apps.spacar.vectors import vectors
from flexel.base.arrays import Array, ComplexArray
from flexel.base.errors import DynamicsError, ModelError
from flexel.integration.outcome import Integration
from flexel.model.state import State
from flexel.results.motion import Motion
from flexel.results.system_facade import System

Results = dict[str, Array | ComplexArray]
# what begins the names of histories: coordinates, deformations, stresses, small changes of the first two
HISTORIES = ("x_", "e_", "s_", "dx_", "de_")


@dataclass(frozen=True)
class Analysis:
    """The output of an analysis.

    Attributes
    ----------
    lines : list of str
        The report.
    results : dict of str to array
        Everything by names; matrices of several states (nt, rows, columns).
    states : sequence of State
        Of the results.
    system : System, optional
        Of these states, if it is a variant of the file's system.
    """

    lines: list[str]
    results: Results
    motion: Motion | None = None
    states: Sequence[State] = ()
    system: System | None = None


def _simulated(file: Spacar) -> Motion:
    if file.duration is None:
        raise ModelError(f"{file.path.name}: the duration of the simulation is missing; add a line TIMESTEP")
    return file.system.simulate(file.duration, samples=file.steps + 1, max_step=file.max_step or np.inf)


def _histories(file: Spacar, states: Motion | list[State], t: Array) -> Results:
    """Return all coordinates, deformations and stresses in SPACAR's numbers and signs."""
    own = vectors(file, states, wanted=("x", "e", "sig"))
    x, deformations, stresses = (own.tables[name].T for name in ("x", "e", "sig"))
    found: Results = {"t": t}
    found |= {f"x_{n}_{i}": values for (n, i), values in zip(own.nodes, x, strict=True)}
    for (e, i), values, forces in zip(own.elements, deformations, stresses, strict=True):
        found |= {f"e_{e}_{i}": values, f"s_{e}_{i}": forces}
    return found


def _counted(file: Spacar) -> Analysis:
    lines, condition = count_lines(file)
    return Analysis(lines, {"condition": np.array(condition)})


def _forward(file: Spacar) -> Analysis:
    motion = _simulated(file)
    results = _histories(file, motion, motion.t)
    lines = state_lines(file, motion[-1])
    if file.linearized:
        found = file.matrices()
        lines += ["", "at the start", *linear_lines(found)]
        results |= found.as_dict()
    return Analysis(lines, results, motion, list(motion))


def _inverse(file: Spacar) -> Analysis:
    left = file.system.dynamic + file.system.kinematic
    if left:
        raise ModelError(
            f"{file.path.name}: inverse dynamics needs all motions prescribed; {', '.join(left)} is free; make it "
            "an input, or use mode 1"
        )
    motion = _simulated(file)
    driven = [file.system.structure.names[i] for i in file.system.roles.prescribed]
    lines = ["driving forces at the end", *(f"  {name}: {motion[-1].drive(name): .9e}" for name in driven)]
    lines = [*state_lines(file, motion[-1]), *lines]
    return Analysis(lines, _histories(file, motion, motion.t), motion, list(motion))


def _along(file: Spacar) -> Analysis:
    motion = _simulated(file)
    lines, stacked = _matrices_along(file, motion)
    return Analysis(lines, _histories(file, motion, motion.t) | stacked, motion, list(motion))


def _matrices_along(file: Spacar, states: Sequence[State]) -> tuple[list[str], Results]:
    """Return the report of the matrices at the first and the last state, and those of all."""
    every = [file.matrices(state) for state in states]
    stacked: Results = {name: np.array([lin.as_dict()[name] for lin in every]) for name in every[0].as_dict()}
    return ["at the start", *linear_lines(every[0]), "", "at the end", *linear_lines(every[-1])], stacked


def _perturbed(file: Spacar) -> Analysis:
    """Small motions about the nominal one, in which the degrees of freedom keep their initial values."""
    system, start = file.system, file.system.initial
    if file.duration is None:
        raise ModelError(
            f"{file.path.name}: the duration of the nominal motion is missing; add a line TIMESTEP"
        )
    times = start.t + np.linspace(0.0, file.duration, file.steps + 1)
    nominal = system.along(times=times)
    states = [lin.state for lin in nominal]
    small = nominal.transient({f"{name}'": start.rate(name) for name in system.dynamic})
    places = [*((name, 1.0) for name in file.coordinates.values()), *file.deformations.values()]
    _, _, C, _ = nominal.state_space(outputs=[name for name, _ in places])
    changes = np.einsum("tij,tj->it", C, small.x) * np.array([[factor] for _, factor in places])
    labels = [f"dx_{n}_{i}" for n, i in file.coordinates] + [f"de_{e}_{i}" for e, i in file.deformations]
    lines = ["nominal motion, at the end", *state_lines(file, states[-1]), "small changes from it"]
    lines += [f"  {name}: {small[name][-1]: .9e}" for name in system.dynamic]
    report, stacked = _matrices_along(file, states)
    results = _histories(file, states, times) | dict(zip(labels, changes, strict=True)) | stacked
    return Analysis([*lines, "", *report], results, states=states)


def _static(file: Spacar) -> Analysis:
    state = file.system.equilibrium()
    lines, results = state_lines(file, state), _histories(file, [state], np.array([state.t]))
    found = np.array(
        [mode.omega if mode.omega >= 0 else -1j * mode.omega for mode in file.frequencies(state)]
    )
    results["frequencies"] = _real(found)
    lines += frequency_lines(found)
    if file.model.loads:
        results["multipliers"] = np.array([mode.multiplier for mode in file.buckling()])
        multipliers = [f"  {multiplier: .9e}" for multiplier in results["multipliers"]]
        lines += ["load multipliers of buckling", *(multipliers or ["  none: these loads cause no buckling"])]
    try:
        matrices = file.matrices(state)
    except DynamicsError as error:  # equilibria and frequencies need no mass for every degree of freedom
        return Analysis([*lines, f"no matrices: {error}"], results, states=[state])
    results |= matrices.as_dict()
    return Analysis([*lines, *linear_lines(matrices)], results, states=[state])


def _space(file: Spacar) -> Analysis:
    state = file.system.equilibrium()
    found = dict(zip("ABCD", file.state_space(state), strict=True))
    return Analysis([*state_lines(file, state), *matrix_lines(found)], {**found}, states=[state])


def _space_along(file: Spacar) -> Analysis:
    if file.duration is None:
        return _space(file)
    motion = _simulated(file)
    every = [file.state_space(state) for state in motion]
    stacked = {name: np.array([matrices[i] for matrices in every]) for i, name in enumerate("ABCD")}
    lines = ["at the start", *matrix_lines(dict(zip("ABCD", every[0], strict=True)))]
    return Analysis(lines, _histories(file, motion, motion.t) | stacked, motion, list(motion))


def _load_steps(file: Spacar) -> Analysis:
    system, states = file.static_steps()
    motion = Motion(system, Integration.of_equilibria(states, f"{file.increments} load steps"))
    results = _histories(file, states, np.array([state.t for state in states]))
    lines = state_lines(file, states[-1])
    try:
        every = [file.matrices(state, system=system) for state in states]
    except DynamicsError as error:
        return Analysis([*lines, f"no matrices: {error}"], results, motion, states, system)
    stacked: Results = {name: np.array([lin.as_dict()[name] for lin in every]) for name in every[0].as_dict()}
    lines += linear_lines(every[-1])
    if not system.kinematic:
        stacked["frequencies"] = _real(np.array([lin.frequencies() for lin in every]))
        lines += frequency_lines(every[-1].frequencies())
    return Analysis(lines, results | stacked, motion, states, system)


def _real(found: ComplexArray) -> Array | ComplexArray:
    """Return frequencies as real numbers if all are real."""
    return found if np.any(found.imag) else found.real


MODES: dict[int, Callable[[Spacar], Analysis]] = {
    0: _counted,
    1: _forward,
    2: _inverse,
    3: _perturbed,
    4: _along,
    7: _static,
    8: _space,
    9: _space_along,
    10: _load_steps,
}
