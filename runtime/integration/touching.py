"""Ends steps where contacts, stops and tyres begin and end to act."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from scipy.optimize import brentq

from flexel.base.arrays import Array, Index
from flexel.derive.spec import TermSpec
from flexel.engine.contact_selection import every_gap
from flexel.engine.tables import Tables
from flexel.model.snapshot import Snapshot

CLOSE = (
    1e-9  # share of a step, at its ends, in which a contact may begin or end: it shifts the rates by as much
)
BEYOND = (
    1e-10  # the same, by which a step ends past that instant, so that the next one begins on the other side
)
TRIALS = 8  # of one step


class TouchingContacts:
    """Finds where a gap changes its sign within a step, or what is zero where a law begins to act (`Law.begins`).

    The estimates of the error of a step hold for smooth forces.  Those of a contact have a finite order at the
    instant at which it begins or ends, and the error may be much larger than the estimate.  So a step ends there.

    Parameters
    ----------
    tables : Tables

    Attributes
    ----------
    rows : ndarray of int (k,)
        Deformations that are gaps, or with which laws begin to act.
    value, rate, rest : ndarray (k,)
        value e + rate e' + rest is zero there.
    """

    def __init__(self, tables: Tables) -> None:
        gaps = every_gap(tables)
        still = np.zeros(gaps.size)
        found = [(gaps, still + 1.0, still, still), *_begins(tables)]
        self.rows: Index = np.concatenate([rows for rows, *_ in found])
        self.value, self.rate, self.rest = (
            np.concatenate(part) for part in list(zip(*found, strict=True))[1:]
        )

    def until(self, first: Snapshot, last: Snapshot) -> float:
        """Return the step [s] up to the first contact that begins or ends within a step; zero if there is none.

        Parameters
        ----------
        first, last : Snapshot
            At its ends.
        """
        if not self.rows.size:
            return 0.0
        h = last.t - first.t
        e, r0, r1 = first.e[self.rows], h * first.ed[self.rows], h * last.ed[self.rows]
        rise = last.e[self.rows] - e
        # e + r0 s + a s² + b s³ for the part s of the step; the rate at its end is left out where it does not count: a
        # stiff contact that has begun within the step has changed it
        b = np.where(self.rate == 0, 0.0, r0 + r1 - 2 * rise)
        a = rise - r0 - b
        own, along = self.value, self.rate / h
        g = np.array(
            [own * b, own * a + 3 * along * b, own * r0 + 2 * along * a, own * e + along * r0 + self.rest]
        )
        crossed = np.flatnonzero(g[3] * (((g[0] + g[1]) + g[2]) + g[3]) < 0)
        shares = [float(brentq(_cubic, 0.0, 1.0, args=tuple(g[:, i].tolist()))) for i in crossed]
        share = min((s for s in shares if s > CLOSE), default=1.0)
        return h * (share + BEYOND) if share < 1 - CLOSE else 0.0


def _begins(tables: Tables) -> Iterator[tuple[Index, Array, Array, Array]]:
    """Yield the first deformations of laws that begin to act somewhere, and the coefficients of what is zero there."""
    for batch, p in zip(tables.laws, tables.parameters[1], strict=True):  # p: the parameters of a variant
        components = [(q.name, component) for q in batch.spec.parameters for component in range(q.size)]
        for begin in batch.spec.begins:
            rows = batch.places["e"][:, 0]
            values = np.swapaxes(p, 1, 2).reshape(-1, p.shape[1])[: rows.size]
            columns = dict(zip(components, values.T, strict=True))
            value, rate, rest = (
                _sum(terms, columns, rows.size) for terms in (begin.value, begin.rate, begin.rest)
            )
            yield rows, value, rate, rest


def _sum(terms: Sequence[TermSpec], columns: dict[tuple[str, int], Array], size: int) -> Array:
    """Return a sum of products of parameters, whose values (size,) are in columns."""
    found = np.zeros(size)
    for term in terms:
        powers = [columns[name, component] ** n for name, component, n in term.powers]
        found += term.factor * np.prod(powers, axis=0)
    return found


def _cubic(s: float, a: float, b: float, c: float, d: float) -> float:
    return ((a * s + b) * s + c) * s + d
