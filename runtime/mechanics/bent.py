"""Elements that are bent or twisted beyond the range of their deformations.

Deformations of beams are sines of angles times the length: an end moment that turns the ends by φ against one another
is too small by φ²/6 of its size, a torsional moment by 1 - sin 2φ/2φ.  Source: Jonker and Meijaard (2013), Int. J.
Non-Linear Mech. 53, for the deformations.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

import numpy as np
from numpy.typing import ArrayLike

from flexel.base.arrays import Array, Index
from flexel.base.callers import outside
from flexel.base.errors import RangeWarning
from flexel.mechanics.sheared import shear_angles, shear_numbers, warn_sheared
from flexel.mechanics.turned import warn_turned
from flexel.structure.structure import Structure

FAR = 15.0  # angle within one element [°] at which moments have errors of 1 % (bending) and 4.5 % (torsion)
TWIST, BENDS = "twist", ("bend_y", "bend_z")
_part_of_another: ContextVar[bool] = ContextVar("part_of_another", default=False)


class Turns:
    """The elements whose deformations are sines of angles times their length.

    Attributes
    ----------
    names : list of str (elements,)
    lengths : ndarray (elements,)
    twist : ndarray of int (elements,)
        Deformations of twist by number; -1 for none.
    bends : ndarray of int (elements, 2, 2)
        By plane those of both ends; -1 for none.
    shear : ndarray (elements, 2)
        Shear numbers by plane.
    """

    def __init__(self, structure: Structure) -> None:
        self.names: list[str] = []
        lengths, twist, bends, numbers = [], [], [], []
        first = 0
        for instance in structure.instances:
            kinds = [deformation.kind for deformation in instance.spec.deformations]
            if BENDS[1] in kinds:
                self.names.append(instance.name)
                lengths.append(float(instance.parameters["l0"][0]))
                twist.append(first + kinds.index(TWIST) if TWIST in kinds else -1)
                bends.append([_both(kinds, kind, first) for kind in BENDS])
                numbers.append(shear_numbers(instance))
            first += len(kinds)
        self.lengths, self.shear = np.array(lengths), np.array(numbers)
        self.twist: Index = np.array(twist, dtype=np.intp)
        self.bends: Index = np.array(bends, dtype=np.intp)

    def angles(self, e: Array) -> tuple[Array, Array]:
        """Turns (states, elements) of the ends against one another [°], by bending and by twist, from (states, m)."""
        known = _with_none(e)
        ends = np.arcsin(np.clip(known[:, self.bends] / self.lengths[:, None, None], -1.0, 1.0))
        twisted = np.arcsin(np.clip(np.abs(known[:, self.twist]) / self.lengths, 0.0, 1.0))
        return np.degrees(np.linalg.norm(np.abs(ends).sum(axis=3), axis=2)), np.degrees(twisted)

    def sheared(self, e: Array) -> Array:
        """Shear angles (states, elements) [rad] at deformations (states, m)."""
        return shear_angles(_with_none(e), self.bends, self.lengths, self.shear)


@contextmanager
def warned_together() -> Iterator[None]:
    """Analyses within give no warning of their own: the one that consists of them does, of all their states."""
    token = _part_of_another.set(True)
    try:
        yield
    finally:
        _part_of_another.reset(token)


def warn_bent(structure: Structure, times: ArrayLike, e: Array, analysis: str) -> None:
    """Warn, at the caller of an analysis, of elements that are bent, twisted, sheared or turned too far.

    Parameters
    ----------
    structure : Structure
    times : array_like (states,)
    e : ndarray (states, m)
        Their deformations.
    analysis : str
        For the message.
    """
    if _part_of_another.get() or not len(e):
        return
    warn_turned(structure, times, e, analysis)
    turns = Turns(structure)
    if not turns.names:
        return
    warn_sheared(turns.names, turns.sheared(e), times, analysis)
    bent, twisted = turns.angles(e)
    worst = np.maximum(bent, twisted)
    far = int((worst.max(axis=0) > FAR).sum())
    if not far:
        return
    when, which = np.unravel_index(int(np.argmax(worst)), worst.shape)
    angle, twists = float(worst[when, which]), bool(twisted[when, which] > bent[when, which])
    others = f" ({far - 1} more by more than {FAR:g}°)" if far > 1 else ""
    count = int(np.ceil(angle / FAR))
    warnings.warn(
        f"{analysis}: '{turns.names[which]}' is {'twisted' if twists else 'bent'} by {angle:.0f}° at t = "
        f"{np.asarray(times)[when]:g} s{others}: its moments are about {100 * _error(angle, twists):.2g} % too small; "
        f"{count} elements in place of each, or rotations='logarithmic', would do",
        RangeWarning,
        stacklevel=outside(),
    )


def _with_none(e: Array) -> Array:
    """Deformations with zero behind them, in the place of those that are not."""
    return np.concatenate([e, np.zeros((len(e), 1))], axis=1)


def _both(kinds: list[str], kind: str, first: int) -> list[int]:
    """Numbers of the two deformations of a plane of bending; -1 for none."""
    found = [first + place for place, other in enumerate(kinds) if other == kind]
    return found or [-1, -1]


def _error(angle: float, twists: bool) -> float:
    """The part of a moment that is missing at an angle [°] within one element."""
    phi = np.radians(angle)
    return float(1 - np.sin(2 * phi) / (2 * phi) if twists else phi**2 / 6)
