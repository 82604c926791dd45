"""Closed forms and small reference solutions of the rope problems."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.special import jn_zeros, jv, yv

from flexel.base.arrays import Array

G = 9.81
CONTACT_TIME = 2.94327518432470466  # of Hertz: duration of contact over largest approach per speed


@dataclass(frozen=True)
class Catenary:
    """An elastic cable between supports (0, 0) and (l, h), with the forces at its first end.

    Attributes
    ----------
    l, h : float
        Span and height of the second support over the first [m].
    L0 : float
        Undeformed length [m].
    w : float
        Weight per undeformed length [N/m].
    EA : float
        [N]
    H, V : float
        Horizontal and vertical force at the first support [N].
    """

    l: float
    h: float
    L0: float
    w: float
    EA: float
    H: float
    V: float

    def __call__(self, u: float) -> tuple[float, float]:
        """Return the point of the closed form at the undeformed arc length u L0 (Irvine 1981)."""
        s = u * self.L0
        H, V, w = self.H, self.V, self.w
        x = H * s / self.EA + H / w * (np.arcsinh(V / H) - np.arcsinh((V - w * s) / H))
        y = w * s / self.EA * (V / w - s / 2) + (np.hypot(H, V) - np.hypot(H, V - w * s)) / w
        return float(x), -float(y)

    @property
    def forces(self) -> Array:
        """Horizontal force and tensions at both ends (3,) [N]."""
        return np.array([self.H, np.hypot(self.H, self.V), np.hypot(self.H, self.V - self.w * self.L0)])


# sag of a tenth of the span, supports at different heights
CATENARY = Catenary(10.0, 3.0, 12.0, 19.62, 1e5, 101.2854789775084, 78.41315172609652)


def chain_frequencies(length: float, count: int) -> Array:
    """Return frequencies (count,) [rad/s] of a chain that hangs from one end: zeros of the Bessel function J0."""
    return np.asarray(jn_zeros(0, count) / 2 * np.sqrt(G / length))


def loaded_chain_frequencies(length: float, share: float, count: int) -> Array:
    """Return frequencies (count,) [rad/s] of a hanging chain with a payload of 1/share of its mass at its end.

    Shapes are A J0(s) + B Y0(s) with s = 2 ω sqrt((y + l)/g) at a height y over the payload and l = length/share; the
    top is at rest, and the payload swings like the last of the chain: J2(s₀) Y0(s₁) = Y2(s₀) J0(s₁).
    """
    l = length / share

    def residual(omega: float) -> float:
        s = 2 * omega * np.sqrt(np.array([l, l + length]) / G)
        return float(jv(2, s[0]) * yv(0, s[1]) - yv(2, s[0]) * jv(0, s[1]))

    step = (
        np.pi / 16 * np.sqrt(G) / (np.sqrt(l + length) - np.sqrt(l))
    )  # an eighth of that between high roots
    grid = step * np.append(1e-6, np.arange(1, 8 * (count + 2)))
    found = [brentq(residual, a, b, xtol=1e-14) for a, b in pairwise(grid) if residual(a) * residual(b) < 0]
    return np.array(found[:count])


def stretched_frequencies(share: float, count: int) -> Array:
    """Return frequencies (count,) along a rope of a share of its payload's mass, in units of sqrt(k/payload).

    beta tan beta = share, frequency beta/sqrt(share); a third of the rope's mass added to the payload gives nearly the
    first, 1/sqrt(1 + share/3).
    """
    roots = [
        brentq(lambda x: x * np.sin(x) - share * np.cos(x), k * np.pi, (k + 0.5) * np.pi, xtol=1e-15)
        for k in range(count)
    ]
    return np.asarray(np.array(roots) / np.sqrt(share))


def atwood_fall(
    t: Array, m1: float, m2: float, rope: float, length: float, inertia: float, radius: float
) -> Array:
    """Return the fall (nt,) [m] of m1 of Atwood's machine from rest, the rope with a mass per length, level at first.

    (m1 + m2 + rope length + inertia/radius²) x'' = (m1 - m2) g + 2 rope g x
    """
    rate = np.sqrt(2 * rope * G / (m1 + m2 + rope * length + inertia / radius**2))
    return np.asarray((m1 - m2) / rope * np.sinh(rate * t / 2) ** 2)  # cosh - 1, without cancellation


def hertz(stiffness: float, mass: float, speed: float) -> tuple[float, float]:
    """Return the largest approach [m] and duration [s] of the impact of a mass on a spring of exponent 3/2."""
    approach = (5 * mass * speed**2 / (4 * stiffness)) ** 0.4
    return float(approach), CONTACT_TIME * approach / speed


def sliding_fall(t: Array, ahead: float, length: float) -> Array:
    """Return the fall (nt,) [m] of the lower end of a rope over a smooth edge, lower by twice `ahead` at first."""
    return np.asarray(2 * ahead * np.sinh(np.sqrt(G / (2 * length)) * t) ** 2)


def reduced_hoist(
    times: Array,
    mass: float,
    EA: float,
    length: float,
    radius: float,
    damping: float,
    speed: Callable[[float], float],
    stretched: bool,
) -> tuple[Array, Array]:
    """Return depth (nt,) [m] and tension (nt,) [N] of a load that is released on a rope that a drum winds up.

    The rope is massless and straight; its tension is EA (strain + damping strain') with the strain x/l - 1 of its free
    undeformed length l.  The drum takes up an undeformed length of radius times angle, or, `stretched`, the rope as it
    arrives, of which less is undeformed.
    """

    def pull(t: float, x: float, v: float, free: float) -> tuple[float, float]:
        taken = -radius * speed(t) * (free / x if stretched else 1.0)
        return max(EA * (x / free - 1 + damping * (v / free - x * taken / free**2)), 0.0), taken

    def rates(t: float, y: Array) -> list[float]:
        force, taken = pull(t, *y)
        return [y[1], G - force / mass, taken]

    start = [length, 0.0, length]
    found = solve_ivp(rates, (0, times[-1]), start, t_eval=times, rtol=1e-10, atol=1e-12, max_step=1e-2).y
    return found[0], np.array([pull(t, *y)[0] for t, y in zip(times, found.T, strict=True)])
