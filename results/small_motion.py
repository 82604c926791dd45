"""A small vibration about a nominal motion as a result: changes of all quantities over time, by name."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from flexel.base.arguments import text
from flexel.base.arrays import Array, StateSpace
from flexel.base.errors import LinearizationError
from flexel.base.shown import counted, prints
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.model.controller import parts


class Nominal(Protocol):
    """The equations along a nominal motion, from which a small motion reads its quantities."""

    @property
    def F(self) -> Array:  # noqa: N802
        """Forces (ns, nd) that the nominal motion leaves unbalanced."""

    def state_space(
        self, inputs: Sequence[str] = (), outputs: Sequence[str] = (), times: Sequence[float] | None = None
    ) -> StateSpace:
        """Return state-space matrices A, B, C, D (nt, …) along the motion."""

    def linearized(self, times: Array) -> tuple[list[LinearizedSystem], Array]:
        """Return the linearizations at times, and the forces that are left."""


class SmallMotion:
    """Small differences from a motion, from `TimeVarying.transient`: ``small["tip.y"]`` is the change of a quantity.

    Attributes
    ----------
    t : ndarray (nt,)
        Times [s].
    x : ndarray (nt, n)
        States.
    states : tuple of str
        Their names.
    """

    def __init__(
        self, about: Nominal, t: Array, x: Array, states: tuple[str, ...], inputs: dict[str, Array]
    ) -> None:
        self.about, self.t, self.x, self.states, self.inputs = about, t, x, states, inputs

    @prints
    def __repr__(self) -> str:
        span = f"t = {self.t[0]:g} … {self.t[-1]:g} s"
        return f"SmallMotion({counted(self.t.size, 'time')}, {span}, {counted(len(self.states), 'state')})"

    def __getitem__(self, name: str) -> Array:
        """Return the change (nt,) of a quantity, of its rate or its force, to first order; names as in `Motion`.

        Raises
        ------
        LinearizationError
            A force or an acceleration where the nominal motion leaves forces F.
        """
        if text(name, "small motion", "name") in self.states:
            return np.asarray(self.x[:, self.states.index(name)])
        if parts(name)[1] in (-1, 2) and self.about.F.any():
            raise LinearizationError(
                f"small motion: '{name}' contains the forces that drive the nominal motion; take a value or a rate"
            )
        _, _, C, D = self.about.state_space(tuple(self.inputs), [name], self.t.tolist())
        u = np.array(list(self.inputs.values())).reshape(len(self.inputs), self.t.size)
        return np.asarray(np.einsum("ti,ti->t", C[:, 0], self.x) + np.einsum("ti,it->t", D[:, 0], u))

    def total(self, name: str) -> Array:
        """Return the value (nt,) of a quantity: that of the nominal motion and the change."""
        base, order = parts(text(name, "small motion", "name"))
        states = [lin.state for lin in self.about.linearized(self.t)[0]]
        read = {-1: "force", 1: "rate", 2: "acceleration"}
        nominal = [state[base] if not order else getattr(state, read[order])(base) for state in states]
        return np.asarray(np.array(nominal) + self[name])
