"""Chains: the method of `Model` that adds a line of bars with point masses, which hangs and whips without bending."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arguments import not_negative, positive, text
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.declare.bodies import Bodies
from flexel.declare.joints import Joints
from flexel.declare.nodes import Nodes
from flexel.rope.curves import Path, curve, fractions, points_at
from flexel.structure.nodes import Node
from flexel.structure.state import State


@dataclass(frozen=True, repr=False)
class Chain:
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

    def __repr__(self) -> str:
        """One line: a chain has many points."""
        return f"Chain('{self.name}', {len(self.elements)} bars, {self.s[-1]:.6g} m)"

    def tension(self, states: State | Sequence[State]) -> tuple[Array, Array]:
        """Undeformed length s (n,) [m] at the middle of each bar, and its tension (n,) or (nt, n) [N].

        Parameters
        ----------
        states : State or sequence of State
            States of one system, such as a motion.
        """
        listed = [states] if isinstance(states, State) else states
        T = np.array([[state.force(f"{z}.elongation") for z in self.elements] for state in listed])
        return (self.s[:-1] + self.s[1:]) / 2, T[0] if isinstance(states, State) else T


class Chains(Joints, Bodies, Nodes):
    """Chains."""

    @whole_or_nothing
    def chain(
        self,
        name: str,
        path: Path,
        n: int | None = None,
        *,
        length: float | None = None,
        at: Sequence[float] | Array | None = None,
        start: Node | str | None = None,
        end: Node | str | None = None,
        mass_per_length: float,
        EA: float | None = None,
        damping: float = 0.0,
    ) -> Chain:
        """Add a chain of n bars with point masses: bars ``name1`` …, points ``name_p0`` …, masses ``name_m0`` ….

        It does not bend and carries tension and compression. It is the model of a rope with a free end whose
        bending stiffness is too low for `cable_line`. Its error falls with the square of the bars' length.

        Parameters
        ----------
        path, n, at, start, end
            As for `cable_line`. The bars are chords of a curved path.
        length : float, optional
            Undeformed length of all bars [m], with EA; as drawn by default.
        mass_per_length : float
            [kg/m], half of each bar's mass in each of its points.
        EA : float, optional
            Stiffness in tension [N]; the bars are rigid without it.
        damping : float
            Kelvin–Voigt damping: ratio of damping to stiffness [s], with EA.

        Returns
        -------
        Chain

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
        owner = f"chain '{text(name, 'chain', 'name')}'"
        if EA is None and (length is not None or damping):
            raise ModelError(
                f"{owner}: a length or damping needs bars that stretch; give EA, or leave it out"
            )
        shares = fractions(owner, n, at)
        drawn, total = curve(owner, path)
        places = drawn(shares * total)
        points = points_at(self, owner, name, places, start, end)
        chords = np.linalg.norm(np.diff(places, axis=0), axis=1)
        l0 = chords * (1.0 if length is None else positive(length, owner, "length") / chords.sum())
        elements = tuple(f"{name}{i + 1}" for i in range(l0.size))
        for i, bar in enumerate(elements):
            self.truss(bar, points[i], points[i + 1])
            if EA is not None:
                stiffness = positive(EA, owner, "EA") / l0[i]
                rate = not_negative(damping, owner, "damping") * stiffness
                self.spring(f"{bar}.elongation", stiffness, rate, free_length=float(l0[i]))
        mass = not_negative(mass_per_length, owner, "mass_per_length")
        lumps = mass * np.convolve(l0, [0.5, 0.5])
        for i, lump in enumerate(lumps):
            if lump:
                self.point_mass(f"{name}_m{i}", points[i], float(lump))
        return Chain(name, elements, points, np.concatenate([[0.0], np.cumsum(l0)]))
