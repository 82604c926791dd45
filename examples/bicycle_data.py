"""Reference numbers of the bicycle: parameters, linear equations, eigenvalues, and one nonlinear motion.

Symbols as in the 2007 paper: rear wheel R, rear frame with rider B, front frame H, front wheel F; SI units;
axes x forward, y right, z down; w wheelbase, c trail, lam tilt of the steering axis.
"""

from __future__ import annotations

from math import hypot, pi

from flexel.examples.published import published

PAPER = "Meijaard, Papadopoulos, Ruina, Schwab (2007) Proc. R. Soc. A 463:1955-1982"
TALK = "Schwab, talk on SPACAR"
EXACT = "computed with 22 digits from the matrices of Meijaard et al. (2007)"
MEASURED_SOURCE = "BicycleParameters 1.5.2, closed-form matrices"
MANOEUVRE = "IFToMM benchmark M1, by Kane's equations, derived separately, at 1e-12"


_WHIPPLE = published("bicycle_whipple")
_M1 = published("bicycle_manoeuvre_M1")


def _parameter(value: str | float) -> float:
    return pi / 10 if value == "pi/10" else float(value)


def _matrix(name: str) -> list[list[float]]:
    return [[float(entry) for entry in row] for row in _WHIPPLE["published_matrices"][name]]


# The benchmark bicycle, exactly as in the paper's table of parameters.
BENCHMARK: dict[str, float] = {
    name: _parameter(v) for name, v in _WHIPPLE["parameters_exact_strings"].items()
}

# The same, with all the mass of the two frames in their mass centres.
POINTS = {name: 0.0 if name.startswith(("IB", "IH")) else value for name, value in BENCHMARK.items()}

# M q'' + v C1 q' + (g K0 + v² K2) q = 0 with q = (lean, steer); the digits as printed.
M, C1, K0, K2 = (_matrix(name) for name in ("M", "C1", "K0", "K2"))
WEAVE_SPEED, CAPSIZE_SPEED = 4.29238253634111, 6.02426201538837

# Eigenvalues [1/s] at v = 0, 1, ..., 10 m/s: sorted by real, then imaginary part.
EIGENVALUES = [
    [complex(float(re), float(im)) for re, im in _WHIPPLE["eigenvalues"][str(v)]] for v in range(11)
]

# Measured bicycles without rider: parameters, the speed above which the weave is stable, and the capsize speed.
_NAMES = {
    "Browserins": "Browser with instruments",
    "Rigid": "Rigid rider bicycle",
    "Yellowrev": "Yellow, fork reversed",
}
_BIKES = {
    _NAMES.get(name, name): bike for name, bike in _WHIPPLE["measured_bikes"].items() if name != "Benchmark"
}


def _measured(params: dict[str, float]) -> dict[str, float]:
    """Return the parameters of a measured bicycle, by the symbols of the benchmark.

    Some measured inertias are impossible by a few percent: with the principal moments I1 < I3 in the plane of
    symmetry, Iyy must lie from I3 - I1 to I3 + I1.  It is moved there; the linear equations do not contain it.
    """
    p = {name: params[name] for name in BENCHMARK}
    for body in ("B", "H"):
        xx, yy, zz, xz = (p[f"I{body}{axes}"] for axes in ("xx", "yy", "zz", "xz"))
        p[f"I{body}yy"] = min(max(yy, hypot(xx - zz, 2 * xz)), xx + zz)
    return p


MEASURED = {name: _measured(bike["params"]) for name, bike in _BIKES.items()}
MEASURED_SPEEDS: dict[str, dict[str, float | None]] = {
    name: {
        "weave": float(bike["weave"][-1]),
        "capsize": None if "j" in bike["capsize"] else float(bike["capsize"]),
    }
    for name, bike in _BIKES.items()
}

# The talk's own bicycle: its stable range [m/s]. It is also that of the page of bike3.dat, of the same author.
TALK_RANGE = (4.1, 5.7)

# Manoeuvre M1: rolling upright at 4 m/s with a roll rate of 0.05 rad/s about the ground line.
M1_SPEED = 4.0
ROLL_RATE = 0.05
M1_STEER_5S, M1_FORWARD_SPEED_5S, M1_ENERGY = (
    float(_M1["at_5s"][name]) for name in ("steer", "rear_hub_velocity_forward", "energy_total_J")
)
M1_COLUMNS = [
    "t",
    "lean.angle",
    "steer.angle",
    "yaw.angle",
    "lean.angle'",
    "steer.angle'",
    "rear hub.x",
    "rear hub.y",
]
_KEYS = ("t", "roll", "steer", "yaw", "roll_rate_about_heading", "steer_rate")
M1: list[list[float]] = [
    [*(row[key] for key in _KEYS), *row["rear_hub"][:2]] for row in _M1["maneuvers"][0]["rows"]
]
