"""Cables: slopes, cables between points with slopes, and their ends, clamped or anchored in bodies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import KW_ONLY, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.base.arguments import array, not_negative, positive, span, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.base.quaternions import in_frame, triad
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.parts.beams import Beam
from flexel.parts.cable_pages import cable_pages
from flexel.parts.free_ends import check_free_ends
from flexel.parts.materials import MATERIALS, Material, Profile, profile_of

if TYPE_CHECKING:
    from flexel.derive.compiled import CompiledElement, CompiledLaw


@part
class Slope(Part[Node]):
    """Add a slope node: the derivative of a cable's position with respect to its undeformed arc length.

    Raises
    ------
    ModelError
        A duplicate name, a direction of zero length.
    """

    name: str = entry("Name of the node; its coordinates are ``name.x``, ``name.y`` and ``name.z``.")
    direction: Vector = array_quantity(
        "-", "Direction along the cable, of any length: (x, y, z), or (x, y) in a planar model."
    )
    fixed: bool = entry("Hold direction and stretch; `clamp` holds only the direction.", default=False)
    _: KW_ONLY
    stretch: float = quantity(
        "-", "positive", "Length of the slope as drawn: one for an unstretched cable.", default=1.0
    )

    def lower(self, to: Lowering) -> Node:
        """Add the node."""
        direction = array(self.direction, self.owner, "direction")
        planar = direction.shape == (2,)
        direction = vector(direction, self.owner, "direction", 2 if planar else 3)
        length = float(np.linalg.norm(direction))
        if length == 0:
            raise ModelError(
                f"{self.owner}: its direction {direction.tolist()} has no length; give a vector along the cable"
            )
        x0 = self.stretch * direction / length
        return to.node(self.name, "planar_slope" if planar else "slope", x0, self.fixed)


@part
class Cable(Part[None]):
    """Add one cable element between two points with slopes: it stretches, bends and may sag.

    Raises
    ------
    ModelError
        Coincident points, a stiffness that is missing or negative.

    See Also
    --------
    Model.cable_line : Many elements along a line or curve.
    """

    name: str = entry("Name of the element.")
    p: Node | str = entry("Point at its first end.")
    slope_p: Node | str = entry("Slope at its first end.")
    q: Node | str = entry("Point at its second end.")
    slope_q: Node | str = entry("Slope at its second end.")
    length: float | None = quantity(
        "m", "positive", "Undeformed length; by default the length of the cubic curve as drawn.", default=None
    )
    _: KW_ONLY
    EA: float | None = quantity("N", "positive", "Stiffness in tension.", default=None)
    EI: float | None = quantity(
        "N m²",
        "not negative",
        "Stiffness in bending; it may be zero if both ends of a rope are held.",
        default=None,
    )
    mass_per_length: float | None = quantity(
        "kg/m", "not negative", "Mass per length; by default the section's, or zero.", default=None
    )
    section: Any = entry(
        "Cross-section, with a material: they determine EA, EI and the mass and replace the numbers; an explicit EI "
        "takes precedence.",
        default=None,
        form="Section, optional",
    )
    material: Material | str | None = entry(
        'Material of the section, or the name of one, such as "wire rope".', default=None, named=MATERIALS.get
    )
    damping: float = quantity(
        "s",
        "not negative",
        "Kelvin–Voigt damping of stretching: ratio of damping to stiffness.",
        default=0.0,
    )
    bending_damping: float = quantity(
        "s",
        "not negative",
        "Kelvin–Voigt damping of bending: ratio of damping to stiffness.  In space the rate of the curvature vector "
        "includes its rotation, so bending damping also resists the rotation of a bent cable about axes other than "
        "the normal of its plane.",
        default=0.0,
    )
    element: CompiledElement | None = entry(
        "A user-defined cable page instead of the built-in one: the result of `flexel.compile_element` for an element "
        "of the family cable, with the parameter l0 and the outputs arc_length, tension, strain and curvature.",
        default=None,
    )
    law: CompiledLaw | None = entry(
        "A user-defined elastic law instead of the built-in one: the result of `flexel.compile_law` for a law of all "
        "deformations of the element, in their order.",
        default=None,
    )
    parameters: Mapping[str, Any] | None = array_quantity(
        "",
        "Values of further parameters of these pages, by name; l0, rhoA, EA, EI, damping and bending_damping have "
        "separate arguments.",
        default=None,
        form="mapping of str to array_like, optional",
    )

    def lower(self, to: Lowering) -> None:
        """Add the element and its elastic law."""
        kinds = ((self.p, "point"), (self.slope_p, "slope"), (self.q, "point"), (self.slope_q, "slope"))
        planar, nodes = to.find_nodes(self.owner, *kinds)
        span(nodes[0].x0, nodes[2].x0, self.owner)
        l0 = drawn_length(*(node.x0 for node in nodes)) if self.length is None else self.length
        profile = None
        if self.section is not None or self.material is not None:
            profile = _profile(self.owner, self.section, self.material, self.EA, self.mass_per_length)
        pages = cable_pages(self.owner, self.element, self.law, planar)
        own, elastic = pages.numbers(self.owner, self._properties(profile, l0), self.parameters)
        to.element(self.name, pages.element, nodes, own, pages.element_code)
        to.instances[self.name] = replace(to.instances[self.name], profile=profile)
        to.checks["free ends"] = check_free_ends
        modes, called = to.instances[self.name].deformations, {key: key for key in elastic}
        to.law(self.owner, pages.law, modes, elastic, code=pages.law_code, label=self.name, called=called)

    def _properties(self, profile: Profile | None, l0: float) -> dict[str, float | None]:
        """Return the numbers of the pages by their names there, from the section and the given numbers."""
        EA, EI, mass = self.EA, self.EI, self.mass_per_length
        if profile is not None:
            stiffness = profile.stiffness()
            EA, mass = positive(stiffness["EA"], self.owner, "EA"), profile.mass()[0]
            EI = not_negative(stiffness["EIz"], self.owner, "EI") if EI is None else EI
        return {
            "l0": l0,
            "rhoA": not_negative(0.0 if mass is None else mass, self.owner, "mass_per_length"),
            "EA": EA,
            "EI": EI,
            "damping": self.damping,
            "bending_damping": self.bending_damping,
        }


@part
class Clamp(Part[None]):
    """Fix the direction of a cable's end in a body, as drawn; its stretch remains free."""

    name: str = entry("Name of the element.")
    frame: Node | str = entry("Orientation of the body (an angle in a planar model).")
    slope: Node | str = entry("Slope of the cable's end.")

    def lower(self, to: Lowering) -> None:
        """Add the element."""
        planar, (body, end) = to.find_nodes(self.owner, (self.frame, "frame"), (self.slope, "slope"))
        if planar:
            alpha0 = np.arctan2(end.x0[1], end.x0[0]) - body.x0
            to.element(self.name, "planar_slope_clamp", (body, end), {"alpha0": alpha0})
            return
        t = triad(end.x0 / np.linalg.norm(end.x0), None, self.owner)
        to.element(self.name, "slope_clamp", (body, end), {"t": in_frame(body.x0, t)})


@part
class Anchor(Part[None]):
    """Anchor a cable's end to a body, as drawn; with the slope, also its direction (tangent to a drum).

    The rigid link `name` holds the point, the clamp ``name direction`` the direction.  A cable that ends at a
    body's reference point needs no anchor; one that ends at a beam or point mass shares its point.
    """

    name: str = entry("Name of the rigid link.")
    point: Node | str = entry("A point of the body.")
    frame: Node | str = entry("Orientation of the body.")
    end: Node | str = entry("Point of the cable's end.")
    slope: Node | str | None = entry("Slope of the cable's end.", default=None)

    def lower(self, to: Lowering) -> None:
        """Add the link and the clamp."""
        Beam(self.name, self.point, self.frame, self.end, rigid=True).lower(to)
        if self.slope is not None:
            Clamp(f"{self.name} direction", self.frame, self.slope).lower(to)


def _profile(owner: str, section: Any, material: Any, EA: float | None, mass: float | None) -> Profile:
    """Return section and material of a cable; numbers that follow from them must not be given as well."""
    stated = [key for key, value in (("EA", EA), ("mass_per_length", mass)) if value is not None]
    if section is None:
        raise ModelError(
            f"{owner}: material is given without a section; give section=WireRope(…) or the like"
        )
    if stated:
        raise ModelError(
            f"{owner}: section and material already give {', '.join(stated)}; drop these or the section"
        )
    return profile_of(section, material, owner)


def drawn_length(p: Array, slope_p: Array, q: Array, slope_q: Array) -> float:
    """Return the length l0 of a cable between drawn ends for which its mean stretch equals the slopes' stretch.

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
