"""Choice of the degrees of freedom during a motion: their amplification, and when others are chosen.

The amplification A of a choice is how much the coordinates change per unit of the degrees of freedom, in natural
scales.  Where a degree of freedom passes its extreme it grows without bound, while other choices remain good.  So a
choice is compared with the best one at the same position, whose amplification is A*.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ConstraintError
from flexel.mechanics.amplification import amplification
from flexel.mechanics.diagnose import choose_dofs
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot
from flexel.system import CoreSystem

WORSE = 4.0  # amplification of a choice, relative to the best one's, beyond which the best one is taken; with 2 some
# random chains at rtol 1e-3 gain digits, and a parallelogram loses its branch
REFUSED = 2.0  # the same where a step was refused
HARMLESS = (
    0.5  # both, relative to that, if only Euler parameters change places: their other branch is far away
)


@dataclass
class Choices:
    """The degrees of freedom of one run.

    Attributes
    ----------
    kinematics : Kinematics
        The present ones.
    own : Kinematics
        The user's.
    free : bool
        Whether they may change.
    best : float
        Amplification A* of the best choice, when last determined; zero before, infinite at a singular position.
    share : float
        Of the factors, from which a change is considered.
    changes : list of (float, tuple of str, tuple of str)
        Times [s], old and new names.
    """

    system: CoreSystem
    kinematics: Kinematics
    free: bool
    own: Kinematics = field(init=False)
    best: float = field(init=False, default=0.0)
    share: float = field(init=False, default=1.0)
    changes: list[tuple[float, tuple[str, ...], tuple[str, ...]]] = field(init=False, default_factory=list)
    _at: Snapshot | None = field(init=False, default=None)  # where the best choice was sought last
    _there: Kinematics | None = field(init=False, default=None)

    def __post_init__(self) -> None:
        self.own = self.kinematics
        structure = self.kinematics.structure
        turning = [name for node in structure.nodes if node.kind == "frame" for name in node.coordinates]
        self._turning = frozenset(structure.find(name) for name in turning)
        self._look()

    def _look(self) -> None:
        """Whether Euler parameters are chosen: less is then enough for a change that concerns only these."""
        self.share = HARMLESS if self._turning.intersection(self.kinematics.roles.dofs.tolist()) else 1.0

    def _harmless(self, other: Kinematics) -> bool:
        """Whether another choice differs in Euler parameters alone."""
        mine, others = (set(some.roles.dofs.tolist()) for some in (self.kinematics, other))
        return mine ^ others <= self._turning

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the present degrees of freedom."""
        names = self.kinematics.structure.names
        return tuple(names[i] for i in self.kinematics.roles.dofs)

    def amplification(self, at: Snapshot) -> float:
        """Return the amplification of the present choice at a position."""
        return amplification(self.kinematics, at)

    def worse(self, at: Snapshot, present: float, factor: float) -> Kinematics | None:
        """Return the best choice at a position if the present one amplifies more by a factor; else None."""
        other = self._best(at)
        if other is None:
            return None
        share = self.share if self._harmless(other) else 1.0
        return other if present > factor * share * self.best else None

    def poor(self, at: Snapshot, present: float) -> bool:
        """Whether the best choice at a position is better than the present one by the usual factor."""
        return present > WORSE and self.worse(at, present, WORSE) is not None

    def _best(self, at: Snapshot) -> Kinematics | None:
        """Return the best choice at a position, and find its amplification; None where the position is singular."""
        if at is not self._at:
            self._there, self._at = self._best_at(at), at
        return self._there

    def _best_at(self, at: Snapshot) -> Kinematics | None:
        evaluation = self.kinematics.evaluation
        J = evaluation.position(at.x)[1]
        try:
            roles = choose_dofs(self.kinematics, J, None, None)
        except ConstraintError:
            self.best = np.inf
            return None
        found = self.system.kinematics_with(roles.dynamic, roles.kinematic)
        self.best = amplification(found, at)
        return found

    def change(self, other: Kinematics, t: float) -> None:
        """Take another choice from now on."""
        before = self.names
        self.kinematics = other
        self._look()
        self.changes.append((t, before, self.names))

    def values(self, at: Snapshot, z: Array) -> Array:
        """Return the variables y = (q, q_d', z) of the present choice at a position with rates."""
        kinematics, roles = self.kinematics, self.kinematics.roles
        q = kinematics.values(at.e, at.x)[roles.dofs]
        work = kinematics.evaluation.at(at.t, at.x, at.v, unwrap_from=at.e)
        rates = np.concatenate([work.w, at.v])[roles.dynamic]
        return np.concatenate([q, rates, z])
