"""Properties of the equations in one state: accelerations, degrees of freedom, energy, linearization."""

import numpy as np
from differences import jacobian, numerical_matrices

import flexel as fx
from campaign.changes import Inapplicable
from campaign.trial import Trial, off
from flexel.base.arrays import Array

STEPS = (
    4e-3,
    1e-3,
    2.5e-4,
    2e-5,
)  # of the differences: shorter where the equations curve much or a contact opens
SURE = 1e-7  # error from which the differences must agree with each other better than with the linearization
MANY = 4  # degrees of freedom up to which M, C, K are differentiated too


def constraints(trial: Trial) -> float:
    """The state satisfies the constraints, on both levels."""
    speed = max(1.0, float(np.max(np.abs(trial.v(trial.start)), initial=0.0)))
    return max(trial.answer.position, trial.answer.velocity / speed)


def degrees_of_freedom(trial: Trial) -> float:
    """Counts against ranks of the oracle's Jacobian, as drawn."""
    found = len(trial.system.dynamic), len(trial.system.kinematic)
    return float(np.abs(np.subtract(found, (trial.drawn.dynamic, trial.drawn.kinematic))).sum())


def redundancy(trial: Trial) -> float:
    """The number of conditions to release is that of the oracle's redundant ones."""
    if "redundant" not in trial.case.known:
        raise Inapplicable("no redundant constraints")
    return float(abs(len(trial.case.model().constraint_report().release) - trial.drawn.redundant))


def accelerations(trial: Trial) -> float:
    """Second rates of all coordinates, and rates of internal states."""
    a = trial.oracle.vector(lambda name: trial.answer.a[name], held=False)
    if trial.answer.inertia < 1e-10:
        raise Inapplicable("accelerations of massless parts are undetermined")
    scale = max(float(np.max(np.abs(a), initial=0.0)), 1.0)
    found = [off(trial.a(trial.start), a, scale)]
    found += [
        off(np.array(trial.start.rate(name)), np.array(value), 1.0) for name, value in trial.answer.zd.items()
    ]
    return max(found)


def reactions(trial: Trial) -> float:
    """Forces of the ground on fixed points."""
    found = trial.answer.reactions
    if not found or trial.answer.inertia < 1e-10:
        raise Inapplicable("no point is fixed, or redundant constraints leave its reaction open")
    reference = np.array(list(found.values()))
    return off(np.array([trial.start.force(name) for name in found]), reference, 1.0)


def energy(trial: Trial) -> float:
    """Kinetic and potential energy and that of springs, up to a constant: its change from the state at rest."""
    rest, start = trial.system.unaccelerated, trial.start
    still = trial.system.state(start.t, rest.x, 0 * rest.v, e=rest.e) if trial.moving else rest
    E = trial.energy(start) - trial.energy(still)
    if not trial.oracle.conserves:
        raise Inapplicable("energy is not conserved")
    return abs(start.energy.total - still.energy.total - E) / max(abs(E), 1e-3)


def _rates(system: fx.System, state: fx.State, values: Array) -> Array:
    """The state's rates (q_d', q_d, q_k, z) as `state_matrix` orders them."""
    nq, nd = system.roles.nq, system.roles.nd
    system.warm(state)
    y = np.concatenate([values[nd : nd + nq], values[:nd], values[nd + nq :]])
    r = system.rhs(state.t, y)
    return np.concatenate([r[nq : nq + nd], r[:nq], r[nq + nd :]])


def linearization(trial: Trial) -> float:
    """State matrix, and M, C, K of small systems, against sixth-order differences."""
    system, state = trial.system, trial.start
    if not trial.moving:
        raise Inapplicable("nothing moves freely")
    lin = system.linearize(state)
    own = lin.state_matrix, lin.M, lin.C, lin.K
    found: list[tuple[Array, ...]] = []
    for h in STEPS:
        try:
            found.append(_differences(system, state, h))
        except fx.PositionError:  # the step leads out of the range of the mechanism
            continue
        if _apart(own, found[-1]) < 1e-8:
            break
    errors = [_apart(own, matrices) for matrices in found]
    spread = [_apart(a, b) for a, b in zip(found, found[1:], strict=False)]
    if not errors or (min(errors) > SURE and (not spread or min(spread) > min(errors) / 10)):
        raise Inapplicable("the differences do not converge")
    return min(errors)


def _differences(system: fx.System, state: fx.State, h: float) -> tuple[Array, ...]:
    """The state matrix and, of a small system, M, C, K."""
    y = np.concatenate([state.qd, state.q, state.z])
    A = jacobian(lambda values: _rates(system, state, values), y, h)
    small = len(system.dynamic) <= MANY and not state.z.size
    return (A, *numerical_matrices(system, state, h)) if small else (A,)


def _apart(found: tuple[Array, ...], reference: tuple[Array, ...]) -> float:
    """The largest difference, relative to each matrix; those of a system are compared with its inertia at least."""
    scale = float(np.max(np.abs(found[1]), initial=0.0)) if len(found) > 1 else 1.0
    return max(
        off(a, b, 1.0 if i == 0 else scale) for i, (a, b) in enumerate(zip(found, reference, strict=False))
    )
