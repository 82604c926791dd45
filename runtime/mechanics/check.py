"""A check of a model: all errors that `Model.build` would raise one after another, and probable mistakes."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from flexel.base.errors import AssemblyWarning, ConstraintError, DynamicsError, FlexelError, ModelWarning
from flexel.base.shown import counted
from flexel.declare.declarations import Declarations
from flexel.declare.resolution import norms, resolve_roles
from flexel.engine.evaluate import Evaluation
from flexel.mechanics.constraints import ConstraintReport, report_of_model
from flexel.mechanics.core import Core
from flexel.mechanics.diagnose import choose_dofs, quoted
from flexel.mechanics.findings import SEVERITIES, CheckReport, Finding
from flexel.mechanics.kinematics import size_of
from flexel.mechanics.reach import lost, reach
from flexel.mechanics.suspects import suspects
from flexel.structure.moment import Moment
from flexel.structure.structure import Structure, assemble_structure

SHOWN = 8  # names in a list
MOTIONS = 8  # that no law resists and that have a line each; the rest is counted
POOR = 10.0  # reach of the degrees of freedom, relative to that of the best, from which a note is given


def check(model: Declarations, build: Callable[[], Core]) -> CheckReport:
    """Everything found about a model; see `Model.check`.

    Parameters
    ----------
    model : Declarations
    build : callable
        Makes the system of the model.
    """
    found: list[Finding] = []
    system: Core | None = None
    try:
        structure = assemble_structure(
            model.nodes.values(), [*model.instances.values(), *norms(model)], model.laws
        )
        found += suspects(model, structure, size_of(structure))
        found += _degenerate(model, structure)
        report = report_of_model(model)
        found += _constraints(report)
    except FlexelError as error:  # a role that contradicts another, an unknown name
        found.append(Finding("error", "declarations", str(error)))
    else:
        attempt = _built(build, bool(report.redundant))
        found += attempt.findings
        system = attempt.system
    if system is None:
        return _sorted(found, (), ())
    found += [*_freedom(system), *_masses(system), *_condition(system)]
    return _sorted(found, system.dynamic, system.kinematic)


def _sorted(found: list[Finding], dynamic: tuple[str, ...], kinematic: tuple[str, ...]) -> CheckReport:
    ordered = sorted(found, key=lambda z: SEVERITIES.index(z.severity))
    return CheckReport(tuple(ordered), dynamic, kinematic)


def _constraints(report: ConstraintReport) -> Iterator[Finding]:
    """Redundant conditions with the smallest set to release, and motions that no elastic law resists."""
    for share in report.redundant:
        yield Finding("error", "constraints", f"over-constrained: {quoted(list(share))} are not independent")
    if report.release:
        calls = ", ".join(f"m.release('{z}')" for z in report.release)
        yield Finding("error", "constraints", f"release {quoted(report.release)}: {calls}")
    for name, others in report.alternatives.items():
        if others:
            yield Finding("note", "constraints", f"in place of '{name}' equally well: {quoted(others)}")
    for share in report.motions[:MOTIONS]:
        yield Finding("note", "constraints", f"a mechanism: no law resists a motion of {_leading(share)}")
    if (more := len(report.motions) - MOTIONS) > 0:
        yield Finding("note", "constraints", f"a mechanism: no law resists {counted(more, 'more motion')}")


def _leading(share: dict[str, float]) -> str:
    """The largest entries of a motion, by name."""
    names = list(share)
    return quoted(names[:4]) + (f" and {len(names) - 4} more" if len(names) > 4 else "")


def _degenerate(model: Declarations, structure: Structure) -> Iterator[Finding]:
    """Elements that are undefined as drawn, or whose rigid conditions do not depend on any coordinate."""
    e, J = Evaluation(structure).position(structure.x0)
    rows = np.asarray(abs(J[: structure.m + structure.k]).sum(axis=1)).ravel()
    rigid = set(resolve_roles(model, structure).rigid)
    for i, name in enumerate(structure.names[: structure.m]):
        if not (np.isfinite(e[i]) and np.isfinite(rows[i])):
            message = f"'{name}' is undefined as drawn; move its nodes apart, or out of line"
            yield Finding("error", "elements", message)
        elif rows[i] == 0 and i in rigid:
            message = f"'{name}' depends on no coordinate as drawn; move its nodes apart, or out of line"
            yield Finding("error", "elements", message)


@dataclass(frozen=True)
class Attempt:
    """The system of a model, if it can be built, and the messages."""

    system: Core | None
    findings: list[Finding]


def _built(build: Callable[[], Core], redundant: bool) -> Attempt:
    """Build; redundancy that was reported already is not repeated."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            system: Core | None = build()
            failure = None
        except FlexelError as error:
            system, failure = None, error
    found = [
        Finding("warning", "drawing" if z.category is AssemblyWarning else "model", str(z.message))
        for z in said
        if z.category is not ModelWarning  # found above already
    ]
    if failure is not None and not (redundant and isinstance(failure, ConstraintError)):
        subject = "constraints" if isinstance(failure, ConstraintError) else "assembly"
        found.append(Finding("error", subject, str(failure)))
    return Attempt(system, found)


def _freedom(system: Core) -> Iterator[Finding]:
    count = len(system.dynamic)
    names = f": {quoted(list(system.dynamic), SHOWN)}" if count else ""
    yield Finding("note", "freedom", f"{count} degree(s) of freedom{names}")
    if system.kinematic:
        yield Finding(
            "note", "freedom", f"{len(system.kinematic)} kinematic: {quoted(list(system.kinematic), SHOWN)}"
        )


def _masses(system: Core) -> Iterator[Finding]:
    """Degrees of freedom that move no mass: statics is possible, motion is not."""
    try:
        _ = system.initial
    except DynamicsError as error:
        yield Finding("warning", "masses", f"{error}; statics need none")


def _condition(system: Core) -> Iterator[Finding]:
    """Motion of the coordinates per unit of the degrees of freedom, relative to the best choice."""
    if not system.dynamic:
        return
    kinematics, near = system.kinematics, Moment.of(system.at_rest)
    J = system.evaluation.position(near.x)[1]
    best = system.kinematics_of(choose_dofs(kinematics, J, None, system.roles.kinematic))
    own, least = reach(kinematics, near), reach(best, near)
    factor = own / max(least, 1e-300)
    better = quoted([system.structure.names[i] for i in best.roles.dynamic])
    text = f"{quoted(list(system.dynamic))} move the coordinates {factor:.3g} times as far as {better} do"
    if factor > lost(system.roles):
        yield Finding("warning", "coordinates", f"{text}: nearly singular here; name others")
    elif factor > POOR:
        yield Finding("note", "coordinates", f"{text}; other names may be better")
