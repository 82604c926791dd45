"""Valid calls of the methods of `System` and `State`."""

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
from mechanisms import cantilever
from mistakes import pendulum
from travellers import pushed
from valid_call import Valid, calling

import flexel as fx


@cache
def rod() -> fx.System:
    """A rod on a hinge, at 90 degrees from where it hangs, with a spring."""
    m = pendulum()
    m.spring("pivot.angle", 50.0, 1.0)
    return m.build()


def steps() -> fx.Stepper:
    """The rod in steps."""
    return rod().stepper(0.01, inputs=["pivot.angle"])


@cache
def driven() -> fx.System:
    """A mass on a nonlinear spring, pushed to and fro."""
    return pushed().build()


@cache
def leaf() -> fx.System:
    """A steel strip clamped at one end."""
    return cantilever()


@cache
def strut() -> fx.System:
    """A column of one element, whose tip may be pressed."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.angle("wall", fixed=True)
    m.angle("tip")
    m.beam("column", "O", "wall", "A", "tip", EA=1e6, EIz=1.0, mass_per_length=1.0)
    return m.build()


def changed() -> Valid:
    """Other coordinates, of a system of its own."""
    return calling(pendulum().build().use_coordinates, dynamic=["pivot.angle"], kinematic=[])


MASS = {"rod.rhoA": [1.0, 2.0]}

SYSTEMS: dict[str, Callable[[], Valid]] = {
    "State.acceleration": lambda: calling(rod().initial.acceleration, name="A.x"),
    "State.force": lambda: calling(rod().initial.force, name="pivot.angle"),
    "State.drive": lambda: calling(rod().equilibrium(hold=["pivot.angle"]).drive, name="pivot.angle"),
    "State.outputs": lambda: calling(leaf().initial.outputs, element="leaf"),
    "State.position": lambda: calling(rod().initial.position, node="A"),
    "State.rate": lambda: calling(rod().initial.rate, name="A.x"),
    "State.section_forces": lambda: calling(leaf().initial.section_forces, beam="leaf"),
    "State.stress": lambda: calling(leaf().initial.stress, beam="leaf"),
    "State.velocity": lambda: calling(rod().initial.velocity, node="A"),
    "System.buckling": lambda: calling(strut().buckling, state=strut().at_rest, increment={"A.x": -1.0}, count=2),
    "System.compliance": lambda: calling(
        leaf().compliance, point="A", frame="tip", state=leaf().at_rest, offset=(0.1, 0, 0)
    ),
    "System.equilibrium": lambda: calling(rod().equilibrium, start=rod().initial),
    "System.time_scaled": lambda: calling(rod().time_scaled, factor=2.0),
    "System.along": lambda: calling(rod().along, motion=rod().simulate(0.1, samples=4), period=0.1),
    "System.linearize": lambda: calling(rod().linearize, state=rod().initial),
    "System.linearize_many": lambda: calling(
        rod().linearize_many, state=rod().initial, parameters=MASS, threads=1, progress=False
    ),
    "System.periodic": lambda: calling(driven().periodic, period=np.pi, harmonics=2),
    "System.periodic_branch": lambda: calling(driven().periodic_branch, period=np.pi, end=3.0, harmonics=1),
    "System.residual": lambda: calling(
        rod().residual, t=0.0, q=np.zeros(1), qd=np.zeros(1), qdd=np.zeros(1), guess=rod().initial
    ),
    "System.restore": lambda: calling(rod().restore, saved=rod().initial),
    "System.rhs": lambda: calling(rod().rhs, t=0.0, y=np.zeros(2)),
    "System.root_loci": lambda: calling(
        rod().root_loci, state=rod().initial, parameters=MASS, threads=1, progress=False
    ),
    "System.simulate": lambda: calling(
        rod().simulate, duration=0.1, start=rod().initial, samples=3, progress=False, checkpoint=Path("run.npz")
    ),
    "System.simulate_many": lambda: calling(
        rod().simulate_many, duration=0.1, parameters=MASS, initial={"pivot.angle": 0.1}, outputs=["A.x"], samples=3,
        threads=1, progress=False,
    ),
    "System.state": lambda: calling(
        rod().state, t=0.0, x=rod().initial.x, v=rod().initial.v, e=rod().initial.e, z=rod().initial.z
    ),
    "System.state_at": lambda: calling(rod().state_at, values={"pivot.angle": 0.1}, rates={"pivot.angle": 0.1}, t=0.0),
    "System.static_path": lambda: calling(leaf().static_path, start=leaf().at_rest, t_end=1.0),
    "System.stepper": lambda: calling(
        rod().stepper, dt=0.1, inputs=["pivot.angle"], outputs=["pivot.angle"], start=rod().initial, rtol=1e-6,
        atol=1e-8,
    ),
    "Stepper.reset": lambda: calling(steps().reset, start=steps().state),
    "Stepper.restore": lambda: calling(steps().restore, saved=steps().save()),
    "Stepper.step": lambda: calling(steps().step, values=[0.0]),
    "System.steady": lambda: calling(rod().steady, start=rod().initial, rates={"pivot.angle": 0.0}),
    "System.use_coordinates": changed,
    "System.vibrations": lambda: calling(leaf().vibrations, state=leaf().at_rest, count=2),
    "System.with_parameters": lambda: calling(rod().with_parameters, values={"rod.rhoA": 3.0}),
}  # fmt: skip
