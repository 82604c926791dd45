"""Wheels on tyres, for tests."""

import numpy as np

import flexel as fx
from flexel.base.quaternions import matrix

R, H, K = 0.36, 0.35, 2e5


CALSPAN = {
    "A": (2625.0, 14.47, 12930.0, 2.29, 18175.0),
    "B": (-0.464e-4, 1.216, 2.18e-11),
    "SN": 1.0274,
    "AF": (-0.171e-4, 0.171e-4),
    "standstill": 0.1,
}


MAGIC = {
    "load0": 4000.0,
    "rolling_radius": 0.35,
    "friction": (1.0, -0.1),
    "slip_stiffness": 20.0,
    "cornering": (15.0, 2.0),
    "camber_stiffness": 0.5,
    "shape": (1.4, -0.5),
    "trail": (0.03, 8.0),
    "relaxation": (0.2, 0.4),
}


PARTS = ("deflection", "camber", "forward", "sideways", "rolling", "longitudinal", "lateral", "spin")


SIDE = [
    f"tyre.{part}" for part in PARTS if part not in ("rolling", "longitudinal")
]  # of the linear and the CALSPAN law


MAGIC_ON = [f"tyre.{part}" for part in PARTS if part != "sideways"]


def wheel(
    orientation: object = (1, 0, 0, 0), crown: float = 0.0, road: fx.Waves | None = None, **at: float
) -> fx.Model:
    """A free wheel with a tyre, its centre H above the road; its axle is its own y axis."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("hub", (at.get("x", 0.0), 0, at.get("z", H)))
    m.frame("wheel", orientation)
    m.body("mass", "hub", "wheel", mass=400.0, inertia=(6.0, 10.0, 6.0))
    axle = matrix(np.array(orientation, dtype=float))[:, 1]
    m.tyre("tyre", "hub", "wheel", radius=R, axle=axle, crown=crown, road=road)
    m.angular_velocity("wheel")
    return m
