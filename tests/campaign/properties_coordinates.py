"""Properties under another choice of degrees of freedom, also a bad one."""

import numpy as np

import flexel as fx
from campaign.changes import Inapplicable
from campaign.oracle import RANK
from campaign.trial import Trial, off
from flexel.base.arrays import Array

NEAR = 1e-3  # smallest singular value of constraints at an equilibrium that is examined
NOISE = 1e-5  # of the rate at which a pendulum of the model's size swings: what smaller eigenvalues are
BAD = 0.03  # of the motion left by the coordinates chosen before, the least that a further one must show


def free_motions(trial: Trial, x: Array, v: Array) -> Array:
    """An orthonormal basis (n, nd) of the rates that all constraints admit."""
    _, C, _, _ = trial.oracle.holonomic(x, v, trial.start.t)
    S, _ = trial.oracle.rolling(x, v)
    A = np.concatenate([C, S])[:, trial.oracle.free]
    if not len(A):
        return np.eye(trial.oracle.free.size)
    _, s, Vt = np.linalg.svd(A)
    return np.asarray(Vt[int(np.sum(s > RANK * s[0])) :].T)


def other_names(trial: Trial, x: Array, v: Array) -> tuple[str, ...]:
    """Coordinates that determine the motion as drawn, picked in a scattered order that the case fixes; often bad ones.

    Raises
    ------
    Inapplicable
        If there are no others, or they do not determine the motion in the state x, v.
    """
    drawn = trial.oracle.drawn
    Z = free_motions(trial, drawn, 0 * drawn)
    names = [trial.oracle.names[i] for i in trial.oracle.free]
    rng = np.random.default_rng([round(1e3 * abs(rate)) for rate in trial.case.rates])
    chosen: list[str] = []
    left = Z.copy()
    for i in rng.permutation(len(names)):
        size = float(np.linalg.norm(left[i]))
        if size > BAD and len(chosen) < Z.shape[1]:
            chosen.append(names[i])
            row = left[i] / size
            left = left - np.outer(left @ row, row)
    if len(chosen) < Z.shape[1] or set(chosen) == set(trial.system.dynamic):
        raise Inapplicable("no other coordinates at hand")
    rows = [i for i, k in enumerate(trial.oracle.free) if trial.oracle.names[k] in chosen]
    if np.linalg.svd(free_motions(trial, x, v)[rows])[1][-1] < NEAR:
        raise Inapplicable("other coordinates are nearly singular in the state")
    return tuple(chosen)


def in_others(trial: Trial) -> tuple[fx.System, fx.State]:
    """The system in other degrees of freedom, and its start."""
    start = trial.start
    if not trial.moving:
        raise Inapplicable("nothing moves freely")
    names = other_names(trial, trial.x(start), trial.v(start))

    def made() -> fx.System:
        m = trial.model()
        m.independent(*names)
        return m.build()

    system = trial.keep(names, made)
    return system, system.state(start.t, start.x, start.v, z=start.z)


def other_coordinates(trial: Trial) -> float:
    """Accelerations in other degrees of freedom are the same."""
    _, same = in_others(trial)
    a = trial.a(trial.start)
    return off(trial.a(same), a, max(1.0, float(np.max(np.abs(a), initial=0.0))))


def motion_in_others(trial: Trial) -> float:
    """The end of a motion that starts in other degrees of freedom."""
    end = trial.moved(*in_others(trial), trial.case.duration)[-1]
    return float(np.max(np.abs(trial.x(end) - trial.x(trial.motion[-1]))))


def eigenvalues(trial: Trial) -> float:
    """Eigenvalues about an equilibrium do not depend on the choice of degrees of freedom."""
    if not trial.moving or not trial.oracle.conserves or trial.system.kinematic:
        raise Inapplicable("no equilibrium is looked for")
    if "adrift" in trial.case.known:
        raise Inapplicable("nothing holds it")
    try:
        rest = trial.system.equilibrium(stable=True)
    except (fx.PositionError, fx.DynamicsError):
        raise Inapplicable("no equilibrium is found") from None
    if trial.oracle.solve(trial.x(rest), trial.v(rest), {}, rest.t).gap < NEAR or folded(trial, rest):
        raise Inapplicable("the equilibrium is nearly singular")
    m = trial.model()
    m.independent(*other_names(trial, trial.x(rest), trial.v(rest)))
    other = m.build()
    second = other.linearize(other.state(rest.t, rest.x, 0 * rest.v, e=rest.e))
    values = trial.system.linearize(rest).eigenvalues()
    if neutral(trial, values):
        raise Inapplicable("nothing holds it")
    return polynomials(values, second.eigenvalues())


def neutral(trial: Trial, values: Array) -> bool:
    """Whether all eigenvalues are rounding errors of stiffnesses, as in a linkage that moves in a horizontal plane."""
    size = float(np.ptp(trial.oracle.drawn[trial.oracle.free]))
    pendulum = (float(np.linalg.norm(trial.case.gravity)) / max(size, 1e-3)) ** 0.5
    return bool(np.max(np.abs(values), initial=0.0) < NOISE * pendulum)


def folded(trial: Trial, state: fx.State) -> bool:
    """Whether a condition hardly depends on the coordinates any more, as where a rigid element is twisted by 90°."""
    oracle, still = trial.oracle, 0 * trial.oracle.drawn
    here, drawn = (
        np.linalg.norm(oracle.holonomic(x, still, state.t)[1][:, oracle.free], axis=1)
        for x in (trial.x(state), oracle.drawn)
    )
    return bool(np.any(here < NEAR * drawn))


def polynomials(first: Array, second: Array) -> float:
    """Difference of two spectra by the coefficients of their polynomials, which multiple roots leave smooth."""
    scale = max(float(np.max(np.abs(first))), 1e-3)
    return off(np.poly(second / scale), np.poly(first / scale), 1.0)
