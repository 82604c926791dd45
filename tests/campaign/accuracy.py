"""How accurate a motion is, by two references and the growth of a perturbation; see docs/verification.md.

A quantity is a coordinate, its rate, a deformation or an internal state.  Its error is the largest difference from the
reference at the stored times, relative to its range in this motion.  The bound is ``FACTOR * rtol * A``; A >= 1 is how
much a perturbation of the start, relative to the ranges, has grown in this quantity.  A quantity is decided where two
references differ by less than a tenth of the bound.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array, Index

FACTOR = 20.0  # errors of so many tolerances are admitted
SURER = 10.0  # times better than the bound must references agree
PERTURBATION = 1e-7  # of a degree of freedom and of its rate, relative to their ranges
SATURATED = 0.1  # of a range: a perturbation that becomes larger than this no longer grows as small ones do
STILL = 1e-12  # of the largest value or range of its kind: a quantity that moves less is still
EPSILON, LOOKS = np.finfo(float).eps, 20  # of rounding; states at which its effect is computed
DEFAULT, IMPLICIT = 1e-9, 1e-6  # tolerances that the methods promise, if none is given
CHOSEN = re.compile(r"\((DOP853|Radau|generalized-alpha), chosen because")
LOOSE = re.compile(r"at rtol = ([0-9.e+-]+);")


@dataclass(frozen=True)
class Accuracy:
    """A method with its tolerance, and how many steps it takes at least."""

    method: str
    rtol: float
    pieces: int


FIRST = Accuracy("DOP853", 1e-12, 120)
SECOND = Accuracy("DOP853", 3e-13, 187)
IMPLICITLY = Accuracy("Radau", 1e-11, 187)
BESIDE = Accuracy("DOP853", 1e-11, 120)  # for the growth of a perturbation


@dataclass(frozen=True)
class Histories:
    """Quantities over time.

    Attributes
    ----------
    names : tuple of str (n,)
    values : ndarray (nt, n)
    kinds : ndarray of int (n,)
        The same for quantities whose sizes are compared: those of one unit.
    """

    names: tuple[str, ...]
    values: Array
    kinds: Array

    @property
    def ranges(self) -> Array:
        """Largest less smallest value (n,)."""
        return np.asarray(np.ptp(self.values, axis=0))

    @property
    def moving(self) -> Array:
        """Whether a quantity moves by more than rounding (n,)."""
        size = np.max(np.abs(self.values), axis=0)
        moving = self.ranges > STILL * size
        for kind in np.unique(self.kinds):
            own = self.kinds == kind
            moving[own] &= self.ranges[own] > STILL * np.max(self.ranges[own])
        return np.asarray(moving)


def histories(motion: fx.Motion) -> Histories:
    """All coordinates that are not fixed, their rates, deformations that are not rigid, and internal states."""
    s = motion.structure
    free = _free(motion)
    coordinates, deformations = s.names[s.m + s.k :][: s.nf], (s.names[i] for i in free)
    names = (*coordinates, *(f"{name}'" for name in coordinates), *deformations, *s.internal)
    values = np.array(
        [np.concatenate([state.x[: s.nf], state.v[: s.nf], state.e[free], state.z]) for state in motion]
    )
    units: dict[str, int] = {}
    kinds = np.array([units.setdefault(_unit(motion, name), len(units)) for name in names], int)
    return Histories(names, values, kinds)


def _free(motion: fx.Motion) -> Index:
    """Places of the deformations that are not rigid."""
    return np.setdiff1d(np.arange(motion.structure.m), motion[0].roles.rigid)


def _unit(motion: fx.Motion, name: str) -> str:
    return motion.unit(name) if name not in motion.structure.internal else "internal"


def promised(motion: fx.Motion, rtol: float | None = None) -> float:
    """The tolerance for which the method of a motion was chosen; `rtol` if that was given."""
    if rtol is not None:
        return rtol
    chosen, loose = CHOSEN.search(motion.message), LOOSE.search(motion.message)
    if loose is not None:
        return float(loose[1])
    return IMPLICIT if chosen is not None and chosen[1] == "generalized-alpha" else DEFAULT


@dataclass(frozen=True)
class Judgement:
    """Errors of a motion and their bounds; all arrays (n,).

    Attributes
    ----------
    names : tuple of str (n,)
    errors, bounds : ndarray
        Relative to the ranges; the bound is `FACTOR` rtol A.
    growth : ndarray
        A.
    doubts : ndarray
        Differences of the references.
    moving : ndarray of bool
        Quantities that have a range.
    """

    names: tuple[str, ...]
    errors: Array
    bounds: Array
    growth: Array
    doubts: Array
    moving: Array

    @property
    def decided(self) -> Array:
        """Whether the references agree well enough, and the bound means something."""
        return np.asarray(self.moving & (self.doubts * SURER <= self.bounds) & (self.bounds < 1.0))

    @property
    def wrong(self) -> Array:
        """Quantities whose error is beyond the bound."""
        return np.asarray(self.decided & ~(self.errors <= self.bounds))

    @property
    def undecided(self) -> Array:
        """Quantities that cannot be decided."""
        return np.asarray(self.moving & ~self.decided)

    @property
    def excess(self) -> float:
        """Largest error over its bound, of what is decided."""
        return float(np.max(self.errors[self.decided] / self.bounds[self.decided], initial=0.0))

    @property
    def worst(self) -> str:
        """The quantity with the largest error over its bound, with numbers."""
        if not np.any(self.decided):
            return ""
        ratio = np.where(self.decided, self.errors / self.bounds, -1.0)
        i = int(np.argmax(ratio))
        return f"{self.names[i]}: {ratio[i]:.2g} times the bound (error {self.errors[i]:.1e}, A {self.growth[i]:.2g})"


@dataclass(frozen=True)
class References:
    """Two accurate motions, and the first one from a perturbed start."""

    first: fx.Motion
    second: fx.Motion
    perturbed: fx.Motion


def references(
    system: fx.System,
    start: fx.State,
    duration: float,
    atol: float,
    fine: int,
    implicit: bool,
    looser: float = 1.0,
) -> References:
    """The references of a motion; the second one is implicit for one that is stiff.

    Parameters
    ----------
    system : System
    start : State
    duration : float
        [s]
    atol : float
        Absolute tolerance in natural scales.
    fine : int
        How many times `PIECES` steps are taken at least.
    implicit : bool
    looser : float
        Factor of the relative tolerances of the references.
    """
    one, other = (
        replace(reference, rtol=looser * reference.rtol)
        for reference in (FIRST, IMPLICITLY if implicit else SECOND)
    )
    first = tight(system, start, duration, one, atol, fine)
    second = tight(system, start, duration, other, atol, fine)
    beside = perturbed_start(system, start, first)
    return References(first, second, tight(system, beside, duration, BESIDE, atol, fine))


def judge(found: fx.Motion, known: References, rtol: float) -> Judgement:
    """Hold a motion against its references."""
    motions = found, known.first, known.second, known.perturbed
    return judged(*map(histories, motions), rtol, rounding(known.first))


def rounding(motion: fx.Motion) -> Array:
    """Errors (n,) that rounding in the conditions of positions makes in quantities of `histories`, at some states.

    Near flat positions a condition hardly depends on coordinates, and they are known to so much less.  Rates follow
    from conditions whose derivatives have these errors.
    """
    system, s = motion._system, motion.structure
    assert system is not None
    coordinates = s.m + s.k + np.arange(s.nf)
    free = _free(motion)
    found, deformed = np.zeros((2, s.nf)), np.zeros(free.size)
    for state in motion[:: max(1, len(motion) // LOOKS)]:
        kinematics = system.kinematics_of(state.roles)
        choice = kinematics.given(state.t)
        choice.reset()
        choice.work.x[:], choice.work.unwrap_from[:] = state.x, state.e
        choice.work.position()
        choice.factorize()
        sensitivity, scales = choice.sensitivity(), kinematics.scales(coordinates)
        fastest = float(np.max(np.abs(state.v[: s.nf]) / scales, initial=0.0))
        off = EPSILON * sensitivity * np.array([1.0, sensitivity * fastest])
        found = np.maximum(found, off[:, None] * scales)
        deformed = np.maximum(deformed, off[0] * kinematics.scales(free))
    return np.concatenate([*found, deformed, np.zeros(len(s.internal))])


def judged(
    found: Histories,
    reference: Histories,
    second: Histories,
    perturbed: Histories,
    rtol: float,
    rounded: Array | float = 0.0,
) -> Judgement:
    """Errors of histories; `perturbed` is the reference from a perturbed start, `rounded` has errors of rounding."""
    ranges, moving = reference.ranges, reference.moving
    safe = np.where(moving, ranges, 1.0)

    def off(a: Histories) -> Array:
        if a.values.shape != reference.values.shape:
            return np.full(safe.size, np.inf)  # it ended early
        return np.asarray(np.max(np.abs(a.values - reference.values), axis=0) / safe)

    grown = off(perturbed)
    growth = np.maximum(grown / PERTURBATION, 1.0)
    doubts = np.where(
        grown > SATURATED, np.inf, np.maximum(off(second), rounded / safe)
    )  # the growth is not known
    return Judgement(reference.names, off(found), FACTOR * rtol * growth, growth, doubts, moving)


def perturbed_start(system: fx.System, start: fx.State, motion: fx.Motion, seed: int = 0) -> fx.State:
    """The start with degrees of freedom and rates changed by `PERTURBATION` of their ranges in a motion, up or down."""
    rng = np.random.default_rng([seed, len(system.dynamic)])
    values, rates = {}, {}
    for name in system.dynamic:
        up, faster = rng.choice([-1.0, 1.0], 2)
        values[name] = float(start[name] + up * PERTURBATION * np.ptp(motion[name]))
        rates[name] = float(start.rate(name) + faster * PERTURBATION * np.ptp(motion.rate(name)))
    kept = {name: float(start[name]) for name in system.kinematic}
    return system.state_at(values | kept, rates, start.t, start)


def tight(
    system: fx.System,
    start: fx.State,
    duration: float,
    accuracy: Accuracy,
    atol: float,
    fine: int = 1,
    **more: Any,
) -> fx.Motion:
    """An accurate motion; its steps are short enough for nothing to be stepped over."""
    return system.simulate(
        duration,
        start=start,
        method=accuracy.method,
        rtol=accuracy.rtol,
        atol=atol,
        max_step=duration / (fine * accuracy.pieces),
        progress=False,
        **more,
    )


def event_times(motion: fx.Motion) -> Array:
    """Times of all events [s]."""
    return np.array([state.t for _, state in motion.events])


def passing_times(
    system: fx.System, motion: fx.Motion, event: fx.Event, accuracy: Accuracy, atol: float, fine: int
) -> Array:
    """Times [s] at which an event happens in an accurate motion, located between its stored states."""
    values = np.array([event.function(state) for state in motion])
    found = []
    for i in np.flatnonzero(values[:-1] * values[1:] < 0).tolist():
        duration = motion[i + 1].t - motion[i].t
        once = replace(accuracy, pieces=1)
        found.append(event_times(tight(system, motion[i], duration, once, atol, fine, events=[event])))
    return np.concatenate([[], *found])


def differ(first: Sequence[float], second: Sequence[float]) -> float:
    """Largest difference of two lists of times; infinite if one has more."""
    a, b = np.asarray(first), np.asarray(second)
    if a.shape != b.shape:
        return float("inf")
    return float(np.max(np.abs(a - b), initial=0.0))
