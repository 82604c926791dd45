"""Properties of short motions: energy, momentum, time reversal, two methods, an interrupt."""

import warnings
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

import flexel as fx
from campaign.algebra import product
from campaign.changes import Inapplicable
from campaign.trial import ACCURATE, Trial, off
from flexel.base.arrays import Array
from flexel.parts.wheels import Tyre

STEPS = 16  # of the implicit method, at least
MORE = (1, 4, 16)  # times as many steps, where the motion is fast in other ways
ENOUGH = 1e-7  # error at which no more are tried
LONGEST = 4.0  # radians of the fastest vibration
WATCHED = 201  # instants at which a tyre is looked at for whether it leaves the road
MOVED = 1e-9  # change of a coordinate that is a motion
LAG = 0.002  # radians by which the implicit method may lag behind it


def _check_branch(trial: Trial) -> None:
    """Leave out motions that pass a flat position: rounding errors of positions turn the rates there.

    One that begins close to it may be refused at this tolerance, as it is when it goes back.
    """
    if trial.oracle.passes_flat(trial.x(trial.start), trial.x(trial.motion[-1])):
        raise Inapplicable("a flat position is passed, where rounding errors turn the rates")


def energy_kept(trial: Trial) -> float:
    """Energy by the oracle, at the end against the start."""
    if not trial.oracle.conserves:
        raise Inapplicable("energy is not conserved")
    if trial.answer.singular:  # rates follow from positions to their rounding errors by the square of the gap
        raise Inapplicable("the position is nearly singular, and its rounding errors turn the rates")
    _check_branch(trial)
    start, end = trial.start, trial.motion[-1]
    kinetic = [
        trial.energy(state) - trial.oracle.energy(trial.x(state), 0 * trial.v(state))
        for state in (start, end)
    ]
    return abs(trial.energy(end) - trial.energy(start)) / max(*kinetic, 1e-3)


def fields(trial: Trial, x: Array) -> Array:
    """Rates of all coordinates (n, 6) in unit translations along and turns about the axes."""
    F = np.zeros((x.size, 6))
    first = 0
    for node in trial.nodes.values():
        own = x[first : first + node.drawn.size]
        for k in range(3):
            e = np.eye(3)[k]
            if node.kind == "point":
                F[first : first + 3, k], F[first : first + 3, 3 + k] = e, np.cross(e, own)
            else:
                F[first : first + 4, 3 + k] = product(np.array([0.0, *e]), own) / 2
        first += node.drawn.size
    return F


def momentum(trial: Trial) -> float:
    """Momentum and, without gravity, angular momentum of what floats."""
    if "floating" not in trial.case.known:
        raise Inapplicable("the ground reacts")
    start, end = trial.start, trial.motion[-1]
    p = []
    for state in (start, end):
        x = trial.x(state)
        F = fields(trial, x)
        p.append(F.T @ trial.oracle.inertia(x) @ trial.v(state))
        mass = float(F[:, 0] @ trial.oracle.inertia(x) @ F[:, 0])
    weight = mass * np.array(trial.case.gravity) * (end.t - start.t)
    rows = 3 if np.any(weight) else 6
    return off(p[1][:rows], (p[0] + np.array([*weight, 0, 0, 0]))[:rows], 1.0)


def time_reversal(trial: Trial) -> float:
    """With all velocities reversed the motion goes back to where it began."""
    if not trial.oracle.conserves:
        raise Inapplicable("energy is not conserved")
    _check_branch(trial)
    end = trial.motion[-1]
    back = trial.system.state(end.t, end.x, -end.v, e=end.e)
    again = trial.moved(trial.system, back, trial.case.duration)[-1]
    return float(np.max(np.abs(trial.x(again) - trial.x(trial.start))))


def implicit(trial: Trial) -> float:
    """The implicit method, extrapolated from two steps by its order, against the explicit one.

    The motion is as short, and the steps are as many, as the fastest vibration asks for.
    """
    if not trial.moving:
        raise Inapplicable("nothing moves freely")
    A = trial.system.linearize(trial.start).state_matrix
    fastest = float(np.max(np.abs(np.linalg.eigvals(A)), initial=0.0))
    duration = min(trial.case.duration, LONGEST / max(fastest, 1e-3))
    if _lifts(trial, duration):
        raise Inapplicable("a tyre leaves the road, where forces jump")
    count = max(STEPS, round(((fastest * duration) ** 3 / 12 / LAG) ** 0.5))
    end = trial.x(trial.moved(trial.system, trial.start, duration)[-1])
    errors: list[float] = []
    for more in MORE:
        coarse, fine = (_implicit(trial, duration, more * n) for n in (count, 2 * count))
        errors.append(float(np.max(np.abs((4 * fine - coarse) / 3 - end))))
        if errors[-1] < ENOUGH:
            break
    return errors[-1]


def _lifts(trial: Trial, duration: float) -> bool:
    """Whether a tyre leaves the road or comes down on it; the order of the method holds for smooth forces."""
    tyres = [f"{part.name}.deflection" for part in trial.case.parts if isinstance(part, Tyre)]
    if not tyres:
        return False
    motion = trial.system.simulate(duration, start=trial.start, samples=WATCHED, progress=False, **ACCURATE)
    return any(np.min(motion[name]) < 0 < np.max(motion[name]) for name in tyres)


def _implicit(trial: Trial, duration: float, count: int) -> Array:
    with warnings.catch_warnings():
        warnings.simplefilter(
            "ignore", fx.DampingWarning
        )  # of constant steps: their error is extrapolated, and judged
        motion = trial.system.simulate(
            duration,
            start=trial.start,
            samples=2,
            method="generalized-alpha",
            step=duration / count,
            progress=False,
        )
    return trial.x(motion[-1])


def continued(trial: Trial) -> float:
    """A motion continued from a file against the uninterrupted one."""
    end, half = trial.motion[-1], trial.case.duration / 2
    first = trial.moved(trial.system, trial.start, half)
    with TemporaryDirectory() as folder:
        file = Path(folder) / "motion.npz"
        first.save(file)
        saved = fx.load(file)
    system = trial.model().build()
    last = trial.moved(system, system.restore(saved), half)[-1]
    return float(np.max(np.abs(trial.x(last) - trial.x(end))))


def loose_part(trial: Trial) -> float:
    """With a point that moves no mass and that nothing holds, every method refuses the motion and names the point."""
    if not trial.moving:
        raise Inapplicable("nothing moves freely")
    start, end = trial.system.simulate(trial.case.duration, samples=2)
    if np.abs(end.x - start.x).max() < MOVED:
        raise Inapplicable("nothing moves from rest")
    m = trial.model()
    m.point("loose part", np.zeros(len(trial.case.gravity)))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", fx.ModelWarning)
        system = m.build()
    silent = 0
    for method in ("DOP853", "generalized-alpha"):
        try:
            system.simulate(trial.case.duration, method=method, samples=2)
        except fx.FlexelError as error:
            silent += "'loose part." not in str(error)
        else:
            silent += 1
    return float(silent)
