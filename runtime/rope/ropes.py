"""Ropes around sheaves: the method of `Model` that lays a taut rope, and what it is asked about afterwards.

Imports numpy, the errors, the shared checks, the cables, the contacts and the geometry of paths.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.checks import not_negative, positive
from flexel.errors import ModelError
from flexel.rope.cable_lines import CableLine
from flexel.rope.cables import AXIAL, axial_rows, gauss_tension
from flexel.rope.contacts import Contact, ContactPoint
from flexel.rope.path import Path, taut_path
from flexel.rope.plane import Place, RopePlane
from flexel.state import State
from flexel.structure import Array, Node

if TYPE_CHECKING:
    from flexel.model import Model

LONGEST = (
    1.0  # element over radius of the smallest sheave: a cubic follows one radian of arc, and not much more
)


@dataclass(frozen=True)
class Rope(CableLine):
    """What `Model.rope` laid: the line of cables, its path and its contacts.

    Attributes
    ----------
    path : Path
        As laid, in the plane of the sheaves.
    tension0 : float
        That it was laid with [N].
    contacts : dict of str to list of ContactPoint
        For each sheave or drum.
    """

    path: Path
    tension0: float
    contacts: dict[str, list[ContactPoint]]

    def tension(self, states: State | Sequence[State], mean: bool = False) -> tuple[Array, Array]:
        """Undeformed arc length s (ns,) [m] and tension (ns,) or (nt, ns) [N] along the rope.

        Parameters
        ----------
        states : State or sequence of State
        mean : bool
            The mean of each element at its middle; the tension at all Gauss points by default.  Where a rope runs
            onto a sheave, its curvature jumps within an element; a cubic cannot follow that, and is strained
            unevenly about its mean.
        """
        listed = [states] if isinstance(states, State) else states
        rows, l0 = axial_rows(listed[0], self.elements)
        T = np.array([gauss_tension(state, rows, l0) for state in listed])
        places, shares = (1 + AXIAL[0]) / 2, AXIAL[1] / 2
        if mean:
            s, T = self.s[:-1] + l0 / 2, T @ shares
        else:
            s, T = (self.s[:-1, None] + l0[:, None] * places).ravel(), T.reshape(len(listed), -1)
        return s, T[0] if isinstance(states, State) else T

    def contact_force(self, states: State | Sequence[State], surface: str) -> tuple[Array, Array]:
        """Undeformed arc length s (np,) [m] and normal force (np,) or (nt, np) [N] of the points over one surface."""
        points = self._points(surface)
        s = np.array([p.s for p in points])
        listed = [states] if isinstance(states, State) else states
        N = np.array([[_normal_force(state, p) for p in points] for state in listed])
        return s, N[0] if isinstance(states, State) else N

    def resultant(self, states: State | Sequence[State], surface: str) -> Array:
        """Sum of the normal forces on one surface: a float array () or (nt,) [N]."""
        return np.asarray(self.contact_force(states, surface)[1].sum(axis=-1))

    def wrap_angle(self, state: State, surface: str) -> float:
        """Angle [rad] over which the rope touches: undeformed length from first to last point, over the radius."""
        points = self._points(surface)
        s, N = self.contact_force(state, surface)
        touching = s[N > 0]
        R = points[0].surface.radius
        if not touching.size or not R:
            return 0.0
        share = float(np.mean([p.weight for p in points]))
        return float(touching[-1] - touching[0] + share) / R

    def slip(self, state: State, surface: str) -> tuple[Array, Array]:
        """Undeformed arc length (np,) [m] and sliding velocity along the rope (np,) [m/s]; zero where it is off."""
        points = self._points(surface)
        _, N = self.contact_force(state, surface)
        name = points[0].surface.gaps[0][1][0]
        rate = np.array([state.rate(f"{p.element}.{name}") for p in points])
        return np.array([p.s for p in points]), np.where(N > 0, rate, 0.0)

    def _points(self, surface: str) -> list[ContactPoint]:
        if surface not in self.contacts:
            raise ModelError(
                f"rope '{self.name}': no contact with '{surface}'; it has {', '.join(self.contacts)}"
            )
        return self.contacts[surface]


def _normal_force(state: State, p: ContactPoint) -> float:
    """Length of the sum of the forces of a point's gaps, which are directions of a V groove's two flanks."""
    forces = [-state.force(f"{p.element}.{gap}") for gap, _ in p.surface.gaps]
    return float(sum(forces))


def rope(
    self: Model,
    name: str,
    path: Sequence[Place],
    n: int,
    *,
    contact: Contact,
    rope_radius: float,
    length: float | None = None,
    tension: float | None = None,
    turns: float = 0.0,
    refine: float = 1.0,
    also: Sequence[str] = (),
    **properties: Any,
) -> Rope:
    """Lay a taut rope over sheaves, in contact with each, as it hangs under a tension.

    Parameters
    ----------
    path : sequence
        In the order of the rope: nodes (points) at its ends, names of sheaves between; a drum at an end, on which it
        is anchored in the direction of its circumference.  A pair (name, +1) or (name, -1) gives the sense of wrap
        about the axle, which otherwise is that of the shortest path.
    n : int
        Number of elements.
    contact : Contact
    rope_radius : float
        [m]
    length : float, optional
        Undeformed [m]; gives the tension, instead of it.
    tension : float, optional
        Uniform tension as laid [N], 0 by default; the rope then lies as deep in its sheaves as it carries.
    turns : float
        Turns of rope that lie on a drum at the start, before the first straight part.
    refine : float
        Elements are shorter by this factor where the rope lies on sheaves as laid.
    also : sequence of str
        Further surfaces that the rope may touch.
    **properties
        EA, EI, mass_per_length, section, material, damping, bending_damping of `Model.cable`.

    Returns
    -------
    Rope

    Raises
    ------
    ModelError
        A path that runs through a sheave or has slack, sheaves that do not lie in one plane, elements too long for the
        smallest sheave (with the number that is needed).

    Examples
    --------
    >>> rope = m.rope("rope", ["drum", "sheave", "end"], 56, contact=fx.Contact(1e9), rope_radius=0.01,
    ...               tension=1e4, turns=1, EA=1e7, EI=10, mass_per_length=2)  # doctest: +SKIP
    """
    owner = f"rope '{name}'"
    plane = RopePlane(self, owner, path)
    EA = _axial_stiffness(self, owner, properties)
    radius, T = not_negative(rope_radius, owner, "rope_radius"), 0.0
    if length is not None and tension is not None:
        raise ModelError(f"{owner}: both length and tension are given; drop one")
    if tension is not None:
        T = not_negative(tension, owner, "tension")
    count = _count(owner, n)
    for _ in range(1 if length is None else 4):  # the depth of the rope in its sheaves depends on the tension
        laid = taut_path(owner, plane.circles(radius, contact, T, turns, count))
        if length is not None:
            T = EA * _strain(owner, laid.length / positive(length, owner, "length"))
    stretch = _stretch(T / EA)
    L = laid.length / stretch if length is None else float(length)
    s = L * _fractions(laid, count, refine)
    _check_lengths(owner, plane, s, count)
    line = _lay(self, name, plane, laid, s, stretch, properties)
    contacts = {
        z: self.contact(line, z, contact, rope_radius=radius) for z in dict.fromkeys([*plane.names, *also])
    }
    return Rope(line.name, line.elements, line.points, line.slopes, line.s, laid, T, contacts)


def _stretch(load: float) -> float:
    """Stretch λ at which λ (λ² - 1)/2 = tension/EA: Green's strain, and the force along the deformed rope."""
    stretch = 1 + load
    for _ in range(30):
        stretch -= (stretch * (stretch**2 - 1) / 2 - load) / ((3 * stretch**2 - 1) / 2)
    return float(stretch)


def _strain(owner: str, stretch: float) -> float:
    """Tension over EA of a rope whose path is longer than itself."""
    if stretch < 1 - 1e-9:
        raise ModelError(
            f"{owner}: its length is {(1 / stretch - 1) * 100:.3g} % more than its path, so that it hangs slack; give "
            "a shorter length, or lay a slack rope with m.cable_line along the curve that it hangs in"
        )
    return max(stretch * (stretch**2 - 1) / 2, 0.0)


def _count(owner: str, n: Any) -> int:
    if not isinstance(n, (int, np.integer)) or n < 1:
        raise ModelError(f"{owner}: n = {n!r} elements; give a whole number of at least 1")
    return int(n)


def _axial_stiffness(model: Model, owner: str, properties: dict[str, Any]) -> float:
    if properties.get("EA") is not None:
        return positive(properties["EA"], owner, "EA")
    section, material = properties.get("section"), properties.get("material")
    if section is None:
        raise ModelError(f"{owner}: EA or a section is missing; give EA and EI, or section and material")
    from flexel.materials import profile_of

    return float(profile_of(section, material, owner).stiffness()["EA"])


def _fractions(path: Path, n: int, refine: float) -> Array:
    """Places of the nodes over the length: elements `refine` times shorter on the arcs of the path."""
    knots, weights = [0.0], []
    spans = [(a, b) for _, a, b in path.spans()]
    for a, b in spans:
        if a > knots[-1] + 1e-12:
            knots.append(a)
            weights.append(1.0)
        knots.append(b)
        weights.append(refine)
    if knots[-1] < path.length * (1 - 1e-12):
        knots.append(path.length)
        weights.append(1.0)
    at = np.array(knots) / knots[-1]
    share = np.concatenate([[0.0], np.cumsum(np.diff(at) * np.array(weights))])
    return np.asarray(np.interp(np.linspace(0, share[-1], n + 1), share, at))


def _check_lengths(owner: str, plane: RopePlane, s: Array, n: int) -> None:
    """Elements must be able to follow the smallest sheave."""
    smallest = min((z.radius for z in plane.surfaces), default=np.inf)
    longest = float(np.diff(s).max())
    if longest > LONGEST * smallest * (1 + 1e-9):
        needed = int(np.ceil(n * longest / (LONGEST * smallest)))
        advised = int(np.ceil(n * longest / (0.5 * smallest)))
        raise ModelError(
            f"{owner}: elements of {longest:.4g} m cannot follow a sheave of radius {smallest:.4g} m; it takes "
            f"{needed} elements at least, {advised} for elements of half its radius"
        )


def _lay(
    model: Model,
    name: str,
    plane: RopePlane,
    path: Path,
    s: Array,
    stretch: float,
    properties: dict[str, Any],
) -> CableLine:
    """Points, slopes and elements of the rope on its path; its ends held as the path says."""
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
    return CableLine(name, tuple(elements), tuple(points), tuple(slopes), s)
