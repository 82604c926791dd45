"""Times chains in Pinocchio: joint coordinates and the articulated-body algorithm, and its variant for closed loops."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from bench import chains
from bench.timing import Work
from flexel.base.arrays import Array
from flexel.examples import linkages

LARGEST = {
    "scaling_chain": 250,
    "scaling_ladder": 125,
}  # its data hold tensors n x n x n: 1 GB for 250 joints
PROXIMAL = (1e-8, 3e-4, 30)  # accuracy, damping, most iterations: the fastest found with errors below 1e-6
THIN = 1e-9  # radius of bars [m]


def chain(n: int, closed: bool = False) -> Any:
    """Build the chain of `chains.chain`: joints about y, counted from the directions in which the rods are drawn."""
    import pinocchio as pin

    model, joint = pin.Model(), 0
    model.gravity.linear = np.array([0, 0, -chains.GRAVITY])
    tip = np.array([chains.LENGTH, 0, 0])
    body = pin.Inertia(chains.MASS, tip / 2, np.diag(chains.INERTIA))
    for i, turn in enumerate(np.diff(chains.drawn(n, closed), prepend=0.0)):
        place = pin.SE3(pin.utils.rotate("y", turn), 0 * tip if i == 0 else tip)
        joint = model.addJoint(joint, pin.JointModelRY(), place, f"h{i + 1}")
        model.appendBodyToJoint(joint, body, pin.SE3.Identity())
    return model


def right_hand_side(n: int, closed: bool = False) -> Work:
    """Time accelerations of the joints at the states of `chains.right_hand_side`."""
    import pinocchio as pin

    model = chain(n, closed)
    state = chains.moving(n, closed)
    states = [(state.angles + step, state.rates + step) for step in (0.0, 1e-6)]
    hinges: list[Any] = []
    if closed:
        x, z = chains.tip(chains.drawn(n, closed))[0]
        end, held = (pin.SE3(np.eye(3), np.array(place)) for place in ((chains.LENGTH, 0, 0), (x, 0, z)))
        hinges.append(pin.RigidConstraintModel(pin.ContactType.CONTACT_3D, model, n, end, 0, held))
    return Work(accelerations(model, states, hinges), lambda rates: state.error(rates[0]), count=2)


def ladder_side(n: int) -> Work:
    """Time accelerations of cranks and couplers at the states of `chains.ladder`."""
    import pinocchio as pin

    model = pin.Model()
    model.gravity.linear = np.array([0, -linkages.GRAVITY, 0])
    tip, end = (pin.SE3(np.eye(3), np.array([x, 0, 0])) for x in (linkages.CRANK, linkages.SPACING))
    hinges: list[Any] = []
    q: list[float] = []
    v: list[float] = []
    coupler = 0

    def add(parent: int, place: Any, length: float, angle: float, rate: float) -> int:
        bar = pin.Inertia.FromCylinder(linkages.MASS * length, THIN, length)
        middle = pin.SE3(pin.utils.rotate("y", np.pi / 2), np.array([length / 2, 0, 0]))
        joint = int(model.addJoint(parent, pin.JointModelRZ(), place, f"j{len(q)}"))
        model.appendBodyToJoint(joint, bar, middle)
        q.append(angle)
        v.append(rate)
        return joint

    for i in range(n):  # a crank, then the coupler that it carries: a tree must be built branch by branch
        pivot = pin.SE3(np.eye(3), np.array([linkages.SPACING * i, 0, 0]))
        crank = add(0, pivot, linkages.CRANK, linkages.ANGLE, linkages.RATE)
        if i:
            hinges.append(
                pin.RigidConstraintModel(pin.ContactType.CONTACT_3D, model, coupler, end, crank, tip)
            )
        if i < n - 1:
            coupler = add(crank, tip, linkages.SPACING, -linkages.ANGLE, -linkages.RATE)
    states = [(np.array(q) + step, np.array(v) + step) for step in (0.0, 1e-6)]
    run = accelerations(model, states, hinges)
    return Work(run, lambda rates: abs(float(rates[0][0]) / linkages.cranks_acceleration(n) - 1), count=2)


def accelerations(
    model: Any, states: Sequence[tuple[Array, Array]], hinges: Sequence[Any]
) -> Callable[[], Any]:
    """Return a function for the accelerations of the joints in some states, with or without loops closed by hinges."""
    import pinocchio as pin

    data, rest = model.createData(), np.zeros(model.nv)
    if not hinges:
        return lambda: [pin.aba(model, data, q, v, rest).copy() for q, v in states]
    constraints, found = pin.StdVec_RigidConstraintModel(), pin.StdVec_RigidConstraintData()
    for hinge in hinges:
        constraints.append(hinge)
        found.append(hinge.createData())
    settings = pin.ProximalSettings(*PROXIMAL)
    pin.computeJointMinimalOrdering(model, data, constraints)
    loops = constraints, found, settings
    return lambda: [pin.lcaba(model, data, q, v, rest, *loops).copy() for q, v in states]


ROWS: dict[str, Callable[..., Work]] = {
    "chain_40": partial(right_hand_side, 40),
    "chain_100": partial(right_hand_side, 100),
    "chain_40_closed": partial(right_hand_side, 40, True),
    "chain_100_closed": partial(right_hand_side, 100, True),
    "scaling_chain": right_hand_side,
    "scaling_ladder": ladder_side,
}
