"""How parts of each kind change with the model; see `changes`."""

from dataclasses import replace
from typing import Any

import numpy as np

from campaign.case import Case, drawn_nodes
from campaign.changes import Change, Inapplicable, changer, having, listed, numbers, sized
from flexel.model.part import Part
from flexel.parts.bodies import Body, PointMass
from flexel.parts.cables import Anchor, Clamp
from flexel.parts.couplings import PlanarGear, PlanarWheel, RotaryInertia
from flexel.parts.elements import ElementPart
from flexel.parts.joints import Bearing, BodyPoint, Hinge, Truss
from flexel.parts.laws import LawPart
from flexel.parts.loads import LoadPart
from flexel.parts.nodes import Angle, Frame, Point
from flexel.parts.relations import Relation
from flexel.parts.roles import Fix, Independent, Prescribe, Release
from flexel.parts.springs import Spring
from flexel.parts.wheels import Wheel

BENDING = (
    ".torsion",
    ".bend1",
    ".bend2",
)  # of a spatial beam: those that a reflection of its z axis turns over


def unit_of(case: Case, name: str) -> str:
    """Unit of a deformation or coordinate; an angle has none."""
    return "" if name.endswith((".angle", ".relation", ".mesh")) else "L"


def sign_of(change: Change, case: Case, name: str) -> float:
    """Of a deformation under a reflection: one about an axis of the plane or along an axis of turn changes its own."""
    turned_over = (".angle", ".mesh", ".bend1", ".bend2") if len(case.gravity) == 2 else (".axial", *BENDING)
    return change.sign if name.endswith(turned_over) else 1.0


def deformation(case: Case, name: str) -> str:
    """The name of a deformation; that of a coordinate has another meaning after a turn."""
    node = name.rpartition(".")[0]
    nodes = drawn_nodes(case)
    if node in nodes and nodes[node].kind != "angle":
        raise Inapplicable("a coordinate in global axes is named")
    return name


@changer(Point)
def _point(change: Change, part: Point, case: Case) -> Point:
    return replace(part, position=listed(change.place(part.position)))


@changer(Frame)
def _frame(change: Change, part: Frame, case: Case) -> Frame:
    return replace(part, orientation=listed(change.frame(part.orientation)))


@changer(Angle)
def _angle(change: Change, part: Angle, case: Case) -> Angle:
    return replace(part, value=change.heading + change.sign * part.value)


@changer(Fix)
def _fix(change: Change, part: Fix, case: Case) -> Fix:
    if any(name not in drawn_nodes(case) for name in part.names):
        raise Inapplicable("a coordinate in global axes is named")
    return part


@changer(Independent, Release)
def _names(change: Change, part: Independent | Release, case: Case) -> Independent | Release:
    for name in part.names:
        deformation(case, str(name))
    return part


@changer(BodyPoint, Clamp, Anchor)
def _same(change: Change, part: Part[Any], case: Case) -> Part[Any]:
    return part


@changer(Hinge, Bearing)
def _hinge(change: Change, part: Hinge | Bearing, case: Case) -> Hinge | Bearing:
    return part if part.axis is None else having(part, axis=change.axial(part.axis))


@changer(Truss)
def _truss(change: Change, part: Truss, case: Case) -> Truss:
    return sized(change, part, {"mass_per_length": "M L-1"})


@changer(PointMass)
def _point_mass(change: Change, part: PointMass, case: Case) -> PointMass:
    return sized(change, part, {"mass": "M"})


@changer(RotaryInertia)
def _rotary_inertia(change: Change, part: RotaryInertia, case: Case) -> RotaryInertia:
    return having(part, inertia=change.tensor(part.inertia))


@changer(Body)
def _body(change: Change, part: Body, case: Case) -> Body:
    offset = (0.0,) * len(case.gravity) if part.offset is None else part.offset
    mass, inertia = change.size("M", part.mass), change.tensor(part.inertia)
    return having(part, mass=mass, inertia=inertia, offset=change.body(offset))


@changer(Spring)
def _spring(change: Change, part: Spring, case: Case) -> Spring:
    name = str(part.on)
    slip = name.endswith((".lateral", ".longitudinal", ".sideways"))
    unit = "L" if slip else unit_of(case, deformation(case, name))
    length2 = " L2" if not unit else ""  # a moment by an angle
    sign = sign_of(change, case, name)
    return having(
        part,
        stiffness=change.size(f"M T-2{length2}", part.stiffness or 0.0),
        damping=change.size(f"M T-1{length2}", part.damping or 0.0),
        preload=sign * change.size(f"M T-2 {'L2' if not unit else 'L'}", part.preload or 0.0),
        free_length=sign * change.size(unit, part.free_length or 0.0),
    )


@changer(LoadPart)
def _load(change: Change, part: LoadPart, case: Case) -> LoadPart:
    target, value = str(part.target), part.value
    if target in drawn_nodes(case):
        new = change.mass * change.length / change.time**2 * change.vector(value)
        return having(part, value=new)
    unit = "M T-2 L" if unit_of(case, deformation(case, target)) else "M T-2 L2"
    return having(part, value=_signed(change.size(unit, value), sign_of(change, case, target)))


@changer(Prescribe)
def _prescribe(change: Change, part: Prescribe, case: Case) -> Prescribe:
    node = deformation(case, part.name).rpartition(".")[0]
    if node in drawn_nodes(case):
        raise Inapplicable("a coordinate in global axes is named")
    new = change.size(unit_of(case, part.name), part.motion)
    return having(part, motion=_signed(new, sign_of(change, case, part.name)))


def _signed(value: Any, sign: float) -> Any:
    return value if sign > 0 else Change().factored(value, sign)


@changer(PlanarGear)
def _gear(change: Change, part: PlanarGear, case: Case) -> PlanarGear:
    return sized(change, part, {"radius_p": "L", "radius_q": "L"})


@changer(Relation)
def _relation(change: Change, part: Relation, case: Case) -> Relation:
    for term in part.terms:
        deformation(case, term)
    new = {
        term: c / change.size(unit_of(case, term), 1.0) * sign_of(change, case, term)
        for term, c in part.terms.items()
    }
    return Relation(part.name, new)


@changer(Wheel)
def _wheel(change: Change, part: Wheel, case: Case) -> Wheel:
    normal = change.vector(part.normal)
    return replace(
        part,
        radius=change.size("L", part.radius),
        axle=listed(change.vector(part.axle)),
        normal=listed(normal),
        height=float(change.length * part.height + normal @ np.array(change.shift)),
        crown=change.size("L", part.crown),
    )


@changer(PlanarWheel)
def _planar_wheel(change: Change, part: PlanarWheel, case: Case) -> PlanarWheel:
    radius = change.size("L", part.radius) * change.sign
    if radius < 0:
        raise Inapplicable("an upright wheel turns about one side of the plane")
    return replace(part, radius=radius, direction=listed(change.vector(part.direction)))


@changer(ElementPart)
def _element(change: Change, part: ElementPart, case: Case) -> ElementPart:
    given = part.parameters or {}
    new = numbers(change, given, {"mass": "M", "l0": "L", "base": "L", "lift": "L"})
    if "side" in given:
        new["side"] = listed(change.body(given["side"]) / change.length)
    return replace(part, parameters=new)


@changer(LawPart)
def _law(change: Change, part: LawPart, case: Case) -> LawPart:
    unit = "M T-2" if unit_of(case, part.on[0]) else "M T-2 L2"
    return replace(part, parameters=numbers(change, part.parameters or {}, {"k": unit, "lag": "T"}))
