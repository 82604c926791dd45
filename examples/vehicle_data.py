"""Published and recomputed numbers of the road vehicle: the IAVSD benchmark "Bombardier Iltis".

Lengths in m above the road with the chassis at its nominal height; x forward, y left, z up, origin below the mass
centre of the chassis. Corners are named by what they physically are: y < 0 is right. Imports the standard library only.
"""

from __future__ import annotations

from typing import Any

TALK = "Schwab, talk on SPACAR: 85 elements, 239 deformations, 70 nodes, 226 coordinates, 10 freedoms"
TALK_COUNTS = {"elements": 85, "deformations": 239, "nodes": 70, "coordinates": 226, "freedoms": 10}
PAPER = "Frik, Leister, Schwartz (1993) VSD 22 suppl. 215-253, as quoted in ovankerm/IAVSD_ILTIS"
RERUN = "another program's run, not published (Robotran, ovankerm/IAVSD_ILTIS 81cd42c)"
RECOMPUTED = "stationary energy, recomputed by an independent script; agrees with Robotran's printed digits"
LEVER = "lever rule of the level vehicle (as the published loads are)"
INDICATIVE = "independent symmetric model with 4 coordinates, indicative"

GRAVITY = 9.81
HEIGHT = 0.57  # of the chassis' mass centre
AXLES = {"front": 0.97, "rear": -1.047}
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

CHASSIS: dict[str, Any] = {"mass": 1260.0, "inertia": (130.0, 1620.0, 1670.0)}
ARM: dict[str, Any] = {"mass": 6.0, "inertia": (0.052099, 0.023235, 0.068864)}
ARM_CENTRE = 0.16073  # from the lower ball along the arm
WHEEL: dict[str, Any] = {"mass": 57.35, "inertia": (1.2402, 1.908, 1.2402)}

RADIUS = {"front": 0.364325, "rear": 0.363812}  # of the unloaded tyre
TYRE_STIFFNESS = 460000.0
LEAF_STIFFNESS, LEAF_STOP_STIFFNESS = 35906.0, 1e7
LEAF_LENGTH, LEAF_FREE, LEAF_STOP = 0.076, 0.152, 0.006  # nominal, free, and at the stop
UNIT_SPRING = (-4.0092e6, 2.8397e7, -6.7061e7, 5.2796e7)  # tension over the length, rising powers
UNIT_DAMPER = ((-416.42, 1844.3), (0.0, 9945.627, 33955.72, -59832.25, -395651.0), (1919.1638, 1634.727))
UNIT_DAMPER_BREAKS = (-0.2, 0.21)

CALSPAN: dict[str, Any] = {
    "A": (2625.0, 14.47, 12930.0, 2.29, 18175.0),
    "B": (-0.464e-4, 1.216, 2.18e-11),
    "SN": 1.0274,
    "AF": (-0.171e-4, 0.171e-4),
}
LINEAR: dict[str, dict[str, Any]] = {
    "front": {"cornering": 41641.0, "camber_stiffness": 6925.0, "trail": 0.06553},
    "rear": {"cornering": 40162.0, "camber_stiffness": 6600.0, "trail": 0.06142},
}
STANDSTILL = 0.1  # m/s

BUMP_HEIGHT, BUMP = 0.2, (5.0, 0.97)  # crest; wavelength and where it begins
RAMP_RATE, RAMP_SECONDS = 0.004, 0.5  # of the rack
ROUNDED = 0.01  # s: the corners of the ramp, so that the rack has an acceleration

NOMINAL = {"leaf": -2728.9, "unit": -128.0, "tyre_front": 3829.6, "tyre_rear": 3593.6}
EQUILIBRIUM = {
    "drop": (-7.08335795371251e-3, "m"),
    "pitch": (2.557498e-3, "rad"),
    "tyre_front": (3831.3146, "N"),
    "tyre_rear": (3591.9124, "N"),
    "unit_front": (-335.2907, "N"),
    "unit_rear": (-241.6373, "N"),
    "leaf_front": (-3068.621, "N"),
    "leaf_rear": (-2885.5121, "N"),
    "link_front": (-1408.5104630794376, "N"),
    "link_rear": (-1335.522363660857, "N"),
}
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
