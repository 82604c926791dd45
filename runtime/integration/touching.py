"""Ends steps where contacts, stops and tyres begin and end to act: one finder for all methods."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import prod

import numpy as np
from scipy.optimize import brentq

from flexel.base.arrays import Array, Index
from flexel.derive.spec import TermSpec
from flexel.engine.batches import Batch
from flexel.engine.contact_look import PASSES, TOUCHES, ContactLook
from flexel.engine.tables import Tables
from flexel.engine.workspace import Workspace
from flexel.integration.passed import CLOSE, Passages
from flexel.model.snapshot import Snapshot

BEYOND = (
    1e-10  # share of a step, by which it ends past such an instant: the next one begins on the other side
)
ROUGHLY = (
    1e-3  # the same as CLOSE for a method of order two: rates are off by the square of the time across a kink
)
HERTZ = 1.5  # exponent of a force, that of Hertz, across whose beginning steps of order two are as exact as others


class TouchingContacts:
    """Finds where a gap changes its sign within a step, or what is zero where a law begins to act (`Law.begins`).

    The estimates of the error of a step hold for smooth forces.  Those of a contact have a finite order at the
    instant at which it begins or ends, and the error may be much larger than the estimate.  So a step ends there, and
    where a contact begins that would be open again at its end.

    Parameters
    ----------
    tables : Tables
    gaps : ndarray of int
        Gaps that end steps.
    passages : Passages
        Finds contacts that are passed.
    sees_inside : bool
        Whether the method feels forces within a step.

    Attributes
    ----------
    rows : ndarray of int (k,)
        Deformations that are gaps, or with which laws begin to act.
    look : ContactLook
        Says in which steps something happens.
    touched : bool
        Whether a contact begins or ends in the last step that was looked at, if only at its ends.
    """

    touched = False

    def __init__(self, tables: Tables, gaps: Index, passages: Passages, sees_inside: bool = True) -> None:
        self._passages = passages
        self._close = CLOSE if sees_inside else ROUGHLY
        still = np.zeros(gaps.size)
        found = [(gaps, still + 1.0, still, still), *_begins(tables)]
        self.rows: Index = np.concatenate([rows for rows, *_ in found])
        value, rate, rest = (np.concatenate(part) for part in list(zip(*found, strict=True))[1:])
        self.look = ContactLook(self.rows, (value, rate, rest), passages.rows, passages.least, sees_inside)

    def until(self, first: Snapshot, last: Snapshot, end: Workspace) -> float:
        """Return the step [s] up to the first contact that begins or ends within a step; zero if there is none.

        Parameters
        ----------
        first, last : Snapshot
            At its ends.
        end : Workspace
            It holds its end.
        """
        look, h = self.look, last.t - first.t
        happens = look((first.x, first.e, first.ed), last.x, end, h) if look.any else 0
        self.touched = happens & TOUCHES != 0
        if not happens:
            return 0.0
        shares = self._crossings(first, last, h) if self.touched else []
        if happens & PASSES:
            gaps = self._passages.rows[self.look.passed != 0]
            shares.append((self._passages.until(first, last, gaps, self._close) - first.t) / h)
        share = min((share for share in shares if share > self._close), default=1.0)
        return h * (share + BEYOND) if share < 1 - self._close else 0.0

    def _crossings(self, first: Snapshot, last: Snapshot, h: float) -> list[float]:
        """Return the shares of a step of length h after which they change their signs."""
        look = self.look
        e, r0, r1 = first.e[self.rows], h * first.ed[self.rows], h * last.ed[self.rows]
        rise = last.e[self.rows] - e
        # e + r0 s + a s² + b s³ for the part s of the step; the rate at its end is left out where it does not count: a
        # stiff contact that has begun within the step has changed it
        b = np.where(look.rate == 0, 0.0, r0 + r1 - 2 * rise)
        a = rise - r0 - b
        own, along = look.value, look.rate / h
        g = np.array(
            [own * b, own * a + 3 * along * b, own * r0 + 2 * along * a, own * e + along * r0 + look.rest]
        )
        crossed = np.flatnonzero(g[3] * (((g[0] + g[1]) + g[2]) + g[3]) < 0)
        return [float(brentq(_cubic, 0.0, 1.0, args=tuple(g[:, i].tolist()))) for i in crossed]


def abrupt_gaps(tables: Tables, gaps: Index) -> Index:
    """Return those of some gaps, indices in e, whose forces begin more abruptly than with `HERTZ`."""
    abrupt = np.ones(tables.structure.m, dtype=bool)
    for batch, p in zip(tables.laws, tables.parameters[1], strict=True):
        if any(parameter.name == "exponent" for parameter in batch.spec.parameters):
            abrupt[batch.places["e"][:, 0]] = _columns(batch, p)["exponent", 0] < HERTZ
    return gaps[abrupt[gaps]]


def _begins(tables: Tables) -> Iterator[tuple[Index, Array, Array, Array]]:
    """Yield the first deformations of laws that begin to act somewhere, and the coefficients of what is zero there."""
    for batch, p in zip(tables.laws, tables.parameters[1], strict=True):  # p: the parameters of a variant
        if not batch.spec.begins:
            continue
        rows, columns = batch.places["e"][:, 0], _columns(batch, p)
        for begin in batch.spec.begins:
            value, rate, rest = (
                _sum(terms, columns, rows.size) for terms in (begin.value, begin.rate, begin.rest)
            )
            yield rows, value, rate, rest


def _columns(batch: Batch, p: Array) -> dict[tuple[str, int], Array]:
    """Return the values (size,) of the components of parameters of a batch, from its blocks (blocks, parameters, 8)."""
    components = [(q.name, component) for q in batch.spec.parameters for component in range(q.size)]
    values = np.swapaxes(p, 1, 2).reshape(p.shape[0] * p.shape[2], p.shape[1])[: batch.size]
    return dict(zip(components, values.T, strict=True))


def _sum(terms: Sequence[TermSpec], columns: dict[tuple[str, int], Array], size: int) -> Array:
    """Return a sum of products of parameters, whose values (size,) are in columns."""
    found = np.zeros(size)
    for term in terms:
        powers = [columns[name, component] ** n for name, component, n in term.powers]
        found += term.factor * prod(powers)
    return found


def _cubic(s: float, a: float, b: float, c: float, d: float) -> float:
    return ((a * s + b) * s + c) * s + d
