"""One motion of the campaign "no step onto another branch", its judge, and the table of verdicts."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array

LEAST = 1e-3  # see Case.least
ALLOWED = 100.0  # times the error in good coordinates at the same tolerance
SAMPLES = np.linspace(0.0, 1.0, 24)  # share of the duration; the steps end elsewhere


@dataclass(frozen=True, eq=False)
class Case:
    """A model with a start, badly chosen coordinates for it, and its true motion.

    Attributes
    ----------
    name : str
        Family and number, by which it can be made again.
    model : callable() -> Model
        Without `independent`.
    good : tuple of str
        Coordinates that stay regular throughout; none if there are no such, the program's own choice then.
    candidates : tuple of str
        As many of these as there are degrees of freedom are drawn; none: the motion is simulated in the good ones.
    names : tuple of str
        Quantities that are compared.
    exact : callable() -> (callable(ndarray (nt,)) -> ndarray (len(names), nt))
        The true motion.
    size : float
        Natural scale of lengths [m].
    given : tuple of str
        The bad coordinates, if not drawn.
    least : float
        Error up to which it is right at any tolerance, in natural scales.
    worst : float
        Error from which it is on another branch although there is no regular choice to compare with.
    singular : bool
        The motion passes a singular configuration, so that it may be refused.
    duration : float
        [s]
    degrees : int
        Number of degrees of freedom; that of the good ones by default.
    """

    name: str
    model: Callable[[], fx.Model]
    good: tuple[str, ...]
    candidates: tuple[str, ...]
    names: tuple[str, ...]
    exact: Callable[[], Callable[[Array], Array]]
    size: float = 1.0
    given: tuple[str, ...] = ()
    least: float = LEAST
    worst: float = np.inf
    singular: bool = False
    duration: float = 1.0
    degrees: int = 0

    def built(self, names: Iterable[str]) -> fx.System:
        """The system in the named coordinates; in those of the program if there are none."""
        m = self.model()
        if names := tuple(names):
            m.independent(*names)
        return m.build()

    @cached_property
    def bad(self) -> tuple[str, ...]:
        """Coordinates drawn at random among those that `independent` accepts."""
        if self.given or not self.candidates:
            return self.given or self.good
        rng = np.random.default_rng(list(self.name.encode()))
        choices = list(combinations(self.candidates, self.degrees or len(self.good)))
        for i in rng.permutation(len(choices)):
            try:
                self.built(choices[int(i)])
            except fx.ConstraintError:  # dependent ones
                continue
            return choices[int(i)]
        raise AssertionError(f"{self.name}: none of {self.candidates} are accepted")

    @cached_property
    def motion(self) -> Callable[[Array], Array]:
        """The true motion: values of `names` (len(names), nt) at times (nt,)."""
        return self.exact()

    def error(self, states: Sequence[fx.State]) -> float:
        """Largest deviation from the true motion in natural scales, at all states."""
        found = np.array([[state[name] for state in states] for name in self.names])
        lengths = np.array([name.rpartition(".")[2] in ("x", "y", "z") for name in self.names])
        off = (
            np.abs(found - self.motion(np.array([state.t for state in states])))
            / np.where(lengths, self.size, 1.0)[:, None]
        )
        return float(np.max(off))


@dataclass(frozen=True)
class Verdict:
    """What became of a case in some coordinates: right, wrong or refused; error, evaluations, message."""

    case: Case
    coordinates: tuple[str, ...]
    kind: str
    error: float
    evaluations: int
    message: str = field(repr=False, default="")

    @property
    def fails(self) -> bool:
        """Whether it must not happen."""
        return self.kind == "wrong" or (self.kind == "refused" and not self.case.singular)

    def __str__(self) -> str:
        where = f"{self.case.name} in {self.coordinates or 'its own choice'}"
        return f"{where}: {self.kind}, error {self.error:.2g} {self.message}"


def run(case: Case, coordinates: Iterable[str], **options: Any) -> fx.Motion:
    """The motion as simulated in some coordinates."""
    times = SAMPLES * case.duration
    return case.built(coordinates).simulate(case.duration, times=times, progress=False, **options)


def verdict(case: Case, method: str, rtol: float, own: bool = False) -> Verdict:
    """Simulate a case in bad coordinates, or those of the program's own choice, and compare.

    It is simulated in good ones too where these decide.
    """
    coordinates = () if own else case.bad
    options: dict[str, Any] = {"method": method, "rtol": rtol, "atol": max(rtol / 100, 1e-9)}
    try:
        motion = run(case, coordinates, **options)
    except (fx.PositionError, fx.ConstraintError, fx.DynamicsError) as refusal:
        return Verdict(case, coordinates, "refused", np.nan, 0, str(refusal))
    error = case.error(motion) if len(motion) == SAMPLES.size else np.inf  # it must not end early either
    wrong = not error <= case.least and not error <= _limit(case, options)
    evaluations = motion.statistics.get("evaluations", 0)
    return Verdict(case, coordinates, "wrong" if wrong else "right", error, evaluations)


def _limit(case: Case, options: dict[str, Any]) -> float:
    """Error up to which a motion is on its branch."""
    try:
        good = case.error(run(case, case.good, **options))
    except fx.FlexelError:
        return case.least
    return max(case.least, min(ALLOWED * good, case.worst))


def table(verdicts: Iterable[Verdict]) -> str:
    """A line of counts and, below it, the failures by name."""
    verdicts = list(verdicts)
    counts = [sum(verdict.kind == kind for verdict in verdicts) for kind in ("wrong", "refused")]
    done = [verdict.evaluations for verdict in verdicts if verdict.kind != "refused"]
    median = np.median(done) if done else np.nan
    first = (
        f"{len(verdicts)} motions: {counts[0]} wrong, {counts[1]} refused; median evaluations {median:.0f}"
    )
    return "\n".join([first, *(str(verdict) for verdict in verdicts if verdict.fails)])
