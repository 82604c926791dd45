"""Families of the campaign "no step onto another branch" that turn many times: shafts, rotors, screws, drives."""

from collections.abc import Callable

import numpy as np
from branch_case import LEAST, Case
from branch_spatial import parameters, points
from references import follow

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.quaternions import unit

Rng = np.random.Generator


def _sign(rng: Rng) -> float:
    return float(rng.choice([-1.0, 1.0]))


def shafts(beta: float, *inertia: float) -> fx.Model:
    """Two shafts at an angle beta with a Cardan joint between them."""
    m = fx.Model()
    O = m.point("O", (0, 0, 0), fixed=True)
    ground, one, cross, two = (
        m.frame(name, fixed=name == "ground") for name in ("ground", "one", "cross", "two")
    )
    m.hinge("drive", ground, one, axis=(1, 0, 0))
    m.hinge("pin1", one, cross, axis=(0, 1, 0))
    m.hinge("pin2", cross, two, axis=(0, 0, 1))
    m.hinge("driven", ground, two, axis=(np.cos(beta), np.sin(beta), 0))
    for frame, J in zip((one, two), inertia, strict=True):
        m.body(f"rotor {frame.name}", O, frame, mass=1.0, inertia=(J,) * 3)
    return m


def driven_angle(drive: Array, beta: float) -> Array:
    """Angle of the driven shaft, tan(driven) = tan(drive) / cos(beta), with the turns of the driving one."""
    s, k, c = np.sin(drive), np.cos(drive), np.cos(beta)
    return np.asarray(drive + np.arctan2(s * k * (1 - c), c * k**2 + s**2))


def cardan(name: str, rng: Rng) -> Case:
    """A Cardan shaft without load: the energy in one angle, J1 + J2 r² with r the ratio of speeds."""
    beta, J1, J2 = rng.uniform(0.2, 1.1), rng.uniform(0.1, 0.5), rng.uniform(0.1, 0.5)
    rate = _sign(rng) * rng.uniform(5, 30)

    def model() -> fx.Model:
        m = shafts(beta, J1, J2)
        m.initial("drive.angle", rate=rate)
        return m

    def speed(t: float, y: Array) -> Array:
        inertia = [
            J1 + J2 * (np.cos(beta) / (1 - (np.sin(beta) * np.cos(angle)) ** 2)) ** 2 for angle in (0.0, y[0])
        ]
        return np.array([rate * np.sqrt(inertia[0] / inertia[1])])

    def exact() -> Callable[[Array], Array]:
        angle = follow(speed, lambda y: y, np.zeros(1), 1.0)
        return lambda t: np.array([angle(t)[0], driven_angle(angle(t)[0], beta)])

    bad = ("pin1.angle", "pin2.angle", *parameters("one", "cross", "two"))
    return Case(name, model, ("drive.angle",), bad, ("drive.angle", "driven.angle"), exact)


def driven(name: str, rng: Rng) -> Case:
    """No degree of freedom is left: a Cardan shaft (even numbers) or a slider-crank driven at a constant rate."""
    rate = _sign(rng) * rng.uniform(20, 40)
    if int(name.split()[-1]) % 2:
        return _driven_slider(name, rate, rng.uniform(0.2, 0.35), rng.uniform(0.5, 1.0))
    beta = rng.uniform(0.2, 1.1)

    def model() -> fx.Model:
        m = shafts(beta, 0.3, 0.5)
        m.prescribe("drive.angle", fx.Polynomial((0.0, rate)))
        return m

    def exact() -> Callable[[Array], Array]:
        return lambda t: np.array([rate * t, driven_angle(rate * t, beta)])

    return Case(name, model, (), (), ("drive.angle", "driven.angle"), exact, worst=LEAST)


def _driven_slider(name: str, rate: float, a: float, b: float) -> Case:
    def model() -> fx.Model:
        m = fx.Model()
        O, A, B = m.point("O", (0, 0), fixed=True), m.point("A", (a, 0)), m.point("B", (a + b, 0))
        m.fix("B.y")
        ground, crank, rod = m.angle("ground", fixed=True), m.angle("crank"), m.angle("rod")
        m.hinge("crank hinge", ground, crank)
        m.beam("crank bar", O, crank, A, mass_per_length=1.0)
        m.beam("rod bar", A, rod, B, mass_per_length=1.0)
        m.prescribe("crank hinge.angle", fx.Polynomial((0.0, rate)))
        return m

    def place(t: Array) -> Array:
        tilt = -np.arcsin(a * np.sin(rate * t) / b)
        return np.array([rate * t, tilt, a * np.cos(rate * t) + b * np.cos(tilt)])

    return Case(name, model, (), (), ("crank.angle", "rod.angle", "B.x"), lambda: place, a + b, worst=LEAST)


def rotor(name: str, rng: Rng) -> Case:
    """A balanced rotor on a tilted axle that turns many times, with a point on its rim."""
    rate, axis = _sign(rng) * rng.uniform(50, 200), unit(rng.normal(size=3), "rotor", "axis")
    rim = 0.3 * unit(np.cross(axis, rng.normal(size=3)), "rotor", "rim")

    def model() -> fx.Model:
        m = fx.Model()
        O, P = m.point("O", (0, 0, 0), fixed=True), m.point("P", rim)
        m.hinge("axle", m.frame("ground", fixed=True), m.frame("disc"), axis=axis)
        m.body("rotor", O, "disc", mass=1.0, inertia=(1.0, 1.0, 1.0))
        m.body_point("rim", O, "disc", P)
        m.initial("axle.angle", rate=rate)
        return m

    def place(t: Array) -> Array:
        turned = np.outer(rim, np.cos(rate * t)) + np.outer(np.cross(axis, rim), np.sin(rate * t))
        return np.vstack([rate * t, turned])

    bad = (*points("P"), *parameters("disc"))
    names = ("axle.angle", *points("P"))  # the constant rate is exact in the angle: no measure for an error
    return Case(name, model, ("axle.angle",), bad, names, lambda: place, 0.3, least=1.0)


def screw(name: str, rng: Rng) -> Case:
    """A heavy nut that turns many times on a screw."""
    pitch, rate = 10.0 ** rng.uniform(-3, -1), _sign(rng) * rng.uniform(10, 60)
    mass, J = 2.0, 0.02

    def model() -> fx.Model:
        m = fx.Model(gravity=(0, 0, -9.81))
        m.point("O", (0, 0, 0), fixed=True)
        m.point("P", (0, 0, 0.3))
        m.frame("ground", fixed=True)
        m.frame("nut")
        m.bearing("guide", "O", "ground", "P", "nut", axis=(0, 0, 1))
        m.body("mass", "P", "nut", mass=mass, inertia=(0.1, 0.1, J))
        m.relation("screw", {"guide.axial": 1.0, "guide.angle": -pitch})
        m.initial("guide.angle", rate=rate)
        return m

    def place(t: Array) -> Array:
        turned = rate * t - mass * 9.81 * pitch / (J + mass * pitch**2) * t**2 / 2
        return np.array([turned, 0.3 + pitch * turned])

    bad = ("guide.axial", "P.z", *parameters("nut"))
    names = ("guide.angle", "P.z")  # the constant acceleration is exact in the angle: no measure for an error
    return Case(name, model, ("guide.angle",), bad, names, lambda: place, 0.3, least=1.0)


TURNING: dict[str, Callable[[str, Rng], Case]] = {
    "cardan": cardan,
    "driven": driven,
    "rotor": rotor,
    "screw": screw,
}
