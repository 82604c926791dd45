"""Published and recomputed numbers of the road vehicle: the IAVSD benchmark "Bombardier Iltis", from `examples/data`.

Lengths in m above the road with the chassis at its nominal height; x forward, y left, z up, origin below the mass
centre of the chassis. Corners are named by what they physically are: y < 0 is right.
"""

from __future__ import annotations

from typing import Any

from flexel.examples.published import published

TALK = (
    "Schwab, talk on SPACAR: 85 elements, 239 deformations, 70 nodes, 226 coordinates, 10 degrees of freedom"
)
TALK_COUNTS = {"elements": 85, "deformations": 239, "nodes": 70, "coordinates": 226, "degrees_of_freedom": 10}
# 70 nodes with 226 coordinates: three coordinates of a point, four Euler parameters of a frame.
TALK_NODES = {kind: f"the talk's model can only have {n}" for kind, n in (("point", 54), ("frame", 16))}
PAPER = "Frik, Leister, Schwartz (1993) VSD 22 suppl. 215-253, as quoted in ovankerm/IAVSD_ILTIS"
RERUN = "another program's run, not published (Robotran, ovankerm/IAVSD_ILTIS 81cd42c)"
RECOMPUTED = (
    "stationary energy, by a separate script; agrees with Robotran's digits (the pitch is Robotran's)"
)
INDICATIVE = "independent symmetric model with 4 coordinates, indicative"

_TABLES = published("iltis")
_BODIES, _FORCES = _TABLES["bodies"], _TABLES["forces"]
_UNIT, _TYRE = _FORCES["damper_unit"], _FORCES["tyre_vertical"]
_COEFFICIENTS = _FORCES["tyre_horizontal_calspan"]["coefficients"]
_REST = _TABLES["static_equilibrium"]["independent_check_this_extraction"]


def _body(name: str, inertia: str = "inertia_diag") -> dict[str, Any]:
    return {"mass": float(_BODIES[name]["mass"]), "inertia": tuple(_BODIES[name][inertia])}


GRAVITY = 9.81
HEIGHT = 0.57  # of the chassis' mass centre
AXLES: dict[str, float] = _TABLES["axle_x"]
SIDES = {"right": -1.0, "left": 1.0}
CORNERS = tuple(f"{axle} {side}" for axle in AXLES for side in SIDES)

# (x from the axle towards its rack negative in front, |y|, z) of one corner; the rear is mirrored about its axle.
POINTS = {
    "link pivot": (0.0, 0.1585, 0.6),
    "upper ball": (0.0, 0.488, 0.531),
    "arm pivot": (0.0, 0.259, 0.302),
    "lower ball": (0.0, 0.572, 0.229),
    "unit top": (0.075, 0.297, 0.632),
    "unit foot": (0.075, 0.5, 0.241),
    "rack end": (-0.14, 0.07, 0.6),
    "tie rod end": (-0.14, 0.448, 0.531),
    "hub": (0.0, 0.615, 0.356),
}

CHASSIS = _body("chassis")
ARM = _body("lower_arm", "inertia_diag_about_com")
ARM_CENTRE: float = _BODIES["lower_arm"]["com"][1]  # from the lower ball along the arm
WHEEL = _body("wheel_assembly")

RADIUS: dict[str, float] = _TYRE["unloaded_radius"]  # of the unloaded tyre
TYRE_STIFFNESS: float = _TYRE["stiffness"]
_LEAF = _FORCES["leaf_spring"]
LEAF_STIFFNESS, LEAF_STOP_STIFFNESS = (float(_LEAF[name]) for name in ("stiffness", "stop_stiffness"))
LEAF_LENGTH, LEAF_FREE, LEAF_STOP = (
    0.076,
    float(_LEAF["free_length"]),
    float(_LEAF["stop_length"]),
)  # nominal, free, and at the stop
UNIT_SPRING: tuple[float, ...] = tuple(
    _UNIT["spring_polynomial_coeff_Z0_to_Z3"]
)  # tension over the length, rising powers
UNIT_DAMPER = ((-416.42, 1844.3), (0.0, 9945.627, 33955.72, -59832.25, -395651.0), (1919.1638, 1634.727))
UNIT_DAMPER_BREAKS = (-0.2, 0.21)

CALSPAN: dict[str, Any] = {
    "A": tuple(_COEFFICIENTS[f"A{i}"] for i in range(5)),
    "B": tuple(_COEFFICIENTS[name] for name in ("B1", "B3", "B4")),
    "SN": _COEFFICIENTS["SN"],
    "AF": tuple(_COEFFICIENTS[name] for name in ("AF1", "AF2")),
}
LINEAR: dict[str, dict[str, Any]] = {
    "front": {"cornering": 41641.0, "camber_stiffness": 6925.0, "trail": 0.06553},
    "rear": {"cornering": 40162.0, "camber_stiffness": 6600.0, "trail": 0.06142},
}
STANDSTILL = 0.1  # m/s

BUMP_HEIGHT, BUMP = 0.2, (5.0, 0.97)  # crest; wavelength and where it begins
RAMP_RATE, RAMP_SECONDS = 0.004, 0.5  # of the rack
ROUNDED = 0.01  # s: the corners of the ramp, so that the rack has an acceleration

_QUOTED = _TABLES["nominal_forces"]["benchmark_published_quoted"]
NOMINAL: dict[str, float] = {
    "leaf": _QUOTED["leaf_to_carrier"],
    "unit": _QUOTED["damper_unit"],
    "tyre_front": _QUOTED["front_tyre"],
    "tyre_rear": _QUOTED["rear_tyre"],
}
EQUILIBRIUM: dict[str, tuple[float, str]] = {
    "drop": (_REST["dz_mm"] / 1000, "m"),
    "pitch": (_TABLES["static_equilibrium"]["robotran"]["pitch_rad"], "rad"),
    "tyre_front": (_REST["tyre_front"], "N"),
    "tyre_rear": (_REST["tyre_rear"], "N"),
    "unit_front": (_REST["damper_front"], "N"),
    "unit_rear": (_REST["damper_rear"], "N"),
    "leaf_front": (_REST["leaf_front"], "N"),
    "leaf_rear": (_REST["leaf_rear"], "N"),
    "link_front": (_REST["upper_link_axial"][0], "N"),
    "link_rear": (_REST["upper_link_axial"][1], "N"),
}
EQUILIBRIUM_TOLERANCES = {
    "drop": 1e-8, "pitch": 2e-9, "tyre_front": 8e-5, "tyre_rear": 8e-5, "unit_front": 4e-4, "unit_rear": 6e-4,
    "leaf_front": 4e-4, "leaf_rear": 3e-4, "link_front": 3e-4, "link_rear": 9e-4,
}  # fmt: skip
SYMMETRIC = (-29.81 + 81.96j, -29.66 + 82.89j, -4.91 + 11.10j, -3.93 + 9.50j)
SYMMETRIC_NO_SIDE_FORCE = (-29.077 + 82.476j, -28.896 + 83.179j, -4.824 + 11.005j, -3.775 + 9.578j)
ANOTHER = "another reading without lateral tyre forces, indicative"
NO_SIDE_FORCE = {
    "hop warp": -28.73 + 86.13j,
    "hop pitch": -28.90 + 83.17j,
    "hop bounce": -29.08 + 82.48j,
    "hop roll": -27.17 + 70.59j,
    "bounce": -4.82 + 11.00j,
    "pitch": -3.78 + 9.58j,
}
RACK_STEER = {"front right": -0.8916, "front left": -0.8869}  # degrees about the kingpin for 2 mm

# Ramp to 2 mm: speed -> values at 5 s and peaks (value, time); rotations in the order pitch, roll, yaw from the road.
STEER_ENDS: dict[int, dict[str, float]] = {
    10: {"yaw_rate": -0.06253, "lateral_acceleration": -0.624, "roll": -0.329, "speed": 9.978},
    20: {"yaw_rate": -0.08564, "lateral_acceleration": -1.701, "roll": -0.924, "speed": 19.847},
    30: {"yaw_rate": -0.08484, "lateral_acceleration": -2.519, "roll": -1.400, "speed": 29.655},
}
STEER_PEAKS: dict[int, dict[str, float]] = {
    10: {"yaw_rate": -0.06280, "lateral_acceleration": -0.626},
    20: {"yaw_rate": -0.09166, "lateral_acceleration": -1.741},
    30: {"yaw_rate": -0.10303, "lateral_acceleration": -2.675},
}
STEER_LOADS: dict[
    int, tuple[float, float, float, float]
] = {  # front right, front left, rear right, rear left
    10: (3615.0, 4050.0, 3359.0, 3822.0),
    20: (3242.0, 4426.0, 2960.0, 4219.0),
    30: (2957.0, 4713.0, 2659.0, 4517.0),
}
# Absolute tolerances of these; where the other program's digits are too few, half a unit of the last one.
STEER_TOLERANCES: dict[str, dict[int, float]] = {
    "yaw_rate_5s": {10: 5e-6, 20: 1.2e-5, 30: 3e-5},
    "lateral_acceleration_5s": dict.fromkeys((10, 20, 30), 5e-4),
    "roll_5s": {10: 5e-4, 20: 1e-3, 30: 2e-3},
    "speed_5s": dict.fromkeys((10, 20, 30), 5e-4),
    "yaw_rate_peak": {10: 5e-6, 20: 3e-5, 30: 8e-5},
    "lateral_acceleration_peak": {10: 5e-4, 20: 5e-4, 30: 1.5e-3},
}
LOADS_TOLERANCES = {10: 1.2, 20: 2.5, 30: 3.5}
SINE_TOLERANCES = {1: 1.2e-4, 2: 1.2e-4, 4: 6e-4}
IN_PHASE_TOLERANCES: dict[int, dict[str, float]] = {
    5: {"z": 2.5e-4, "pitch": 0.03, "tyre_front": 12.0, "tyre_rear": 30.0},
    10: {"z": 9e-4, "pitch": 0.05, "tyre_front": 700.0, "tyre_rear": 50.0},
}
LAST_DIGITS = {  # halves of their units
    "yaw_rate": 5e-6, "lateral_acceleration": 5e-4, "roll": 5e-4, "speed": 5e-4, "pitch": 0.05, "tyre_rear": 50.0,
}  # fmt: skip
SINE_STEER: dict[int, tuple[float, float]] = {  # amplitude in mm -> smallest and largest yaw rate
    1: (-0.0392, 0.0399),
    2: (-0.0778, 0.0793),
    4: (-0.1533, 0.1565),
}
IN_PHASE: dict[int, dict[str, tuple[float, float]]] = {
    5: {
        "z": (-0.0225, 0.1207),
        "pitch": (-6.35, 7.64),
        "tyre_front": (1300.0, 6202.0),
        "tyre_rear": (1360.0, 5664.0),
    },
    10: {
        "z": (-0.084, 0.307),
        "pitch": (-8.3, 8.3),
        "tyre_front": (0.0, 33500.0),
        "tyre_rear": (0.0, 24000.0),
    },
}
ANTIPHASE: dict[int, dict[str, tuple[float, float]]] = {
    5: {"roll": (-2.2, 18.2), "yaw": (-0.86, 1.43)},
    10: {"roll": (-1.6, 14.9)},
}
