"""A stretch of motion as polynomials of high degree in time: series of Legendre's polynomials for all coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.polynomial.legendre import legder, leggauss, legint, legvander

from flexel.base.arrays import Array
from flexel.base.copies import Portable
from flexel.model.snapshot import Snapshot

POINTS = 20  # of Gauss: an even number, so that none lies in the middle
PLACES, WEIGHTS = leggauss(POINTS)  # from -1 to 1
SERIES = (np.arange(POINTS)[:, None] + 0.5) * (legvander(PLACES, POINTS - 1) * WEIGHTS[:, None]).T
BASIS = legvander(PLACES, POINTS + 1)
LAST = 2  # terms of a series that show its error


class Rates(NamedTuple):
    """The quantities that a path integrates, at its points.

    Attributes
    ----------
    a : ndarray (POINTS, nf)
        Accelerations.
    zd : ndarray (POINTS, nz)
        Rates of internal states.
    powers : ndarray (POINTS, 2)
        Powers taken out and supplied [W].
    """

    a: Array
    zd: Array
    powers: Array


@dataclass(frozen=True)
class Path(Portable):
    """Free coordinates, their rates, internal states of laws, and energies over a stretch of time.

    Attributes
    ----------
    t0, t1 : float
        Its ends [s].
    x, v, z : ndarray (terms, nf), (terms, nf), (terms, nz)
        Coefficients of Legendre's polynomials from degree zero on.
    energies : ndarray (terms, 2)
        The same for the energies taken out and supplied since the start [J].
    """

    t0: float
    t1: float
    x: Array
    v: Array
    z: Array
    energies: Array

    @classmethod
    def through(cls, moments: Sequence[Snapshot], nf: int, z: Array, t1: float) -> Path:
        """Return the path of least degree through the coordinates and rates at some instants, from the first on.

        Parameters
        ----------
        z : ndarray (nz,)
            Internal states, which are constant.
        """
        t0 = moments[0].t
        half, size = (t1 - t0) / 2, 2 * len(moments)
        places = np.array([(m.t - t0) / half - 1 for m in moments])
        values = legvander(places, size - 1)
        slopes = values[:, :-1] @ legder(np.eye(size))
        sides = [[m.x[:nf] for m in moments], [half * m.v[:nf] for m in moments]]
        x = np.linalg.solve(np.concatenate([values, slopes]), np.concatenate(sides))
        v = np.asarray(legder(x, axis=0) / half, dtype=float)
        return cls(t0, t1, x, v, z[None, :], np.zeros((1, 2)))

    @classmethod
    def integral(cls, start: Snapshot, z: Array, t1: float, rates: Rates) -> Path:
        """Integrate the path from a start on.

        Parameters
        ----------
        z : ndarray (nz,)
            Internal states at the start.
        rates : Rates
        """
        half, nf = (t1 - start.t) / 2, rates.a.shape[1]
        v = _integral(SERIES @ rates.a, half, start.v[:nf])
        x, z = _integral(v, half, start.x[:nf]), _integral(SERIES @ rates.zd, half, z)
        return cls(start.t, t1, x, v, z, _integral(SERIES @ rates.powers, half, np.zeros(2)))

    @property
    def half(self) -> float:
        """Half its length [s]."""
        return (self.t1 - self.t0) / 2

    @property
    def times(self) -> Array:
        """Times (POINTS,) of the points [s]."""
        return np.asarray(self.t0 + self.half * (1 + PLACES))

    def at_points(self) -> tuple[Array, Array, Array]:
        """Return coordinates, rates and internal states at the points, each (POINTS, number)."""
        x, v, z = (BASIS[:, : len(series)] @ series for series in (self.x, self.v, self.z))
        return x, v, z

    def at(self, t: float) -> tuple[Array, Array, Array]:
        """Return the same at a time [s], each (number,)."""
        x, v, z = (self._value(series, t) for series in (self.x, self.v, self.z))
        return x, v, z

    def accelerations(self, t: float) -> Array:
        """Return the accelerations (nf,) at a time [s]."""
        return self._value(np.asarray(legder(self.v, axis=0) / self.half, dtype=float), t)

    def exchanged(self, t0: float, t1: float) -> tuple[float, float, float]:
        """Return energies [J] taken out and supplied from one time [s] to another, and their error."""
        lost, work = (self._value(self.energies, t1) - self._value(self.energies, t0)).tolist()
        return lost, work, float(np.abs(self.energies[-LAST:]).sum())

    def _value(self, series: Array, t: float) -> Array:
        place = (t - self.t0) / self.half - 1
        return np.asarray(legvander(np.array([place]), len(series) - 1)[0] @ series)


def _integral(series: Array, half: float, start: Array) -> Array:
    """Integrate a series from -1 on, times half the length, with a given value at the start."""
    if not start.size:
        return np.zeros((len(series) + 1, 0))
    found = np.asarray(half * legint(series, lbnd=-1, axis=0))
    found[0] += start
    return found
