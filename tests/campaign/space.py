"""A planar model written as a spatial one."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from campaign.algebra import about
from campaign.case import Case, drawn_nodes
from campaign.changes import Inapplicable
from campaign.known_lines import KnownLine
from flexel.model.part import Part, kind_of
from flexel.parts.beams import Beam
from flexel.parts.bodies import Body, PointMass
from flexel.parts.cables import Anchor, Cable, Clamp, Slope
from flexel.parts.couplings import RotaryInertia
from flexel.parts.joints import Bearing, BodyPoint, Hinge, Truss
from flexel.parts.laws import LawPart
from flexel.parts.loads import DistributedLoad, LoadPart
from flexel.parts.nodes import Angle, Frame, Point
from flexel.parts.relations import Relation
from flexel.parts.roles import Fix, Independent, Initial, Prescribe, Release
from flexel.parts.rope_contacts import RopeContact
from flexel.parts.rope_surfaces import Sheave
from flexel.parts.springs import MassDamping, Spring

Z = (0.0, 0.0, 1.0)
CHOICES = (Independent, Initial)  # of coordinates and a state, which the property gives itself


def in_space(case: Case) -> Case:
    """The same mechanism, each planar part by its spatial counterpart.

    Raises
    ------
    Inapplicable
        A spatial model, or a part without a counterpart.
    """
    if len(case.gravity) == 3:
        raise Inapplicable("not planar")
    parts = tuple(_in_space(part, case) for part in case.parts if not isinstance(part, CHOICES))
    known = case.known | {"redundant"}  # a planar loop has conditions in space that follow from others
    return replace(case, gravity=(*case.gravity, 0.0), parts=parts, known=known)


def _in_space(part: Any, case: Case) -> Part[Any]:
    match part:
        case Point():
            return replace(part, position=(*part.position, 0.0))
        case Angle():
            lam = about(np.array(Z), part.value)
            return Frame(part.name, tuple(lam.tolist()), fixed=part.fixed)
        case Hinge() | Bearing():
            return replace(part, axis=Z)
        case Body():
            offset = None if part.offset is None else (*part.offset, 0.0)
            return replace(part, inertia=_thick(part.inertia), offset=offset)
        case RotaryInertia():
            return replace(part, inertia=(*_thick(part.inertia), 0.0, 0.0, 0.0))
        case Beam() if part.frame_q is not None:
            bent = part.initial_curvature
            return replace(
                part,
                GJ=3.0,
                EIy=5.0,
                inertia_per_length=_thick(part.inertia_per_length or 0.0),
                direction=_side(part, case),
                initial_curvature=None if bent is None else (0.0, 0.0, bent),
            )
        case Slope():
            return replace(part, direction=(*part.direction, 0.0))
        case DistributedLoad():
            return replace(part, value=(*part.value, 0.0))
        case Sheave():
            return replace(part, axle=Z)
        case RopeContact():
            if part.contact.bristle_stiffness:
                raise Inapplicable("bristles bend in two directions in space")
            return part
        case Release():
            return _same_names(replace(part, names=tuple(map(_bending, part.names))), part.names, case)
        case Spring():
            return _same_names(part, (part.on,), case)
        case Prescribe():
            return _same_names(part, (part.name,), case)
        case LoadPart():
            if part.target in drawn_nodes(case):
                return replace(part, value=(*part.value, 0.0))
            return _same_names(part, (part.target,), case)
        case LawPart():
            return _same_names(part, part.on, case)
        case Relation():
            return _same_names(part, part.terms, case)
        case Fix() | MassDamping() | Cable() | Clamp() | Anchor() | KnownLine():
            return part
        case BodyPoint() | Truss() | PointMass():
            return part
    raise Inapplicable(f"a {kind_of(type(part))} has no counterpart in space")


def _thick(J: float) -> tuple[float, float, float]:
    """Moments of inertia of a body whose planar one is J."""
    return 0.7 * J, 0.6 * J, J


def _bending(name: str) -> str:
    """A deformation: the plane of a planar beam is that of bend3 and bend4 of the spatial one."""
    return name.replace(".bend2", ".bend4").replace(".bend1", ".bend3")


def _side(part: Beam, case: Case) -> tuple[float, float, float]:
    """The direction in the plane across a beam."""
    nodes = drawn_nodes(case)
    d = nodes[str(part.q)].drawn - nodes[str(part.p)].drawn
    return -float(d[1]), float(d[0]), 0.0


def _same_names(part: Part[Any], names: Iterable[Any], case: Case) -> Part[Any]:
    """The part, unless it names an angle of a node, which does not exist in space."""
    nodes = drawn_nodes(case)
    if any(str(name).rpartition(".")[0] in nodes for name in names):
        raise Inapplicable("a coordinate of the plane is named")
    return part
