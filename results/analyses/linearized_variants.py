"""Linearizes variants of a system at one position and many rates, in few calls of the engine."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.mechanics.dynamics import complete
from flexel.mechanics.linearize import Stack, linearized
from flexel.mechanics.states import moving
from flexel.model.snapshot import Snapshot
from flexel.model.state import State, own_state
from flexel.results.analyses.equilibria import steady
from flexel.results.linearization import Linearization, as_linearization
from flexel.system import CoreSystem

BLOCKS = ("M", "C", "K", "A_k", "B_k")
STEADY_TOLERANCE = 1e-10  # largest residual force in a steady motion, relative to the balancing forces


class LinearizedMany:
    """Linearizes each variant.

    Parameters
    ----------
    system : CoreSystem
        Determines the degrees of freedom and the positions.
    start : State or callable
        A state, or a function that finds the state of a variant.
    rates : mapping of name to ndarray (rates,)
    steady : bool
        Whether the states must be steady motions.
    """

    def __init__(
        self,
        system: CoreSystem,
        start: State | Callable[[Any], State],
        rates: Mapping[str, Array],
        steady: bool,
    ) -> None:
        self.rates, self._steady = dict(rates), steady
        self._find = start if callable(start) else self._moved
        self._roles = system.roles if callable(start) else system._usable(start).roles
        self._nz = system.structure.nz
        kinematics = system.kinematics_of(self._roles)
        self.role_names = kinematics.role_names
        self._moments: list[Snapshot] = []
        self._rows: Array | None = None  # where all states can be completed in one call
        if callable(start):
            return
        some = [dict(zip(rates, row, strict=True)) for row in zip(*rates.values(), strict=True)]
        self._z, self._moments = start.z, moving(kinematics, start, some) if rates else [Snapshot.of(start)]
        if not (system.roles.motions or system.loads.any):
            none, stresses = np.zeros(start.x.size), np.zeros(start.stresses.size)
            parts = [((m.t,), m.x, m.v, none, start.z, m.e, stresses) for m in self._moments]
            self._rows = np.array([np.concatenate(row) for row in parts])

    def state(self, system: Any, i: int) -> State:
        """Return state number i of a variant."""
        if not self._moments:
            owner = "root_loci" if self._steady else "linearize_many"
            found = own_state(system.structure, self._find(system), owner)
            return steady(system, found) if self._steady else found
        return self._moved(system, i)

    def linearization(self, system: Any, _: int, i: int) -> Linearization:
        """Return the linearized equations of a variant at state number i."""
        state = self.state(system, i)
        kinematics = system.kinematics_of(self._roles)
        return as_linearization(linearized(kinematics, kinematics.linearizer.rows([state])).about(state, 0))

    def _moved(self, system: Any, i: int = 0) -> State:
        at = self._moments[i]
        found = complete(system.kinematics_of(self._roles), at.t, at.x, at.v, at.e, self._z)
        return steady(system, found) if self._steady else found

    def blocks(self, system: Any) -> dict[str, Array]:
        """Return the matrices of a variant at all states, by name."""
        kinematics = system.kinematics_of(self._roles)
        stack = None if self._rows is None else self._together(system, self._rows.copy())
        if stack is None:
            states = [self.state(system, i) for i in range(max(len(self._moments), 1))]
            stack = linearized(kinematics, kinematics.linearizer.rows(states))
        found = {name: stack.blocks[name].copy() for name in BLOCKS}  # without intermediate results
        return found | stack.all_internal_states() if self._nz else found

    def _together(self, system: Any, rows: Array) -> Stack | None:
        """Return the equations at all states; None if a state must be found first or has no forces (reported then)."""
        kinematics = system.kinematics_of(self._roles)
        done = kinematics.linearizer.complete(kinematics.choice, rows)
        if done.code:
            raise kinematics.failure(done.code, float(rows[done.done, 0]))
        if not np.isfinite(rows).all() or (self._steady and self._nz):
            return None
        stack = linearized(kinematics, rows)
        if not self._steady:
            return stack
        inertia = np.einsum("sij,sj->si", stack.blocks["M"], done.qdd)
        reach = np.abs(stack.H).max(axis=(1, 2), initial=0.0)
        scale = np.maximum(done.forces * reach, 1e-3 * kinematics.linearizer.largest_mass(stack.found))
        off = np.abs(inertia).max(axis=1, initial=0.0) > STEADY_TOLERANCE * np.maximum(scale, 1e-300)
        return None if off.any() else stack

    def stacked(self, results: Mapping[int, dict[str, Array]], count: int) -> dict[str, Array]:
        """Return the matrices of all variants; NaN for those without a result."""
        rates = max(len(self._moments), 1)
        found = {}
        for name, shape in self._shapes().items():
            found[name] = np.full((count, rates, *shape), np.nan)
            for i, blocks in results.items():
                if name in blocks:
                    found[name][i] = blocks[name]
        return found if self.rates else {name: array[:, 0] for name, array in found.items()}

    def _shapes(self) -> dict[str, tuple[int, int]]:
        nd, nk = (len(names) for names in self.role_names[:2])
        nz, nq = self._nz, nd + nk
        sizes = {"M": (nd, nd), "C": (nd, nd), "K": (nd, nq), "A_k": (nk, nd), "B_k": (nk, nq)}
        return sizes | {"Z": (nd, nz), "Z_v": (nz, nd), "Z_q": (nz, nq), "Z_z": (nz, nz)}
