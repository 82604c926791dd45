"""Checks a model: all errors that `Model.build` would raise one after another, and probable mistakes."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from flexel.base.blas import in_one_thread
from flexel.base.errors import AssemblyWarning, ConstraintError, DynamicsError, FlexelError, ModelWarning
from flexel.base.shown import counted, quoted
from flexel.engine.evaluate import Evaluation
from flexel.mechanics.amplification import amplification, lost
from flexel.mechanics.diagnose import choose_dofs
from flexel.mechanics.findings import SEVERITIES, CheckReport, Finding
from flexel.mechanics.kinematics import size_of
from flexel.mechanics.singular_drawing import SingularDrawingError
from flexel.mechanics.suspects import suspects
from flexel.model.constraints import ConstraintReport, constraint_report
from flexel.model.lowering import Lowering
from flexel.model.resolution import norms, resolve_roles
from flexel.model.snapshot import Snapshot
from flexel.model.structure import Structure, assemble_structure, declared
from flexel.system import CoreSystem

MAX_NAMES_SHOWN = 8  # names in a list
MAX_MOTIONS_SHOWN = 8  # motions without an elastic law that get a line each; further ones are counted
POOR = (
    10.0  # amplification by the degrees of freedom, relative to the best choice, above which a note is given
)


@in_one_thread
def check(model: Lowering, build: Callable[[], CoreSystem]) -> CheckReport:
    """Check a model; see `Model.check`.

    Parameters
    ----------
    model : Lowering
    build : callable
        Makes the system of the model.
    """
    found: list[Finding] = []
    system: CoreSystem | None = None
    try:
        structure = assemble_structure(
            model.nodes.values(), [*model.instances.values(), *norms(model)], model.laws
        )
        found += suspects(model, structure, size_of(structure))
        found += _degenerate(model, structure)
        report = report_of_model(model)
    except FlexelError as error:  # conflicting roles, or an unknown name
        found.append(Finding("error", "declarations", str(error)))
    else:
        attempt = _built(build, bool(report.redundant))
        found += [*_constraints(report, attempt.singular), *attempt.findings]
        system = attempt.system
    if system is None:
        return _sorted(found, (), ())
    found += [*_freedom(system), *_masses(system), *_condition(system)]
    return _sorted(found, system.dynamic, system.kinematic)


def _sorted(found: list[Finding], dynamic: tuple[str, ...], kinematic: tuple[str, ...]) -> CheckReport:
    ordered = sorted(found, key=lambda finding: SEVERITIES.index(finding.severity))
    return CheckReport(tuple(ordered), dynamic, kinematic)


def _constraints(report: ConstraintReport, singular: bool) -> Iterator[Finding]:
    """Find redundant conditions with the smallest set to release, and motions that no elastic law resists.

    A singular drawing has none to release: another finding says so.
    """
    if not singular:
        yield from _redundant(report)
    for share in report.motions[:MAX_MOTIONS_SHOWN]:
        yield Finding(
            "note",
            "constraints",
            f"a mechanism: no law resists a motion of {_leading(declared(share, report.added))}",
        )
    if (more := len(report.motions) - MAX_MOTIONS_SHOWN) > 0:
        yield Finding("note", "constraints", f"a mechanism: no law resists {counted(more, 'more motion')}")


def _redundant(report: ConstraintReport) -> Iterator[Finding]:
    """Find redundant conditions, with the smallest set to release."""
    for share in report.redundant:
        yield Finding(
            "error",
            "constraints",
            f"over-constrained: {quoted(declared(share, report.added))} are not independent",
        )
    if report.release:
        calls = ", ".join(f"m.release('{name}')" for name in report.release)
        yield Finding("error", "constraints", f"release {quoted(report.release)}: {calls}")
    for name, others in report.alternatives.items():
        if others:
            yield Finding(
                "note",
                "constraints",
                f"alternatives to '{name}': {quoted(declared(others, report.added))}",
            )


def _leading(names: list[str]) -> str:
    """Name the largest entries of a motion."""
    return quoted(names[:4]) + (f" and {len(names) - 4} more" if len(names) > 4 else "")


def _degenerate(model: Lowering, structure: Structure) -> Iterator[Finding]:
    """Find elements that are undefined as drawn, or whose rigid conditions do not depend on any coordinate."""
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


@in_one_thread
def report_of_model(model: Lowering) -> ConstraintReport:
    """Report over- and under-constraint of a model as drawn; see `Model.constraint_report`."""
    elements = [*model.instances.values(), *norms(model)]
    structure = assemble_structure(model.nodes.values(), elements, model.laws)
    _, J = Evaluation(structure).position(structure.x0)
    return constraint_report(structure, resolve_roles(model, structure), J)


@dataclass(frozen=True)
class Attempt:
    """The system of a model, if it can be built, the messages, and whether its drawing is singular."""

    system: CoreSystem | None
    findings: list[Finding]
    singular: bool


def _built(build: Callable[[], CoreSystem], redundant: bool) -> Attempt:
    """Build the system; redundancy that was already reported is not repeated."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            system: CoreSystem | None = build()
            failure = None
        except FlexelError as error:
            system, failure = None, error
    found = [
        Finding(
            "warning", "drawing" if warning.category is AssemblyWarning else "model", str(warning.message)
        )
        for warning in said
        if warning.category is not ModelWarning  # already found above
    ]
    singular = isinstance(failure, SingularDrawingError)
    reported = redundant and isinstance(failure, ConstraintError) and not singular
    if failure is not None and not reported:
        subject = "constraints" if isinstance(failure, ConstraintError) else "assembly"
        found.append(Finding("error", subject, str(failure)))
    return Attempt(system, found, singular)


def _freedom(system: CoreSystem) -> Iterator[Finding]:
    count = len(system.dynamic)
    names = f": {quoted(list(system.dynamic), MAX_NAMES_SHOWN)}" if count else ""
    yield Finding("note", "freedom", f"{count} degree(s) of freedom{names}")
    if system.kinematic:
        yield Finding(
            "note",
            "freedom",
            f"{len(system.kinematic)} kinematic: {quoted(list(system.kinematic), MAX_NAMES_SHOWN)}",
        )


def _masses(system: CoreSystem) -> Iterator[Finding]:
    """Find degrees of freedom without mass: statics is possible, motion is not."""
    try:
        _ = system.initial
    except DynamicsError as error:
        yield Finding("warning", "masses", f"{error}; statics need none")


def _condition(system: CoreSystem) -> Iterator[Finding]:
    """Judge the motion of the coordinates per unit of the degrees of freedom, relative to the best choice."""
    if not system.dynamic:
        return
    kinematics, here = system.kinematics, Snapshot.of(system.at_rest)
    J = system.evaluation.position(here.x)[1]
    best = system.kinematics_of(choose_dofs(kinematics, J, None, system.roles.kinematic))
    own, least = amplification(kinematics, here), amplification(best, here)
    factor = own / max(least, 1e-300)
    better = quoted([system.structure.names[i] for i in best.roles.dynamic])
    text = f"{quoted(list(system.dynamic))} move the coordinates {factor:.3g} times as far as {better} do"
    if factor > lost(system.roles):
        yield Finding("warning", "coordinates", f"{text}: nearly singular here; name others")
    elif factor > POOR:
        yield Finding("note", "coordinates", f"{text}; other names may be better")
