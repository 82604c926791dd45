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
    1e-4,
    1e-5,
)  # of the differences: shorter where the equations curve much, or a contact opens
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
    if not trial.drawn.redundant:
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
        off(np.array(trial.start.rate(z)), np.array(value), 1.0) for z, value in trial.answer.zd.items()
    ]
    return max(found)


def reactions(trial: Trial) -> float:
    """Forces of the ground on fixed points."""
    found = trial.answer.reactions
    if not found or trial.answer.inertia < 1e-10:
        raise Inapplicable("no point is fixed, or redundant constraints leave its reaction open")
    reference = np.array(list(found.values()))
    return off(np.array([trial.start.force(z) for z in found]), reference, 1.0)


def energy(trial: Trial) -> float:
    """Kinetic and potential energy and that of springs, up to a constant: its change from the state at rest."""
    rest, start = trial.system.unaccelerated, trial.start
    still = trial.system.state(start.t, rest.x, 0 * rest.v) if trial.moving else rest
    E = trial.energy(start) - trial.energy(still)
    if not trial.oracle.conserves:
        raise Inapplicable("energy is not conserved")
    return abs(start.energy.total - still.energy.total - E) / max(abs(E), 1e-3)


def _rates(system: fx.System, state: fx.State, z: Array) -> Array:
    """The state's rates (q_d', q_d, q_k, z) as `state_matrix` orders them."""
    nq, nd = system.roles.nq, system.roles.nd
    system.warm(state)
    y = np.concatenate([z[nd : nd + nq], z[:nd], z[nd + nq :]])
    r = system.rhs(state.t, y)
    return np.concatenate([r[nq : nq + nd], r[:nq], r[nq + nd :]])


def linearization(trial: Trial) -> float:
    """State matrix, and M, C, K of small systems, against sixth-order differences."""
    system, state = trial.system, trial.start
    if not trial.moving:
        raise Inapplicable("nothing moves freely")
    lin = system.linearize(state)
    y = np.concatenate([state.qd, state.q, state.z])
    errors = []
    for h in STEPS:
        J = jacobian(lambda z: _rates(system, state, z), y, h)
        errors.append(off(lin.state_matrix, J, 1.0))
        if len(system.dynamic) <= MANY and not state.z.size:
            errors[-1] = max(errors[-1], _matrices(system, state, lin))
        if errors[-1] < 1e-8:
            break
    return min(errors)


def _matrices(system: fx.System, state: fx.State, lin: fx.Linearization) -> float:
    M, C, K = numerical_matrices(system, state)
    scale = float(np.max(np.abs(M)))
    return max(off(lin.M, M), off(lin.C, C, scale), off(lin.K, K, scale))
