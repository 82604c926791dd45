"""Laws that depend on time: analyses of periodic or steady motions must account for them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import LinearizationError, PositionError
from flexel.engine.evaluate import Evaluation
from flexel.generated._kernels import lib
from flexel.model.callbacks import Callback
from flexel.model.instances import LawInstance
from flexel.model.state import State
from flexel.model.structure import Structure

LATER = 1.0  # [s], after which a controller is asked again
SAME = 1e-9  # change of a stress within a period, relative to the largest, that is rounding of the time
Forces = tuple[Array, Array, Array]  # stresses, and their derivatives by values and by rates


def timed_law(structure: Structure) -> LawInstance | None:
    """Return the first law whose formula contains the time; None without one."""
    return next((law for law in structure.laws if law.spec.timed), None)


def described(law: LawInstance) -> str:
    """Name a law by the first quantity on which it acts."""
    return f"the law of '{(*law.deformations, *law.slips)[0]}' depends on time"


def refuse_steady(structure: Structure) -> None:
    """Raise if a law depends on time: no motion is then steady.

    Raises
    ------
    PositionError
    """
    law = timed_law(structure)
    if law is not None:
        raise PositionError(
            f"steady: {described(law)}, so no motion is steady; simulate it, or find an equilibrium at a given time"
        )


def refuse_speeds(evaluation: Evaluation, state: State) -> None:
    """Raise if a law depends on time, where a system runs faster or slower; a controller is tried at a state.

    Raises
    ------
    LinearizationError
    """
    law = timed_law(evaluation.structure)
    if law is None:
        now, later = ([_forces(evaluation, state, state.t + after)] for after in (0.0, LATER))
        law = next(
            (law for law in _calling(evaluation.structure) if _changed(evaluation, law, now, later)),
            None,
        )
    if law is not None:
        raise LinearizationError(
            f"periodic_branch: {described(law)}, and its speed is not known; use a load or a prescribed motion"
        )


def check_period(evaluation: Evaluation, states: Sequence[State], period: float) -> None:
    """Check that laws which depend on time have the same stresses one period later.

    Parameters
    ----------
    evaluation : Evaluation
    states : sequence of State
        Of the motion, over the period.
    period : float
        [s]

    Raises
    ------
    LinearizationError
        Names the law.
    """
    laws = [
        *(law for law in evaluation.structure.laws if law.spec.timed),
        *_calling(evaluation.structure),
    ]
    if not laws:
        return
    now, later = (
        [_forces(evaluation, state, state.t + after) for state in states] for after in (0.0, period)
    )
    for law in laws:
        if _changed(evaluation, law, now, later):
            raise LinearizationError(
                f"periodic: {described(law)}, but not with the period {period:g} s: its force or its stiffness "
                "differs one period later; give a period of the law"
            )


def _calling(structure: Structure) -> list[LawInstance]:
    """Return the laws of controllers that act on something: their functions may depend on time."""
    acting = [law for law in structure.laws if law.deformations or law.slips]
    return [law for law in acting if isinstance(law.code, Callback)]


def _changed(
    evaluation: Evaluation, law: LawInstance, now: Sequence[Forces], later: Sequence[Forces]
) -> bool:
    """Whether stresses of a law, or their derivatives, differ by more than rounding."""
    structure = evaluation.structure
    acting = [structure.find(name) for name in (*law.deformations, *law.slips)]
    pairs = np.isin(evaluation.tables.law.codes // max(structure.m + structure.k, 1), acting)
    for kind, rows in enumerate((np.array(acting), pairs, pairs)):
        both = np.array([[forces[kind][rows] for forces in states] for states in (now, later)])
        if np.abs(both[1] - both[0]).max(initial=0.0) > SAME * np.abs(both).max(initial=0.0):
            return True
    return False


def _forces(evaluation: Evaluation, state: State, t: float) -> Forces:
    """Return the stresses (m + k,) of laws for the position and rates of a state, and their derivatives."""
    work = evaluation.at(t, state.x, state.v, z=state.z, unwrap_from=state.e)
    work.laws()
    stress, pairs = work.law_stress.copy(), work.tables.law.codes.size
    lib.flexel_law_tangents(work.struct, 0.0, 0)
    return stress, work.S[:pairs].copy(), work.S_rate[:pairs].copy()
