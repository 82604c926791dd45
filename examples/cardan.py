"""The universal joint of the talk: (a) four rigid hinges, (b) the two hinges of the cross flexible in bending.

Only orientations are needed: ground, driving shaft, cross and driven shaft, joined by the bearings of the shafts and
the pins of the cross.  `reproduce` compares kinematics, reaction moments, the linearization about steady rotation and
a free run with closed forms, shows how (b) converges to (a), and finds the zones of parametric instability.
Pictures and table are in `cardan_figures` and `cardan_table`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.special import mathieu_a, mathieu_b

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import cardan_data as data
from flexel.linear import periodic
from flexel.linear.periodic import Coefficients, Orbit, SpeedFamily
from flexel.results.reproduction import Report

ANGLES = (10.0, 20.0, 30.0, 45.0, 60.0)  # between the shafts [degrees]
B30 = np.radians(30.0)
TURN = np.linspace(0.0, 2 * np.pi, 145)
STIFFNESSES = 10.0 ** np.arange(2, 8)  # of the pins in bending [N m/rad]
CROSS = 0.005  # inertia of the cross over that of the driven rotor, in the flexible model
HARMONICS = 12
BENDS = tuple(f"{pin}.{mode}" for pin in ("driving pin", "driven pin") for mode in ("bend1", "bend2"))


# -- models ---------------------------------------------------------------------------------------


def joint(b: float, shaft: str = "ground") -> fx.Model:
    """Build two shafts at an angle b [rad] in the plane x, y; the driving one turns about x in a bearing on `shaft`."""
    m = fx.Model()
    m.frame("ground", fixed=True)
    if shaft != "ground":
        m.frame(shaft)
        m.hinge("motor", "ground", shaft, axis=(1, 0, 0))
    for name in ("driving", "cross", "driven"):
        m.frame(name)
    m.hinge("in", shaft, "driving", axis=(1, 0, 0))
    m.hinge("driving pin", "driving", "cross", axis=(0, 1, 0))
    m.hinge("driven pin", "cross", "driven", axis=(0, 0, 1))
    m.hinge("out", "ground", "driven", axis=(np.cos(b), np.sin(b), 0))
    m.point("centre", (0, 0, 0), fixed=True)
    return m


def rotor(m: fx.Model, frame: str, inertia: float) -> None:
    """Add a ball on a frame: its moment of inertia is the same about every axis."""
    m.body(f"{frame} rotor", "centre", frame, mass=1.0, inertia=(inertia,) * 3)


def driven(b: float, torque: float = 0.0) -> fx.System:
    """Build (a): the driving shaft turns at 1 rad/s, torque on the driven one; no degree of freedom is left."""
    m = joint(b)
    m.prescribe("in.angle", fx.Polynomial((0.0, 1.0)))
    m.load("out.angle", -torque)
    return m.build()


def free_run(b: float = B30, rtol: float = 1e-11) -> fx.Motion:
    """Simulate (a): two rotors turn freely; states at the times of the reference."""
    m = joint(b)
    rotor(m, "driving", data.J1)
    rotor(m, "driven", data.J2)
    m.independent("in.angle")
    m.initial("in.angle", 0.0, data.FIRST_SPEED)
    times = [0.0, *(row[0] for row in data.FREE_RUN)]
    return m.build().simulate(
        times[-1], times=times, method="DOP853", rtol=rtol, atol=rtol / 10, progress=False
    )


def elastic_shaft(b: float, speed: float, stiffness: float, damping: float = 0.0) -> fx.System:
    """Build (a) driven at a steady speed through a torsionally elastic shaft, whose twist is the degree of freedom."""
    m = joint(b, "motor shaft")
    m.spring("in.angle", stiffness, damping)
    m.prescribe("motor.angle", fx.Polynomial((0.0, speed)))
    rotor(m, "driven", 1.0)
    m.independent("in.angle")
    return m.build()


def flexible(
    b: float, speed: float, stiffness: float, damping: float = 0.0, cross: float = CROSS
) -> fx.System:
    """Build (b): pins with bending stiffness [N m/rad] and damping/stiffness [s], driving shaft at a steady speed.

    The driven rotor has 1 kg m², the cross a small share of it, for its degrees of freedom need some inertia.
    """
    m = joint(b)
    m.prescribe("in.angle", fx.Polynomial((0.0, speed)))
    rotor(m, "cross", cross)
    rotor(m, "driven", 1.0)
    for name in BENDS:
        m.spring(name, stiffness, damping * stiffness)
    m.independent(*BENDS)
    return m.build()


# -- closed forms ---------------------------------------------------------------------------------


def closed_form(angle: Array, b: float) -> tuple[Array, Array, Array]:
    """Return the angle of the driven shaft, its rate and second rate by the driving shaft's angle."""
    c, s2 = np.cos(b), np.sin(b) ** 2
    out = np.arctan2(np.sin(angle), np.cos(angle) * c)
    out = out + 2 * np.pi * np.round((angle - out) / (2 * np.pi))
    D = 1 - s2 * np.cos(angle) ** 2
    return out, c / D, -c * s2 * np.sin(2 * angle) / D**2


def closed_moments(angle: Array, b: float) -> dict[str, Array]:
    """Return, per unit of torque on the driven shaft, the driving moment and the bearing moments of both shafts."""
    ratio, s = closed_form(angle, b)[1], np.sin(b)
    tilt = s * np.abs(np.cos(angle))
    return {
        "driving": ratio,
        "driving bearing": ratio * np.tan(b) * np.abs(np.sin(angle)),
        "driven bearing": tilt / np.sqrt(1 - tilt**2),
    }


def closed_coefficients(
    b: float, speed: float, stiffness: float, damping: float, samples: int
) -> Coefficients:
    """Linearize the twist of the elastic shaft about steady rotation, driven rotor of 1 kg m²."""
    angle = 2 * np.pi * np.arange(samples) / samples
    _, r, d = closed_form(angle, b)
    dd = _second(angle, b)
    rows = r**2, 2 * r * d * speed + damping, stiffness + speed**2 * (d**2 + r * dd), -r * d * speed**2
    M, C, K, F = (np.asarray(matrix) for matrix in rows)
    grid = (slice(None), None, None)
    return Coefficients(speed, M[grid], C[grid], K[grid], F[:, None], ("in.angle",))


def _second(angle: Array, b: float) -> Array:
    """Return the second derivative of the speed ratio by the angle."""
    c, s2 = np.cos(b), np.sin(b) ** 2
    D = 1 - s2 * np.cos(angle) ** 2
    return np.asarray(-c * s2 * (2 * np.cos(2 * angle) * D - 2 * s2 * np.sin(2 * angle) ** 2) / D**3)


def mathieu_edges(eps: float) -> tuple[float, float]:
    """Return the speeds over w0 between which y'' + w0² (1 + eps cos 2 w t) y = 0 is unstable, first zone."""
    found = []
    for characteristic in (mathieu_a, mathieu_b):
        a = 1.0
        for _ in range(200):
            a = float(characteristic(1, abs(a * eps / 2)))
        found.append(a**-0.5)
    return min(found), max(found)


def mathieu(eps: float, speed: float, samples: int = 16) -> Coefficients:
    """Return Mathieu's equation with w0 = 1."""
    one = np.ones((samples, 1, 1))
    K = 1 + eps * np.cos(4 * np.pi * np.arange(samples) / samples)
    return Coefficients(speed, one, 0 * one, K[:, None, None], np.zeros((samples, 1)), ("y",))


# -- analyses -------------------------------------------------------------------------------------


def modulation(b: float) -> float:
    """Return the relative variation of the torsional stiffness of two flexible pins: of 1 - sin² b cos² (angle)."""
    half = np.sin(b) ** 2 / 2
    return float(half / (1 - half))


def pins_for_unit_frequency(b: float) -> float:
    """Return the bending stiffness of pins for a mean torsional frequency of 1 rad/s of a rotor of 1 kg m²."""
    return float(2 / (1 - np.sin(b) ** 2 / 2))


def family(system: Callable[[float], fx.System], samples: int = 32) -> SpeedFamily:
    """Return the linearized equations about steady rotation, for every speed."""
    return SpeedFamily.through([_steady(system(w), w, samples) for w in (0.5, 1.0, 2.0)])


def _steady(system: fx.System, speed: float, samples: int) -> Orbit:
    return periodic.orbit(system, 2 * np.pi / speed, samples)


def growth(c: Coefficients, tolerance: float = 1e-8) -> float:
    """Return the largest growth of a small disturbance in a turn: log of the largest Floquet multiplier's modulus."""
    return float(np.log(np.abs(c.floquet_multipliers(tolerance)[0])))


def zone_edges(
    at: Callable[[float], Coefficients], centre: float = 1.0, width: float = 0.15
) -> tuple[float, float]:
    """Find the speeds at which the instability around an unstable speed ends, by bisection."""
    edges = []
    for outside in (centre - width, centre + width):
        inside = centre
        while abs(outside - inside) > 1e-7:
            middle = (inside + outside) / 2
            if growth(at(middle)) > 2e-4:
                inside = middle
            else:
                outside = middle
        edges.append(inside)
    return edges[0], edges[1]


def flexible_edges(b: float = B30) -> tuple[float, float]:
    """Find the edges of the first zone of (b) with a massless cross: extrapolated from two that are not."""

    def edges(cross: float) -> Array:
        equations = family(lambda w: flexible(b, w, pins_for_unit_frequency(b), cross=cross))
        return np.array(zone_edges(equations.at))

    low, high = 2 * edges(CROSS) - edges(2 * CROSS)
    return float(low), float(high)


def flexible_error(stiffness: float) -> float:
    """Return the largest difference of the driven angle between (b) and (a) in steady rotation at 1 rad/s, 30°."""
    system = flexible(B30, 1.0, stiffness, damping=0.01)
    motion, _ = periodic.periodic_motion(system, 2 * np.pi, HARMONICS)
    return float(np.abs(motion["out.angle"] - closed_form(motion.t, B30)[0]).max())


@dataclass(frozen=True)
class CardanResults:
    """All computed results, for the table and for the figures."""

    turns: dict[float, fx.Motion]  # by the angle between the shafts [degrees]
    free: fx.Motion
    linear: tuple[Coefficients, Coefficients]  # computed, closed form
    errors: Array  # of (b), by stiffness
    edges: tuple[float, float]  # of (b)
    shaft_edges: tuple[float, float]
    shaft_edges_closed: tuple[float, float]
    mathieu_edges: tuple[float, float]


def analyse() -> CardanResults:
    """Run all analyses."""
    speed, stiffness, damping = 1.3, 2.0, 0.1
    system = elastic_shaft(B30, speed, stiffness, damping)
    return CardanResults(
        turns={
            angle: driven(np.radians(angle), 1.0).simulate(TURN[-1], times=TURN, progress=False)
            for angle in ANGLES
        },
        free=free_run(),
        linear=(
            _steady(system, speed, 48).coefficients,
            closed_coefficients(B30, speed, stiffness, damping, 48),
        ),
        errors=np.array([flexible_error(float(stiffness)) for stiffness in STIFFNESSES]),
        edges=flexible_edges(),
        shaft_edges=zone_edges(family(lambda w: elastic_shaft(B30, w, 1.0), 64).at, 1.0, 0.25),
        shaft_edges_closed=zone_edges(lambda w: closed_coefficients(B30, w, 1.0, 0.0, 64), 1.0, 0.25),
        mathieu_edges=zone_edges(lambda w: mathieu(data.EPS, w)),
    )


def reproduce(out: Path | None = None) -> Report:
    """Compute all quantities with their references; write figures to `out`, if given."""
    from flexel.examples.cardan_table import flexibility, motion

    results = analyse()
    files: list[Path] = []
    if out is not None:
        from flexel.examples.cardan_figures import pictures

        files = pictures(results, out)
    return Report("cardan", [*motion(results), *flexibility(results)], files)
