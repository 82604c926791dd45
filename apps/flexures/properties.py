"""Properties of nodes and of groups of elements, and the options of the analysis.

Each is a dataclass; a mapping with the same names is accepted as well.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from typing import Any, TypeVar

from flexel.base.arguments import unknown
from flexel.base.arrays import Vector
from flexel.base.errors import ModelError
from flexel.model.profiles import Section
from flexel.parts.materials import Material

Components = Sequence[float | None] | Mapping[str, float]


@dataclass(frozen=True)
class NodeProperties:
    """The properties of a node: supports, loads, prescribed motions and mass; a node without properties is free.

    Loads and prescribed motions without ``_initial`` grow evenly over the load steps; those with it act fully from
    the first step on.

    Parameters
    ----------
    fixed : bool or sequence of str
        True fixes the whole node; "position" or "rotation" all coordinates of that kind, "x", "y" or "z" a single one.
    force, force_initial : sequence of float (3,), optional
        Force in global axes [N].
    moment, moment_initial : sequence of float (3,), optional
        Moment about global axes [N m].
    displacement, displacement_initial : sequence (3,) with None for what is free, or {"x": …}, optional
        Prescribed displacement from the drawn position, in global axes [m].
    rotation, rotation_initial : sequence (3,) with None for what is free, or {"z": …}, optional
        Prescribed rotation [rad] below half a turn.  All three: a rotation about the vector's direction, by
        its length.  One or two: these components of the rotation about global axes; the others are free.
    mass : float
        [kg]
    inertia : array_like, optional
        About the node, in global axes as drawn [kg m²]: three principal moments, (xx, yy, zz, xy, xz, yz), or (3, 3).
    """

    fixed: bool | Sequence[str] = False
    force: Vector | None = None
    force_initial: Vector | None = None
    moment: Vector | None = None
    moment_initial: Vector | None = None
    displacement: Components | None = None
    displacement_initial: Components | None = None
    rotation: Components | None = None
    rotation_initial: Components | None = None
    mass: float = 0.0
    inertia: Any = None


@dataclass(frozen=True)
class ElementProperties:
    """The properties of a group of elements; elements in no group, and those without flexible modes, are rigid.

    Parameters
    ----------
    elements : sequence of int
        Rows of the table of elements, from 1.
    section : str or Section
        "rectangle", "circle" or "tube" with `dimensions`; or an object such as ``fx.IBeam(…)``.
    dimensions : sequence of float
        Rectangle: its size along `orientation`, then its thickness.  Circle: its diameter.  Tube: outer and inner
        diameter [m].
    material : Material or str, optional
        Such as "spring steel"; or the values below.
    E, G, nu, density, strength : float, optional
        Young's modulus [Pa]; shear modulus [Pa] or Poisson's ratio; [kg/m³]; yield stress [Pa].
    orientation : sequence of float (3,), optional
        Global direction of the section's y axis as drawn: for a leaf spring, along its width.
    beams : int
        Number of beams in series that each element is divided into.
    flexible : sequence of int or of str
        The modes that deform: 1 or "elongation", 2 or "torsion", 3 and 4 or "bend1" and "bend2" (the deflection is
        normal to `orientation`), 5 and 6 or "bend3" and "bend4"; or "all".  The others are rigid.
    warping : bool
        Whether its sections warp when it twists (Vlasov).  They stay plane at both ends; where two elements of the
        group are aligned and nothing else holds their common node, they warp there too.
    colour : str or sequence of float (3,), optional
        In pictures, as "#0b5fa5", or red, green and blue from 0 to 1.
    opacity : float, optional
        In pictures, from 0 to 1.
    hidden : bool
        True: not drawn.
    """

    elements: Sequence[int]
    section: str | Section | None = None
    dimensions: Sequence[float] | float | None = None
    material: Material | str | None = None
    E: float | None = None
    G: float | None = None
    nu: float | None = None
    density: float | None = None
    strength: float | None = None
    orientation: Vector | None = None
    beams: int = 1
    flexible: Sequence[int | str] | str = ()
    warping: bool = False
    colour: str | Vector | None = None
    opacity: float | None = None
    hidden: bool = False


@dataclass(frozen=True)
class FlexureOptions:
    """Options of the analysis of a flexure mechanism.

    Parameters
    ----------
    steps : int
        Number of load steps; step 0 has the initial loads alone.
    both_ways : bool
        Whether the loads also act reversed: twice as many steps, from -1 to 1 times the loads, with the
        initial loads alone in the middle.
    gravity : sequence of float (3,)
        [m/s²]
    release : bool or sequence of str
        True releases the over-constraint and reports it; False refuses such a mechanism.  Names such as
        "element 1 beam 2.torsion" or "element 3.bend3" release these, and refuse remaining over-constraint.
    compliance : bool or sequence of int
        Whether to compute the compliance of all nodes; or the nodes for which to compute it.
    frequencies, buckling : int
        Number of natural frequencies, and of buckling multipliers, at each step.
    """

    steps: int = 10
    both_ways: bool = False
    gravity: Vector = (0.0, 0.0, 0.0)
    release: bool | Sequence[str] = True
    compliance: bool | Sequence[int] = True
    frequencies: int = 10
    buckling: int = 5


Properties = TypeVar("Properties", NodeProperties, ElementProperties, FlexureOptions)


def properties_of(kind: type[Properties], given: Any, owner: str) -> Properties:
    """Return the given properties, or those in a mapping; raise a ModelError for an unknown name."""
    if isinstance(given, kind):
        return given
    if is_dataclass(given) or not isinstance(given, Mapping):
        raise ModelError(
            f"{owner}: {given!r:.60} is not a set of properties; give {{'name': …}} or fx.{kind.__name__}(…)"
        )
    known = [field.name for field in fields(kind)]
    for name in given:
        if name not in known:
            raise ModelError(f"{owner}: {unknown(str(name), known, 'property')}")
    if kind is ElementProperties and "elements" not in given:
        raise ModelError(f"{owner}: its elements are missing; give elements=[1, 2, …]")
    return kind(**given)
