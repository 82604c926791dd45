"""Closed forms of Vlasov's torsion, for the beams of `warping`: stiffness, twist, buckling, frequencies."""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import flexel as fx
from flexel.base.arrays import Array
from flexel.parts.materials import MATERIALS

STEEL = MATERIALS["steel"]
LEAF = fx.Rectangle(20e-3, 0.3e-3)  # a leaf spring on edge, its height along y
BEAM = fx.IBeam(0.2, 0.1, flange=0.01, web=0.007)
SPAN = 3.0  # of the I beam [m]

Section = fx.Rectangle | fx.IBeam


def stiffnesses(section: Section) -> tuple[float, float]:
    """Return GJ [N m²] and E Iw [N m⁴] of a section of steel."""
    return STEEL.shear_modulus * section.J, STEEL.E * section.Iw


def decay(section: Section) -> float:
    """Return Vlasov's k [1/m]: warping decays from a restraint with exp(-k x)."""
    GJ, EIw = stiffnesses(section)
    return float(np.sqrt(GJ / EIw))


def restrained(kl: float) -> float:
    """Return the torsional stiffness of a beam clamped at both ends over that of uniform torsion."""
    return float(1 / (1 - np.tanh(kl / 2) / (kl / 2)))


def cantilever_twist(x: Array, torque: float, length: float, section: Section) -> Array:
    """Return the angle of twist of a cantilever under an end torque: warping held at x = 0, free at the end."""
    GJ, k = stiffnesses(section)[0], decay(section)
    return np.asarray(torque / GJ * (x - np.sinh(k * x) / k + np.tanh(k * length) / k * (np.cosh(k * x) - 1)))


def lateral_moment(section: Section, length: float, warping: bool = True) -> float:
    """Return the uniform moment that buckles a beam between forks, whose weak axis is y."""
    GJ, EIw = stiffnesses(section)
    EIw = EIw if warping else 0.0
    return float(np.pi / length * np.sqrt(STEEL.E * section.Iy * (GJ + np.pi**2 * EIw / length**2)))


def torsional_load(length: float, restraint: float) -> float:
    """Return the axial load that twists the I beam; `restraint` 1: ends free to warp, 2: ends held plane."""
    GJ, EIw = stiffnesses(BEAM)
    return float(BEAM.A / (BEAM.Iy + BEAM.Iz) * (GJ + (restraint * np.pi / length) ** 2 * EIw))


def fork_frequencies(count: int) -> Array:
    """Return the torsional frequencies [rad/s] of the I beam between forks, ends free to warp."""
    GJ, EIw = stiffnesses(BEAM)
    a2 = (np.arange(1, count + 1) * np.pi / SPAN) ** 2
    inertia = STEEL.rho * (BEAM.Iy + BEAM.Iz + BEAM.Iw * a2)
    return np.asarray(np.sqrt(a2 * (GJ + EIw * a2) / inertia))


def cantilever_frequency() -> float:
    """Return the lowest torsional frequency [rad/s] of the I beam with warping held at one end, the other end free."""
    GJ, EIw = stiffnesses(BEAM)
    polar, rho_iw = STEEL.rho * (BEAM.Iy + BEAM.Iz), STEEL.rho * BEAM.Iw

    def determinant(w: float) -> float:
        # phi = exp(r x): E Iw r⁴ - (GJ - rho Iw w²) r² - rho Ip w² = 0, with r² = a² and -b²
        b = GJ - rho_iw * w**2
        root = np.sqrt(b**2 + 4 * EIw * polar * w**2)
        p, q = np.sqrt((b + root) / (2 * EIw)), np.sqrt((root - b) / (2 * EIw))
        c, s, C, S = np.cos(q * SPAN), np.sin(q * SPAN), np.cosh(p * SPAN), np.sinh(p * SPAN)
        # phi = A (cosh - cos) + B (sinh/p - sin/q); at the end no bimoment phi'' and no torque E Iw phi''' - b phi'
        bimoment = [p**2 * C + q**2 * c, p * S + q * s]
        torque = [
            EIw * (p**3 * S - q**3 * s) - b * (p * S + q * s),
            EIw * (p**2 * C + q**2 * c) - b * (C - c),
        ]
        return float(bimoment[0] * torque[1] - bimoment[1] * torque[0])

    guess = fork_frequencies(1)[0]
    grid = np.linspace(0.05, 1.0, 40) * guess
    values = [determinant(w) for w in grid]
    first = next(i for i in range(len(grid) - 1) if values[i] * values[i + 1] < 0)
    return float(brentq(determinant, grid[first], grid[first + 1], xtol=1e-12 * guess))


def stretched(kl: float, ratio: float) -> float:
    """Return the torsional stiffness of a leaf in tension over uniform torsion's; N Ip/A = ratio GJ (Wagner)."""
    tensioned = kl * np.sqrt(1 + ratio)
    return (1 + ratio) * restrained(float(tensioned))


def tip_load_factor(ratio: float) -> float:
    """Return the tip load over sqrt(EIy GJ)/L² that buckles a cantilever sideways, at GJ L²/(E Iw) = ratio.

    The load acts at the centroid.  Integrates E Iw phi'''' - GJ phi'' = (P (L - x))² phi/EIy with phi = phi' = 0 at the
    clamp, and neither bimoment nor torque at the end.
    """

    def determinant(load: float) -> float:
        def slope(x: float, y: Array) -> Array:
            a, b = y[:4], y[4:]
            return np.concatenate(
                [[*state[1:], ratio * (state[2] + (load * (1 - x)) ** 2 * state[0])] for state in (a, b)]
            )

        start = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]
        end = solve_ivp(slope, (0.0, 1.0), start, method="DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
        torque = end[3] - ratio * end[1], end[7] - ratio * end[5]
        return float(end[2] * torque[1] - end[6] * torque[0])

    most = 5.0 + 20.0 / np.sqrt(ratio)
    return float(brentq(determinant, 4.0, most, xtol=1e-10))
