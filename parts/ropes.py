"""Ropes around sheaves: a taut rope on its path, in contact with the surfaces that it passes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import KW_ONLY
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.base.arguments import flag, names, text, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.parts.cable_lines import (
    CableLine,
    add_cables,
    contact_radius,
    properties_of,
    section_radius,
)
from flexel.parts.cables import Anchor, Slope
from flexel.parts.laying import Laying, check_clear
from flexel.parts.materials import MATERIALS, Material, profile_of
from flexel.parts.nodes import Point
from flexel.parts.rope import Rope
from flexel.parts.rope_contacts import Contact, RopeContact, check_contact, find_surface
from flexel.parts.rope_path import RopePath
from flexel.parts.rope_plane import Place, RopePlane

if TYPE_CHECKING:
    from flexel.derive.compiled import CompiledElement, CompiledLaw

# Element length over radius of the smallest sheave: a cubic follows about one radian of arc at most.
LONGEST = 1.0


@part
class RopePart(Part[Rope]):
    """Add a taut rope over sheaves, in contact with each, under a given tension.

    Raises
    ------
    ModelError
        A path that runs through a sheave or plane or has slack, a contact too soft for the tension, sheaves that
        do not lie in one plane, a rope that leaves a helical groove across its ridges, elements too long for the
        smallest sheave (with the number needed).  The model is then unchanged.

    Examples
    --------
    >>> rope = m.rope("rope", ["drum", "sheave", "end"], 56, contact=fx.Contact(1e9), tension=1e4, turns=1,
    ...               section=fx.WireRope(0.02), material="wire rope")  # doctest: +SKIP
    """

    name: str = entry("Names of elements and nodes start with it, as for `cable_line`.")
    path: Sequence[Place] = entry(
        "Path of the rope, in order: nodes (points) at its ends and names of sheaves in between; or a drum at an end, "
        "to which it is anchored in the direction of its circumference.  A pair (name, +1) or (name, -1) gives the "
        "sense of wrap about the axle, which otherwise follows the shortest path.",
        form="sequence of str, nodes or pairs",
    )
    n: int = entry("Number of elements.")
    _: KW_ONLY
    contact: Contact = entry("Contact with each surface.")
    radius: float | None = quantity(
        "m",
        "not negative",
        "Radius of the rope; half the diameter of its section by default.",
        default=None,
    )
    length: float | None = quantity(
        "m",
        "positive",
        "Undeformed length [], instead of the tension, which follows from it.",
        default=None,
    )
    tension: float | None = quantity(
        "N",
        "not negative",
        "Uniform tension [] in the initial configuration, 0 by default; the rope lies as deep in the sheaves as in "
        "equilibrium.",
        default=None,
    )
    turns: float | tuple[float, float] = array_quantity(
        "-",
        "Initial turns of rope on the drum, before the first straight part (after the last one for a drum at the end "
        "of the path); a pair for drums at both ends, which otherwise have the same number.  In a `HelicalGroove` they "
        "lie side by side; the first straight part then leaves the groove where it is nearest to the plane.",
        default=0.0,
    )
    refine: float = quantity(
        "-",
        "positive",
        "Elements are shorter by this factor where the rope lies on sheaves in the initial configuration.",
        default=1.0,
    )
    also: Sequence[str] = entry(
        "Further surfaces that the rope may touch; the initial configuration must be clear of them.",
        default=(),
    )
    closed: bool = entry(
        "Make a belt: the path returns from the last sheave to the first, and starts where it leaves the first.",
        default=False,
    )
    EA: float | None = quantity(
        "N",
        "positive",
        "Stiffness in tension [], as for `cable`; the rope is laid with it, even if its pages have another law.",
        default=None,
    )
    EI: float | None = quantity(
        "N m²", "not negative", "Stiffness in bending [], as for `cable`.", default=None
    )
    mass_per_length: float | None = quantity(
        "kg/m", "not negative", "Mass per length [], as for `cable`.", default=None
    )
    section: Any = entry("Cross-section, as for `cable`.", default=None, form="Section, optional")
    material: Material | str | None = entry(
        "Material of the section, as for `cable`.", default=None, named=MATERIALS.get
    )
    damping: float = quantity("s", "not negative", "Damping of stretching [], as for `cable`.", default=0.0)
    bending_damping: float = quantity(
        "s", "not negative", "Damping of bending [], as for `cable`.", default=0.0
    )
    element: CompiledElement | None = entry("A user-defined cable page, as for `cable`.", default=None)
    law: CompiledLaw | None = entry("A user-defined elastic law, as for `cable`.", default=None)
    parameters: Mapping[str, Any] | None = array_quantity(
        "",
        "Values of further parameters of these pages, as for `cable`.",
        default=None,
        form="mapping of str to array_like, optional",
    )

    def lower(self, to: Lowering) -> Rope:
        """Lay the rope on its path, and add its nodes, elements, anchors and contacts."""
        name = text(self.name, "rope", "name")
        check_contact(self.contact, self.owner)
        plane = RopePlane(to, self.owner, self.path, flag(self.closed, self.owner, "closed"))
        also = [find_surface(to, given, self.owner) for given in names(self.also, f"{self.owner}: also")]
        others = [surface for surface in also if surface.name not in plane.names]
        EA = self._axial_stiffness()
        radius = contact_radius(section_radius(self.section), self.radius, self.owner)
        if self.length is not None and self.tension is not None:
            raise ModelError(f"{self.owner}: both length and tension are given; drop one")
        count = whole(self.n, self.owner, "number of elements", most=10**6)
        laying = Laying(plane, self.contact, radius, self.turns, count, self.refine)
        tension = (self.tension or 0.0) if self.length is None else laying.tension(self.length, EA)
        laid, stretch = laying.path(tension), 1 + tension / EA
        length = laid.length / stretch if self.length is None else self.length
        s = length * laying.fractions(laid)
        _check_lengths(self.owner, plane, s, count)
        check_clear(plane, laid, [*plane.surfaces, *others], radius, laying.depths(tension))
        points, slopes = _lay(to, name, plane, laid, s, stretch)
        elements = add_cables(to, name, points, slopes, s, properties_of(self))
        _anchor(to, name, plane, points, slopes)
        line = CableLine(name, elements, points, slopes, s, radius)
        to.lines[name] = line  # its contacts find it there
        touched = dict.fromkeys([*plane.names, *(surface.name for surface in others)])
        contacts = {surface: RopeContact(line, surface, self.contact).lower(to) for surface in touched}
        rope = Rope(name, elements, points, slopes, s, radius, laid, tension, contacts)
        to.lines[name] = rope
        return rope

    def _axial_stiffness(self) -> float:
        """Return EA [N]: the given one, or the section's."""
        if self.EA is not None:
            return self.EA
        if self.section is None:
            raise ModelError(
                f"{self.owner}: EA or a section is missing; give EA and EI, or section and material"
            )
        return float(profile_of(self.section, self.material, self.owner).stiffness()["EA"])


def _check_lengths(owner: str, plane: RopePlane, s: Array, n: int) -> None:
    """Check that the elements can follow the smallest sheave."""
    smallest = min((surface.radius for surface in plane.surfaces), default=np.inf)
    longest = float(np.diff(s).max())
    if longest > LONGEST * smallest * (1 + 1e-9):
        needed = int(np.ceil(n * longest / (LONGEST * smallest)))
        advised = int(np.ceil(n * longest / (0.5 * smallest)))
        raise ModelError(
            f"{owner}: elements of {longest:.4g} m cannot follow a sheave of radius {smallest:.4g} m; it needs "
            f"at least {needed} elements, or {advised} for elements of half its radius"
        )


def _lay(
    to: Lowering, name: str, plane: RopePlane, path: RopePath, s: Array, stretch: float
) -> tuple[tuple[Node, ...], tuple[Node, ...]]:
    """Add points and slopes of the rope on its path; an end that is a point of the model is used itself."""
    places, tangents = plane.at(path, s * path.length / s[-1])
    points: list[Node] = []
    slopes: list[Node] = []
    for i in range(s.size - plane.closed):
        end = {0: plane.ends[0], s.size - 1: plane.ends[1]}.get(i)
        points.append(end if end is not None else Point(f"{name}_p{i}", places[i]).lower(to))
        slopes.append(Slope(f"{name}_d{i}", tangents[i], stretch=stretch).lower(to))
    return tuple(points), tuple(slopes)


def _anchor(
    to: Lowering, name: str, plane: RopePlane, points: Sequence[Node], slopes: Sequence[Node]
) -> None:
    """Hold the ends of the rope that lie on drums."""
    for i, label in ((0, "start"), (-1, "end")):
        drum = plane.drums[i]
        if drum is not None:
            Anchor(f"{name} {label}", drum.point, drum.frame, points[i], slopes[i]).lower(to)
