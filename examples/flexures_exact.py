"""Closed forms that the flexure mechanisms are compared with, each with its source.

Beam-column theory (Timoshenko and Gere 1961) for the stiffness under payload; Haringx (1949) and Wittrick
(1951) treated the cross-flexure pivot in this way.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

from flexel.base.arrays import Array
from flexel.parts.materials import Profile

BEAM = "Timoshenko cantilevers, moved to the body and added"
COLUMN = "beam-column theory (Timoshenko and Gere 1961)"
PIVOT = "beam-column theory; Haringx 1949, Wittrick 1951"
AWTAR = "Awtar, Slocum and Sevincer 2007, J. Mech. Des. 129"
BENT = "Castigliano on the bent leaf (z, turns); Awtar et al. 2007 (x)"
FREQUENCY = "Euler-Bernoulli beam with end mass, end not turning"
ELASTICA = "elliptic integrals of the elastica, half a leaf as a cantilever"


def root(function: object, a: float, b: float) -> float:
    """Find a root between a and b."""
    return float(brentq(function, a, b, xtol=1e-14, rtol=8.9e-16))  # type: ignore[call-overload]


def end_stiffness(profile: Profile, length: float) -> Array:
    """Return the stiffness (6, 6) of the end of a Timoshenko cantilever along x, in its axes."""
    k, L = profile.stiffness(), length
    C = np.diag(
        [
            L / k["EA"],
            L**3 / (3 * k["EIz"]) + L / k["GAy"],
            L**3 / (3 * k["EIy"]) + L / k["GAz"],
            L / k["GJ"],
            L / k["EIy"],
            L / k["EIz"],
        ]
    )
    C[1, 5] = C[5, 1] = L**2 / (2 * k["EIz"])
    C[2, 4] = C[4, 2] = -(L**2) / (2 * k["EIy"])
    return np.asarray(np.linalg.inv(C))


def body_stiffness(profile: Profile, length: float, ends: Sequence[tuple[Array, Array]]) -> Array:
    """Return the stiffness (6, 6) of a rigid body at its reference point, on unloaded leaf springs.

    Parameters
    ----------
    ends : sequence of (axes (3, 3), place (3,))
        Of each leaf: its axes as columns, and its end on the body from the reference point.
    """
    total = np.zeros((6, 6))
    K = end_stiffness(profile, length)
    for axes, r in ends:
        T = np.eye(6)
        T[:3, 3:] = [[0, r[2], -r[1]], [-r[2], 0, r[0]], [r[1], -r[0], 0]]
        S = np.kron(np.eye(2), axes).T @ T
        total += S.T @ K @ S
    return total


def guided_stiffness(EI: float, L: float, N: float) -> float:
    """Return the lateral stiffness [N/m] of a clamped leaf whose end does not turn, under the tension N [N]."""
    x = L / 2 * np.sqrt(abs(N) / EI)
    return float(N / (L * (1 - (np.tanh(x) if N > 0 else np.tan(x)) / x)))


def pivot_stiffness(EI: float, L: float, N: float) -> float:
    """Return the stiffness [N m/rad] that a leaf crossing at its middle gives a pivot, under the tension N [N].

    Symmetric bending of the leaf, EI/L x coth x, and the moment -N L/4 of the force along its chord about the
    pivot, with x = L/2 sqrt(N/EI); in compression x cot x + x² replaces x coth x - x².
    """
    x = L / 2 * np.sqrt(abs(N) / EI)
    return float(EI / L * (x / np.tanh(x) - x * x if N > 0 else x / np.tan(x) + x * x))


def pivot_buckling(EI: float, L: float) -> tuple[float, float]:
    """Return the compression and tension [N] of a leaf at which that stiffness is zero."""
    push = root(lambda x: x / np.tan(x) + x * x, 2.0, 3.1)
    pull = root(lambda x: 1 / np.tanh(x) - x, 0.5, 2.0)
    return 4 * push**2 * EI / L**2, 4 * pull**2 * EI / L**2


def bent_leaf(profile: Profile, L: float, u: float) -> Array:
    """Return the compliance (3, 3) of the end of a leaf bent to y = u (3 s² - 2 s³): z force, moments about x and y.

    Castigliano's theorem for a curved bar: torque, bending about the normal in the plane, shear.
    """
    k = profile.stiffness()
    nodes, weights = np.polynomial.legendre.leggauss(24)
    total = np.zeros((3, 3))
    for s, w in zip((nodes + 1) / 2, weights / 2, strict=True):
        slope = 6 * u / L * s * (1 - s)
        c = 1 / np.hypot(1, slope)
        about_x = np.array([u * (1 - 3 * s**2 + 2 * s**3), 1.0, 0.0])
        about_y = np.array([-L * (1 - s), 0.0, 1.0])
        torque, bending = c * (about_x + slope * about_y), c * (about_y - slope * about_x)
        shear = np.array([1.0, 0.0, 0.0])
        parts = ((torque, k["GJ"]), (bending, k["EIy"]), (shear, k["GAz"]))
        total += (
            w * L / c * np.sum([np.outer(vector, vector) / stiffness for vector, stiffness in parts], axis=0)
        )
    return total


def bent_guide(profile: Profile, L: float, spacing: float, u: float) -> dict[str, float]:
    """Return the stiffness of a parallel guide at the travel u, at half its height, in x, z, turn x, turn y.

    Small u, and leaf springs much stiffer in their plane than out of it; the drive is held.
    """
    K = np.zeros((3, 3))
    for y in (-spacing / 2, spacing / 2):
        T = np.array([[1, y, -L / 2], [0, 1, 0], [0, 0, 1]])
        K += T.T @ np.linalg.inv(bent_leaf(profile, L, u)) @ T
    C = np.diag(np.linalg.inv(K))
    k = profile.stiffness()
    along = (
        (L / k["EA"] + L * u**2 / (700 * k["EIz"])) / 2 * (1 + (u / spacing) ** 2)
    )  # the shuttle turns a little
    return {"x": 1 / along, "z": float(1 / C[0]), "turn x": float(1 / C[1]), "turn y": float(1 / C[2])}


def guided_frequency(EI: float, L: float, rhoA: float, mass: float) -> float:
    """Return the lowest frequency [rad/s] of a clamped Euler-Bernoulli beam whose end has a mass and does not turn."""

    def residual(b: float) -> float:
        """Return the end force for the shape A (cosh - cos) + B (sinh - sin) with slope zero at the end."""
        s, c, sh, ch = np.sin(b), np.cos(b), np.sinh(b), np.cosh(b)
        A, B = ch - c, -(sh + s)
        value = A * (ch - c) + B * (sh - s)
        third = A * (sh - s) + B * (ch + c)
        return float(third + mass / (rhoA * L) * b * value)

    b = root(residual, 1e-2, 2.4)
    return b * b * float(np.sqrt(EI / (rhoA * L**4)))


def cantilever_elastica(a: float) -> tuple[float, float]:
    """Return deflection and shortening, over the length, of a cantilever with a dead end force across it, a = P L²/EI.

    Bisshop and Drucker 1945: k² = (1 + sin of the end slope)/2, K(k) - F(k, phi) = sqrt(a), sin phi = 1/(k sqrt 2).
    """

    def gap(m: float) -> float:
        return float(ellipk(m) - ellipkinc(np.arcsin(1 / np.sqrt(2 * m)), m) - np.sqrt(a))

    m = root(gap, 0.5 + 1e-14, 1 - 1e-12)
    phi = np.arcsin(1 / np.sqrt(2 * m))
    deflection = 1 - 2 / np.sqrt(a) * (ellipe(m) - ellipeinc(phi, m))
    return float(deflection), float(1 - np.sqrt(2 * (2 * m - 1) / a))
