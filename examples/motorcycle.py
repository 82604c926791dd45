"""A motorcycle from the parts of the road vehicle and the bicycle: nothing in them is specific to one vehicle.

Rear frame with rider, swinging arm, telescopic fork on an inclined steering axis, two wheels with compliant
toroidal tyres (crown radius, Magic Formula with relaxation). The data are not those of a real machine, but
typical in size. Weave, wobble and capsize are followed over the speed. x forward, y left, z up, origin on the
road below the rear hub.
"""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.quaternions import in_frame, matrix, triad
from flexel.examples import bicycle
from flexel.examples.bicycle_data import BENCHMARK, EIGENVALUES, EXACT
from flexel.examples.differences import mismatch
from flexel.examples.reasons import ROUNDING
from flexel.results.linearization import Linearization
from flexel.results.reproduction import Quantity, Report

GRAVITY = 9.81
WHEELBASE, RAKE, TRAIL, HEAD_HEIGHT = 1.45, 0.47, 0.11, 0.9
RADIUS, CROWN = {"rear": 0.31, "front": 0.30}, {"rear": 0.09, "front": 0.06}
SINK = 0.007  # of the hubs as drawn, so that the tyres are pressed
PIVOT = (0.50, 0.0, 0.42)  # of the swinging arm
FRAME: dict[str, Any] = {"mass": 240.0, "inertia": (28.0, 40.0, 24.0, 0.0, 2.0, 0.0)}  # with rider
FRAME_CENTRE = (0.62, 0.0, 0.62)
FORK: dict[str, Any] = {"mass": 12.0, "inertia": (0.9, 0.8, 0.25)}
FORK_CENTRE = (1.26, 0.0, 0.66)
WHEELS: dict[str, dict[str, Any]] = {
    "rear": {"mass": 18.0, "inertia": (0.55, 0.95, 0.55)},
    "front": {"mass": 14.0, "inertia": (0.35, 0.62, 0.35)},
}
FORK_SPRING, SWING_SPRING = (9000.0, 550.0, 1000.0), (9000.0, 700.0, 690.0)  # stiffness, damping, preload
STEERING_DAMPER = 6.8
TYRES: dict[str, dict[str, Any]] = {
    axle: {
        "stiffness": 180e3, "damping": 250.0, "load0": load, "rolling_radius": RADIUS[axle] - 0.004,
        "friction": (1.2, -0.1), "slip_stiffness": 15.0, "cornering": (stiffness, 2.0), "camber_stiffness": 0.8,
        "shape": (1.5, -0.5), "trail": (0.02, 5.0), "relaxation": (0.12, 0.22),
    }
    for axle, load, stiffness in (("rear", 1500.0, 12.0), ("front", 1300.0, 11.0))
}  # fmt: skip
SPEEDS = tuple(float(v) for v in np.arange(5.0, 60.1, 2.5))
LATERAL = ("lean.angle", "steer.angle", "yaw.angle", "frame.y")
PLANE = ("frame.z", "pitch.angle", "fork.along", "swing.angle")


def motorcycle(speed: float = 0.0, crown: float = 1.0) -> fx.System:
    """Build the motorcycle upright; `crown` scales the radii of the tyres' cross sections (0: thin discs)."""
    m = fx.Model(gravity=(0, 0, -GRAVITY))
    axis = np.array([np.sin(RAKE), 0.0, -np.cos(RAKE)])  # of steering, downwards
    head = np.array([WHEELBASE + TRAIL - HEAD_HEIGHT * np.tan(RAKE), 0.0, HEAD_HEIGHT])
    m.frame("road", fixed=True)
    for name in ("yawed", "leaned", "body", "front body", "arm", "rear wheel", "front wheel"):
        m.frame(name)
    m.point("frame", FRAME_CENTRE)
    m.point("head", head)
    m.point("pivot", PIVOT)
    m.point("rear hub", (0, 0, RADIUS["rear"] - SINK))
    m.point("front hub", (WHEELBASE, 0, RADIUS["front"] - SINK))
    m.hinge("yaw", "road", "yawed", axis=(0, 0, 1))
    m.hinge("lean", "yawed", "leaned", axis=(1, 0, 0))
    m.hinge("pitch", "leaned", "body", axis=(0, 1, 0))
    m.hinge("steer", "body", "front body", axis=axis)
    m.hinge("swing", "body", "arm", axis=(0, 1, 0))
    m.body_point("steering head", "frame", "body", "head")
    m.body_point("swing pivot", "frame", "body", "pivot")
    m.body_point("swinging arm", "pivot", "arm", "rear hub")
    telescope(m, "fork", "head", "front body", "front hub", axis)
    for axle, frame in (("rear", "arm"), ("front", "front body")):
        hub, wheel = f"{axle} hub", f"{axle} wheel"
        m.hinge(f"{axle} spin", frame, wheel, axis=(0, 1, 0))
        m.body(f"{axle} wheel body", hub, wheel, **WHEELS[axle])
        tyre: dict[str, Any] = {"radius": RADIUS[axle], "axle": (0, 1, 0), "crown": crown * CROWN[axle]}
        m.tyre(f"{axle} tyre", hub, wheel, **tyre, law="magic_formula", **TYRES[axle])
    m.body("rear frame", "frame", "body", **FRAME)
    m.body("front frame", "head", "front body", offset=np.array(FORK_CENTRE) - head, **FORK)
    k, c, preload = FORK_SPRING
    m.spring("fork.along", k, c, preload=-preload)
    k, c, preload = SWING_SPRING
    m.spring("swing.angle", k, c, preload=preload)
    m.spring("steer.angle", damping=STEERING_DAMPER)
    m.independent("frame.x", *LATERAL, *PLANE, "rear spin.angle", "front spin.angle")
    m.initial("frame.x", rate=speed)
    for axle in RADIUS:
        m.initial(f"{axle} spin.angle", rate=speed / TYRES[axle]["rolling_radius"])
    return m.build()


def telescope(m: fx.Model, name: str, p: str, frame: str, q: str, axis: Array) -> None:
    """Add a sliding joint: the point q moves in the body (p, frame) along an axis only; the stroke is ``along``."""
    t = triad(axis, None, name)
    d0 = matrix(t).T @ (m.nodes[q].x0 - m.nodes[p].x0)
    values = {"tp": in_frame(m.nodes[frame].x0, t), "d0": d0, "l0": np.linalg.norm(d0)}
    m.element(name, "beam3", p, frame, q, **values, rhoA=0.0, rhoJ=np.zeros(3))


def straight(system: fx.System, speed: float) -> fx.State:
    """Compute steady straight running: springs and tyres take the weight, the wheels roll without slip."""
    rates = dict.fromkeys(system.dynamic, 0.0) | {"frame.x": speed}
    rates |= {f"{axle} spin.angle": speed / tyre["rolling_radius"] for axle, tyre in TYRES.items()}
    return system.steady(system.state_at(rates=rates), unknown=PLANE)


def lateral_modes(lin: Linearization) -> dict[str, fx.Mode]:
    """Select weave, wobble and capsize among the modes that lean, steer and yaw.

    Wobble is the fastest oscillation, weave the least damped of the clearly slower ones, capsize the least stable
    motion that does not oscillate.
    """
    modes = [
        mode
        for mode in lin.modes()
        if sum(mode.participation[name] for name in LATERAL) > 0.5 and mode.omega > 1e-3
    ]
    swinging = [mode for mode in modes if mode.eigenvalue.imag > 1.0]
    wobble = max(swinging, key=lambda mode: mode.eigenvalue.imag)
    found = {"wobble": wobble}
    slower = [mode for mode in swinging if mode.eigenvalue.imag < 0.7 * wobble.eigenvalue.imag]
    if slower:
        found["weave"] = max(slower, key=lambda mode: mode.eigenvalue.real)
    creeping = [mode for mode in modes if abs(mode.eigenvalue.imag) < 1e-6]
    if creeping:
        found["capsize"] = max(creeping, key=lambda mode: mode.eigenvalue.real)
    return found


def loci(speeds: tuple[float, ...] = SPEEDS, crown: float = 1.0) -> list[dict[str, fx.Mode]]:
    """Compute the lateral modes at each speed, linearized again about steady running."""
    system = motorcycle(crown=crown)
    return [lateral_modes(system.linearize(straight(system, v))) for v in speeds]


def unstable_range(found: list[dict[str, fx.Mode]], name: str) -> list[float]:
    """Return the speeds [m/s] between which a mode grows, by its real part over `SPEEDS`; empty if it never does."""
    points = [
        (v, modes[name].eigenvalue.real) for v, modes in zip(SPEEDS, found, strict=True) if name in modes
    ]
    growing = [v for v, real in points if real > 0]
    crossings = [v0 - a * (v1 - v0) / (b - a) for (v0, a), (v1, b) in pairwise(points) if a * b < 0]
    ends = [v for v in (points[0][0], points[-1][0]) if v in growing]
    return sorted(crossings + ends)


def reproduce(out: Path | None = None) -> Report:
    """Compare modes over the speed with toroidal and thin tyres, what confirms the tyres, and the linearization."""
    system = motorcycle()
    found = {"toroidal": loci(), "thin": loci(crown=0.0)}
    error = mismatch(system, straight(system, 30.0))
    counted = "six of the frame, steering, fork, swinging arm, spins"
    rows = [
        Quantity(
            "degrees_of_freedom", system.counts["degrees_of_freedom"], 11, 0, "", counted, kind="closed form"
        ),
        Quantity(
            "linearization_error",
            error,
            0.0,
            1e-11,
            "",
            "differences of the nonlinear equations",
            kind="own",
            reason=ROUNDING,
        ),
        *confirmations(),
    ]
    for tyres, modes in found.items():
        for name in ("weave", "wobble", "capsize"):
            table = [[v, at_speed[name].eigenvalue.real, at_speed[name].eigenvalue.imag]
                     for v, at_speed in zip(SPEEDS, modes, strict=True) if name in at_speed]  # fmt: skip
            rows.append(Quantity(f"{name}_{tyres}", table, source="rows of speed, real, imaginary part"))
            grows = unstable_range(modes, name)
            said = f"speeds between which it grows, of {SPEEDS[0]:g} ... {SPEEDS[-1]:g} m/s"
            if grows:
                rows.append(Quantity(f"{name}_{tyres}_unstable", grows, unit="m/s", source=said))
            else:
                least = max(table, key=lambda row: row[1])[:2]
                said = (
                    "dies out at every speed; where it does so slowest [m/s], and its real part there [1/s]"
                )
                rows.append(Quantity(f"{name}_{tyres}_least_damped", least, source=said))
    files = [] if out is None else [picture(found, out)]
    return Report("motorcycle", rows, files)


# -- confirmations --------------------------------------------------------------------------------


def bicycle_on_tyres(speed: float, crown: float, stiffness: float) -> Array:
    """Compute the eigenvalues of the benchmark's bicycle on Magic Formula tyres that are stiff in every direction."""
    p = BENCHMARK
    m = fx.Model(gravity=(0, 0, p["g"]))
    bicycle.mechanism(m, p)
    radii = {"rear": p["rR"], "front": p["rF"]}
    law: dict[str, Any] = {
        "stiffness": stiffness, "damping": 0.0, "load0": 500.0, "friction": (1.0, 0.0),
        "slip_stiffness": stiffness / 500, "cornering": (stiffness / 500, 1.0), "camber_stiffness": 0.0,
        "shape": (1.4, 0.0), "trail": (0.0, 1.0), "relaxation": (1e4 / stiffness, 1e4 / stiffness),
    }  # fmt: skip
    for axle, radius in radii.items():
        tyre: dict[str, Any] = dict(radius=radius, axle=(0, -1, 0), normal=(0, 0, -1), crown=crown)
        tyre |= {"law": "magic_formula", "rolling_radius": radius}
        m.tyre(f"{axle} tyre", f"{axle} hub", f"{axle} wheel", **tyre, **law)
    place = ("rear hub.x", "rear hub.y", "rear hub.z", "yaw.angle", "lean.angle", "pitch.angle")
    m.independent(*place, "steer.angle", "rear spin.angle", "front spin.angle")
    system = m.build()
    rates = dict.fromkeys(system.dynamic, 0.0) | {"rear hub.x": speed}
    rates |= {f"{axle} spin.angle": -speed / radius for axle, radius in radii.items()}
    pressed = system.state_at({"rear hub.z": 500.0 / stiffness - p["rR"]}, rates)
    lin = system.linearize(system.steady(pressed, unknown=("rear hub.z", "pitch.angle")))
    return np.asarray(lin.eigenvalues())


def rigid_bicycle(speed: float, crown: float) -> Array:
    """Compute lean and steer eigenvalues of the benchmark's bicycle on rigid toroidal wheels."""
    return np.asarray(bicycle.lean_steer(bicycle.bicycle(crown=crown), speed).eigenvalues())


def nearest(found: Array, wanted: Array) -> Array:
    """Return the the eigenvalue nearest to each of those wanted."""
    return np.array([found[np.argmin(np.abs(found - eigenvalue))] for eigenvalue in wanted])


def confirmations() -> list[Quantity]:
    """Compare tyres with and without a crown on the benchmark's bicycle, at 5 m/s."""
    published = np.array(EIGENVALUES[5])
    rounded = rigid_bicycle(5.0, 0.05)
    stiff = "stiff Magic Formula tyres, error as one over the stiffness (1e8 N/m)"
    return [
        Quantity("bicycle_toroidal_zero_crown", rigid_bicycle(5.0, 1e-10), published, 3e-8, "1/s",
                 EXACT, kind="own", reason="the crown is 1e-10 m, not 0; some entries are small"),
        Quantity("bicycle_on_tyres_zero_crown", nearest(bicycle_on_tyres(5.0, 0.0, 1e8), published),
                 published, 6e-5, "1/s", f"{EXACT}; {stiff}", kind="own"),
        Quantity("bicycle_on_tyres_crown_50mm", nearest(bicycle_on_tyres(5.0, 0.05, 1e8), rounded),
                 rounded, 4e-5, "1/s", f"rigid toroidal wheels; {stiff}", kind="own"),
    ]  # fmt: skip


def picture(found: dict[str, list[dict[str, fx.Mode]]], out: Path) -> Path:
    """Plot real and imaginary parts of the lateral modes over the speed."""
    from scipy.interpolate import CubicSpline

    from flexel.apps.view.figures import COLOURS, GUIDE, figure, save

    out.mkdir(parents=True, exist_ok=True)
    path = out / "motorcycle_modes.png"
    with figure(2, size=(8.0, 6.4), sharex=True) as (drawn, axes):
        for style, (tyres, modes) in zip(("-", "--"), found.items(), strict=True):
            for colour, name in zip(COLOURS, ("weave", "wobble", "capsize"), strict=False):
                points = np.array([[v, at_speed[name].eigenvalue.real, at_speed[name].eigenvalue.imag / (2 * np.pi)]
                                   for v, at_speed in zip(SPEEDS, modes, strict=True) if name in at_speed])  # fmt: skip
                fine = np.linspace(points[0, 0], points[-1, 0], 300)
                for panel, values in zip(axes, CubicSpline(points[:, 0], points[:, 1:])(fine).T, strict=True):
                    panel.plot(fine, values, style, color=colour, label=f"{name}, {tyres} tyres")
        axes[0].axhline(0, **GUIDE)
        axes[0].set(ylabel="real part [1/s]", title="Lateral modes of a motorcycle over its speed")
        axes[1].set_ylabel("frequency [Hz]")
        axes[1].set_xlabel("speed [m/s]")
        axes[0].legend(fontsize=8)
        save(drawn, path)
    return path
