"""Spatial linkages that follow one angle, also through their change points: cranks on hinges that bars connect.

The hinges of neighbouring cranks of length a are b apart on a common line, and turned against one another by beta
about it.  Angles of the cranks are measured from that line.  A bar of length b between their ends demands, with the
tangents t and u of half the angles,

    (a + b) t^2 - 2 a cos(beta) t u + (a - b) u^2 = 0,

so that u = k t with either of two constants k.  The two branches meet where all cranks are on the line.  Parallelogram
and antiparallelogram have beta = 0; where a sin(beta) = b sin(alpha), one branch is the linkage of Bennett.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import sympy as sp
from linkages import PHI, Bar, G, Linkage, Place

import flexel as fx

CRANK = 0.8
TILTED = sp.rot_axis1(sp.Rational(7, 10)) * sp.rot_axis3(sp.Rational(-4, 10))  # the axes of the linkage


@dataclass(frozen=True)
class SpatialLinkage(Linkage):
    """Bars in space.

    Attributes
    ----------
    axes : mapping of (str, str) to tuple of float
        The hinges of those bars that are cranks; the others have a ball at each end.
    """

    axes: Mapping[Bar, tuple[float, ...]] = field(default_factory=dict)

    def model(self) -> fx.Model:
        """The linkage as drawn at its start."""
        m = self.points()
        ground = m.frame("ground", fixed=True)
        for p, q in self.bars:
            name = f"bar {p}{q}"
            if (p, q) not in self.axes:
                m.truss(name, p, q, mass_per_length=1.0)
                continue
            frame = m.frame(f"R{p}{q}")
            m.hinge(f"hinge {p}{q}", ground, frame, self.axes[p, q])
            m.beam(name, p, frame, q, mass_per_length=1.0)
        return m


def series(loops: Sequence[tuple[float, float, int]], start: float = 1.2) -> SpatialLinkage:
    """Cranks in series on one line.

    Parameters
    ----------
    loops : sequence of (float, float, int)
        Of each loop b, beta and the branch, 1 or -1.
    """
    x, turned, factor = 0.0, 0.0, 1.0
    places: dict[str, Place] = {}
    axes = {}
    for i, (b, beta, branch) in enumerate([(0.0, 0.0, 1), *loops]):
        if i:
            root = np.sqrt(b**2 - (CRANK * np.sin(beta)) ** 2)
            factor *= float((CRANK * np.cos(beta) - branch * root) / (CRANK - b))
        x, turned = x + b, turned + beta
        up, along = factor * sp.sin(PHI / 2), sp.cos(PHI / 2)
        cosine, sine = ((along**2 - up**2) / (along**2 + up**2), 2 * up * along / (along**2 + up**2))
        y, z = float(np.cos(turned)), float(np.sin(turned))  # SymPy 1.12 cannot read NumPy's numbers
        tip = sp.Matrix([x + CRANK * cosine, CRANK * sine * y, CRANK * sine * z])
        places[f"O{i}"] = tuple(TILTED * sp.Matrix([x, 0, 0]))
        places[f"A{i}"] = tuple(TILTED * tip)
        axis = TILTED * sp.Matrix([0, -z, y])
        axes[f"O{i}", f"A{i}"] = tuple(map(float, axis))
    bars = [*axes, *((f"A{i}", f"A{i + 1}") for i in range(len(loops)))]
    return SpatialLinkage(places, bars, start, gravity=(0.0, -G, 0.0), axes=axes)


BENNETT = float(
    np.arcsin(1.7 / CRANK * np.sin(0.3))
)  # the twist of a coupler of 1.7 m between cranks of 0.3 rad
SPATIAL: dict[str, Callable[[], SpatialLinkage]] = {
    "one parallelogram": lambda: series([(1.3, 0.0, 1)]),
    "two parallelograms": lambda: series([(1.3, 0.0, 1), (1.9, 0.0, 1)]),
    "three parallelograms": lambda: series([(1.3, 0.0, 1), (1.9, 0.0, 1), (1.3, 0.0, 1)]),
    "parallelogram and antiparallelogram": lambda: series([(1.3, 0.0, 1), (1.9, 0.0, -1)]),
    "one twisted loop": lambda: series([(1.7, 0.6, 1)]),
    "the same on its other branch": lambda: series([(1.7, 0.6, -1)], -0.6),
    "Bennett's linkage": lambda: series([(1.7, BENNETT, 1)]),
    "two twisted loops": lambda: series([(1.7, 0.6, 1), (1.4, -0.9, 1)]),
    "three twisted loops": lambda: series([(1.7, 0.6, 1), (1.4, -0.9, 1), (2.1, 0.5, 1)]),
}
