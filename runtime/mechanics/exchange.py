"""Other degrees of freedom, so that values can be given to quantities that are none."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from flexel.base.arrays import Index
from flexel.base.errors import ModelError
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.travel import motions
from flexel.model.snapshot import Snapshot
from flexel.model.state import State

Exchange = Callable[[Index, Index], Kinematics]  # for dynamic and kinematic degrees of freedom
LOST = 1e-8  # motion of a quantity beside the others, in natural scales, that is none


def exchanged(kinematics: Kinematics, exchange: Exchange, start: State, names: Sequence[str]) -> Kinematics:
    """Return the kinematics in which the named quantities are degrees of freedom.

    Each takes the place of the one with which it moves most at the start.

    Raises
    ------
    ModelError
        Names a quantity that is fixed, or determined by the others.
    """
    roles, structure = kinematics.roles, kinematics.structure
    rows = [structure.find(name, "state_at") for name in names]
    others = [row for row in rows if row not in roles.dofs]
    if not others:
        return kinematics
    dofs = roles.dofs.copy()
    moved = motions(kinematics, Snapshot.of(start))[:, others]
    rates = moved.T / kinematics.scales(np.array(others))[:, None]
    free = np.array([row not in rows for row in dofs], dtype=bool)
    for k, row in enumerate(others):
        sizes = np.where(free, np.abs(rates[k]), 0.0)
        j = int(np.argmax(sizes)) if sizes.size else 0
        if not sizes.size or sizes[j] < LOST:
            present = kinematics.names(roles.dofs) or "nothing: all motion is prescribed, or held"
            raise ModelError(
                f"'{structure.names[row]}' is not a degree of freedom, and does not move at this start while the other "
                f"named values stay; values can be given to {present}"
            )
        rates -= np.outer(rates[:, j] / rates[k, j], rates[k]) * (np.arange(len(others)) > k)[:, None]
        dofs[j], free[j] = row, False
    return exchange(dofs[: roles.nd], dofs[roles.nd :])
