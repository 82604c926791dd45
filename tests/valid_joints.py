"""Valid calls of the methods of `Model` that make rigid bodies, their joints, gears, cams and skates."""

from collections.abc import Callable

from valid_call import Valid
from valid_models import declared, spatial

import flexel as fx


def bodies(*, flat: bool = False) -> fx.Model:
    """Two rigid bodies, the first of which turns on the ground."""
    m = fx.Model()
    for name, x in (("a", 0.0), ("b", 1.0)):
        m.rigid_body(name, (x, 0) if flat else (x, 0, 0), mass=1.0, inertia=1.0 if flat else (1.0, 1.0, 1.0))
    m.revolute("pin", "ground", "a", at=(0, 0) if flat else (0, 0, 0), axis=None if flat else (0, 0, 1))
    return m


def train() -> fx.Model:
    """The same with the second body on a pin, and a third on a guide."""
    m = bodies()
    m.revolute("axle", "ground", "b", at=(1, 0, 0), axis=(0, 0, 1))
    m.rigid_body("c", (0, -0.4, 0), mass=1.0, inertia=(1.0, 1.0, 1.0))
    m.prismatic("guide", "ground", "c", axis=(1, 0, 0))
    return m


JOIN = {"name": "z", "p": "a", "q": "b"}
PLACE = {"at": (0.5, 0.1, 0.0), "axis": (0.0, 1.0, 0.0)}

JOINTS: dict[str, Callable[[], Valid]] = {
    "Model.belt": declared(
        train, "belt", name="z", p="pin", q="axle", radius_p=0.2, radius_q=0.1, crossed=True
    ),
    "Model.cam": declared(
        lambda: bodies(flat=True), "cam", name="z", cam="a", follower="b", at=(1.0, 0.0), outline=[1.0] * 6,
        centre=(0.0, 0.0), start=(1.0, 0.0), face=(1.0, 0.0)
    ),
    "Model.cardan_chain": declared(
        bodies, "cardan_chain", first="yaw", second="lean", third="pitch", body="b", base="a", axes="zxy"
    ),
    "Model.clearance": declared(
        bodies, "clearance", joint="pin", gap=0.001, stiffness=1e5, damping=0.1, friction_radius=0.01, slip_speed=0.1
    ),
    "Model.cylindrical": declared(bodies, "cylindrical", **JOIN, **PLACE),
    "Model.friction": declared(spatial, "friction", on="pivot.angle", limit=1.0, speed=0.1),
    "Model.gear": declared(
        train, "gear", name="z", p="pin", q="axle", at=(0.4, 0.0, 0.0), teeth=(20, 30)
    ),
    "Model.limits": declared(spatial, "limits", on="pivot.angle", low=-1.0, high=1.0, stiffness=10.0, damping=0.1),
    "Model.planar_joint": declared(bodies, "planar_joint", **JOIN, normal=(0.0, 1.0, 0.0), at=(0.5, 0.1, 0.0)),
    "Model.prismatic": declared(
        bodies, "prismatic", **JOIN, **PLACE, stiffness=1.0, damping=0.1, stops=(-1.0, 1.0, 10.0), friction=(0.1, 0.1)
    ),
    "Model.rack_and_pinion": declared(
        train, "rack_and_pinion", name="z", pinion="pin", rack="guide", at=(0.0, -0.4, 0.0)
    ),
    "Model.revolute": declared(
        bodies, "revolute", **JOIN, **PLACE, stiffness=1.0, damping=0.1, stops=(-1.0, 1.0, 10.0), friction=(0.1, 0.1)
    ),
    "Model.rigid_body": declared(
        bodies, "rigid_body", name="z", position=(0.0, 0.0, 1.0), orientation=(1.0, 0.0, 0.0, 0.0), mass=1.0,
        inertia=(1.0, 1.0, 1.0), points={"tip": (1.0, 0.0, 1.0)}
    ),
    "Model.screw": declared(bodies, "screw", **JOIN, **PLACE, pitch=0.01),
    "Model.skate": declared(
        bodies, "skate", name="z", body="b", at=(0.5, 0.1, 0.0), direction=(0.0, 1.0, 0.0), normal=(0.0, 0.0, 1.0)
    ),
    "Model.spherical": declared(bodies, "spherical", **JOIN, at=(0.5, 0.1, 0.0)),
    "Model.universal": declared(
        bodies, "universal", **JOIN, at=(0.5, 0.1, 0.0), axis_p=(1.0, 0.0, 0.0), axis_q=(0.0, 1.0, 0.0)
    ),
    "Model.weld": declared(bodies, "weld", **JOIN, at=(0.5, 0.1, 0.0)),
}  # fmt: skip
