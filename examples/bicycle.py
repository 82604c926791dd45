"""The uncontrolled bicycle: rigid rider, hands off, knife-edge wheels that roll without slip.

The model of the SPACAR talk (2 wheels, 2 beams, 6 hinges; 3 degrees of freedom, 4 kinematic coordinates) with the
parameters of the 2007 benchmark.  Axes are the benchmark's: x forward, y right, z down, origin at the rear contact.
`reproduce` compares the linear equations, their eigenvalues, the stable range of speeds and one nonlinear motion
with published numbers, and lets the bicycle roll on after a kick from the side.
The pictures are in `flexel.examples.bicycle_figures`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.quaternions import matrix
from flexel.examples import bicycle_data as data
from flexel.examples import whipple
from flexel.examples.bicycle_file import of_the_file
from flexel.examples.reasons import ROUNDING, STEPS
from flexel.examples.stable_speeds import LEAN_STEER, by_formulas, stable_speeds
from flexel.integration.step_method import natural_scales_of_y
from flexel.mechanics.modes import Reduced
from flexel.results.reproduction import Quantity, Report

SPEEDS = range(11)  # of the eigenvalue table [m/s]
KICK_SPEEDS = (3.5, 4.5, 6.3)  # of the talk: below, within and above the stable range [m/s]
KICK_SECONDS = 10.0
HEAD_HEIGHT = 0.9  # where the two beams meet on the steering axis [m]; any other point of the axis would do


def bicycle(p: Mapping[str, float] = data.BENCHMARK, crown: float = 0.0) -> fx.System:
    """Build the bicycle upright at the origin; parameters as for `model`."""
    return model(p, crown).build()


def model(p: Mapping[str, float] = data.BENCHMARK, crown: float = 0.0) -> fx.Model:
    """Return the model of the bicycle upright at the origin.

    Parameters
    ----------
    p : mapping
        The 25 parameters of the benchmark, by their symbols.
    crown : float
        Radius of the cross sections of both tyres [m]; the benchmark has knife edges, zero.
    """
    m = fx.Model(gravity=(0, 0, p["g"]))
    mechanism(m, p)
    m.point("rear contact", (0, 0, 0))
    m.point("front contact", (p["w"], 0, 0))
    for wheel, radius in (("rear", p["rR"]), ("front", p["rF"])):
        nodes = f"{wheel} hub", f"{wheel} wheel", f"{wheel} contact"
        m.wheel(wheel, *nodes, radius=radius, axle=(0, 1, 0), normal=(0, 0, -1), crown=crown)
    m.independent("lean.angle", "steer.angle", "rear spin.angle")
    m.kinematic("rear contact.x", "rear contact.y", "yaw.angle", "front spin.angle")
    return m


def mechanism(m: fx.Model, p: Mapping[str, float]) -> None:
    """Put frames, hinges, beams and bodies into a model: all but what touches the road."""
    axis = np.array([np.sin(p["lam"]), 0, np.cos(p["lam"])])  # of steering, downwards
    head = np.array([p["w"] + p["c"], 0, 0]) - axis * HEAD_HEIGHT / axis[2]
    m.point("rear hub", (0, 0, -p["rR"]))
    m.point("front hub", (p["w"], 0, -p["rF"]))
    m.point("head", head)
    m.frame("ground", fixed=True)
    for name in ("yawed", "leaned", "rear frame", "front frame", "rear wheel", "front wheel"):
        m.frame(name)
    m.hinge("yaw", "ground", "yawed", axis=(0, 0, 1))
    m.hinge("lean", "yawed", "leaned", axis=(1, 0, 0))
    m.hinge("pitch", "leaned", "rear frame", axis=(0, 1, 0))
    m.hinge("steer", "rear frame", "front frame", axis=axis)
    m.hinge("rear spin", "rear frame", "rear wheel", axis=(0, 1, 0))
    m.hinge("front spin", "front frame", "front wheel", axis=(0, 1, 0))
    m.beam("frame", "rear hub", "rear frame", "head")
    m.beam("fork", "head", "front frame", "front hub")
    _bodies(m, p, head)


def _bodies(m: fx.Model, p: Mapping[str, float], head: Array) -> None:
    """Add the the four bodies; mass centres of B and H relative to the points that carry them."""
    B = (p["IBxx"], p["IByy"], p["IBzz"], 0, p["IBxz"], 0)
    H = (p["IHxx"], p["IHyy"], p["IHzz"], 0, p["IHxz"], 0)
    R, F = (p["IRxx"], p["IRyy"], p["IRxx"]), (p["IFxx"], p["IFyy"], p["IFxx"])
    rear_offset, front_offset = (p["xB"], 0, p["zB"] + p["rR"]), np.array([p["xH"], 0, p["zH"]]) - head
    m.body("frame and rider", "rear hub", "rear frame", mass=p["mB"], inertia=B, offset=rear_offset)
    m.body("handlebar and fork", "head", "front frame", mass=p["mH"], inertia=H, offset=front_offset)
    m.body("rear wheel body", "rear hub", "rear wheel", mass=p["mR"], inertia=R)
    m.body("front wheel body", "front hub", "front wheel", mass=p["mF"], inertia=F)


# -- analyses -------------------------------------------------------------------------------------


def rolling(system: fx.System, speed: float, roll_rate: float = 0.0) -> fx.State:
    """Return the upright state straight ahead at a speed [m/s], with a roll rate [rad/s] about the ground line."""
    # the rates of all degrees of freedom: no other rates have to be chosen
    spin = -speed / system.parameters["rear.radius"].item()
    return system.state_at(rates={"lean.angle": roll_rate, "steer.angle": 0.0, "rear spin.angle": spin})


def steady(system: fx.System, speed: float, lean: float = 0.0, steer: float = 0.0) -> fx.State:
    """Find the steady motion at a speed, starting from a leaning and steered state (upright merely confirms it)."""
    start = rolling(system, speed)
    if lean or steer:
        start = system.state_at({"lean.angle": lean, "steer.angle": steer}, start=start)
    return system.steady(start)


def lean_steer(system: fx.System, speed: float) -> Reduced:
    """Linearize lean and steer about the steady motion, after a check that nothing else enters the equations."""
    return system.linearize(steady(system, speed)).reduced(LEAN_STEER)


def matrices(system: fx.System, gravity: float) -> dict[str, Array]:
    """Return M, C1, K0, K2 of M q'' + v C1 q' + (g K0 + v² K2) q = 0, from linearizations at 1 and 2 m/s."""
    one, two = lean_steer(system, 1.0), lean_steer(system, 2.0)
    K2 = (two.K - one.K) / 3
    return {"M": one.M, "C1": two.C / 2, "K0": (one.K - K2) / gravity, "K2": K2}


def eigenvalues(system: fx.System, speeds: Array) -> Array:
    """Compute the eigenvalues (nv, 4) [1/s] of the lean-steer block, linearized again at each speed."""
    return np.array([lean_steer(system, float(v)).eigenvalues() for v in speeds])


def stable_range(system: fx.System, fastest: float = 12.0) -> tuple[float, float | None]:
    """Weave speed and capsize speed [m/s], see `stable_speeds`."""
    return stable_speeds(lambda v: lean_steer(system, v), fastest)


def kick(system: fx.System, speed: float, seconds: float = KICK_SECONDS, rtol: float = 1e-10) -> fx.Motion:
    """Simulate a kick from the side: rolling upright with a roll rate of 0.05 rad/s."""
    start = rolling(system, speed, data.ROLL_RATE)
    times = np.linspace(0.0, seconds, round(40 * seconds) + 1)
    atol = rtol / 100 / natural_scales_of_y(system.kinematics)  # the same for metres and radians
    return system.simulate(
        seconds, start=start, times=times, method="DOP853", rtol=rtol, atol=atol, rechoose=False
    )


def energy_drift(motion: fx.Motion) -> float:
    """Return the largest |E - E0| / E0, with no potential energy at ground level."""
    E = motion.energy["total"]
    return float(np.max(np.abs(E - E[0])) / abs(E[0]))


def forward_speed(state: fx.State) -> float:
    """Return the velocity of the rear hub along the rear frame's x axis [m/s]."""
    return float(matrix(state.position("rear frame"))[:, 0] @ state.velocity("rear hub"))


def manoeuvre_m1(motion: fx.Motion) -> Array:
    """Return the columns `data.M1_COLUMNS` (17, 8) of manoeuvre M1 at the times of the reference."""
    states = [motion.at(row[0]) for row in data.M1]
    names = data.M1_COLUMNS[1:]
    return np.array(
        [[state.t, *(state.rate(n[:-1]) if n.endswith("'") else state[n] for n in names)] for state in states]
    )


@dataclass(frozen=True)
class BicycleResults:
    """All computed results, for the table and for the figures."""

    system: fx.System
    matrices: dict[str, Array]
    eigenvalues: Array
    range: tuple[float, float | None]
    points: tuple[float, float | None]
    measured: dict[str, tuple[float, float | None]]
    steady: list[fx.State]
    m1: fx.Motion
    kicks: dict[float, fx.Motion]


def analyse() -> BicycleResults:
    """Run all analyses."""
    system = bicycle()
    return BicycleResults(
        system=system,
        matrices=matrices(system, data.BENCHMARK["g"]),
        eigenvalues=eigenvalues(system, np.array(SPEEDS, dtype=float)),
        range=stable_range(system),
        points=stable_range(bicycle(data.POINTS)),
        measured={name: stable_range(bicycle(p)) for name, p in data.MEASURED.items()},
        steady=[steady(system, float(v), lean=0.005, steer=-0.005) for v in SPEEDS],
        m1=kick(system, data.M1_SPEED, 5.0, rtol=1e-12),
        kicks={v: kick(system, v) for v in KICK_SPEEDS},
    )


# -- the table ------------------------------------------------------------------------------------


def reproduce(out: Path | None = None) -> Report:
    """Compute all quantities with their references; write figures and an animation to `out`, if given."""
    results = analyse()
    files: list[Path] = []
    if out is not None:
        from flexel.examples.bicycle_figures import pictures

        files = pictures(results, out)
    return Report(
        "bicycle",
        [*counts(results), *linear(results), *of_the_file(), *manoeuvre(results), *kicks(results)],
        files,
    )


def counts(results: BicycleResults) -> list[Quantity]:
    """Compare the size of the model."""
    found = results.system.counts
    return [
        Quantity("degrees_of_freedom", found["degrees_of_freedom"], 3, 0, "", data.TALK, kind="published"),
        Quantity(
            "kinematic_coordinates", found["kinematic_coordinates"], 4, 0, "", data.TALK, kind="published"
        ),
        Quantity("coordinates", found["coordinates"]),
        Quantity("deformations", found["deformations"], source="Euler-parameter norms not counted"),
    ]


def linear(results: BicycleResults) -> list[Quantity]:
    """Compare steady motion, linear equations, eigenvalues, stable ranges."""
    published = {"M": data.M, "C1": data.C1, "K0": data.K0, "K2": data.K2}
    units = {"M": "kg m2", "C1": "kg m", "K0": "kg m", "K2": "kg"}
    angles = [[state[name] for name in LEAN_STEER] for state in results.steady]
    residual = max(
        abs(state.acceleration(name)) for state in results.steady for name in results.system.dynamic
    )
    weave, capsize = results.range
    formulas = by_formulas(whipple.matrices(data.POINTS), data.POINTS["g"])
    points, by_formula = (np.array(pair, dtype=float) for pair in (results.points, stable_speeds(formulas)))
    speeds = {name: pair for name, pair in results.measured.items() if pair[1] is not None}
    found = np.array(list(speeds.values()), dtype=float)
    expected = np.array([list(data.MEASURED_SPEEDS[name].values()) for name in speeds], dtype=float)
    return [
        Quantity("steady_lean_steer", angles, np.zeros((len(angles), 2)), 1e-11, "rad",
                 "0 by symmetry, found from a leaning bicycle, v = 0 ... 10 m/s", kind="closed form", reason=ROUNDING),
        Quantity("steady_residual", residual, 0.0, 3e-10, "rad/s2", "0; largest acceleration of the motions found",
                 kind="closed form", reason=ROUNDING),
        *(Quantity(k, results.matrices[k], expected, 2e-12, units[k], data.PAPER, kind="published",
                   tolerance_kind="absolute") for k, expected in published.items()),
        Quantity("eigenvalues", results.eigenvalues, data.EIGENVALUES, 1e-11, "1/s", data.EXACT,
                 kind="own", reason=f"{ROUNDING}; some entries are small"),
        Quantity("weave_speed", weave, data.WEAVE_SPEED, 1e-12, "m/s", data.PAPER, kind="published"),
        Quantity("capsize_speed", np.nan if capsize is None else capsize, data.CAPSIZE_SPEED, 1e-12, "m/s", data.PAPER,
                 kind="published"),
        Quantity("point_masses_weave_and_capsize", points, by_formula, 1e-12, "m/s",
                 f"both frames as point masses; formulas of {data.PAPER}, appendix A", kind="closed form"),
        Quantity("measured_bicycles_weave_and_capsize", found, expected, 3e-10, "m/s",
                 data.MEASURED_SOURCE, {"bicycles": list(speeds)}, kind="other program"),
    ]  # fmt: skip


def manoeuvre(results: BicycleResults) -> list[Quantity]:
    """Compare manoeuvre M1 with its reference trajectory, row by row, and at 5 s."""
    found, reference, end = manoeuvre_m1(results.m1), np.array(data.M1), results.m1[-1]
    units = ("s", "rad", "rad", "rad", "rad/s", "rad/s", "m", "m")
    accurate: Any = {"kind": "own", "reason": f"{STEPS}, at 1e-12"}
    return [
        Quantity("M1_steer_5s", end["steer.angle"], data.M1_STEER_5S, 1e-9, "rad", data.MANOEUVRE, **accurate),
        Quantity("M1_forward_speed_5s", forward_speed(end), data.M1_FORWARD_SPEED_5S, 1e-11, "m/s",
                 data.MANOEUVRE, **accurate),
        Quantity("M1_energy", end.energy.total, data.M1_ENERGY, 1e-12, "J", data.MANOEUVRE, kind="own"),
        Quantity("M1_energy_drift", energy_drift(results.m1), 0.0, 1e-12, "", "0, conservative; over the energy",
                 kind="closed form", reason=f"{STEPS}, at 1e-12"),
        *(
            Quantity(f"M1 {name}", found[:, i], reference[:, i], 1e-10 if "steer" in name else 1e-11, units[i],
                     data.MANOEUVRE, tolerance_kind="absolute", **accurate)
            for i, name in enumerate(data.M1_COLUMNS)
            if i > 0
        ),
    ]  # fmt: skip


def kicks(results: BicycleResults) -> list[Quantity]:
    """Compare the three kicks of the talk: lean after 2 s (no published number), drift of energy and constraints."""
    rows = []
    for v, motion in results.kicks.items():
        rows.append(Quantity(f"kick_{v}", motion.at(2.0)["lean.angle"], unit="rad", source="lean at t = 2 s"))
        drift, violation = energy_drift(motion), float(np.max(motion.drift))
        rows += [
            Quantity(f"kick_{v}_energy_drift", drift, 0.0, 1e-10, "", "0, conservative; over the energy",
                     kind="closed form", reason=f"{STEPS}, at 1e-10"),
            Quantity(f"kick_{v}_constraint_drift", violation, 0.0, 1e-12, "", "0, rigid bodies and road",
                     kind="closed form"),
        ]  # fmt: skip
    return rows
