"""Ropes around sheaves: the method of `Model` that adds a taut rope, and the results of a rope."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from flexel.base.arguments import flag, names, not_negative, positive, text, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.rope.cable_lines import CableLine, contact_radius, section_radius
from flexel.rope.contacts import Contact, Contacts, check_contact, find_surface
from flexel.rope.laying import Laying, check_clear
from flexel.rope.path import Path
from flexel.rope.plane import Place, RopePlane
from flexel.rope.rope import Rope
from flexel.rope.surfaces import Surfaces
from flexel.structure.nodes import Node

# Element length over radius of the smallest sheave: a cubic follows about one radian of arc at most.
LONGEST = 1.0


class Ropes(Contacts, Surfaces):
    """Ropes around drums and sheaves."""

    @whole_or_nothing
    def rope(
        self,
        name: str,
        path: Sequence[Place],
        n: int,
        *,
        contact: Contact,
        radius: float | None = None,
        length: float | None = None,
        tension: float | None = None,
        turns: float | tuple[float, float] = 0.0,
        refine: float = 1.0,
        also: Sequence[str] = (),
        closed: bool = False,
        **properties: Any,
    ) -> Rope:
        """Add a taut rope over sheaves, in contact with each, under a given tension.

        Parameters
        ----------
        path : sequence
            In the order of the rope: nodes (points) at its ends, names of sheaves between; a drum at an end, on which
            it is anchored in the direction of its circumference.  A pair (name, +1) or (name, -1) gives the sense of
            wrap about the axle, which otherwise is that of the shortest path.
        n : int
            Number of elements.
        contact : Contact
        radius : float, optional
            Of the rope [m]; where its section has a diameter, it is half of that and need not be given.
        length : float, optional
            Undeformed length [m], instead of the tension, which follows from it.
        tension : float, optional
            Uniform tension in the initial configuration [N], 0 by default; its depth in the sheaves is that
            in equilibrium.
        turns : float or pair of float
            Initial turns of rope on the drum, before the first straight part (after the last one for a drum at the end
            of the path); a pair for drums at both ends, which otherwise have equally many.  In a `HelicalGroove` they
            lie side by side; the first straight part then leaves the groove where it is nearest to the plane.
        refine : float
            Elements are shorter by this factor where the rope lies on sheaves in the initial configuration.
        also : sequence of str
            Further surfaces that the rope may touch; the initial configuration must be clear of them.
        closed : bool
            A belt: from the last sheave the path goes back to the first. It starts where it leaves the first one.
        **properties
            EA, EI, mass_per_length, section, material, damping, bending_damping of `Model.cable`.

        Returns
        -------
        Rope

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
        owner = f"rope '{text(name, 'rope', 'name')}'"
        check_contact(contact, owner)
        plane = RopePlane(self, owner, path, flag(closed, owner, "closed"))
        others = [find_surface(self, z, owner) for z in names(also, f"{owner}: also")]
        EA = _axial_stiffness(self, owner, properties)
        radius = contact_radius(section_radius(properties.get("section")), radius, owner)
        if length is not None and tension is not None:
            raise ModelError(f"{owner}: both length and tension are given; drop one")
        count = whole(n, owner, "number of elements", most=10**6)
        laying = Laying(plane, contact, radius, turns, count, positive(refine, owner, "refine"))
        if length is not None:
            T = laying.tension(positive(length, owner, "length"), EA)
        else:
            T = not_negative(0.0 if tension is None else tension, owner, "tension")
        laid, stretch = laying.path(T), 1 + T / EA
        s = (laid.length / stretch if length is None else float(length)) * laying.fractions(laid)
        _check_lengths(owner, plane, s, count)
        others = [z for z in others if z.name not in plane.names]
        check_clear(plane, laid, [*plane.surfaces, *others], radius, laying.depths(T))
        line = _lay(self, name, plane, laid, s, stretch, radius, properties)
        touched = dict.fromkeys([*plane.names, *(z.name for z in others)])
        contacts = {z: self.rope_contact(line, z, contact) for z in touched}
        return Rope(line.name, line.elements, line.points, line.slopes, line.s, radius, laid, T, contacts)


def _axial_stiffness(model: Contacts, owner: str, properties: dict[str, Any]) -> float:
    if properties.get("EA") is not None:
        return positive(properties["EA"], owner, "EA")
    section, material = properties.get("section"), properties.get("material")
    if section is None:
        raise ModelError(f"{owner}: EA or a section is missing; give EA and EI, or section and material")
    from flexel.declare.materials import profile_of

    return float(profile_of(section, material, owner).stiffness()["EA"])


def _check_lengths(owner: str, plane: RopePlane, s: Array, n: int) -> None:
    """Check that the elements can follow the smallest sheave."""
    smallest = min((z.radius for z in plane.surfaces), default=np.inf)
    longest = float(np.diff(s).max())
    if longest > LONGEST * smallest * (1 + 1e-9):
        needed = int(np.ceil(n * longest / (LONGEST * smallest)))
        advised = int(np.ceil(n * longest / (0.5 * smallest)))
        raise ModelError(
            f"{owner}: elements of {longest:.4g} m cannot follow a sheave of radius {smallest:.4g} m; it needs "
            f"at least {needed} elements, or {advised} for elements of half its radius"
        )


def _lay(
    model: Contacts,
    name: str,
    plane: RopePlane,
    path: Path,
    s: Array,
    stretch: float,
    radius: float,
    properties: dict[str, Any],
) -> CableLine:
    """Points, slopes and elements of the rope on its path; its ends are held as the path requires."""
    places, tangents = plane.at(path, s * path.length / s[-1])
    points: list[Node] = []
    slopes: list[Node] = []
    for i in range(s.size - plane.closed):
        end = {0: plane.ends[0], s.size - 1: plane.ends[1]}.get(i)
        node = end if end is not None else model.point(f"{name}_p{i}", places[i])
        points.append(node)
        slopes.append(model.slope(f"{name}_d{i}", tangents[i], stretch=stretch))
    elements = []
    for i in range(s.size - 1):
        elements.append(f"{name}{i + 1}")
        after = (i + 1) % len(points)
        ends = points[i], slopes[i], points[after], slopes[after]
        model.cable(elements[-1], *ends, float(s[i + 1] - s[i]), **properties)
    for i, label in ((0, "start"), (-1, "end")):
        drum = plane.drums[i]
        if drum is not None:
            model.anchor(f"{name} {label}", drum.point, drum.frame, points[i], slopes[i])
    return CableLine(name, tuple(elements), tuple(points), tuple(slopes), s, radius)
