"""Ropes around sheaves: the method of `Model` that adds a taut rope, and the results of a rope."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.base.arguments import names, not_negative, positive
from flexel.base.arrays import Array, Index
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.rope.cable_lines import CableLine, contact_radius, section_radius
from flexel.rope.cables import AXIAL, axial_rows, gauss_tension
from flexel.rope.contacts import Contact, ContactPoint, Contacts, check_contact, find_surface
from flexel.rope.laying import Laying, check_clear, stretched
from flexel.rope.path import Path
from flexel.rope.plane import Place, RopePlane
from flexel.rope.surfaces import Surfaces
from flexel.structure.nodes import Node
from flexel.structure.state import State

# Element length over radius of the smallest sheave: a cubic follows about one radian of arc at most.
LONGEST = 1.0


@dataclass(frozen=True, repr=False)
class Rope(CableLine):
    """A rope made by `Model.rope`: the line of cables, its path and its contacts.

    Attributes
    ----------
    radius : float
        Radius of the rope [m].
    path : Path
        Initial path, in the plane of the sheaves.
    tension0 : float
        Tension in the initial configuration [N].
    contacts : dict of str to list of ContactPoint
        For each sheave or drum.
    """

    radius: float
    path: Path
    tension0: float
    contacts: dict[str, list[ContactPoint]]

    def tension(self, states: State | Sequence[State], mean: bool = False) -> tuple[Array, Array]:
        """Undeformed arc length s (ns,) [m] and tension (ns,) or (nt, ns) [N] along the rope.

        Parameters
        ----------
        states : State or sequence of State
            States of one system, such as a motion.
        mean : bool
            Give the mean of each element at its middle, instead of the tension at all Gauss points.  Where a rope runs
            onto a sheave, its curvature jumps within an element; a cubic cannot follow that, and is strained
            unevenly about its mean.
        """
        listed, rows, l0 = self._checked(states)
        T = np.array([gauss_tension(state, rows, l0) for state in listed])
        places, shares = (1 + AXIAL[0]) / 2, AXIAL[1] / 2
        if mean:
            s, T = self.s[:-1] + l0 / 2, T @ shares
        else:
            s, T = (self.s[:-1, None] + l0[:, None] * places).ravel(), T.reshape(len(listed), -1)
        return s, T[0] if isinstance(states, State) else T

    def contact_force(self, states: State | Sequence[State], surface: str) -> tuple[Array, Array]:
        """Undeformed arc length s (np,) [m] and normal force (np,) or (nt, np) [N] of the points over one surface.

        The forces on both flanks of a V groove are added: friction is limited by their sum, and the load that they
        carry is sin(opening/2) times it.
        """
        points = self._points(surface)
        s = np.array([p.s for p in points])
        N = np.array([[_normal_force(state, p) for p in points] for state in self._checked(states)[0]])
        return s, N[0] if isinstance(states, State) else N

    def resultant(self, states: State | Sequence[State], surface: str) -> Array:
        """Sum of the normal forces (see `contact_force`) on one surface: a float array () or (nt,) [N]."""
        return np.asarray(self.contact_force(states, surface)[1].sum(axis=-1))

    def wrap_angle(self, states: State | Sequence[State], surface: str) -> Array:
        """Angle () or (nt,) [rad] over which the rope touches.

        Undeformed length from the first to the last point that touches, over the radius of the centre line.
        """
        points = self._points(surface)
        s, N = self.contact_force(states, surface)
        R = points[0].surface.radius
        if not R:
            return np.zeros(N.shape[:-1])
        share = float(np.mean([p.weight for p in points]))
        first = np.where(N > 0, s, np.inf).min(axis=-1)
        last = np.where(N > 0, s, -np.inf).max(axis=-1)
        return np.asarray(np.maximum(last - first + share, 0.0) / (R + self.radius))

    def slip(self, states: State | Sequence[State], surface: str) -> tuple[Array, Array]:
        """Undeformed arc length (np,) [m] and sliding velocity along the rope (np,) or (nt, np) [m/s]; zero off it."""
        points = self._points(surface)
        s, N = self.contact_force(states, surface)
        name = points[0].surface.gaps[0][1][0]
        rates = np.array([[z.rate(f"{p.element}.{name}") for p in points] for z in self._checked(states)[0]])
        return s, np.where(N > 0, rates[0] if isinstance(states, State) else rates, 0.0)

    def _checked(self, states: State | Sequence[State]) -> tuple[Sequence[State], Index, Array]:
        """The states, which must belong to one system with this rope, and the result of `axial_rows` there."""
        listed = [states] if isinstance(states, State) else states
        known = isinstance(listed, Sequence) and len(listed) and all(isinstance(z, State) for z in listed)
        if not known:
            raise ModelError(f"rope '{self.name}': {states!r:.60} is not a state; give a state, or a motion")
        first = listed[0].structure
        rows, l0 = axial_rows(listed[0], self.elements)
        same = all(z.structure is first or z.structure.names == first.names for z in listed)
        if not same or not np.allclose(l0, np.diff(self.s), rtol=1e-9):
            raise ModelError(
                f"rope '{self.name}': the states belong to different models, or to another model than this "
                "rope; use the rope of their own model"
            )
        return listed, rows, l0

    def _points(self, surface: str) -> list[ContactPoint]:
        if surface not in self.contacts:
            raise ModelError(
                f"rope '{self.name}': no contact with '{surface}'; it has {', '.join(self.contacts)}"
            )
        return self.contacts[surface]


def _normal_force(state: State, p: ContactPoint) -> float:
    """Sum of the forces of a point's gaps: those of both flanks of a V groove."""
    return -sum(state.force(f"{p.element}.{gap}") for gap, _ in p.surface.gaps)


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
            of the path); a pair for drums at both ends, which otherwise have equally many.
        refine : float
            Elements are shorter by this factor where the rope lies on sheaves in the initial configuration.
        also : sequence of str
            Further surfaces that the rope may touch; the initial configuration must be clear of them.
        **properties
            EA, EI, mass_per_length, section, material, damping, bending_damping of `Model.cable`.

        Returns
        -------
        Rope

        Raises
        ------
        ModelError
            A path that runs through a sheave or plane or has slack, a contact too soft for the tension, sheaves that
            do not lie in one plane, elements too long for the smallest sheave (with the number needed).  The model is
            then unchanged.

        Examples
        --------
        >>> rope = m.rope("rope", ["drum", "sheave", "end"], 56, contact=fx.Contact(1e9), tension=1e4, turns=1,
        ...               section=fx.WireRope(0.02), material="wire rope")  # doctest: +SKIP
        """
        owner = f"rope '{name}'"
        check_contact(contact, owner)
        plane = RopePlane(self, owner, path)
        others = [find_surface(self, z, owner) for z in names(also, f"{owner}: also")]
        EA = _axial_stiffness(self, owner, properties)
        radius = contact_radius(section_radius(properties.get("section")), radius, owner)
        if length is not None and tension is not None:
            raise ModelError(f"{owner}: both length and tension are given; drop one")
        count = _count(owner, n)
        laying = Laying(plane, contact, radius, turns, count, positive(refine, owner, "refine"))
        if length is not None:
            T = laying.tension(positive(length, owner, "length"), EA)
        else:
            T = not_negative(0.0 if tension is None else tension, owner, "tension")
        laid, stretch = laying.path(T), stretched(T / EA)
        s = (laid.length / stretch if length is None else float(length)) * laying.fractions(laid)
        _check_lengths(owner, plane, s, count)
        others = [z for z in others if z.name not in plane.names]
        check_clear(plane, laid, [*plane.surfaces, *others], radius, laying.depths(T))
        line = _lay(self, name, plane, laid, s, stretch, radius, properties)
        touched = dict.fromkeys([*plane.names, *(z.name for z in others)])
        contacts = {z: self.rope_contact(line, z, contact) for z in touched}
        return Rope(line.name, line.elements, line.points, line.slopes, line.s, radius, laid, T, contacts)


def _count(owner: str, n: Any) -> int:
    if not isinstance(n, (int, np.integer)) or n < 1:
        raise ModelError(f"{owner}: n = {n!r} elements; give a whole number of at least 1")
    return int(n)


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
    places, tangents = path.at(s * path.length / s[-1])
    points: list[Node] = []
    slopes: list[Node] = []
    for i in range(s.size):
        end = {0: plane.ends[0], s.size - 1: plane.ends[1]}.get(i)
        node = end if end is not None else model.point(f"{name}_p{i}", plane.place(places[i]))
        points.append(node)
        slopes.append(model.slope(f"{name}_d{i}", plane.direction(tangents[i]), stretch=stretch))
    elements = []
    for i in range(s.size - 1):
        elements.append(f"{name}{i + 1}")
        ends = points[i], slopes[i], points[i + 1], slopes[i + 1]
        model.cable(elements[-1], *ends, float(s[i + 1] - s[i]), **properties)
    for i, label in ((0, "start"), (-1, "end")):
        drum = plane.drums[i]
        if drum is not None:
            model.anchor(f"{name} {label}", drum.point, drum.frame, points[i], slopes[i])
    return CableLine(name, tuple(elements), tuple(points), tuple(slopes), s, radius)
