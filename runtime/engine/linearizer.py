"""Linearizes the equations of motion at any number of states of a model in one call of the engine; see linear.h."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.coordinate_work import CoordinateLists, CoordinateWork
from flexel.engine.derivatives import Derivatives
from flexel.engine.evaluate import Evaluation
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi, lib
from flexel.model.role_lists import Roles
from flexel.model.state import State

COMPUTED, ZERO = int(lib.FLEXEL_COMPUTED), int(lib.FLEXEL_ZERO)


@dataclass(frozen=True, eq=False)
class Linearized:
    """Results of the engine at some states.

    Attributes
    ----------
    derivatives : ndarray (states, …)
    transfer : ndarray (states, …)
    factors : ndarray (states, nf, …)
        M H, r_v H + M A_v and r_x G + r_v N + M A_q side by side.
    laws : ndarray (states, nd, …)
        What the derivatives of laws add to [C K].
    done, code : int
        Number of states that are done, and why the next one is not; zero if all are.
    """

    derivatives: Array
    transfer: Array
    factors: Array
    laws: Array
    done: int
    code: int


@dataclass(frozen=True, eq=False)
class Completed:
    """Results of the engine that complete some states.

    Attributes
    ----------
    qdd : ndarray (states, nd)
        Second rates of the dynamic degrees of freedom.
    forces : ndarray (states,)
        Largest of the forces that balance on a free coordinate.
    done, code : int
        As in `Linearized`.
    """

    qdd: Array
    forces: Array
    done: int
    code: int


class Linearizer(Struct):
    """The lists of a choice of degrees of freedom for its linearization, shared by all workspaces.

    Attributes
    ----------
    width : int
        Columns of rates, nd + nu filled up to a multiple of four.
    """

    def __init__(self, evaluation: Evaluation, lists: CoordinateLists) -> None:
        super().__init__(ffi.new("flexel_linear *"))
        self._evaluation = evaluation
        s, t, roles = evaluation.structure, evaluation.tables, lists.roles
        laws = t.law.entries[2]
        self.struct.T_column = self.integers(t.T.whole.column.astype(np.int32))
        self.struct.nlaws, self.struct.laws = laws.size, self.integers(laws.astype(np.int32))
        acting = self._laws(evaluation, roles)
        nu, nk = roles.prescribed.size, roles.nq - roles.nd
        p, r = -(-(roles.nq + nu) // 4) * 4, -(-(roles.nd + nu) // 4) * 4  # as in linear.h
        self.width = r
        self._factors, self._by_laws = (s.nf, 2 * r + p), (roles.nd, r + p)
        self._space = 3 * s.nf * (p + r) + acting * (r + 2 * p)
        self._transfer = _places([(s.nf, p), (s.nf, r + p), (s.nf, r + p), (nk, r + p)])
        nJ, nT = t.J.size, t.T.whole.size
        self._derivatives = _places([(size,) for size in (nJ, nJ, nJ, nJ, t.M.size, nT, nT, laws.size)])

    def _laws(self, evaluation: Evaluation, roles: Roles) -> int:
        """Set the lists of the laws, see linear.h; return the number of their quantities."""
        s = evaluation.structure
        rows, columns, _ = evaluation.tables.law.entries
        rate = columns >= s.m
        by = np.where(
            columns < 2 * s.m, columns % max(s.m, 1), columns - s.m
        )  # (e, ed, s, z): slips are rates
        stress = (rows < s.m + s.k) & (columns < 2 * s.m + s.k)
        acting = np.unique(np.concatenate([rows[stress], by[stress]]))
        values, rates = np.full((2, s.m + s.k + s.n), COMPUTED)
        for number, quantity in enumerate(roles.position_rows):
            place = number - roles.rigid.size
            moved = place - roles.prescribed.size
            if moved < 0:
                values[quantity] = ZERO if place < 0 else roles.nq + place
                rates[quantity] = ZERO if place < 0 else roles.nd + place
                continue
            values[quantity] = moved
            if moved < roles.nd:
                rates[quantity] = moved
        rates[roles.zero] = ZERO
        self.struct.nacting = acting.size
        struct, lists = self.struct, {"acting": acting, "by_value": values[acting], "by_rate": rates[acting]}
        lists |= {"row": np.where(stress, np.searchsorted(acting, rows), -1)}
        lists |= {"column": np.where(stress, np.searchsorted(acting, by), -1), "rate": rate}
        for name, numbers in lists.items():
            setattr(struct, name, self.integers(numbers.astype(np.int32)))
        return int(acting.size)

    @staticmethod
    def rows(states: Sequence[State]) -> Array:
        """Return complete states as rows of numbers, see linear.h."""
        return np.array(
            [
                np.concatenate([(state.t,), state.x, state.v, state.a, state.z, state.e, state.stresses])
                for state in states
            ]
        )

    def complete(self, choice: CoordinateWork, given: Array) -> Completed:
        """Fill the accelerations, deformations and stresses in rows of states, in place; without loads and motions."""
        count = given.shape[0]
        qdd, forces = np.empty((count, int(choice.struct.nd))), np.empty(count)
        space, code = np.empty(self._evaluation.structure.n), ffi.new("int *")
        pointers = (ffi.from_buffer("double[]", values) for values in (given, qdd, forces, space))
        done = lib.flexel_complete_states(choice.work.struct, choice.struct, count, *pointers, code)
        return Completed(qdd, forces, int(done), int(code[0]))

    def run(self, choice: CoordinateWork, given: Array) -> Linearized:
        """Compute derivatives and transfer functions at complete states of the model, given as rows."""
        count = given.shape[0]
        found = (
            np.empty((count, self._derivatives[-1][0].stop)),
            np.empty((count, self._transfer[-1][0].stop)),
        )
        factors, laws = np.empty((count, *self._factors)), np.empty((count, *self._by_laws))
        space, code = np.empty(self._space), ffi.new("int *")
        pointers = (ffi.from_buffer("double[]", values) for values in (given, *found, factors, laws, space))
        done = lib.flexel_linearize(choice.work.struct, choice.struct, self.struct, count, *pointers, code)
        return Linearized(*found, factors, laws, int(done), int(code[0]))

    def derivatives(self, found: Linearized, i: int) -> Derivatives:
        """Return the derivatives at state number i."""
        own = found.derivatives[i]
        return Derivatives(self._evaluation, *(own[place] for place, _ in self._derivatives))

    def transfers(self, found: Linearized) -> list[Array]:
        """Return G, [H N], [A_v A_q] and [𝒜 ℬ] (states, …); columns of values begin at number `width`."""
        count = found.transfer.shape[0]
        return [found.transfer[:, place].reshape(count, *shape) for place, shape in self._transfer]

    def largest_mass(self, found: Linearized) -> Array:
        """Return the largest entry (states,) of the mass matrix."""
        M = found.derivatives[:, self._derivatives[4][0]]
        return np.asarray(np.abs(M).max(axis=1, initial=0.0))

    def slopes(self, found: Linearized, i: int) -> Array:
        """Return the derivatives of the laws at state number i."""
        return found.derivatives[i, self._derivatives[-1][0]]


def _places(shapes: Sequence[tuple[int, ...]]) -> list[tuple[slice, tuple[int, ...]]]:
    """Return the slices of arrays that follow one another, and their shapes."""
    ends = np.cumsum([math.prod(shape) for shape in shapes]).tolist()
    return [(slice(end - math.prod(shape), end), shape) for shape, end in zip(shapes, ends, strict=True)]
