"""Warns of elements that are bent or twisted beyond the range of their deformations.

Deformations of beams are sines of angles times the length: an end moment that turns the ends by φ relative to each
other is too small by a fraction φ²/6, a torsional moment by 1 - sin 2φ/2φ.  Source: Jonker and Meijaard (2013), Int. J.
Non-Linear Mech. 53, for the deformations.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from flexel.base.arrays import Array, Index
from flexel.base.callers import outside
from flexel.base.errors import RangeWarning
from flexel.mechanics.folded import folded
from flexel.mechanics.sheared import shear_angles, sheared
from flexel.mechanics.turned import AXES, instant, turned
from flexel.model.instances import Instance
from flexel.model.structure import Structure

FAR = 15.0  # angle within one element [°] at which moments have errors of 1 % (bending) and 4.5 % (torsion)
TWIST, BENDS = "twist", ("bend_y", "bend_z")
_part_of_another: ContextVar[bool] = ContextVar("part_of_another", default=False)


class ElementTurns:
    """The elements whose deformations are sines of angles times their length.

    Attributes
    ----------
    elements : list of Instance
    lengths : ndarray (elements,)
    twist : ndarray of int (elements,)
        Deformations of twist by number; -1 for none.
    bends : ndarray of int (elements, 2, 2)
        By plane, those of both ends; -1 for none.
    """

    def __init__(self, structure: Structure) -> None:
        self.elements: list[Instance] = []
        lengths, twist, bends = [], [], []
        first = 0
        for instance in structure.instances:
            kinds = [deformation.kind for deformation in instance.spec.deformations]
            if BENDS[1] in kinds:
                self.elements.append(instance)
                lengths.append(float(instance.parameters["l0"][0]))
                twist.append(first + kinds.index(TWIST) if TWIST in kinds else -1)
                bends.append([_both(kinds, kind, first) for kind in BENDS])
            first += len(kinds)
        self.lengths = np.array(lengths)
        self.twist: Index = np.array(twist, dtype=np.intp)
        self.bends: Index = np.array(bends, dtype=np.intp)

    def angles(self, e: Array) -> tuple[Array, Array]:
        """Return turns (states, elements) between the ends [°], by bending and by twist, from (states, m)."""
        known = _with_none(e)
        ends = np.arcsin(np.clip(known[:, self.bends] / self.lengths[:, None, None], -1.0, 1.0))
        twisted = np.arcsin(np.clip(np.abs(known[:, self.twist]) / self.lengths, 0.0, 1.0))
        return np.degrees(np.linalg.norm(np.abs(ends).sum(axis=3), axis=2)), np.degrees(twisted)


@contextmanager
def warned_together() -> Iterator[None]:
    """Suppress the warnings of analyses within another one, which warns once for all their states."""
    token = _part_of_another.set(True)
    try:
        yield
    finally:
        _part_of_another.reset(token)


def warn_bent(structure: Structure, times: ArrayLike, e: Array, x: Array, analysis: str) -> None:
    """Warn, at the caller of an analysis, of what `bent` finds; parameters as there, and its name for the message."""
    for text in bent(structure, times, e, x).texts:
        warnings.warn(f"{analysis}: {text}", RangeWarning, stacklevel=outside())


@dataclass(frozen=True)
class Bent:
    """How far elements are bent or twisted.

    Attributes
    ----------
    angle : float
        The largest turn of the ends of an element against one another [°]; not a number if there are no such elements.
    texts : list of str
        What to say about those that are bent, twisted, sheared or turned too far.
    """

    angle: float
    texts: list[str]


def bent(structure: Structure, times: ArrayLike, e: Array, x: Array) -> Bent:
    """Compute how far elements are bent or twisted; report nothing within another analysis.

    Parameters
    ----------
    structure : Structure
    times : array_like (states,)
    e : ndarray (states, m)
        Their deformations.
    x : ndarray (states, n)
        Their coordinates.
    """
    if _part_of_another.get() or not len(e) or not {BENDS[1], AXES[0]} & set(structure.kinds):
        return Bent(np.nan, [])
    found = turned(structure, times, e)
    turns = ElementTurns(structure)
    if not turns.elements:
        return Bent(np.nan, found)
    names, (bends, twisted) = [element.name for element in turns.elements], turns.angles(e)
    if over := folded(structure, turns.elements, x[-1:], e[-1:], FAR):
        return Bent(over.angle, [*found, over.text])
    found += sheared(names, shear_angles(structure, turns.elements, x, e, np.radians(bends)), times)
    worst = np.maximum(bends, twisted)
    far = int((worst.max(axis=0) > FAR).sum())
    when, which = np.unravel_index(int(np.argmax(worst)), worst.shape)
    angle, twists = float(worst[when, which]), bool(twisted[when, which] > bends[when, which])
    if not far:
        return Bent(angle, found)
    others = f" ({far - 1} more by more than {FAR:g}°)" if far > 1 else ""
    count = int(np.ceil(angle / FAR))
    found.append(
        f"'{names[which]}' is {'twisted' if twists else 'bent'} by {angle:.0f}°"
        f"{instant(times, int(when))}{others}: its moments are about {100 * _error(angle, twists):.2g} % too small; "
        f"use {count} elements in place of each, or rotations='logarithmic'"
    )
    return Bent(angle, found)


def _with_none(e: Array) -> Array:
    """Return the deformations with a zero appended, to which missing ones point."""
    return np.concatenate([e, np.zeros((len(e), 1))], axis=1)


def _both(kinds: list[str], kind: str, first: int) -> list[int]:
    """Return the indices of the two deformations of a plane of bending; -1 for none."""
    found = [first + place for place, other in enumerate(kinds) if other == kind]
    return found or [-1, -1]


def _error(angle: float, twists: bool) -> float:
    """Return the missing fraction of a moment at an angle [°] within one element."""
    phi = np.radians(angle)
    return float(1 - np.sin(2 * phi) / (2 * phi) if twists else phi**2 / 6)
