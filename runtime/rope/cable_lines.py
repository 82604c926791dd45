"""Lines of cables: the method of `Model` that adds many elements along a straight line or a curve."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flexel.base.arguments import not_negative, positive, text
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.rope.cables import Cables
from flexel.rope.curves import Path, curve, fractions, points_at
from flexel.structure.nodes import Node


@dataclass(frozen=True, repr=False)
class CableLine:
    """A line of cable elements made by `Model.cable_line`.

    Attributes
    ----------
    name : str
    elements : tuple of str (n,)
    points, slopes : tuple of Node (n + 1,)
    s : ndarray (n + 1,)
        Undeformed arc length of the nodes [m].
    radius : float, optional
        Contact radius [m]: half the diameter of its section; None without a round section.
    """

    name: str
    elements: tuple[str, ...]
    points: tuple[Node, ...]
    slopes: tuple[Node, ...]
    s: Array
    radius: float | None

    def __repr__(self) -> str:
        """One line: a rope has hundreds of nodes."""
        return f"{type(self).__name__}('{self.name}', {len(self.elements)} elements, {self.s[-1]:.6g} m)"


class CableLines(Cables):
    """Lines of cables."""

    @whole_or_nothing
    def cable_line(
        self,
        name: str,
        path: Path,
        n: int | None = None,
        *,
        length: float | None = None,
        at: Sequence[float] | Array | None = None,
        start: Node | str | None = None,
        end: Node | str | None = None,
        **properties: Any,
    ) -> CableLine:
        """Add a cable of n elements along a path: elements ``name1`` …, points ``name_p0`` …, slopes ``name_d0`` ….

        Parameters
        ----------
        path : sequence of points (3,) or (2,), or callable
            Two points are a straight line, more a smooth curve through them; a callable gives the place for a parameter
            from 0 to 1.
        n : int
            Number of elements, of equal length.
        length : float, optional
            Undeformed length of the whole cable [m], that of the path by default; a longer path stretches the cable.
        at : sequence of float, optional
            Instead of n: undeformed arc length of the nodes over the length, from 0 to 1, for example to refine near
            a sheave.
        start, end : node, optional
            Existing points to use for the ends, such as those of a body.
        **properties
            EA, EI, mass_per_length, section, material, damping, bending_damping of `Model.cable`.

        Returns
        -------
        CableLine

        Raises
        ------
        ModelError
            A path without length, places that do not ascend, ends that are not on the path.

        Examples
        --------
        >>> rope = m.cable_line("rope", [(0, 0, 0), (0, 0, -10)], 20, EA=1e6, EI=1.0, mass_per_length=1.0)
        ... # doctest: +SKIP
        """
        owner = f"cable line '{text(name, 'cable line', 'name')}'"
        shares = fractions(owner, n, at)
        drawn, total = curve(owner, path)
        length = total if length is None else positive(length, owner, "length")
        places, directions = drawn(shares * total), drawn(shares * total, 1)
        nodes = points_at(self, owner, name, places, start, end)
        slopes = [
            self.slope(f"{name}_d{i}", direction, stretch=total / length)
            for i, direction in enumerate(directions)
        ]
        s = shares * length
        elements = []
        for i in range(len(s) - 1):
            elements.append(f"{name}{i + 1}")
            ends = nodes[i], slopes[i], nodes[i + 1], slopes[i + 1]
            self.cable(elements[-1], *ends, float(s[i + 1] - s[i]), **properties)
        radius = section_radius(properties.get("section"))
        return CableLine(name, tuple(elements), nodes, tuple(slopes), s, radius)


def section_radius(section: object) -> float | None:
    """Half the outer diameter [m] of a round section; None for others."""
    diameter = getattr(section, "diameter", None)
    return None if diameter is None else float(diameter) / 2


def contact_radius(own: float | None, given: float | None, owner: str) -> float:
    """Radius [m] at which a rope touches: that of its section, or the given one if the section has none."""
    if given is None:
        if own is None:
            raise ModelError(f"{owner}: its radius is not known; give radius=…, or a section with a diameter")
        return own
    radius = not_negative(given, owner, "radius")
    if own is not None and abs(radius - own) > 1e-9 * own:
        raise ModelError(
            f"{owner}: radius {radius:g} m contradicts that of the rope's section, {own:g} m; leave radius out"
        )
    return radius
