"""Piecewise polynomial curves of springs and dampers.

Polynomials are re-expanded in exact arithmetic, so that terms of a million newtons that cancel to a hundred lose no
digits.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import comb
from typing import Any

import numpy as np

from flexel.base.arguments import LARGEST, array, number
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.generated.table import LAWS

_SIZES = {parameter.name: parameter.size for parameter in LAWS["spring_curve"].parameters}
PIECES = _SIZES["origins"]
TERMS = _SIZES["coefficients"] // PIECES
NEVER = LARGEST  # a break that no argument reaches
CONTINUOUS = 1e-6  # largest jump at a break, relative to the terms that sum up there: rounded data pass
SMOOTH = 1e-6  # largest jump of the slope, relative to the slopes on both sides, that ends no step


@dataclass(frozen=True)
class Curve:
    """A force as a piecewise polynomial; the first and last piece are extrapolated.

    Parameters
    ----------
    pieces : sequence of sequences of float
        Coefficients of each piece in ascending powers of x, at most `TERMS`.
    breaks : sequence of float
        Where the next piece begins, one fewer than pieces.

    Raises
    ------
    ModelError
        Too many pieces or powers, breaks that are not increasing, a jump at a break.

    Examples
    --------
    A spring of 30 kN/m with a stop of 10 MN/m from 7 cm on:

    >>> import flexel as fx
    >>> spring = fx.Curve([[0, 3e4], [3e4 * 0.07 - 1e7 * 0.07, 1e7]], breaks=[0.07])
    >>> round(spring(0.08))
    102100
    """

    pieces: Sequence[Sequence[float]]
    breaks: Sequence[float] = ()

    def __post_init__(self) -> None:
        breaks, pieces = array(self.breaks, "curve", "breaks"), _checked_pieces(self.pieces)
        if not 1 <= len(pieces) <= PIECES or breaks.shape != (len(pieces) - 1,):
            raise ModelError(
                f"curve: {len(pieces)} pieces and {breaks.size} breaks; give 1 to {PIECES} pieces, with a break "
                "between adjacent ones"
            )
        if np.any(np.diff(breaks) <= 0):
            raise ModelError(f"curve: breaks {breaks.tolist()} are not increasing; sort them")
        object.__setattr__(self, "pieces", pieces)
        object.__setattr__(self, "breaks", tuple(breaks.tolist()))
        allowed = CONTINUOUS * self._size()
        for pair, b in self._joints():
            left, right = (_value(piece, Fraction(float(b))) for piece in pair)
            if abs(left - right) > allowed:
                raise ModelError(
                    f"curve: it jumps from {left:g} to {right:g} at {b:g}; correct a coefficient there"
                )

    def _size(self) -> float:
        """Return the largest sum of absolute terms at a break; the force itself may be zero there, as in free play."""
        terms = (
            sum(abs(c * float(b) ** k) for k, c in enumerate(piece))
            for pair, b in self._joints()
            for piece in pair
        )
        return max(terms, default=0.0)

    def rests(self) -> bool:
        """Whether the force at zero is zero within the accuracy of rounded data."""
        return abs(self(0.0)) <= CONTINUOUS * self._size()

    def _joints(self) -> list[tuple[tuple[Sequence[float], Sequence[float]], float]]:
        """Return the pairs of neighbouring pieces with the break between them."""
        return list(zip(zip(self.pieces[:-1], self.pieces[1:], strict=True), self.breaks, strict=True))

    @staticmethod
    def through(x: Any, y: Any) -> Curve:
        """Make a curve through a table, with continuous slope and no overshoot; straight beyond both ends.

        Parameters
        ----------
        x, y : array_like (n,)
            Increasing values and the forces at them, 2 to `PIECES` - 1 of each.
        """
        from scipy.interpolate import PchipInterpolator

        places, values = array(x, "curve", "x values"), array(y, "curve", "forces")
        if places.ndim != 1 or places.shape != values.shape or not 2 <= places.size < PIECES:
            raise ModelError(
                f"curve: {places.size} x values and {values.size} forces; give 2 to {PIECES - 1} of both, equally many"
            )
        if np.any(np.diff(places) <= 0):
            raise ModelError(f"curve: x values {places.tolist()} are not increasing; sort them")
        p = PchipInterpolator(places, values)
        slopes = p.derivative()(places)
        local: list[tuple[float, Sequence[float]]] = [(places[0], [values[0], slopes[0]])]
        local += [(places[i], p.c[::-1, i].tolist()) for i in range(places.size - 1)]
        local.append((places[-1], [values[-1], slopes[-1]]))
        return Curve([_about_zero(c, o) for o, c in local], places.tolist())

    def __call__(self, x: float) -> float:
        """Return the force at x."""
        place = number(x, "curve", "place")
        piece = self.pieces[int(np.searchsorted(np.asarray(self.breaks), place, side="right"))]
        return _value(piece, Fraction(place))

    def parameters(self, at: float) -> dict[str, Array]:
        """Return the parameters of the laws ``spring_curve`` and ``damper_curve`` in y = x - at."""
        breaks = np.array(self.breaks, dtype=float)
        origins = np.concatenate([breaks[:1] if breaks.size else [at], breaks])
        c = np.zeros((PIECES, TERMS))
        for i, piece in enumerate(self.pieces):
            terms = _expanded(piece, Fraction(float(origins[i])))
            c[i, : len(terms)] = [float(term) for term in terms]
        filled = np.full(PIECES, origins[-1] - at)
        filled[: origins.size] = origins - at
        ends = np.full(PIECES - 1, NEVER)
        ends[: breaks.size] = breaks - at
        kinks = ends.copy()
        kinks[: breaks.size][self._smooth()] = NEVER
        return {
            "breaks": ends,
            "kinks": kinks,
            "origins": filled,
            "coefficients": c.ravel(),
            "stored": self._stored(at, origins),
        }

    def _smooth(self) -> Array:
        """Whether the slope is the same on both sides of each break."""
        slopes = [
            [_value([k * c for k, c in enumerate(piece)][1:], Fraction(float(b))) for piece in pair]
            for pair, b in self._joints()
        ]
        left, right = np.array(slopes).reshape(-1, 2).T
        return np.asarray(np.abs(left - right) <= SMOOTH * (np.abs(left) + np.abs(right)))

    def _stored(self, at: float, origins: Array) -> Array:
        """Return the energy at the origins of the pieces; zero at x = at."""
        U = np.zeros(PIECES)

        def gained(i: int, a: float, b: float) -> float:
            terms = (Fraction(float(term)) / (k + 1) for k, term in enumerate(self.pieces[i]))
            primitive = [Fraction(0), *terms]
            return float(_sum(primitive, Fraction(float(b))) - _sum(primitive, Fraction(float(a))))

        for i in range(1, origins.size):  # the first piece's origin is the first break too
            U[i] = U[i - 1] + (gained(i - 1, origins[i - 1], origins[i]) if i > 1 else 0.0)
        home = int(np.searchsorted(np.asarray(self.breaks), at, side="right"))
        return np.asarray(U - (U[home] + gained(home, origins[home], at)))


def _checked_pieces(pieces: Any) -> tuple[tuple[float, ...], ...]:
    """Return the coefficients of each piece as plain numbers."""
    try:
        rows = list(pieces)
    except TypeError as error:
        raise ModelError(f"curve: pieces {pieces!r} are not a list; give [[c0, c1, …], …]") from error
    found = []
    for i, row in enumerate(rows, 1):
        c = array(row, "curve", f"piece {i}")
        if c.ndim != 1:
            raise ModelError(f"curve: piece {i} {row!r} is not a list of coefficients; give [c0, c1, …]")
        if not 1 <= c.size <= TERMS:
            raise ModelError(f"curve: piece {i} has {c.size} coefficients; give 1 to {TERMS}")
        found.append(tuple(c.tolist()))
    return tuple(found)


def _sum(piece: Sequence[Any], x: Fraction) -> Fraction:
    return sum((Fraction(term) * x**k for k, term in enumerate(piece)), Fraction(0))


def _value(piece: Sequence[float], x: Fraction) -> float:
    """Evaluate a polynomial, rounding only once at the end."""
    return float(_sum([Fraction(float(term)) for term in piece], x))


def _expanded(piece: Sequence[Any], origin: Fraction) -> list[Fraction]:
    """Return the exact coefficients of a polynomial in powers of x - origin."""
    exact = [term if isinstance(term, Fraction) else Fraction(float(term)) for term in piece]
    return [
        sum((exact[i] * comb(i, k) * origin ** (i - k) for i in range(k, len(exact))), Fraction(0))
        for k in range(len(exact))
    ]


def _about_zero(piece: Sequence[float], origin: float) -> list[float]:
    return [float(term) for term in _expanded(piece, -Fraction(float(origin)))]
