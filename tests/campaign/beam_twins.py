"""Flexible beams written again: deformations, energies and stresses of the spatial and of the planar one.

Triads are vectors fixed in the bodies at the ends, not quaternions; the kinetic energy is an integral by Gauss points
over the interpolated motion of the axis and of the sections, not a mass matrix; the bending stiffness is the inverse of
the flexibility of a beam on two supports.
"""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from campaign.algebra import body_rate, conjugate, cross, dot, norm, rotated, rotated_rate, turned
from campaign.elastic import Elastic, Stressed, elastic
from campaign.oracle import jacobian
from flexel.base.arrays import Array

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)  # exact for the squares of cubics
XI, WEIGHTS = (1 + _NODES) / 2, _WEIGHTS / 2

SPATIAL = ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4")
PLANAR = ("elongation", "bend1", "bend2")


def hermite(p: Array, slope_p: Array, q: Array, slope_q: Array) -> list[Array]:
    """Array at the Gauss points of the cubic with these end values and these slopes by xi."""
    return [
        (1 + 2 * xi) * (1 - xi) ** 2 * p
        + xi * (1 - xi) ** 2 * slope_p
        + xi**2 * (3 - 2 * xi) * q
        + xi**2 * (xi - 1) * slope_q
        for xi in XI
    ]


def mean(values: Sequence[Array]) -> Array:
    """Integral over xi, from 0 to 1, of what has these values at the Gauss points."""
    total = WEIGHTS[0] * values[0]
    for w, value in zip(WEIGHTS[1:], values[1:], strict=True):
        total = total + w * value
    return total


def sections(shear: float, chord: Array, p: Array, q: Array) -> Array:
    """Mean square of the angular velocity of the sections about a transverse axis.

    With the shear number, the sections turn as those of a Timoshenko beam under loads at its ends.
    """
    rates = [
        (6 * xi * (1 - xi) * chord + (1 - xi) * (1 - 3 * xi + shear) * p + xi * (3 * xi - 2 + shear) * q)
        / (1 + shear)
        for xi in XI
    ]
    return mean([w * w for w in rates])


def bending(EI: float, GA: float | None, l0: float) -> Array:
    """Stiffness (2, 2) of the two bending modes of a plane.

    On two supports, a unit moment at one end turns this end by l/(3 EI) and the other one by -l/(6 EI), and the shear
    force 1/l turns both by 1/(GA l). The modes are -l and l times the angles of the ends with the chord.
    """
    slide = 0.0 if GA is None else 1 / (GA * l0)
    flexibility = np.array(
        [[l0 / 3 / EI + slide, slide - l0 / 6 / EI], [slide - l0 / 6 / EI, l0 / 3 / EI + slide]]
    )
    to_angles = np.diag([-1.0, 1.0]) / l0
    return np.asarray(to_angles @ np.linalg.inv(flexibility) @ to_angles)


def shear_number(EI: float | None, GA: float | None, l0: float) -> float:
    """12 EI/(GA l²) of one plane of bending; zero without shear deformation."""
    return 0.0 if EI is None or GA is None else 12 * EI / (GA * l0**2)


class Beam(Stressed):
    """A beam in space between the nodes p, frame p, q and frame q; coordinates (14,)."""

    modes = SPATIAL

    def __init__(
        self,
        name: str,
        nodes: Sequence[str],
        drawn: Sequence[Array],
        gravity: Sequence[float],
        *,
        direction: Sequence[float] = (),
        rigid: bool = False,
        EA: float | None = None,
        GJ: float | None = None,
        EIy: float | None = None,
        EIz: float | None = None,
        GAy: float | None = None,
        GAz: float | None = None,
        initial_strain: float = 0.0,
        initial_curvature: Any = (0.0, 0.0, 0.0),
        damping: float = 0.0,
        mass_per_length: float = 0.0,
        inertia_per_length: Any = (0.0, 0.0, 0.0),
        second_order: bool = True,
    ) -> None:
        self.name, self.nodes, self.gravity = name, tuple(nodes), np.array(gravity)
        self.rhoA, self.rhoJ = mass_per_length, np.atleast_1d(inertia_per_length)
        self.second = second_order
        self._draw(drawn, direction)
        l0 = self.l0
        S = np.zeros((6, 6))
        S[0, 0] = (EA or 0.0) / l0
        S[1, 1] = (GJ or 0.0) / l0**3
        S[2:4, 2:4] = 0.0 if EIy is None else bending(EIy, GAz, l0)
        S[4:, 4:] = 0.0 if EIz is None else bending(EIz, GAy, l0)
        self.shear = shear_number(EIz, GAy, l0), shear_number(EIy, GAz, l0)
        self.elastic = self._elasticity(S, initial_strain, initial_curvature, damping)
        self.conserves = not damping
        self.loads: list[Callable[[float], Array]] = []

    def _elasticity(self, S: Array, strain: float, curvature: Any, ratio: float) -> Elastic:
        l0, (twist, about_y, about_z) = self.l0, curvature
        rest = np.array([strain * l0, twist * l0**2, *[about_y * l0**2 / 2] * 2, *[about_z * l0**2 / 2] * 2])
        return elastic(SPATIAL, S, rest, ratio)

    def _draw(self, drawn: Sequence[Array], direction: Sequence[float]) -> None:
        """Undeformed length, and the triads of the section as vectors fixed in the bodies at p and q."""
        xp, rp, xq, rq = (np.asarray(place, float) for place in drawn)
        self.l0 = float(norm(xq - xp))
        ex = (xq - xp) / self.l0
        hint = np.asarray(direction, float)
        ey = hint - (hint @ ex) * ex
        ey /= norm(ey)
        triad = ex, ey, cross(ex, ey)
        self.at_p, self.at_q = ([rotated(conjugate(r), e) for e in triad] for r in (rp, rq))

    def deformations(self, x: Array) -> Array:
        """The six deformations (6, …)."""
        p, q = [rotated(x[3:7], e) for e in self.at_p], [rotated(x[10:14], e) for e in self.at_q]
        d = x[7:10] - x[:3]
        l, l0 = norm(d), self.l0
        t = d / l
        stretch, twist = l - l0, l0 * (dot(p[2], q[1]) - dot(p[1], q[2])) / 2
        b3, b4, b5, b6 = -l0 * dot(p[2], t), l0 * dot(q[2], t), l0 * dot(p[1], t), -l0 * dot(q[1], t)
        if not self.second:
            return np.array([stretch, twist, b3, b4, b5, b6])
        shortening = (b3 * (2 * b3 + b4) + 2 * b4**2 + b5 * (2 * b5 + b6) + 2 * b6**2) / (30 * l0)
        k, h = twist * (b5 + b6) / (6 * l0), twist * (b3 + b4) / (6 * l0)
        torsion = twist + (b4 * b5 - b3 * b6) / l0
        return np.array([stretch + shortening, torsion, b3 + k, b4 - k, b5 - h, b6 + h])

    def kinetic(self, x: Array, v: Array) -> Array:
        l0, (jx, jy, jz) = self.l0, self.rhoJ
        p, q = [rotated(x[3:7], e) for e in self.at_p], [rotated(x[10:14], e) for e in self.at_q]
        slope_p = rotated_rate(x[3:7], v[3:7], self.at_p[0])
        slope_q = rotated_rate(x[10:14], v[10:14], self.at_q[0])
        axis = hermite(v[:3], l0 * slope_p, v[7:10], l0 * slope_q)
        T = self.rhoA * mean([dot(velocity, velocity) for velocity in axis])
        chord = (v[7:10] - v[:3]) / norm(x[7:10] - x[:3])
        about_y, about_z = -dot(chord, p[2] + q[2]) / 2, dot(chord, p[1] + q[1]) / 2
        in_p, in_q = body_rate(x[3:7], v[3:7]), body_rate(x[10:14], v[10:14])
        w_p, w_q = ([dot(w, e) for e in at] for w, at in ((in_p, self.at_p), (in_q, self.at_q)))
        twisting = [(1 - xi) * w_p[0] + xi * w_q[0] for xi in XI]
        T = T + jx * mean([w * w for w in twisting])
        T = T + jy * sections(self.shear[1], about_y, w_p[1], w_q[1])
        T = T + jz * sections(self.shear[0], about_z, w_p[2], w_q[2])
        return l0 * T / 2

    def moment(self, x: Array) -> Array:
        """Integral (3, …) of the position over the undeformed length."""
        slopes = self.l0 * rotated(x[3:7], self.at_p[0]), self.l0 * rotated(x[10:14], self.at_q[0])
        return self.l0 * mean(hermite(x[:3], slopes[0], x[7:10], slopes[1]))

    def potential(self, x: Array) -> Array:
        return self.elastic.energy(self.deformations(x)) - self.rhoA * np.tensordot(
            self.gravity, self.moment(x), 1
        )

    def force(self, x: Array, v: Array, z: Array, t: float) -> Array:  # noqa: ARG002 (no internal states)
        damping = self.elastic.viscous(self.deformations, x, v)
        return damping + sum((w(t) @ jacobian(self.moment, x) for w in self.loads), np.zeros_like(x))

    def stresses(self, x: Array, v: Array, z: Array, t: float) -> dict[str, float]:  # noqa: ARG002 (as force)
        found = self.elastic.stresses(self.deformations, x, v)
        return {f"{self.name}.{mode}": value for mode, value in found.items()}


class PlanarBeam(Beam):
    """A beam in the plane between the nodes p, angle p, q and angle q; coordinates (6,)."""

    modes = PLANAR

    def _elasticity(self, S: Array, strain: float, curvature: Any, ratio: float) -> Elastic:
        own, k = [0, 4, 5], np.sum(curvature)  # zeros by default, or one number
        rest = np.array([strain * self.l0, *[k * self.l0**2 / 2] * 2])
        return elastic(PLANAR, S[np.ix_(own, own)], rest, ratio)

    def _draw(self, drawn: Sequence[Array], direction: Sequence[float]) -> None:  # noqa: ARG002 (of space)
        xp, rp, xq, rq = (np.asarray(place, float) for place in drawn)
        self.l0 = float(norm(xq - xp))
        ex = (xq - xp) / self.l0
        self.at_p, self.at_q = ([turned(-r[0], e) for e in (ex, np.array([-ex[1], ex[0]]))] for r in (rp, rq))

    def deformations(self, x: Array) -> Array:
        """Elongation and the two bendings (3, …)."""
        d = x[3:5] - x[:2]
        l, l0 = norm(d), self.l0
        b1, b2 = l0 * dot(turned(x[2], self.at_p[1]), d / l), -l0 * dot(turned(x[5], self.at_q[1]), d / l)
        shortening = (2 * b1**2 + b1 * b2 + 2 * b2**2) / (30 * l0) if self.second else 0.0
        return np.array([l - l0 + shortening, b1, b2])

    def kinetic(self, x: Array, v: Array) -> Array:
        l0 = self.l0
        p, q = turned(x[2], self.at_p[1]), turned(x[5], self.at_q[1])
        axis = hermite(v[:2], l0 * v[2] * p, v[3:5], l0 * v[5] * q)
        T = self.rhoA * mean([dot(velocity, velocity) for velocity in axis])
        chord = dot(v[3:5] - v[:2], p + q) / (2 * norm(x[3:5] - x[:2]))
        return l0 * (T + self.rhoJ.sum() * sections(self.shear[0], chord, v[2], v[5])) / 2

    def moment(self, x: Array) -> Array:
        """Integral (2, …) of the position over the undeformed length."""
        slopes = self.l0 * turned(x[2], self.at_p[0]), self.l0 * turned(x[5], self.at_q[0])
        return self.l0 * mean(hermite(x[:2], slopes[0], x[3:5], slopes[1]))
