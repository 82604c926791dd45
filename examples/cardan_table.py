"""The table of the universal joint: every quantity with its closed form."""

from __future__ import annotations

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import cardan_data as data
from flexel.examples.cardan import (
    ANGLES,
    B30,
    CROSS,
    STIFFNESSES,
    TURN,
    CardanResults,
    closed_form,
    closed_moments,
    mathieu_edges,
    modulation,
)
from flexel.examples.reasons import STEPS
from flexel.results.reproduction import Quantity


def bearing_moment(motion: fx.Motion, name: str) -> Array:
    """Return the size (nt,) of the moment in a bearing across its axis [N m]."""
    force = motion.force
    return np.asarray(np.hypot(force(f"{name}.bend1"), force(f"{name}.bend2")))


def motion(results: CardanResults) -> list[Quantity]:
    """Compare four rigid hinges: kinematics, reactions, linearization, free run."""
    angle, ratio, second, moments = 0.0, 0.0, 0.0, dict.fromkeys(closed_moments(TURN, B30), 0.0)
    for degrees, turn in results.turns.items():
        b = np.radians(degrees)
        found = turn["out.angle"], turn.rate("out.angle"), turn.acceleration("out.angle")
        off = [float(np.abs(x - y).max()) for x, y in zip(found, closed_form(turn.t, b), strict=True)]
        angle, ratio, second = max(angle, off[0]), max(ratio, off[1]), max(second, off[2])
        forces = (turn.drive("in.angle"), bearing_moment(turn, "in"), bearing_moment(turn, "out"))
        for (name, expected), force in zip(closed_moments(turn.t, b).items(), forces, strict=True):
            moments[name] = max(moments[name], float(np.abs(force - expected).max()))
    more = {"angles": list(ANGLES)}
    at = [int(np.argmin(np.abs(TURN - np.radians(row[0])))) for row in data.TABLE_30]
    thirty, free = results.turns[30.0], results.free
    columns = np.degrees(thirty["out.angle"]), thirty.rate("out.angle"), thirty.acceleration("out.angle")
    return [
        Quantity("angle_max_error", angle, 0.0, 1e-12, "rad", data.CLOSED, more, kind="closed form"),
        Quantity("ratio_max_error", ratio, 0.0, 1e-12, "", data.CLOSED, more, kind="closed form"),
        Quantity("acceleration_max_error", second, 0.0, 1e-12, "", data.CLOSED, more, kind="closed form"),
        Quantity("table_30_degrees", np.column_stack(columns)[at], [row[1:] for row in data.TABLE_30], 1e-12, "",
                 "driven angle [degrees], ratio, acceleration", kind="closed form", tolerance_kind="absolute"),
        *(Quantity(f"{name.replace(' ', '_')}_moment_max_error", e, 0.0, 1e-12, "N m", data.MOMENTS, more,
                   kind="closed form") for name, e in moments.items()),
        *linear(results),
        Quantity("free_run_angle", free["in.angle"][1:], [row[1] for row in data.FREE_RUN], 5e-10, "rad", data.FREE,
                 kind="closed form", reason=STEPS),
        Quantity("free_run_speed", free.rate("in.angle")[1:], [row[2] for row in data.FREE_RUN], 5e-10, "rad/s",
                 data.FREE, kind="closed form", reason=STEPS),
    ]  # fmt: skip


def linear(results: CardanResults) -> list[Quantity]:
    """Compare the linearized twist of an elastic driving shaft about steady rotation, over a turn."""
    computed, closed = results.linear
    return [
        Quantity(
            f"linearization_{name}_max_error",
            float(np.abs(getattr(computed, name) - getattr(closed, name)).max()),
            0.0,
            1e-12,
            "",
            "elastic shaft at 30 degrees",
            kind="closed form",
        )
        for name in "MCKF"
    ]


def flexibility(results: CardanResults) -> list[Quantity]:
    """Compare flexible pins: convergence to rigid ones; zones of parametric instability."""
    logs = np.log10(results.errors)
    order = -float(np.polyfit(np.log10(STIFFNESSES[-3:]), logs[-3:], 1)[0])
    more = {"cross": CROSS, "w0": "mean torsional frequency on the pins, cross extrapolated to no mass"}
    own = mathieu_edges(modulation(B30))
    return [
        Quantity("flexible_limit_order", order, 1.0, 6e-5, "", "error of the driven angle over 1/stiffness",
                 kind="closed form"),
        Quantity("flexible_errors", np.column_stack([STIFFNESSES, results.errors]),
                 source="rows of stiffness [N m/rad], largest error [rad]"),
        Quantity("mathieu_edges", results.mathieu_edges, data.EDGES, 2e-7, "w0", data.MATHIEU, kind="closed form",
                 reason="the bisection stops at a width of 1e-7"),
        Quantity("zone_edges", results.edges, data.EDGES, 8e-3, "w0",
                 "Mathieu at eps = b^2/2, b = 30 degrees, its first term; flexible pins", more, kind="closed form"),
        Quantity("zone_edges_exact_modulation", results.edges, own, 5e-3, "w0",
                 "Mathieu at the pins' own sin^2(b)/(2 - sin^2(b))", more, kind="closed form"),
        Quantity("shaft_zone_edges", results.shaft_edges, results.shaft_edges_closed, 2e-7, "w0",
                 "equation in closed form; an elastic driving shaft modulates by b^2, twice the pins",
                 kind="closed form", reason="the bisection stops at a width of 1e-7"),
    ]  # fmt: skip
