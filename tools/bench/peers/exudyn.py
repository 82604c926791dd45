"""Times ropes and a beam in Exudyn: the same cables, its generalized-alpha method and its statics.

The compiled variant without range checks, a sparse factorization and modified Newton iteration are its fastest
settings here; the end of the motion agrees with flexel's at the same step to its last digits. Full Newton iteration,
which flexel uses, and as many load steps as flexel takes are separate ways of using it.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterable
from contextlib import redirect_stdout
from functools import partial
from importlib import import_module
from io import StringIO
from typing import Any

import numpy as np

from bench import beams, ropes
from bench.timing import Work
from flexel.base.arrays import Array
from flexel.examples.rope_models import G

TOLERANCE = 1e-6  # of Newton's iteration; with its default 1e-8, rounding errors in long ropes make it halve the steps
STATIC_TOLERANCE = 1e-12  # relative, of the equilibrium; with 1e-10 the iteration stops too early
STEPS_TOLERANCE = (
    1e-10  # the same in many load steps, relative to a smaller residual; with 1e-11 it does not converge
)


def loaded() -> Any:
    """Return the module in its fast variant, silent."""
    sys.exudynFast = True  # type: ignore[attr-defined]  # asked for when it is first imported
    with warnings.catch_warnings(), redirect_stdout(StringIO()):
        warnings.simplefilter("ignore")  # of its own modules
        import exudyn

    exudyn.config.printToConsole = False
    return exudyn


def rope(n: int) -> tuple[Any, Any, int]:
    """Build the rope of `ropes.rope`: the container that owns the system, the system, and the node at the free end."""
    exudyn = loaded()
    items = import_module("exudyn.itemInterface")

    box = exudyn.SystemContainer()
    system = box.AddSystem()
    across = [ropes.ELEMENT * i for i in range(n + 1)]
    nodes = [system.AddNode(items.NodePointSlope1(referenceCoordinates=[x, 0, 0, 1, 0, 0])) for x in across]
    for ends in zip(nodes, nodes[1:], strict=False):
        cable = items.ObjectANCFCable(
            nodeNumbers=list(ends), length=ropes.ELEMENT, massPerLength=ropes.MASS, bendingStiffness=ropes.EI,
            axialStiffness=ropes.EA,
        )  # fmt: skip
        marker = system.AddMarker(items.MarkerBodyMass(bodyNumber=system.AddObject(cable)))
        system.AddLoad(items.LoadMassProportional(markerNumber=marker, loadVector=[0, 0, -G]))
    hold(system, items, nodes[0], range(3))
    system.AddSensor(
        items.SensorNode(
            nodeNumber=nodes[-1], storeInternal=True, outputVariableType=exudyn.OutputVariableType.Position
        )
    )
    system.Assemble()
    return box, system, nodes[-1]


def hold(system: Any, items: Any, node: int, coordinates: Iterable[int]) -> None:
    """Hold coordinates of a node."""
    ground = system.AddNode(items.NodePointGround())
    fixed = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    for axis in coordinates:
        moving = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=axis))
        system.AddObject(items.CoordinateConstraint(markerNumbers=[fixed, moving]))


def settings(seconds: float, step: float, period: float, modified: bool) -> Any:
    """Return settings of a motion in equal steps by full or modified Newton iteration; results each `period` [s]."""
    exudyn = loaded()
    given = exudyn.SimulationSettings()
    motion = given.timeIntegration
    motion.endTime, motion.numberOfSteps = seconds, round(seconds / step)
    motion.generalizedAlpha.spectralRadius = 0.8
    motion.newton.useModifiedNewton = modified
    motion.newton.relativeTolerance = TOLERANCE
    motion.verboseMode = 0
    given.solution.file.write = False
    given.solution.sensors.writePeriod = period
    given.linearSolver.solverType = exudyn.LinearSolverType.EigenSparse
    given.linearSolver.reuseAnalyzedPattern = True
    return given


def motion(n: int, seconds: float, period: float, error: Callable[[Array], float], modified: bool) -> Work:
    """Time a rope of n cables, run from its start; the result is the position (3,) of its free end."""
    box, system, free = rope(n)
    given = settings(seconds, ropes.STEP, period, modified)

    def run(_: Any = box) -> Array:  # kept alive
        if not system.SolveDynamic(given):
            raise RuntimeError("Exudyn's motion did not reach its end")
        return np.array(system.GetNodeOutput(free, loaded().OutputVariableType.Position), dtype=float)

    return Work(run, error)


def cables(modified: bool = True) -> Work:
    """Time the motion of `ropes.cables`; the position of the free end is stored 101 times, not state or energy."""
    return motion(56, 1.0, 0.01, ropes.place_error, modified)


def release(n: int, modified: bool = True) -> Work:
    """Time the motion of `ropes.release`."""
    return motion(n, ropes.RELEASE, ropes.RELEASE, ropes.release_error, modified)


def cantilever(load_steps: int = 1) -> Work:
    """Time the equilibrium of `beams.equilibrium`, by planar cables with the integration that does not lock."""
    exudyn = loaded()
    items = import_module("exudyn.itemInterface")
    box = exudyn.SystemContainer()
    system, length = box.AddSystem(), 1 / beams.ELEMENTS
    places = [[length * i, 0, 1, 0] for i in range(beams.ELEMENTS + 1)]
    nodes = [system.AddNode(items.NodePoint2DSlope1(referenceCoordinates=place)) for place in places]
    for ends in zip(nodes, nodes[1:], strict=False):
        cable = items.ObjectANCFCable2D(
            nodeNumbers=list(ends), length=length, massPerLength=1.0, bendingStiffness=1.0,
            axialStiffness=beams.EA, useReducedOrderIntegration=2,
        )  # fmt: skip
        system.AddObject(cable)
    hold(system, items, nodes[0], (0, 1, 3))  # holds the direction of the slope
    marker = system.AddMarker(items.MarkerNodePosition(nodeNumber=nodes[-1]))
    system.AddLoad(items.Force(markerNumber=marker, loadVector=[0, beams.LOAD, 0]))
    system.Assemble()
    given = exudyn.SimulationSettings()
    given.staticSolver.numberOfLoadSteps = load_steps
    given.staticSolver.newton.relativeTolerance = STATIC_TOLERANCE if load_steps == 1 else STEPS_TOLERANCE
    given.staticSolver.newton.absoluteTolerance = (
        1e-7  # its 1e-10 is below rounding errors of such a stiff rod
    )
    given.staticSolver.verboseMode = 0
    given.solution.file.write = False
    given.linearSolver.solverType = exudyn.LinearSolverType.EigenSparse

    def run(_: Any = box) -> Array:
        if not system.SolveStatic(given):
            raise RuntimeError("Exudyn found no equilibrium")
        return np.array(system.GetNodeOutput(nodes[-1], exudyn.OutputVariableType.Position), dtype=float)

    return Work(run, beams.tip_error)


ROWS: dict[str, Callable[..., Work]] = {
    "cables_56": cables,
    "scaling_rope": release,
    "cantilever_16": cantilever,
}
FULL_NEWTON: dict[str, Callable[..., Work]] = {
    "cables_56": partial(cables, modified=False),
    "scaling_rope": partial(release, modified=False),
}
IN_LOAD_STEPS: dict[str, Callable[..., Work]] = {
    "cantilever_16": partial(cantilever, load_steps=beams.LOAD_STEPS)
}
