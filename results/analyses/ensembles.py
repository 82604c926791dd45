"""A variant of a system, and motions of many at once."""

from __future__ import annotations

import re
import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from flexel.base.arguments import mapping, names, unknown
from flexel.base.arrays import Array
from flexel.base.blas import in_one_thread
from flexel.base.callers import outside
from flexel.base.errors import ModelError
from flexel.integration import methods
from flexel.integration.outcome import Said, stored_times
from flexel.integration.simulation import Preparation, ended
from flexel.integration.trajectory import Trajectory
from flexel.model.quantities import history
from flexel.model.state import State, own_state
from flexel.results.analyses.variant_lanes import MotionRunner
from flexel.results.analyses.variant_motions import MotionOf
from flexel.results.analyses.variant_runs import C, Recomputation, Values, variant_of
from flexel.results.ensemble import Ensemble
from flexel.system import CoreSystem

NUMBER = re.compile(r"(?<![\w.])-?\d[\d.]*(?:e[-+]?\d+)?")  # not that of a name
OPTIONS = ("method", *sorted(set().union(*methods.OPTIONS.values()) - {"events"}))


@in_one_thread
def with_parameters(system: C, values: Mapping[str, Any]) -> C:
    """Copy the system with other values of some parameters.

    If a parameter of a part changes the geometry, the model is rebuilt with it.

    Raises
    ------
    ModelError
        An unknown name, with the nearest ones; a parameter of an element on which positions depend; a
        parameter of a part that changes which nodes, elements or laws there are.

    Examples
    --------
    >>> heavy = system.with_parameters({"rider.mass": 110.0})  # doctest: +SKIP
    """
    given = Values(system, values, {}, "with_parameters")
    if given.count != 1:
        raise ModelError(f"with_parameters: {given.count} values; give one for each parameter")
    given.check_elements(system)
    return variant_of(system, given, 0)


@in_one_thread
def simulate_many(
    system: CoreSystem,
    duration: float,
    *,
    parameters: Mapping[str, Any] | None = None,
    initial: Mapping[str, Any] | None = None,
    start: State | None = None,
    outputs: Sequence[str] | None = None,
    times: Sequence[float] | Array | None = None,
    samples: int = 201,
    threads: int | None = None,
    progress: bool | None = None,
    **options: Any,
) -> Ensemble:
    """Simulate many variants side by side in threads, each with independent steps.

    The result of a variant depends neither on the others nor on the number of threads, to the last digit.

    Parameters
    ----------
    duration : float
        [s]
    parameters : mapping of name to array_like (variants,)
        Values of parameters, see `parameters`; (variants, size) for parameters of several numbers.  A single value
        holds for all variants.
    initial : mapping of name to array_like (variants,)
        Initial values of degrees of freedom and internal states; with a prime (``"lean.angle'"``) rates of any
        quantities.
    start : State, optional
        Provides all that is not named; the initial state by default.
    outputs : sequence of str, optional
        Quantities to keep, named as in `Motion.series`; the degrees of freedom by default.
    times, samples
        Times at which they are kept, as in `simulate`.
    threads : int, optional
        All processors by default.
    progress : bool, optional
        Progress bar on stderr; by default where stderr is a terminal.
    **options
        Method, tolerances and steps, as in `simulate`.

    Returns
    -------
    Ensemble
        Variants that failed are named in ``failed``.

    Raises
    ------
    ModelError
        An unknown name, with the nearest ones; different numbers of values; a parameter on which positions depend.
    FlexelError
        If all variants fail: the error of the first.

    Warns
    -----
    AuditWarning, DampingWarning, RangeWarning
        What single motions warn of, once for each cause: how many variants, and the text of the first.
    IncompleteWarning
        Some variants failed, or an interrupt (Ctrl-C) left them out: how many, and the first reason.
    """
    for wrong in (name for name in options if name not in OPTIONS):
        raise ModelError(f"simulate_many: {unknown(wrong, OPTIONS, 'option')}")
    values = Values(system, parameters, mapping(initial, "simulate_many", "initial"), "simulate_many")
    wanted = tuple(system.dynamic + system.kinematic if outputs is None else names(outputs, "simulate_many"))
    begin = own_state(system.structure, system.initial if start is None else start, "simulate_many")
    grid = stored_times(begin, duration, times, samples, "simulate_many")
    units = [history(system.structure, name).unit for name in wanted]

    motion = MotionOf(float(grid[-1] - begin.t), grid, start, values, options)

    def end(system: CoreSystem, begun: Preparation) -> tuple[Array, dict[str, int]]:
        found = Trajectory(system, ended(system, begun, grid))
        rows = np.full((len(wanted), grid.size), np.nan)
        for row, name in zip(rows, wanted, strict=True):
            row[: len(found)] = found[name]
        return rows, found.statistics

    runner = MotionRunner(system, values, motion.begun, end)
    runner.run(threads, progress)
    runner.report("simulate_many")
    all_rows = np.full((len(wanted), values.count, grid.size), np.nan)
    statistics: list[dict[str, int]] = [{} for _ in range(values.count)]
    for i, (rows, counts) in runner.results.items():
        all_rows[:, i], statistics[i] = rows, counts
    _warn({i: runner.said.get(i, []) for i in sorted(runner.results)}, values.count)
    series = {name: (rows, unit) for name, rows, unit in zip(wanted, all_rows, units, strict=True)}
    given = values.given | {name: np.array(column) for name, column in values.initial.items()}
    return Ensemble(grid, series, given, runner.failed, statistics, Recomputation(system, values, motion))


def _warn(said: Mapping[int, Said], count: int) -> None:
    """Warn once for each cause; texts that differ in their numbers alone have the same cause."""
    causes: dict[tuple[type[Warning], str], list[tuple[int, str]]] = {}
    for i, entries in said.items():
        for category, text in entries:
            causes.setdefault((category, NUMBER.sub("#", text)), []).append((i, text))
    for (category, _), found in causes.items():
        first, text = found[0]
        many = f"{len(found)} of {count} variants, number {first} first: "
        warnings.warn(f"simulate_many: {many}{text}", category, stacklevel=outside())
