"""Leaf springs: beams in series between two bodies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY

import numpy as np

from flexel.base.arguments import new_name, span, vector, whole
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.base.quaternions import matrix, triad
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.model.profiles import Section
from flexel.parts.beams import Beam
from flexel.parts.materials import MATERIALS, Material
from flexel.parts.nodes import Angle, Frame, Point, Warping
from flexel.parts.warping import nodes_of


@part
class LeafSpring(Part[tuple[str, ...]]):
    """Add a straight leaf spring between two bodies, or between two nodes: beams in series.

    A body is a point and a frame.  The leaf begins at the point `p` and ends at `q`; where it is clamped elsewhere
    on a body, `start` and `end` say where.  Its intermediate nodes are ``<name> point 1``, ``<name> frame 1``, …;
    a frame has its x axis along the leaf and its y axis along `direction`.

    Returns
    -------
    tuple of str
        The names of the beams: ``<name> beam 1``, …; a single one has the name of the leaf.

    Raises
    ------
    ModelError
        Coincident ends, bodies that are not a point and a frame, a section or material that does not exist.

    Examples
    --------
    >>> m.leaf_spring("left", P, RP, Q, RQ, section=fx.Rectangle(0.3e-3, 20e-3), material="steel", elements=6)
    ... # doctest: +SKIP
    """

    name: str = entry("Name of the leaf; its nodes and beams are named after it.")
    p: Node | str = entry("Point of the first body.")
    frame_p: Node | str = entry("Orientation of the first body.")
    q: Node | str = entry("Point of the second body.")
    frame_q: Node | str = entry("Orientation of the second body.")
    _: KW_ONLY
    section: Section = entry("Cross-section, as for `beam`.")
    material: Material | str = entry('Material, or the name of one, such as "steel".', named=MATERIALS.get)
    elements: int = entry("Number of beams.", default=4)
    start: Vector | None = array_quantity(
        "m",
        "Where the leaf is clamped to the first body [], as drawn, in global axes: the point ``<name> start`` is "
        "created there, fixed to its body.",
        default=None,
    )
    end: Vector | None = array_quantity(
        "m",
        "Where it is clamped to the second body [], in the same way: the point ``<name> end``.",
        default=None,
    )
    direction: Vector | None = array_quantity(
        "-", "Global direction of the section's y axis as drawn.", default=None
    )
    flexible: Sequence[str] | None = entry(
        "The flexible modes out of elongation, torsion, bend1 ... bend4; all by default.", default=None
    )
    damping: float = quantity(
        "s", "not negative", "Kelvin–Voigt damping: ratio of damping to stiffness.", default=0.0
    )
    second_order: bool = entry("Include second-order terms in the deformations.", default=True)
    warping: bool | Sequence[Node | str] = entry(
        "Warping of the sections, as for `beam`: the warping nodes at both ends, or True for new free ones; the nodes "
        "between the beams are ``<name> warping 1``, ….",
        default=False,
    )
    rotations: str = entry('"classic" or "logarithmic", as for `beam`.', default="classic")

    def lower(self, to: Lowering) -> tuple[str, ...]:
        """Add the nodes and the beams."""
        new_name(self.name, "leaf spring")
        count = whole(self.elements, self.owner, "elements")
        ends = (self.p, "point"), (self.frame_p, "frame"), (self.q, "point"), (self.frame_q, "frame")
        planar, (p, frame_p, q, frame_q) = to.find_nodes(self.owner, *ends)
        first = _clamped(to, f"{self.name} start", p, frame_p, self.start)
        last = _clamped(to, f"{self.name} end", q, frame_q, self.end)
        along, length = span(first.x0, last.x0, self.owner)
        if planar and self.direction is not None:
            raise ModelError(
                f"{self.owner}: a planar leaf spring bends in its plane and has no direction; leave it out"
            )
        across = None if planar else matrix(triad(along, self.direction, self.owner))[:, 1]
        places = [first.x0 + along * length * i / count for i in range(1, count)]
        between = _between(to, self.name, places, along, across)
        nodes = [(first, frame_p), *between, (last, frame_q)]
        names = tuple(f"{self.name} beam {i + 1}" for i in range(count)) if count > 1 else (self.name,)
        twists = _twists(to, self, count)
        pairs = zip(nodes, nodes[1:], strict=False)
        for name, (start, end), twist in zip(names, pairs, twists, strict=True):
            _beam(self, name, start, end, across, twist).lower(to)
        return names


def _beam(
    leaf: LeafSpring,
    name: str,
    start: tuple[Node, Node],
    end: tuple[Node, Node],
    across: Array | None,
    twist: bool | tuple[Node, Node],
) -> Beam:
    """Add one of the beams, between two pairs of a point and a frame."""
    return Beam(
        name,
        *start,
        *end,
        direction=across,
        section=leaf.section,
        material=leaf.material,
        flexible=leaf.flexible,
        damping=leaf.damping,
        second_order=leaf.second_order,
        warping=twist,
        rotations=leaf.rotations,
    )


def _twists(to: Lowering, leaf: LeafSpring, count: int) -> list[bool | tuple[Node, Node]]:
    """Return the warping nodes at the ends of each beam; False where there are none."""
    if leaf.warping is False:
        return [False] * count
    first, last = nodes_of(to, leaf.owner, leaf.name, leaf.warping)
    between = [Warping(f"{leaf.name} warping {i}").lower(to) for i in range(1, count)]
    nodes = [first, *between, last]
    return list(zip(nodes, nodes[1:], strict=False))


def _clamped(to: Lowering, name: str, point: Node, frame: Node, place: Vector | None) -> Node:
    """Return the point of a body where the leaf is clamped: the body's reference point, or another one as drawn."""
    if place is None:
        return point
    x0 = vector(place, f"point '{name}'", "place", point.x0.size)
    if np.all(point.fixed) and np.all(frame.fixed):
        return Point(name, x0, fixed=True).lower(to)
    made = Point(name, x0).lower(to)
    Beam(f"{name} clamp", point, frame, made).lower(to)
    return made


def _between(
    to: Lowering, name: str, places: Sequence[Array], along: Array, across: Array | None
) -> list[tuple[Node, Node]]:
    """Return points and frames between the beams."""
    made = []
    for i, place in enumerate(places, start=1):
        point, label = Point(f"{name} point {i}", place).lower(to), f"{name} frame {i}"
        if across is None:
            frame = Angle(label, float(np.arctan2(along[1], along[0]))).lower(to)
        else:
            frame = Frame(label, triad(along, across, name)).lower(to)
        made.append((point, frame))
    return made
