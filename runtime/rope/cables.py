"""Cables: the methods of `Model` that make a slope, add a cable between points, and anchor its end on a body."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from flexel.base.arguments import array, not_negative, positive, span, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.quaternions import in_frame, triad
from flexel.base.transactions import whole_or_nothing
from flexel.declare.beams import Beams
from flexel.declare.materials import Material, Profile, profile_of
from flexel.declare.nodes import Nodes
from flexel.generated.table import LAWS
from flexel.structure.instances import Instance
from flexel.structure.nodes import Node
from flexel.structure.structure import Structure

# Three strains are coefficients of Legendre's polynomials, three curvatures belong to Gauss points on (-1, 1); their
# shares of EA l0 and of EI l0.  Tension is reported at the same points.
STRAINS = np.array([1, 1 / 3, 1 / 5])
POINTS, CURVATURES = np.polynomial.legendre.leggauss(3)
CURVATURES /= 2
LEGENDRE = np.polynomial.legendre.legvander(POINTS, 2)
PLACES = (1 + POINTS) / 2


class Cables(Beams, Nodes):
    """Cables with absolute nodal coordinates."""

    def slope(self, name: str, direction: Any, fixed: bool = False, *, stretch: float = 1.0) -> Node:
        """A slope node: derivative of a cable's position by its undeformed arc length.

        Parameters
        ----------
        direction : sequence of float (3,) or (2,)
            Along the cable, of any length.
        fixed : bool
            Hold direction and stretch; `clamp` holds the direction alone.
        stretch : float
            Length of the slope as drawn: one for an unstretched cable.

        Raises
        ------
        ModelError
            Duplicate name, a direction without length.
        """
        owner = f"slope '{name}'"
        d = array(direction, owner, "direction")
        planar = d.shape == (2,)
        d = vector(d, owner, "direction", 2 if planar else 3)
        length = float(np.linalg.norm(d))
        if length == 0:
            raise ModelError(
                f"{owner}: its direction {d.tolist()} has no length; give a vector along the cable"
            )
        x0 = positive(stretch, owner, "stretch") * d / length
        return self._new_node(name, "planar_slope" if planar else "slope", x0, fixed)

    @whole_or_nothing
    def cable(
        self,
        name: str,
        p: Node | str,
        slope_p: Node | str,
        q: Node | str,
        slope_q: Node | str,
        length: float | None = None,
        *,
        EA: float | None = None,
        EI: float | None = None,
        mass_per_length: float | None = None,
        section: Any = None,
        material: Material | str | None = None,
        damping: float = 0.0,
        bending_damping: float = 0.0,
    ) -> None:
        """Add one cable element between two points with slopes: it stretches, bends and may sag.

        Parameters
        ----------
        length : float, optional
            Undeformed length [m]; by default that of the cubic curve as drawn.
        EA, EI : float
            Stiffness in tension [N] and in bending [N m²]; EI may be zero where both ends of a rope are held.
        mass_per_length : float
            [kg/m]
        section, material : Section and Material (or its name, such as "wire rope")
            Give EA, EI and the mass instead of the numbers; an explicit EI takes precedence.
        damping, bending_damping : float
            Kelvin–Voigt damping of stretching and of bending: ratio of damping to stiffness [s].  In space the rate of
            the curvature vector includes its rotation, so bending damping also resists the rotation of a bent cable
            about axes other than the normal of its plane.

        Raises
        ------
        ModelError
            Points that coincide, a stiffness that is missing or negative.

        See Also
        --------
        Model.cable_line : Many elements along a line or curve.
        """
        owner = f"cable '{name}'"
        kinds = ((p, "point"), (slope_p, "slope"), (q, "point"), (slope_q, "slope"))
        planar, nodes = self._find_nodes(owner, *kinds)
        span(nodes[0].x0, nodes[2].x0, owner)
        l0 = drawn_length(*(z.x0 for z in nodes)) if length is None else positive(length, owner, "length")
        profile = None
        if section is not None or material is not None:
            profile = _profile(owner, section, material, EA, mass_per_length)
            stiffness = profile.stiffness()
            EA, mass_per_length = stiffness["EA"], profile.mass()[0]
            EI = stiffness["EIz"] if EI is None else EI
        if EA is None or EI is None:
            raise ModelError(
                f"{owner}: EA or EI is missing; give both (EI=0 for a chain), or section and material"
            )
        mass = np.array(
            [not_negative(0.0 if mass_per_length is None else mass_per_length, owner, "mass_per_length")]
        )
        element = "planar_cable" if planar else "cable"
        self._place(name, element, nodes, {"l0": np.array([l0]), "rhoA": mass})
        self.instances[name] = replace(self.instances[name], profile=profile)
        S = weights(l0, positive(EA, owner, "EA"), not_negative(EI, owner, "EI"), planar)
        D = S.copy()
        D[:3] *= not_negative(damping, owner, "damping")
        D[3:] *= not_negative(bending_damping, owner, "bending_damping")
        values = {"preload": np.zeros(S.size), "S": S, "D": D}
        modes = self.instances[name].deformations
        self._add_law(owner, LAWS[f"diagonal_{S.size}"], modes, values, label=name)

    def clamp(self, name: str, frame: Node | str, slope: Node | str) -> None:
        """Fix the direction of a cable's end in a body, as drawn; its stretch stays free.

        Parameters
        ----------
        frame : node
            Orientation of the body (an angle in a planar model).
        slope : node
            Slope of the cable's end.
        """
        owner = f"clamp '{name}'"
        planar, (r, d) = self._find_nodes(owner, (frame, "frame"), (slope, "slope"))
        if planar:
            alpha0 = np.arctan2(d.x0[1], d.x0[0]) - r.x0
            self._place(name, "planar_slope_clamp", (r, d), {"alpha0": alpha0})
            return
        t = triad(d.x0 / np.linalg.norm(d.x0), None, owner)
        self._place(name, "slope_clamp", (r, d), {"t": in_frame(r.x0, t)})

    @whole_or_nothing
    def anchor(
        self,
        name: str,
        point: Node | str,
        frame: Node | str,
        end: Node | str,
        slope: Node | str | None = None,
    ) -> None:
        """Anchor a cable's end on a body, where it is drawn; with the slope, its direction too (tangent to a drum).

        The rigid link `name` holds the point, the clamp ``name direction`` the direction.  A cable that ends in a
        body's own point needs no anchor; one that ends at a beam or point mass shares its point.

        Parameters
        ----------
        point, frame : node
            A point of the body, and its orientation.
        end, slope : node
            Point and slope of the cable's end.
        """
        self.beam(name, point, frame, end, rigid=True)
        if slope is None:
            return
        self.clamp(f"{name} direction", frame, slope)


def _profile(owner: str, section: Any, material: Any, EA: float | None, mass: float | None) -> Profile:
    """Section and material of a cable; numbers that they imply must not be given as well."""
    stated = [key for key, z in (("EA", EA), ("mass_per_length", mass)) if z is not None]
    if section is None:
        raise ModelError(
            f"{owner}: material is given without a section; give section=WireRope(…) or the like"
        )
    if stated:
        raise ModelError(
            f"{owner}: section and material give {', '.join(stated)} already; drop these, or drop the section"
        )
    return profile_of(section, material, owner)


def weights(l0: float, EA: float, EI: float, planar: bool) -> Array:
    """Stiffness (12,) or (6,) of the strains and curvatures of a cable."""
    bending = EI * CURVATURES * l0
    return np.concatenate([EA * STRAINS * l0, bending if planar else np.repeat(bending, 3)])


def bending_stiffness(structure: Structure, cable: Instance) -> float:
    """Smallest EI [N m²] of a cable of a model: its own, and what springs on its curvatures add.

    It is infinite where a law of another kind acts on all of its curvatures, since that may do anything.
    """
    curvatures = cable.deformations[POINTS.size :]
    weights = np.repeat(CURVATURES, len(curvatures) // POINTS.size) * float(cable.parameters["l0"][0])
    EI = dict.fromkeys(curvatures, 0.0)
    for law in structure.laws:
        if law.deformations == cable.deformations or ("S" in law.parameters and len(law.deformations) == 1):
            stiffness = dict(zip(law.deformations, law.parameters["S"], strict=True))
        else:
            stiffness = dict.fromkeys(law.deformations, np.inf)
        for name, weight in zip(curvatures, weights, strict=True):
            EI[name] += stiffness.get(name, 0.0) / weight
    return float(min(EI.values()))


def drawn_length(p: Array, slope_p: Array, q: Array, slope_q: Array) -> float:
    """Length l0 of a cable between drawn ends whose mean stretch is that of the slopes.

    The cubic curve depends on l0 itself; the fixed-point iteration converges as long as the slopes point roughly
    along the chord.
    """
    xi = (1 + np.polynomial.legendre.leggauss(8)[0][:, None]) / 2
    gauss = np.polynomial.legendre.leggauss(8)[1] / 2
    stretch = (np.linalg.norm(slope_p) + np.linalg.norm(slope_q)) / 2
    l0 = float(np.linalg.norm(q - p)) / stretch
    for _ in range(60):
        rate = 6 * xi * (1 - xi) * (q - p) + l0 * (
            (1 - xi) * (1 - 3 * xi) * slope_p + xi * (3 * xi - 2) * slope_q
        )
        last, l0 = l0, float(gauss @ np.linalg.norm(rate, axis=1)) / stretch
        if abs(l0 - last) < 1e-15 * l0:
            break
    return float(l0)
