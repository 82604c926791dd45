"""Analyses flexure mechanisms in one call: from tables of nodes and elements to all results over the load steps."""

from __future__ import annotations

import warnings
from itertools import pairwise
from typing import Any

import numpy as np

from flexel.apps.flexures.declaring import declared, schedule_of
from flexel.apps.flexures.input_tables import read_tables
from flexel.apps.flexures.measuring import Measuring
from flexel.apps.flexures.releasing import freed
from flexel.base.blas import in_one_thread
from flexel.base.callers import outside
from flexel.base.errors import DynamicsError, IncompleteWarning, ModelWarning, PositionError
from flexel.integration.outcome import Integration
from flexel.mechanics.ranges import warn_beyond, warned_together
from flexel.model.state import State
from flexel.parts.model import Model
from flexel.results.flexure_result import Flexure
from flexel.results.motion import Motion
from flexel.results.system_facade import System
from flexel.statics.load_path import static_path


@in_one_thread
def flexure(
    nodes: Any, elements: Any, node_properties: Any = None, element_properties: Any = (), options: Any = None
) -> Flexure:
    """Analyse a flexure mechanism from tables: equilibria under growing loads, and the requested results at each.

    Each node has a position and an orientation, initially that of the global axes.  An element joins two
    nodes; it is rigid, or a leaf spring of several beams.  Over-constraint is released, starting with
    flexible elements, the largest contribution first; the result names the released deformations, which keep the
    stiffness of their section.  With the option `both_ways` the loads go from -1 to 1 times the given ones.
    Nothing is printed.

    Parameters
    ----------
    nodes : array_like (n, 3)
        Positions of the nodes [m].
    elements : array_like of int (m, 2)
        The two nodes of each element, numbered from 1.
    node_properties : mapping of int to NodeProperties or mapping, optional
        By node number; or a list with an entry for each node, None for a node without properties.
    element_properties : sequence of ElementProperties or mapping
        Groups of elements.
    options : FlexureOptions or mapping, optional

    Returns
    -------
    Flexure
        With ``steps[i].node(3)``, ``steps[i].element(2)``, ``steps[i].frequencies``; pictures, tables and files.

    Raises
    ------
    ModelError
        An error in the tables; the message names the row.
    ConstraintError
        Unresisted motions; over-constraint, if it is not to be released.
    PositionError, DynamicsError
        If there is no equilibrium under the initial loads.

    Warns
    -----
    IncompleteWarning
        If a later load step has no equilibrium: the steps so far are returned.
    UnstableWarning
        If an equilibrium is unstable.
    ModelWarning
        If a number looks as if given in another unit, or a stress exceeds the strength of its material.
    RangeWarning
        If a beam is bent or twisted by more than 15°: the leaf needs more beams.

    Examples
    --------
    >>> leaf = {"elements": [1, 3], "section": "rectangle", "dimensions": (25e-3, 0.4e-3), "material": "spring steel",
    ...         "orientation": (0, 0, 1), "beams": 4, "flexible": [2, 3, 4]}
    >>> found = fx.flexure([[0, 0, 0], [0, 0.1, 0], [0.06, 0.1, 0], [0.06, 0, 0]], [[1, 2], [2, 3], [3, 4]],
    ...                    {1: {"fixed": True}, 4: {"fixed": True}, 2: {"force": (5, 0, 0), "mass": 0.5}}, [leaf])
    >>> found.steps[-1].node(2).displacement  # doctest: +SKIP
    """
    tables = read_tables(nodes, elements, node_properties, element_properties, options)
    model = declared(tables)
    released, redundant = freed(model, tables.options.release)
    schedule = schedule_of(tables)
    system = model.build(t=schedule.times[0])
    measuring = Measuring(tables, model, system)
    with warned_together():
        states, message = _load_steps(system, model, tables.options.steps, schedule.times)
        variables = measuring.variables(states)
    steps = Integration.of_equilibria(states, message)
    path = steps.states
    warn_beyond(system.evaluation, path.times, path.deformations, path.coordinates, "flexure")
    labels = measuring.labels(variables)
    found = Flexure(Motion(system, steps), variables, labels, released, redundant, measuring.notes)
    _warn_stresses(found, len(tables.ends))
    return found


def _warn_stresses(found: Flexure, elements: int) -> None:
    """Warn of the stress that exceeds the strength of its material by the largest factor."""
    stresses = [
        (step, stress)
        for step in found.steps
        for number in range(1, elements + 1)
        if (stress := step.element(number).stress) is not None and stress.safety is not None
    ]
    if not stresses:
        return
    step, stress = min(stresses, key=lambda pair: pair[1].safety or 0.0)
    if stress.strength is not None and stress.mises > stress.strength:
        warnings.warn(
            f"flexure: at step {step.number} the stress of {stress.mises:.3g} Pa in '{stress.beam}' exceeds the "
            f"strength of its material, {stress.strength:.3g} Pa",
            ModelWarning,
            stacklevel=outside(),
        )


def _load_steps(
    system: System, model: Model, steps: int, times: tuple[float, ...]
) -> tuple[list[State], str]:
    """Find equilibria at the load steps; return a message if not all are found.

    Parameters
    ----------
    steps : int
        From the initial loads to all loads.
    times : tuple of float
        Without loads, with the initial loads, the first step where that is another one, and with all loads.
    """
    state = system.equilibrium(t=times[0])
    for before, t in pairwise(times[:-1]):
        changes = _changes(model, before, t)
        state = _followed(system, state, t) if changes else system.equilibrium(state, t=t)
    states, begin = [state], times[-2]
    shares = np.linspace(begin, 1.0, 1 + steps * round(1.0 - begin)).tolist()
    for before, share in pairwise(shares if _changes(model, begin, 1.0) else shares[:1]):
        try:
            states.append(_followed(system, states[-1], share))
        except (PositionError, DynamicsError) as error:
            done = f"after step {len(states) - 1} of {len(shares) - 1}, at {before:.3g} of the loads"
            message = f"flexure: stopped {done}: {error}"
            warnings.warn(message, IncompleteWarning, stacklevel=outside())
            return states, message
    return states, ""


def _changes(model: Model, start: float, end: float) -> bool:
    """Whether a load or a prescribed motion differs between two times."""
    functions = [*(load.function for load in model.loads), *model.lowering.motions.values()]
    return any(function.rates(start)[0] != function.rates(end)[0] for function in functions)


def _followed(system: System, start: State, t: float) -> State:
    """Find the equilibrium at a time by a path from another state; a single large step could find a different one.

    Raises
    ------
    PositionError
        If the path does not reach that time.
    """
    path = static_path(system, t, start)
    if path.message:
        raise PositionError(path.message)
    return system.equilibrium(path.states[-1], t=t)  # also warns if it is unstable
