"""Chains: a line of bars with point masses, which hangs and whips without bending."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass

import numpy as np

from flexel.base.arguments import text
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.base.shown import prints
from flexel.model.handle import Handle
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.model.state import State
from flexel.parts.bodies import PointMass
from flexel.parts.joints import Truss
from flexel.parts.path_curves import Path, curve, fractions, points_at
from flexel.parts.springs import Spring


@dataclass(frozen=True, repr=False)
class Chain(Handle):
    """A chain made by `Model.chain`.

    Attributes
    ----------
    name : str
    elements : tuple of str (n,)
        The bars.
    points : tuple of Node (n + 1,)
    s : ndarray (n + 1,)
        Undeformed length up to each point [m].
    """

    name: str
    elements: tuple[str, ...]
    points: tuple[Node, ...]
    s: Array

    @prints
    def __repr__(self) -> str:
        """Return one line: a chain has many points."""
        return f"Chain('{self.name}', {len(self.elements)} bars, {self.s[-1]:.6g} m)"

    def tension(self, states: State | Sequence[State]) -> tuple[Array, Array]:
        """Return the undeformed length s (n,) [m] at the middle of each bar, and its tension (n,) or (nt, n) [N].

        Parameters
        ----------
        states : State or sequence of State
            States of one system, such as a motion.
        """
        listed = [states] if isinstance(states, State) else states
        T = np.array([[state.force(f"{bar}.elongation") for bar in self.elements] for state in listed])
        return (self.s[:-1] + self.s[1:]) / 2, T[0] if isinstance(states, State) else T


@part
class ChainPart(Part[Chain]):
    """Add a chain of n bars with point masses: bars ``name1`` …, points ``name_p0`` …, masses ``name_m0`` ….

    It has no bending stiffness, and carries tension and compression. It models a rope with a free end whose
    bending stiffness is too low for `cable_line`. Its error decreases with the square of the bar length.

    Raises
    ------
    ModelError
        As `cable_line`; a length or damping of rigid bars.

    Examples
    --------
    >>> import flexel as fx
    >>> m = fx.Model(gravity=(0, -9.81))
    >>> chain = m.chain("chain", [(0, 0), (0, -2)], 8, mass_per_length=1.5)
    >>> m.fix(chain.points[0])
    >>> len(m.build().dynamic)
    8
    """

    name: str = entry("Names of bars, points and masses start with it.")
    path: Path = array_quantity(
        "m", "Path of the chain [], as for `cable_line`.  The bars are chords of a curved path."
    )
    n: int | None = entry("Number of bars, as for `cable_line`.", default=None)
    _: KW_ONLY
    length: float | None = quantity(
        "m", "positive", "Total undeformed length [] of the bars, with EA; as drawn by default.", default=None
    )
    at: Sequence[float] | Array | None = array_quantity(
        "-", "Positions of the points, as for `cable_line`.", default=None
    )
    start: Node | str | None = entry("Existing point to use for the first end.", default=None)
    end: Node | str | None = entry("Existing point to use for the other end.", default=None)
    mass_per_length: float = quantity(
        "kg/m", "not negative", "Mass per length; half of each bar's mass is at each of its points."
    )
    EA: float | None = quantity(
        "N", "positive", "Stiffness in tension; the bars are rigid without it.", default=None
    )
    damping: float = quantity(
        "s", "not negative", "Kelvin–Voigt damping, with EA: ratio of damping to stiffness.", default=0.0
    )

    def lower(self, to: Lowering) -> Chain:
        """Add the points, the bars with their springs, and the masses."""
        name = text(self.name, "chain", "name")
        if self.EA is None and (self.length is not None or self.damping):
            raise ModelError(
                f"{self.owner}: a length or damping needs bars that stretch; give EA, or leave it out"
            )
        shares = fractions(self.owner, self.n, self.at)
        drawn, total = curve(self.owner, self.path)
        places = drawn(shares * total)
        points = points_at(to, self.owner, name, places, self.start, self.end)
        chords = np.linalg.norm(np.diff(places, axis=0), axis=1)
        l0 = chords * (1.0 if self.length is None else self.length / chords.sum())
        bars = tuple(f"{name}{i + 1}" for i in range(l0.size))
        for i, bar in enumerate(bars):
            Truss(bar, points[i], points[i + 1]).lower(to)
            if self.EA is not None:
                stiffness = self.EA / l0[i]
                rate = self.damping * stiffness
                Spring(f"{bar}.elongation", stiffness, rate, free_length=float(l0[i])).lower(to)
        lumps = self.mass_per_length * np.convolve(l0, [0.5, 0.5])
        for i, lump in enumerate(lumps):
            if lump:
                PointMass(f"{name}_m{i}", points[i], float(lump)).lower(to)
        chain = Chain(name, bars, points, np.concatenate([[0.0], np.cumsum(l0)]))
        to.lines[name] = chain
        return chain
