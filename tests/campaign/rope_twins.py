"""Cables written again: cubic curves with slopes that stretch and bend, in space and in the plane."""

from collections.abc import Sequence

import numpy as np

from campaign.algebra import cross, dot, norm
from campaign.beam_twins import hermite, mean
from campaign.elastic import Stressed, elastic
from flexel.base.arrays import Array

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(3)
XI, SHARES = (1 + _NODES) / 2, _WEIGHTS / 2


def ends(x: Array) -> tuple[Array, Array, Array, Array]:
    """Place and slope at p, place and slope at q, of the coordinates of a cable in space or in the plane."""
    size = x.shape[0] // 4
    return x[:size], x[size : 2 * size], x[2 * size : 3 * size], x[3 * size :]


def first(x: Array, xi: float, l0: float) -> Array:
    """Slope of the cubic at the fraction xi of its length."""
    p, dp, q, dq = ends(x)
    return 6 * (xi - xi**2) / l0 * (q - p) + (1 - 4 * xi + 3 * xi**2) * dp + (3 * xi**2 - 2 * xi) * dq


def second(x: Array, xi: float, l0: float) -> Array:
    """Its second derivative by the arc length."""
    p, dp, q, dq = ends(x)
    return ((6 - 12 * xi) / l0 * (q - p) + (6 * xi - 4) * dp + (6 * xi - 2) * dq) / l0


class Cable(Stressed):
    """A cable between the nodes p, slope p, q and slope q; coordinates (12,), or (8,) in the plane.

    The strain is the quadratic function of the arc length that has the cubic's strain |r'| - 1 at the ends, and its
    mean by three Gauss points. It is described by its mean and by its parts along Legendre's polynomials P1 and P2.
    """

    def __init__(
        self,
        name: str,
        nodes: Sequence[str],
        l0: float,
        gravity: Sequence[float],
        *,
        EA: float,
        EI: float,
        mass_per_length: float = 0.0,
        damping: float = 0.0,
        bending_damping: float = 0.0,
    ) -> None:
        self.name, self.nodes, self.l0 = name, tuple(nodes), l0
        self.rhoA, self.gravity = mass_per_length, np.array(gravity)
        planar = len(gravity) == 2
        bends = [EI * w * l0 for w in SHARES for _ in range(1 if planar else 3)]
        axes = ("",) if planar else ("x", "y", "z")
        modes = [
            "strain1",
            "strain2",
            "strain3",
            *(f"curvature{i}{axis}" for i in (1, 2, 3) for axis in axes),
        ]
        stretches = [
            EA * l0 * w for w in (1, 1 / 3, 1 / 5)
        ]  # squares of Legendre's polynomials over the length
        S = np.diag([*stretches, *bends])
        ratios = np.array([damping] * 3 + [bending_damping] * len(bends))
        self.elastic = elastic(modes, S, np.zeros(len(modes)), ratios)
        self.conserves = not self.elastic.D.any()

    def deformations(self, x: Array) -> Array:
        """Strains, then curvatures at the Gauss points (6, …) or (12, …)."""
        slopes = [first(x, xi, self.l0) for xi in XI]
        average = sum(w * norm(slope) for w, slope in zip(SHARES, slopes, strict=True)) - 1
        _, dp, _, dq = ends(x)
        at_p, at_q = norm(dp) - 1, norm(dq) - 1
        found = [average, (at_q - at_p) / 2, (at_p + at_q) / 2 - average]
        for xi, slope in zip(XI, slopes, strict=True):
            bend = second(x, xi, self.l0)
            if len(slope) == 2:
                found.append((slope[0] * bend[1] - slope[1] * bend[0]) / dot(slope, slope))
            else:
                found.extend(cross(slope, bend) / dot(slope, slope))
        return np.array(found)

    def kinetic(self, x: Array, v: Array) -> Array:  # noqa: ARG002 (the mass matrix is constant)
        p, dp, q, dq = ends(v)
        rates = hermite(p, self.l0 * dp, q, self.l0 * dq)
        return self.rhoA * self.l0 / 2 * mean([dot(rate, rate) for rate in rates])

    def potential(self, x: Array) -> Array:
        p, dp, q, dq = ends(x)
        centre = mean(hermite(p, self.l0 * dp, q, self.l0 * dq))
        weight = self.rhoA * self.l0 * np.tensordot(self.gravity, centre, 1)
        return self.elastic.energy(self.deformations(x)) - weight

    def force(self, x: Array, v: Array, z: Array, t: float) -> Array:  # noqa: ARG002 (no internal states)
        return self.elastic.viscous(self.deformations, x, v)

    def stresses(self, x: Array, v: Array, z: Array, t: float) -> dict[str, float]:  # noqa: ARG002 (as force)
        found = self.elastic.stresses(self.deformations, x, v)
        return {f"{self.name}.{mode}": value for mode, value in found.items()}


def on_arc(x: Array, xi: float, l0: float) -> Array:
    """The point at the fraction xi that touches: of the cubic whose slopes are longer where it turns."""
    p, dp, q, dq = ends(x)
    turn = dq - dp
    D = dot(turn, turn)
    h = 1 + D / 48 + 13 * D**2 / 5760
    weights = (
        (1 + 2 * xi) * (1 - xi) ** 2,
        l0 * xi * (1 - xi) ** 2,
        xi**2 * (3 - 2 * xi),
        l0 * xi**2 * (xi - 1),
    )
    return weights[0] * p + weights[2] * q + h * (weights[1] * dp + weights[3] * dq)
