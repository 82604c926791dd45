"""From a declared model to a system: roles resolved, position assembled, coordinates chosen, rates made consistent."""

from __future__ import annotations

import logging
import warnings
from collections.abc import Sequence
from dataclasses import replace
from typing import TypeVar

from flexel.base.arguments import number
from flexel.base.callers import outside
from flexel.base.errors import AssemblyWarning, ConstraintError, ModelError, ModelWarning
from flexel.engine.evaluate import Evaluation
from flexel.mechanics.diagnose import choose_dofs, named_dofs
from flexel.mechanics.findings import Finding
from flexel.mechanics.first_position import first_position
from flexel.mechanics.kinematics import Kinematics, check_size, size_of
from flexel.mechanics.reference_misfit import misfit
from flexel.mechanics.singular_drawing import singular_drawing
from flexel.mechanics.suspects import suspects
from flexel.model.applied_loads import Loads
from flexel.model.lowering import Lowering
from flexel.model.quantities import history
from flexel.model.resolution import check_names, norms, resolve_roles
from flexel.model.structure import Structure, assemble_structure
from flexel.system import CoreSystem

log = logging.getLogger("flexel.build")
Built = TypeVar("Built", bound=CoreSystem)
SHOWN = 3  # probable mistakes named in the warning


def build(model: Lowering, t: float, kind: type[Built]) -> Built:
    """Return the system of a model at time t, of a kind: a `CoreSystem`, or what users see; see `Model.build`."""
    t = number(t, "build", "time t")
    if not model.nodes:
        raise ModelError("the model has no nodes; add points and frames first")
    structure = assemble_structure(
        model.nodes.values(), [*model.instances.values(), *norms(model)], model.laws, model.controllers
    )
    check_size(structure)
    _check_inputs(structure)
    evaluation = Evaluation(structure)
    roles = resolve_roles(model, structure)
    loads = Loads(structure, tuple(model.loads))
    check_names(model, structure, roles)
    taken = [*structure.names[structure.m + structure.k + structure.nf :], *model.motions]
    for check in model.checks.values():
        check(structure, [*taken, *(load.name for load in model.loads)])
    loads.at(t)  # a function of a load that fails is reported here, not during a motion
    kinematics = Kinematics(evaluation, roles, loads)
    c = first_position(model, kinematics, t)
    wrong = misfit(model, kinematics, c)
    if wrong is not None:
        warnings.warn(str(wrong), AssemblyWarning, stacklevel=outside())
    dynamic = named_dofs(structure, model.dynamic, "independent")
    kinematic = named_dofs(structure, model.kinematic, "kinematic")
    try:
        chosen = replace(choose_dofs(kinematics, c.J, dynamic, kinematic), named=bool(model.dynamic))
    except ConstraintError as error:
        raise (singular_drawing(kinematics, c) or error) from None
    system = kind(evaluation, loads, chosen, c, model.rates)
    _warn(suspects(model, structure, size_of(structure)))
    log.info("%s; degrees of freedom %s", system, "chosen" if model.dynamic is None else "as named")
    _log_rates(system)
    return system


def _log_rates(system: CoreSystem) -> None:
    """Report with what rates the degrees of freedom start, if any of them moves."""
    if not log.isEnabledFor(logging.INFO):
        return
    start = system.unaccelerated
    moving = [f"{name}' = {start.rate(name):.6g}" for name in system.dynamic if start.rate(name)]
    if moving:
        log.info("at t = %g s: %s", start.t, ", ".join(moving))


def _warn(found: Sequence[Finding]) -> None:
    """One warning of all that is probably a mistake."""
    if found:
        more = f"; and {len(found) - SHOWN} more, see m.check()" if len(found) > SHOWN else ""
        text = "; ".join(finding.message for finding in found[:SHOWN])
        warnings.warn(f"build: {text}{more}", ModelWarning, stacklevel=outside())


def _check_inputs(structure: Structure) -> None:
    """Check that all that controllers measure has a value."""
    for controller in structure.controllers:
        for name in controller.inputs:
            try:
                history(structure, name)
            except ModelError as error:
                raise ModelError(f"{controller.owner}: input {error}") from None
