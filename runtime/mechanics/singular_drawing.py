"""Tells a drawing in a singular position from a mechanism with too many constraints, which has them elsewhere too."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ConstraintError
from flexel.base.null_space import null_space
from flexel.base.shown import quoted
from flexel.mechanics.diagnose import largest
from flexel.mechanics.kinematics import Configuration, Kinematics
from flexel.model.constraints import flexible

LARGEST = 300  # free coordinates up to which it is looked for
STEP = 0.05  # distance to another position, in natural scales
DIRECTIONS = 3  # in which one is looked for
ITERATIONS, REACHED = 20, 1e-10  # of Newton's method, and residual in natural scales


class SingularDrawingError(ConstraintError):
    """Conditions are not independent as drawn, but are elsewhere: no condition is to be released."""


def singular_drawing(kinematics: Kinematics, drawn: Configuration) -> SingularDrawingError | None:
    """Return the error of a drawing at a dead centre, or flat; None if its constraints are redundant elsewhere too.

    Also None if stiff directions of flexible elements are among them: a flexure that bends far may have none to spare,
    but is drawn as it is used.
    """
    structure, roles, nf = kinematics.structure, kinematics.roles, kinematics.structure.nf
    if nf > LARGEST or kinematics.evaluation.large:
        return None
    rows = np.concatenate([roles.holonomic, roles.zero])
    left = null_space(drawn.J[rows, :nf], nf)[1]
    motions = null_space(drawn.J[roles.rigid, :nf], nf)[0]
    if not left.shape[1] or not motions.shape[1]:
        return None
    concerned = list(dict.fromkeys(name for column in left.T for name in largest(structure, rows, column)))
    if flexible(structure).intersection(concerned):
        return None
    random = np.random.default_rng(0)
    for _ in range(DIRECTIONS):
        J = _moved(kinematics, drawn, motions @ random.normal(size=motions.shape[1]))
        if J is not None and null_space(J[rows, :nf], nf)[1].shape[1] < left.shape[1]:
            return SingularDrawingError(
                f"the drawing is in a singular position, such as a dead centre, or flat: {quoted(concerned[:10])} are "
                "not independent there, but are in other positions; draw it a little aside"
            )
    return None


def _moved(kinematics: Kinematics, drawn: Configuration, direction: Array) -> Array | None:
    """Return J at another position of the mechanism, without its prescribed motions; None if none is found."""
    rigid, nf = kinematics.roles.rigid, kinematics.structure.nf
    size = float(np.max(np.abs(direction) * kinematics.lists.step_weight))
    x = drawn.x.copy()
    x[:nf] += STEP / size * direction
    for _ in range(ITERATIONS):
        e, J = kinematics.evaluation.position(x, drawn.e)
        off = e[rigid] / kinematics.scales(rigid)
        if np.max(np.abs(off)) < REACHED:
            return np.asarray(J)
        x[:nf] -= np.linalg.lstsq(J[rigid, :nf], e[rigid], rcond=1e-9)[0]
    return None
