"""Parts of mechanisms that `Model` can declare, one class per kind, and the tools for writing user-defined parts.

Names are imported on first use, so that modules of parts can be imported individually.
"""
# ruff: noqa: F401 (the table below, imported, for static tools)

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from flexel.base.meaning import array_quantity, entry, quantity
    from flexel.model.lowering import Lowering
    from flexel.model.part import Part, part
    from flexel.parts.beams import Beam
    from flexel.parts.bodies import Body, PointMass
    from flexel.parts.body_joints import (
        Cylindrical,
        PlanarJoint,
        Prismatic,
        Revolute,
        Screw,
        Spherical,
        Universal,
        Weld,
    )
    from flexel.parts.cable_lines import CableLinePart
    from flexel.parts.cables import Anchor, Cable, Clamp, Slope
    from flexel.parts.cams import Cam
    from flexel.parts.chains import ChainPart
    from flexel.parts.controllers import ControllerPart
    from flexel.parts.couplings import PlanarBelt, PlanarGear, PlanarWheel, Quadric, RotaryInertia
    from flexel.parts.elements import ElementPart
    from flexel.parts.friction import Clearance, Friction, Limits
    from flexel.parts.gearing import Belt, CardanChain, Gear, RackAndPinion
    from flexel.parts.joints import Bearing, BodyPoint, Hinge, Truss
    from flexel.parts.laws import AttachedLaw, LawPart
    from flexel.parts.leaf_springs import LeafSpring
    from flexel.parts.loads import AngularVelocity, DistributedLoad, LoadPart
    from flexel.parts.looks import LookPart
    from flexel.parts.nodes import Angle, Frame, Point, Warping
    from flexel.parts.point_contacts import PointContact
    from flexel.parts.relations import Relation
    from flexel.parts.rigid_bodies import RigidBodyPart
    from flexel.parts.roles import Fix, Independent, Initial, Kinematic, Prescribe, Release, Rigid
    from flexel.parts.rope_contacts import RopeContact
    from flexel.parts.rope_surfaces import Plane, Sheave
    from flexel.parts.ropes import RopePart
    from flexel.parts.skates import Skate
    from flexel.parts.springs import MassDamping, Spring, Stop
    from flexel.parts.wheels import AxleSlip, Tyre, Wheel

_HOMES = {
    "Anchor": "flexel.parts.cables",
    "Angle": "flexel.parts.nodes",
    "AngularVelocity": "flexel.parts.loads",
    "AttachedLaw": "flexel.parts.laws",
    "AxleSlip": "flexel.parts.wheels",
    "Beam": "flexel.parts.beams",
    "Bearing": "flexel.parts.joints",
    "Belt": "flexel.parts.gearing",
    "Body": "flexel.parts.bodies",
    "BodyPoint": "flexel.parts.joints",
    "Cable": "flexel.parts.cables",
    "CableLinePart": "flexel.parts.cable_lines",
    "Cam": "flexel.parts.cams",
    "CardanChain": "flexel.parts.gearing",
    "ChainPart": "flexel.parts.chains",
    "Clamp": "flexel.parts.cables",
    "Clearance": "flexel.parts.friction",
    "ControllerPart": "flexel.parts.controllers",
    "Cylindrical": "flexel.parts.body_joints",
    "DistributedLoad": "flexel.parts.loads",
    "ElementPart": "flexel.parts.elements",
    "Fix": "flexel.parts.roles",
    "Frame": "flexel.parts.nodes",
    "Friction": "flexel.parts.friction",
    "Gear": "flexel.parts.gearing",
    "Hinge": "flexel.parts.joints",
    "Independent": "flexel.parts.roles",
    "Initial": "flexel.parts.roles",
    "Kinematic": "flexel.parts.roles",
    "LawPart": "flexel.parts.laws",
    "LeafSpring": "flexel.parts.leaf_springs",
    "Limits": "flexel.parts.friction",
    "LoadPart": "flexel.parts.loads",
    "LookPart": "flexel.parts.looks",
    "Lowering": "flexel.model.lowering",
    "MassDamping": "flexel.parts.springs",
    "Part": "flexel.model.part",
    "PlanarBelt": "flexel.parts.couplings",
    "PlanarGear": "flexel.parts.couplings",
    "PlanarJoint": "flexel.parts.body_joints",
    "PlanarWheel": "flexel.parts.couplings",
    "Plane": "flexel.parts.rope_surfaces",
    "Point": "flexel.parts.nodes",
    "PointContact": "flexel.parts.point_contacts",
    "PointMass": "flexel.parts.bodies",
    "Prescribe": "flexel.parts.roles",
    "Prismatic": "flexel.parts.body_joints",
    "Quadric": "flexel.parts.couplings",
    "RackAndPinion": "flexel.parts.gearing",
    "Relation": "flexel.parts.relations",
    "Release": "flexel.parts.roles",
    "Revolute": "flexel.parts.body_joints",
    "Rigid": "flexel.parts.roles",
    "RigidBodyPart": "flexel.parts.rigid_bodies",
    "RopeContact": "flexel.parts.rope_contacts",
    "RopePart": "flexel.parts.ropes",
    "RotaryInertia": "flexel.parts.couplings",
    "Screw": "flexel.parts.body_joints",
    "Sheave": "flexel.parts.rope_surfaces",
    "Skate": "flexel.parts.skates",
    "Slope": "flexel.parts.cables",
    "Spherical": "flexel.parts.body_joints",
    "Spring": "flexel.parts.springs",
    "Stop": "flexel.parts.springs",
    "Truss": "flexel.parts.joints",
    "Tyre": "flexel.parts.wheels",
    "Universal": "flexel.parts.body_joints",
    "Warping": "flexel.parts.nodes",
    "Weld": "flexel.parts.body_joints",
    "Wheel": "flexel.parts.wheels",
    "array_quantity": "flexel.base.meaning",
    "entry": "flexel.base.meaning",
    "part": "flexel.model.part",
    "quantity": "flexel.base.meaning",
}
__all__ = sorted(_HOMES)


def __getattr__(name: str) -> object:
    """Import the module in which a name lives."""
    if name not in _HOMES:
        raise AttributeError(f"module 'flexel.parts' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    """List all names, whether or not they have been imported yet."""
    return sorted({*globals(), *_HOMES})
