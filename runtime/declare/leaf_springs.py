"""Leaf springs: the method of `Model` that puts beams in series between two bodies."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.arguments import new_name, span, vector, whole
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.quaternions import matrix, triad
from flexel.base.transactions import whole_or_nothing
from flexel.declare.beams import Beams
from flexel.declare.materials import Material
from flexel.declare.nodes import Nodes
from flexel.declare.sections import Section
from flexel.declare.warping import nodes_of
from flexel.structure.nodes import Node


class LeafSprings(Beams, Nodes):
    """Leaf springs."""

    @whole_or_nothing
    def leaf_spring(
        self,
        name: str,
        p: Node | str,
        frame_p: Node | str,
        q: Node | str,
        frame_q: Node | str,
        *,
        section: Section,
        material: Material | str,
        elements: int = 4,
        start: Vector | None = None,
        end: Vector | None = None,
        direction: Vector | None = None,
        flexible: Sequence[str] | None = None,
        damping: float = 0.0,
        second_order: bool = True,
        warping: bool | Sequence[Node | str] = False,
        rotations: str = "classic",
    ) -> tuple[str, ...]:
        """Add a straight leaf spring between two bodies, or between two nodes: beams in series.

        A body is a point and a frame.  The leaf begins at the point `p` and ends at `q`; where it is clamped elsewhere
        on a body, `start` and `end` say where.  Its intermediate nodes are ``<name> point 1``, ``<name> frame 1``, …;
        a frame has its x axis along the leaf and its y axis along `direction`.

        Parameters
        ----------
        p, frame_p, q, frame_q : nodes or names
            Point and frame at both ends.
        section, material : Section and Material (or its name, such as "steel")
            Cross-section and material, as of `beam`.
        elements : int
            Number of beams.
        start, end : sequence of float (3,), or (2,) in a planar model, optional
            Where the leaf is clamped to the bodies, as drawn, in global axes [m]: points ``<name> start`` and
            ``<name> end`` are made there, rigid on their bodies.
        direction : sequence of float (3,)
            Global direction of the section's y axis as drawn.
        flexible : sequence of str, optional
            The modes that deform, of elongation, torsion, bend1 ... bend4; all by default.
        damping : float
            Kelvin–Voigt damping: ratio of damping to stiffness [s].
        second_order : bool
            Second-order terms in the deformations.
        warping : True or two nodes
            Sections warp, as of `beam`: the warping nodes at both ends, or True for free ones of its own; those between
            the beams are ``<name> warping 1``, ….
        rotations : str
            "classic" or "logarithmic", as of `beam`.

        Returns
        -------
        tuple of str
            The names of the beams: ``<name> beam 1``, …; a single one has the name of the leaf.

        Raises
        ------
        ModelError
            Ends that coincide, bodies that are not a point and a frame, a section or material that does not exist.

        Examples
        --------
        >>> m.leaf_spring("left", P, RP, Q, RQ, section=fx.Rectangle(0.3e-3, 20e-3), material="steel", elements=6)
        ... # doctest: +SKIP
        """
        owner = f"leaf spring '{name}'"
        new_name(name, "leaf spring")
        count = whole(elements, owner, "elements")
        planar, bodies = self._find_nodes(
            owner, (p, "point"), (frame_p, "frame"), (q, "point"), (frame_q, "frame")
        )
        first = self._clamped(f"{name} start", bodies[0], bodies[1], start)
        last = self._clamped(f"{name} end", bodies[2], bodies[3], end)
        along, length = span(first.x0, last.x0, owner)
        if planar and direction is not None:
            raise ModelError(
                f"{owner}: a planar leaf spring has no direction, it bends in its plane; leave it out"
            )
        across = None if planar else matrix(triad(along, direction, owner))[:, 1]
        places = [first.x0 + along * length * i / count for i in range(1, count)]
        nodes = [(first, bodies[1]), *self._between(name, places, along, across), (last, bodies[3])]
        beams = tuple(f"{name} beam {i + 1}" for i in range(count)) if count > 1 else (name,)
        twists = self._twists(name, owner, count, warping)
        for beam, (a, b), twist in zip(beams, zip(nodes, nodes[1:], strict=False), twists, strict=True):
            self.beam(
                beam,
                *a,
                *b,
                direction=across,
                section=section,
                material=material,
                flexible=flexible,
                damping=damping,
                second_order=second_order,
                warping=twist,
                rotations=rotations,
            )
        return beams

    def _twists(
        self, name: str, owner: str, count: int, warping: bool | Sequence[Node | str]
    ) -> list[bool | tuple[Node, Node]]:
        """The warping nodes at the ends of each beam; False where there are none."""
        if warping is False:
            return [False] * count
        first, last = nodes_of(self, owner, name, warping)
        nodes = [first, *(self.warping(f"{name} warping {i}") for i in range(1, count)), last]
        return list(zip(nodes, nodes[1:], strict=False))

    def _clamped(self, name: str, point: Node, frame: Node, place: Vector | None) -> Node:
        """The point of a body where the leaf is clamped: its own point, or another one at a place as drawn."""
        if place is None:
            return point
        x0 = vector(place, f"point '{name}'", "place", point.x0.size)
        if np.all(point.fixed) and np.all(frame.fixed):
            return self.point(name, x0, fixed=True)
        made = self.point(name, x0)
        self.beam(f"{name} clamp", point, frame, made)
        return made

    def _between(
        self, name: str, places: Sequence[Array], along: Array, across: Array | None
    ) -> list[tuple[Node, Node]]:
        """Points and frames between the beams."""
        made = []
        for i, place in enumerate(places, start=1):
            point, label = self.point(f"{name} point {i}", place), f"{name} frame {i}"
            if across is None:
                frame = self.angle(label, float(np.arctan2(along[1], along[0])))
            else:
                frame = self.frame(label, triad(along, across, name))
            made.append((point, frame))
        return made
