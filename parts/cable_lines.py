"""Lines of cables: many elements along a straight line or a curve."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, fields
from typing import TYPE_CHECKING, Any

from flexel.base.arguments import text, unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.base.shown import prints
from flexel.model.handle import Handle
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.parts.cables import Cable, Slope
from flexel.parts.materials import MATERIALS, Material
from flexel.parts.path_curves import Path, curve, fractions, points_at

if TYPE_CHECKING:
    from flexel.derive.compiled import CompiledElement, CompiledLaw

PROPERTIES = tuple(item.name for item in fields(Cable) if item.kw_only)  # that a line passes to its elements


@dataclass(frozen=True, repr=False)
class CableLine(Handle):
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

    @prints
    def __repr__(self) -> str:
        """Return one line: a rope has hundreds of nodes."""
        return f"{type(self).__name__}('{self.name}', {len(self.elements)} elements, {self.s[-1]:.6g} m)"


@part
class CableLinePart(Part[CableLine]):
    """Add a cable of n elements along a path: elements ``name1`` …, points ``name_p0`` …, slopes ``name_d0`` ….

    Raises
    ------
    ModelError
        A path of zero length, positions that do not increase, ends that are not on the path.

    Examples
    --------
    >>> rope = m.cable_line("rope", [(0, 0, 0), (0, 0, -10)], 20, EA=1e6, EI=1.0, mass_per_length=1.0)
    ... # doctest: +SKIP
    """

    name: str = entry("Names of elements and nodes start with it.")
    path: Path = array_quantity(
        "m",
        "Points [], (3,) or (2,): two define a straight line, more a smooth curve through them.  A callable returns "
        "the position for a parameter from 0 to 1.",
    )
    n: int | None = entry("Number of elements, of equal length.", default=None)
    _: KW_ONLY
    length: float | None = quantity(
        "m",
        "positive",
        "Undeformed length [] of the whole cable, by default the path's; a longer path stretches the cable.",
        default=None,
    )
    at: Sequence[float] | Array | None = array_quantity(
        "-",
        "Instead of n: undeformed arc length of the nodes over the total, from 0 to 1, for example to refine near a "
        "sheave.",
        default=None,
    )
    start: Node | str | None = entry(
        "Existing point to use for the first end, such as a body's point.", default=None
    )
    end: Node | str | None = entry("Existing point to use for the other end.", default=None)
    EA: float | None = quantity("N", "positive", "Stiffness in tension [], as for `cable`.", default=None)
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

    def lower(self, to: Lowering) -> CableLine:
        """Add the nodes and elements."""
        name = text(self.name, "cable line", "name")
        shares = fractions(self.owner, self.n, self.at)
        drawn, total = curve(self.owner, self.path)
        length = total if self.length is None else self.length
        places, directions = drawn(shares * total), drawn(shares * total, 1)
        points = points_at(to, self.owner, name, places, self.start, self.end)
        slopes = [
            Slope(f"{name}_d{i}", direction, stretch=total / length).lower(to)
            for i, direction in enumerate(directions)
        ]
        s = shares * length
        elements = add_cables(to, name, points, slopes, s, properties_of(self))
        line = CableLine(name, elements, points, tuple(slopes), s, section_radius(self.section))
        to.lines[name] = line
        return line


def properties_of(line: Part[Any]) -> dict[str, Any]:
    """Return the stiffness, mass and damping that a line or rope passes to each of its cables."""
    return {key: getattr(line, key) for key in PROPERTIES}


def add_cables(
    to: Lowering,
    name: str,
    points: Sequence[Node],
    slopes: Sequence[Node],
    s: Array,
    properties: dict[str, Any],
) -> tuple[str, ...]:
    """Add the elements ``name1`` … of a line; the last one of a closed line ends at the first point.

    Parameters
    ----------
    s : ndarray (n + 1,)
        Undeformed arc length of the ends of the n elements [m].
    properties : dict
        Those of `properties_of`.
    """
    elements = tuple(f"{name}{i + 1}" for i in range(s.size - 1))
    for i, element in enumerate(elements):
        after = (i + 1) % len(points)
        ends = points[i], slopes[i], points[after], slopes[after]
        Cable(element, *ends, float(s[i + 1] - s[i]), **properties).lower(to)
    return elements


def find_line(to: Lowering, line: Any, owner: str) -> CableLine:
    """Find the line of cables with this name, or a line of this model; else raise a ModelError that names the owner."""
    known = {name: found for name, found in to.lines.items() if isinstance(found, CableLine)}
    if isinstance(line, str) and line in known:
        return known[line]
    if isinstance(line, str) and known:
        raise ModelError(f"{owner}: {unknown(line, known, 'rope')}")
    if not isinstance(line, CableLine):
        raise ModelError(f"{owner}: {line!r} is not a rope; give the result of m.rope(…) or m.cable_line(…)")
    if known.get(line.name) is not line:
        raise ModelError(
            f"{owner}: the rope '{line.name}' belongs to another model; use the ropes of this one"
        )
    return line


def section_radius(section: object) -> float | None:
    """Return half the outer diameter [m] of a round section; None for others."""
    diameter = getattr(section, "diameter", None)
    return None if diameter is None else float(diameter) / 2


def contact_radius(own: float | None, given: float | None, owner: str) -> float:
    """Return the contact radius [m] of a rope: its section's, or the given one if the section has none."""
    if given is None:
        if own is None:
            raise ModelError(f"{owner}: its radius is not known; give radius=…, or a section with a diameter")
        return own
    if own is not None and abs(given - own) > 1e-9 * own:
        raise ModelError(
            f"{owner}: radius {given:g} m contradicts the radius of the rope's section, {own:g} m; leave radius out"
        )
    return given
