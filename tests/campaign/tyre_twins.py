"""The compliant tyre written again: where it touches the road, how it moves there, and the laws of its forces."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from campaign.algebra import body_rate, columns, cross, dot, norm, rotated
from campaign.elastic import Stressed, rates
from campaign.oracle import jacobian
from campaign.twin import Twin
from flexel.base.arrays import Array
from flexel.parts import wheels

UP = (0.0, 0.0, 1.0)
PLACES = ("deflection", "drop", "camber")
RATES = ("forward", "sideways", "rolling", "longitudinal", "lateral", "spin")


class Plane:
    """The road n.x = height."""

    def __init__(self, normal: Any, height: float) -> None:
        self.n, self.height = np.array(normal, float) / np.linalg.norm(normal), height

    def below(self, w: Array) -> tuple[Array, Array, Array]:
        """Normal (3, …), distance from the tangent plane, and distance that the springs count."""
        n = columns(self.n, w) + 0 * w
        h = dot(n, w) - self.height
        return n, h, h


class Wavy:
    """The road of cosine waves z = height + amplitude (1 - cos(2π s/wavelength))/2, on its waves."""

    def __init__(self, amplitude: float, wavelength: float, **more: Any) -> None:
        self.amplitude, self.k = amplitude, 2 * np.pi / wavelength
        self.start, self.height = more.get("start", 0.0), more.get("height", 0.0)
        self.heading = np.array(more.get("heading", (1.0, 0.0)), float)
        self.heading /= np.linalg.norm(self.heading)

    def below(self, w: Array) -> tuple[Array, Array, Array]:
        """Normal (3, …), distance from the tangent plane, and the vertical distance, which the springs count."""
        s = self.heading[0] * w[0] + self.heading[1] * w[1] - self.start
        slope = self.amplitude * self.k * np.sin(self.k * s) / 2
        up = np.array([-slope * self.heading[0], -slope * self.heading[1], 1 + 0 * s])
        above = w[2] - self.height - self.amplitude * (1 - np.cos(self.k * s)) / 2
        return up / norm(up), above / norm(up), above


class Tyre(Twin):
    """The geometry of a tyre on the nodes hub and frame, without any force; coordinates (7,)."""

    def __init__(self, part: wheels.Tyre, orientation: Array) -> None:
        self.name, self.nodes = part.name, (str(part.hub), str(part.frame))
        axle = np.array(part.axle, float)
        back = orientation * [1, -1, -1, -1]
        self.axle = rotated(back, axle / np.linalg.norm(axle))
        self.radius, self.crown = part.radius, part.crown
        waves = part.road
        if waves is None:
            self.road: Plane | Wavy = Plane(part.normal, part.height)
        else:
            self.road = Wavy(**vars(waves))

    def places(self, x: Array) -> Array:
        """Deflection, drop and camber (3, …)."""
        n, _, distance = self.road.below(x[:3])
        a = rotated(x[3:], self.axle)
        lean = dot(a, n)
        upright = np.sqrt(1 - lean * lean / dot(a, a))  # cosine of the camber
        deflection = self.radius - self.crown - (distance - self.crown) / (upright * norm(a))
        return np.array([deflection, self.radius - distance, np.arctan(lean / norm(cross(a, n)))])

    def rates(self, x: Array, v: Array) -> Array:
        """The six slips (6, …), linear in v."""
        n, h, _ = self.road.below(x[:3])
        a = rotated(x[3:], self.axle)
        ahead = cross(a, n)
        ahead = ahead / norm(ahead)
        aside = cross(n, ahead)
        down = dot(a, n) * a - n  # in the plane of the wheel, steepest
        upright = norm(down)
        contact = (h - self.crown) / upright * down / upright - self.crown * n
        omega = rotated_vector(x[3:], body_rate(x[3:], v[3:]))
        slide = v[:3] + cross(omega, contact)
        found = (
            dot(ahead, v[:3]),
            dot(aside, v[:3]),
            dot(omega, a),
            dot(ahead, slide),
            dot(aside, slide),
            dot(omega, n),
        )
        return np.array(found)

    def rows(self, x: Array) -> Array:
        """The slips as rows (6, 7, …) by the rates of the coordinates."""
        one = np.eye(7).reshape(7, 7, *(1,) * (x.ndim - 1))
        return self.rates(x[:, None], one)


def rotated_vector(lam: Array, vector: Array) -> Array:
    """R(λ) b (3, …) of vectors in body axes (3, …)."""
    each = [rotated(lam, e) for e in np.eye(3)]
    return np.asarray(sum(e * b for e, b in zip(each, vector, strict=True)))


Stresses = tuple[Mapping[str, float], Mapping[str, float], Mapping[str, float]]
Law = Callable[[Mapping[str, float], Mapping[str, float], Mapping[str, Any]], Stresses]


def pressed(e: float, rate: float, p: Mapping[str, Any]) -> float:
    """Vertical force: a spring and a damper that never pull."""
    return max(0.0, p["stiffness"] * e + p["damping"] * rate) if e > 0 else 0.0


def vertical(now: Mapping[str, float], rate: Mapping[str, float], p: Mapping[str, Any]) -> Stresses:
    return {now["on"]: pressed(now[now["on"]], rate[now["on"]], p)}, {}, {}


def standing(now: Mapping[str, float], p: Mapping[str, Any]) -> tuple[float, float]:
    """Slip angle of the wheel's centre, and the factor that fades side forces out at standstill."""
    speed = abs(now["forward"])
    u = min(1.0, speed / p["standstill"])
    return float(np.arctan(now["sideways"] / max(speed, p["standstill"]))), u * u * (3 - 2 * u)


def linear(now: Mapping[str, float], rate: Mapping[str, float], p: Mapping[str, Any]) -> Stresses:
    Fz = pressed(now["deflection"], rate["deflection"], p)
    alpha, fade = standing(now, p)
    on = now["deflection"] > 0
    Fy = -p["cornering"] * alpha - p["camber_stiffness"] * now["camber"] if on else 0.0
    return {"deflection": Fz}, {"lateral": -fade * Fy, "spin": fade * p["trail"] * Fy}, {}


def calspan(now: Mapping[str, float], rate: Mapping[str, float], p: Mapping[str, Any]) -> Stresses:
    Fz = pressed(now["deflection"], rate["deflection"], p)
    alpha, fade = standing(now, p)
    (A0, A1, A2, A3, A4), (B1, B3, B4) = p["A"], p["B"]
    F = min(Fz, A2)
    mu = p["SN"] * (B1 * F + B3 + B4 * F**2)
    pull = (A0 + A1 * F - A1 * F**2 / A2) * alpha + (A3 * F - A3 * F**2 / A4) * now["camber"]
    slip = float(np.clip(-pull / (mu * max(Fz, 1e-3)), -3, 3))
    Fy = mu * Fz * (slip - slip * abs(slip) / 3 + slip**3 / 27)
    Mz = (p["AF"][0] * Fz + p["AF"][1] * abs(Fy)) * Fy
    return {"deflection": Fz}, {"lateral": -fade * Fy, "spin": -fade * Mz}, {}


def magic(now: Mapping[str, float], rate: Mapping[str, float], p: Mapping[str, Any]) -> Stresses:
    Fz, F0 = pressed(now["deflection"], rate["deflection"], p), p["load0"]
    kappa, tan_alpha = now["kappa"], now["tan_alpha"]
    mu = p["friction"][0] + p["friction"][1] * min(1.0, Fz / F0 - 1)
    grip = mu * max(Fz, 1e-3)
    cornering = p["cornering"][0] * F0 * np.sin(2 * np.arctan(Fz / (p["cornering"][1] * F0)))
    pull = np.array(
        [p["slip_stiffness"] * Fz * kappa, cornering * tan_alpha + p["camber_stiffness"] * Fz * now["camber"]]
    )
    slip = np.hypot(np.hypot(*pull) / grip, 1e-8)  # the least slip, so that its direction exists
    C, E = p["shape"]
    b = slip / C
    total = mu * Fz * np.sin(C * np.arctan(b - E * (b - np.arctan(b))))
    Fx, Fy = total * pull / grip / slip * [1, -1]
    arm = p["trail"][0] * Fz / F0 / np.hypot(1, p["trail"][1] * tan_alpha)
    speed = abs(now["forward"])
    zdot = {
        "kappa": (p["rolling_radius"] * now["rolling"] - now["forward"] - speed * kappa) / p["relaxation"][0],
        "tan_alpha": (now["lateral"] - speed * tan_alpha) / p["relaxation"][1],
    }
    return {"deflection": Fz}, {"longitudinal": -Fx, "lateral": -Fy, "spin": arm * Fy}, zdot


LAWS: dict[str, tuple[Law, tuple[str, ...]]] = {
    "vertical_tyre": (vertical, ()),
    "linear_tyre": (linear, ()),
    "calspan_tyre": (calspan, ()),
    "magic_formula": (magic, ("kappa", "tan_alpha")),
}


class TyreForces(Stressed):
    """A law on a tyre."""

    conserves = False

    def __init__(
        self, tyre: Tyre, law: str, label: str, parameters: Mapping[str, Any], on: str = "deflection"
    ) -> None:
        self.tyre, self.nodes, self.on = tyre, tyre.nodes, on
        self.law, own = LAWS[law]
        self.states = tuple(f"{label}.{name}" for name in own)
        self._own, self.parameters = own, parameters
        self.conserves = law == "vertical_tyre" and not parameters["damping"]

    def _found(self, x: Array, v: Array, z: Array) -> Stresses:
        places, moving = self.tyre.places(x), rates(self.tyre.places, x, v)
        now: dict[str, Any] = {"on": self.on, **dict(zip(PLACES, places, strict=True))}
        now |= dict(zip(RATES, self.tyre.rates(x, v), strict=True)) | dict(zip(self._own, z, strict=True))
        return self.law(now, dict(zip(PLACES, moving, strict=True)), self.parameters)

    def potential(self, x: Array) -> Array:
        """The energy of the spring while it is pressed."""
        e = self.tyre.places(x)[PLACES.index(self.on)]
        return np.where(np.real(e) > 0, self.parameters["stiffness"] * e**2 / 2, 0.0)

    def force(self, x: Array, v: Array, z: Array, t: float) -> Array:  # noqa: ARG002 (no law depends on time)
        sigma, tau, _ = self._found(x, v, z)
        De, V = jacobian(self.tyre.places, x), self.tyre.rows(x)
        f = jacobian(self.potential, x)  # the law gives all of the vertical force
        for name, value in sigma.items():
            f -= value * De[PLACES.index(name)]
        for name, value in tau.items():
            f -= value * V[RATES.index(name)]
        return f

    def scaled(self, length: float, mirror: bool) -> Array:  # noqa: ARG002 (slips are relative)
        return np.array([-1.0 if mirror and name == "tan_alpha" else 1.0 for name in self._own])

    def zdot(self, x: Array, v: Array, z: Array, t: float) -> Array:  # noqa: ARG002 (no law depends on time)
        found = self._found(x, v, z)[2]
        return np.array([found[name] for name in self._own])

    def stresses(self, x: Array, v: Array, z: Array, t: float) -> dict[str, float]:  # noqa: ARG002 (as force)
        sigma, tau, _ = self._found(x, v, z)
        return {f"{self.tyre.name}.{name}": float(value) for name, value in {**sigma, **tau}.items()}
