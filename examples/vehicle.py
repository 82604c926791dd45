"""The road vehicle of the talk: the IAVSD benchmark "Bombardier Iltis" as a finite-element model.

A rigid chassis on four independently suspended wheels: lower arm, upright with inclined kingpin, end of the transverse
leaf spring as upper link, tie rod to the rack, spring-damper unit, and a compliant tyre. One function builds a corner;
the rear is the front mirrored. 10 degrees of freedom with the rack and the wheel spins
prescribed, 8 without lateral slip.
What is done with the model is in `flexel.examples.vehicle_runs`.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

import flexel as fx
from flexel.examples import vehicle_data as data
from flexel.results.reproduction import Report

TYRES = ("calspan", "linear", "zero slip", "vertical")
UNIT_SPRING = fx.Curve([data.UNIT_SPRING])
UNIT_DAMPER = fx.Curve(data.UNIT_DAMPER, data.UNIT_DAMPER_BREAKS)
LEAF = fx.Curve(  # over the compression, which is LEAF_FREE - length
    [[0.0, data.LEAF_STIFFNESS], [
        (data.LEAF_STIFFNESS - data.LEAF_STOP_STIFFNESS) * (data.LEAF_FREE - data.LEAF_STOP), data.LEAF_STOP_STIFFNESS,
    ]],
    breaks=[data.LEAF_FREE - data.LEAF_STOP],
)  # fmt: skip
SUSPENSION = tuple(f"{corner} arm.angle" for corner in data.CORNERS)
BODY = ("chassis.x", "chassis.y", "chassis.z", "yaw.angle", "pitch.angle", "roll.angle")


def vehicle(
    speed: float = 0.0,
    *,
    tyres: str = "calspan",
    rack: Any = None,
    roads: Mapping[str, fx.Waves] | None = None,
    deflection: str = "deflection",
    spinning: bool = True,
    thrust: float = 0.0,
    driven: bool = False,
) -> fx.System:
    """Build the vehicle in its nominal position.

    Parameters
    ----------
    speed : float
        Forward speed [m/s]; the wheels turn with speed/radius throughout.
    tyres : str
        One of `TYRES`: side forces by CALSPAN or linear, no lateral slip in the mean of each axle, or none at all.
    rack : function of time, optional
        Displacement of the front rack towards +y [m].
    roads : mapping of corner to Waves, optional
        The plane z = 0 by default.
    deflection : str
        What the tyres' springs act on: ``deflection``, in the plane of the wheel, so that a leaning wheel carries its
        load next to its centre; or ``drop``, of the height of the centre, so that it carries it straight below.
    spinning : bool
        False locks all wheels.
    thrust : float
        Force on the chassis along x [N], for a steady motion against the drag of the tyres.
    driven : bool
        Prescribe the motion of the chassis along x, so that its reaction is the thrust that is needed.
    """
    if tyres not in TYRES:
        raise fx.ModelError(f"vehicle: tyres {tyres!r} are unknown; choose one of {', '.join(TYRES)}")
    m = fx.Model(gravity=(0, 0, -data.GRAVITY))
    m.point("chassis", (0, 0, data.HEIGHT))
    m.frame("road", fixed=True)
    for frame in ("yawed", "pitched", "body"):
        m.frame(frame)
    m.hinge("yaw", "road", "yawed", axis=(0, 0, 1))
    m.hinge("pitch", "yawed", "pitched", axis=(0, 1, 0))
    m.hinge("roll", "pitched", "body", axis=(1, 0, 0))
    m.angular_velocity("body")
    m.body("chassis mass", "chassis", "body", mass=data.CHASSIS["mass"], inertia=data.CHASSIS["inertia"])
    for axle in data.AXLES:
        for side in data.SIDES:
            corner(m, axle, side, rack if axle == "front" else None, (roads or {}).get(f"{axle} {side}"))
            spin = speed / data.RADIUS[axle] if spinning else 0.0
            m.prescribe(f"{axle} {side} spin.angle", fx.Polynomial((0.0, spin)))
            tyre_forces(m, axle, side, tyres, deflection)
        if tyres == "zero slip":
            left, right = ((f"{axle} {side} hub", f"{axle} {side} wheel") for side in ("left", "right"))
            m.axle_slip(f"{axle} slip", left, right, axle=(0, 1, 0))
    _dofs(m, speed, tyres == "zero slip", driven)
    if thrust:
        m.load("chassis.x", thrust)
    return m.build()


def _dofs(m: fx.Model, speed: float, rolling: bool, driven: bool) -> None:
    """Choose body and suspension; rolling without lateral slip takes two of them, a driven chassis one."""
    kinematic = ("chassis.y", "yaw.angle") if rolling else ()
    m.independent(
        *(name for name in BODY if name not in kinematic and not (driven and name == "chassis.x")),
        *SUSPENSION,
    )
    if kinematic:
        m.kinematic(*kinematic)
    if driven:
        m.prescribe("chassis.x", fx.Polynomial((0.0, speed)))
    else:
        m.initial("chassis.x", rate=speed)


def corner(m: fx.Model, axle: str, side: str, rack: Any, road: fx.Waves | None) -> None:
    """Add suspension, unit, leaf spring, wheel and tyre of one corner; names begin with ``front left`` and the like."""
    s, ahead = data.SIDES[side], 1.0 if axle == "front" else -1.0

    def named(part: str) -> str:
        return f"{axle} {side} {part}"

    for part, (x, y, z) in data.POINTS.items():
        m.point(named(part), (data.AXLES[axle] + ahead * x, s * y, z))
    _, yp, zp = data.POINTS["arm pivot"]
    _, yb, zb = data.POINTS["lower ball"]
    m.frame(named("leaf end"))
    m.frame(named("lower arm"), fx.turn((1, 0, 0), -s * float(np.arctan2(zp - zb, yb - yp))))
    m.frame(named("upright"))
    m.frame(named("wheel"))
    for part in ("link pivot", "arm pivot", "unit top"):
        m.body_point(named(f"{part} seat"), "chassis", "body", named(part))
    in_chassis(m, named("rack"), named("rack end"))
    if rack is not None:
        m.prescribe(named("rack.across1"), rack)
    up = (s, 0, 0)  # hinge angles grow as the wheel goes up
    m.hinge(named("link"), "body", named("leaf end"), axis=up)
    m.hinge(named("arm"), "body", named("lower arm"), axis=up)
    m.body_point(named("upper link"), named("link pivot"), named("leaf end"), named("upper ball"))
    m.body_point(named("arm ball"), named("arm pivot"), named("lower arm"), named("lower ball"))
    m.body_point(named("arm unit"), named("arm pivot"), named("lower arm"), named("unit foot"))
    for part in ("upper ball", "tie rod end", "hub"):
        m.body_point(named(f"upright {part}"), named("lower ball"), named("upright"), named(part))
    m.truss(named("tie rod"), named("rack end"), named("tie rod end"))
    m.hinge(named("spin"), named("upright"), named("wheel"), axis=(0, 1, 0))
    offset = (0, -s * data.ARM_CENTRE, 0)
    m.body(named("arm mass"), named("lower ball"), named("lower arm"), offset=offset, **data.ARM)
    m.body(named("wheel mass"), named("hub"), named("wheel"), **data.WHEEL)
    m.truss(named("unit"), named("unit top"), named("unit foot"))
    m.spring(
        named("unit.elongation"), UNIT_SPRING, UNIT_DAMPER, free_length=0.0
    )  # curve of the length itself
    in_chassis(m, named("leaf"), named("upper ball"))
    m.release(named("leaf.along"), named("leaf.across1"))
    m.spring(named("leaf.across2"), LEAF, free_length=data.LEAF_LENGTH - data.LEAF_FREE)
    hub, wheel = named("hub"), named("wheel")
    m.tyre(named("tyre"), hub, wheel, radius=data.RADIUS[axle], axle=(0, 1, 0), road=road)


def in_chassis(m: fx.Model, name: str, point: str) -> None:
    """Add a link whose deformations are the displacements of a point along the chassis' x, y and z axes."""
    d0 = m.nodes[point].x0 - m.nodes["chassis"].x0
    none = np.zeros(3)
    values = {"tp": np.eye(4)[0], "d0": d0, "l0": np.linalg.norm(d0), "rhoA": 0.0, "rhoJ": none}
    m.element(name, "beam3", "chassis", "body", point, **values)


def tyre_forces(m: fx.Model, axle: str, side: str, tyres: str, deflection: str) -> None:
    """Add the law of a tyre: its spring, and side forces where there are any."""
    tyre = f"{axle} {side} tyre"
    spring: dict[str, Any] = {"stiffness": data.TYRE_STIFFNESS, "damping": 0.0}
    if tyres in ("zero slip", "vertical"):
        m.attach("vertical_tyre", [f"{tyre}.{deflection}"], **spring)
        return
    parts = (deflection, "camber", "forward", "sideways", "lateral", "spin")
    values: Mapping[str, Any] = data.CALSPAN if tyres == "calspan" else data.LINEAR[axle]
    on = [f"{tyre}.{part}" for part in parts]
    m.attach(f"{tyres}_tyre", on, standstill=data.STANDSTILL, **spring, **values)


def reproduce(out: Path | None = None) -> Report:
    """Compute all quantities with their references; write figures and an animation to `out`, if given."""
    from flexel.examples import vehicle_runs, vehicle_table

    results = vehicle_runs.analyse()
    files: list[Path] = []
    if out is not None:
        from flexel.examples.vehicle_figures import pictures

        files = pictures(results, out)
    return Report("vehicle", vehicle_table.quantities(results), files)
