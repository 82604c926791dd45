"""Figures of the universal joint: kinematics, reactions, free run, convergence, zones of instability."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from flexel import View
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.apps.view.plot import Sketch
from flexel.base.arrays import Array
from flexel.base.quaternions import matrix
from flexel.examples import cardan_data as data
from flexel.examples.cardan import (
    B30,
    STIFFNESSES,
    CardanResults,
    closed_form,
    closed_moments,
    elastic_shaft,
    family,
    flexible,
    mathieu_edges,
    modulation,
    pins_for_unit_frequency,
)
from flexel.examples.cardan_table import bearing_moment
from flexel.examples.cardan_zones import Zone, trace

CHART_ANGLES = np.linspace(5.0, 45.0, 9)  # degrees
EDGE = "#7a2e00"  # lines of a zone, over its colours


def pictures(results: CardanResults, out: Path) -> list[Path]:
    """Write all figures to a folder; return their paths."""
    out.mkdir(parents=True, exist_ok=True)
    names: dict[str, Callable[[CardanResults, Path], None]] = {
        "cardan_model.png": model,
        "cardan_kinematics.png": kinematics,
        "cardan_moments.png": moments,
        "cardan_free_run.png": free_run,
        "cardan_flexible_limit.png": limit,
        "cardan_zones.png": zones,
        "cardan_free_run.html": animation,
    }
    for name, make in names.items():
        make(results, out / name)
    return [out / name for name in names]


def model(results: CardanResults, path: Path) -> None:
    """Draw the joint at three angles of the driving shaft, 45 degrees between the shafts."""
    turn, b = results.turns[45.0], np.radians(45.0)
    with figure(1, 3, size=(9.0, 3.6), subplot_kw={"projection": "3d"}) as (drawn, axes):
        for panel, degrees in zip(axes, (0, 40, 90), strict=True):
            state = turn.nearest(np.radians(degrees))
            driving, cross, driven = (
                matrix(state.position(frame)) for frame in ("driving", "cross", "driven")
            )
            line(panel, [(-0.9, 0, 0), (-0.42, 0, 0)], COLOURS[0], 5)
            d2 = np.array([np.cos(b), np.sin(b), 0])
            line(panel, [0.42 * d2, 0.9 * d2], COLOURS[1], 5)
            fork(panel, driving @ [0, 0.3, 0], np.array([-0.42, 0, 0]), COLOURS[0])
            fork(panel, driven @ [0, 0, 0.3], 0.42 * d2, COLOURS[1])
            for axis in ([0, 0.3, 0], [0, 0, 0.3]):
                arm = cross @ axis
                line(panel, [-arm, arm], COLOURS[5], 3)
            panel.set(xlim=(-0.8, 0.6), ylim=(-0.4, 0.6), zlim=(-0.4, 0.4))
            panel.set_box_aspect((1.4, 1.0, 0.8), zoom=1.4)
            panel.view_init(28, -60)
            panel.set_axis_off()
            panel.set_title(
                f"driving {degrees}°, driven {abs(np.degrees(state['out.angle'])):.1f}°", fontsize=10
            )
        drawn.suptitle(
            "Universal joint: two bearings, two pins; (a) rigid, (b) with pins that bend", fontsize=11
        )
        save(drawn, path)


def line(panel: Any, points: Any, colour: str, width: float) -> None:
    """Draw a straight piece in space."""
    panel.plot(*np.array(points, dtype=float).T, color=colour, lw=width, solid_capstyle="round")


def fork(panel: Any, pin: Array, root: Array, colour: str) -> None:
    """Draw a fork from its root on the shaft to both ends of its pin."""
    for side in (pin, -pin):
        line(panel, [root, root + side, side], colour, 3)


def kinematics(results: CardanResults, path: Path) -> None:
    """Plot the lead of the driven shaft, ratios of speed and acceleration over a turn."""
    labels = ("driven - driving angle [°]", "speed ratio [-]", "acceleration / speed² [-]")
    with figure(3, size=(8.0, 8.0), sharex=True) as (drawn, axes):
        for j, (degrees, turn) in enumerate(results.turns.items()):
            angle = np.degrees(turn.t)
            exact = closed_form(turn.t, np.radians(degrees))
            computed = turn["out.angle"], turn.rate("out.angle"), turn.acceleration("out.angle")
            for i, panel in enumerate(axes):
                ours, reference = computed[i], exact[i]
                if i == 0:
                    ours, reference = np.degrees(ours - turn.t), np.degrees(reference - turn.t)
                panel.plot(angle, ours, color=COLOURS[j], label=f"{degrees:g}°")
                panel.plot(angle[::9], reference[::9], "o", ms=3, color=COLOURS[j])
        for panel, label in zip(axes, labels, strict=True):
            panel.set_ylabel(label)
        axes[0].legend(title="between the shafts", ncols=5, loc="lower left", bbox_to_anchor=(0.0, 1.0))
        axes[2].set(xlabel="angle of the driving shaft [°]", xlim=(0, 360), xticks=range(0, 361, 45))
        drawn.suptitle("Four rigid hinges (lines) and the closed form (dots)")
        drawn.align_ylabels()
        save(drawn, path)


def moments(results: CardanResults, path: Path) -> None:
    """Plot driving moment and moments in the bearings, per unit of torque on the driven shaft."""
    turn = results.turns[30.0]
    curves = (turn.drive("in.angle"), bearing_moment(turn, "in"), bearing_moment(turn, "out"))
    with figure(size=(8.0, 4.4)) as (drawn, axes):
        for j, ((name, exact), y) in enumerate(zip(closed_moments(turn.t, B30).items(), curves, strict=True)):
            label = "driving moment" if j == 0 else f"bending moment, {name} of its shaft"
            axes.plot(np.degrees(turn.t), y, color=COLOURS[j], label=label.replace(" bearing of its", ""))
            axes.plot(np.degrees(turn.t)[::6], exact[::6], "o", ms=3, color=COLOURS[j])
        axes.set(
            xlabel="angle of the driving shaft [°]",
            ylabel="moment / torque [-]",
            xlim=(0, 360),
            ylim=(0, 1.6),
        )
        axes.set_xticks(range(0, 361, 45))
        axes.legend(loc="upper right", ncols=3)
        axes.set_title("Moments at 30° between the shafts: computed (lines), closed form (dots)")
        save(drawn, path)


def free_run(results: CardanResults, path: Path) -> None:
    """Plot two rotors that turn freely through the joint."""
    motion = results.free
    t = np.linspace(0, motion.t[-1], 400)
    states = [motion.at(float(time)) for time in t]
    with figure(size=(8.0, 4.2)) as (drawn, axes):
        axes.plot(t, [state.rate("in.angle") for state in states], color=COLOURS[0], label="driving rotor")
        axes.plot(t, [state.rate("out.angle") for state in states], color=COLOURS[1], label="driven rotor")
        axes.plot(*np.array(data.FREE_RUN)[:, [0, 2]].T, "o", color=COLOURS[0], mfc="none", label="reference")
        axes.set(xlabel="time [s]", ylabel="speed [rad/s]", xlim=(0, t[-1]), ylim=(9.8, 12.4))
        axes.legend(ncols=3, loc="upper right", framealpha=0.9, frameon=True)
        axes.set_title("Two rotors turn freely through a universal joint, 30° between the shafts")
        save(drawn, path)


def limit(results: CardanResults, path: Path) -> None:
    """Plot how flexible pins become rigid ones: the error falls with the stiffness."""
    with figure(size=(8.0, 4.6)) as (drawn, axes):
        axes.loglog(
            STIFFNESSES, results.errors, "o-", color=COLOURS[0], label="flexible minus rigid, over one turn"
        )
        slope = results.errors[-1] * STIFFNESSES[-1] / STIFFNESSES
        axes.loglog(STIFFNESSES, 2 * slope, "--", color=COLOURS[1], label="slope -1")
        axes.set(
            xlabel="bending stiffness of the pins [N m/rad]", ylabel="largest error of the driven angle [rad]"
        )
        axes.legend()
        axes.set_title("Flexible pins (b) converge to rigid pins (a), 30° between the shafts", fontsize=11)
        save(drawn, path)


def zones(results: CardanResults, path: Path) -> None:
    """Plot zones of parametric instability over angle and speed, pins or shaft elastic."""
    pins = cache(lambda b: family(lambda w: flexible(b, w, pins_for_unit_frequency(b))).at)
    shaft = cache(lambda b: family(lambda w: elastic_shaft(b, w, 1.0), 64).at)
    charts = (
        ("(b) pins flexible in bending", pins, ((1, 0.12), (2, 0.03)), results.edges),
        ("(a) with an elastic driving shaft", shaft, ((1, 0.2), (2, 0.06), (3, 0.03)), results.shaft_edges),
    )
    edges = np.array([mathieu_edges(modulation(np.radians(angle))) for angle in CHART_ANGLES])
    with figure(1, 2, size=(9.0, 5.4), sharey=True) as (drawn, axes):
        for panel, (title, at, orders, known) in zip(axes, charts, strict=True):
            for order, width in orders:
                shown = _zone(panel, trace(at, CHART_ANGLES.tolist(), order, width))
            panel.plot([30, 30], known, "o", color=COLOURS[2], label="edges at 30° by bisection", zorder=4)
            panel.set(title=title, xlabel="angle between the shafts [°]", xlim=(0, CHART_ANGLES[-1]))
        axes[0].plot(CHART_ANGLES, edges, "--", color=COLOURS[0], lw=1.2, label=["Mathieu, first zone", None])
        for panel in axes:
            panel.plot([], [], color=EDGE, lw=1.2, label="edges")
            panel.plot([], [], ":", color=EDGE, lw=1.0, label="largest growth")
            panel.legend(loc="upper left")
        axes[0].set(ylabel="speed / natural frequency [-]", ylim=(0.3, 1.42))
        drawn.colorbar(shown, ax=axes, label="growth in one turn, log |multiplier| [-]")
        drawn.suptitle("Parametric instability by Floquet multipliers, no damping")
        save(drawn, path)


def _zone(panel: Any, zone: Zone) -> Any:
    """Plot the growth in a zone with its edges and the speed at which it is largest."""
    angle, speed, growth = zone.field()
    shown = panel.contourf(angle, speed, growth, np.linspace(0.0, 0.65, 14), cmap="Oranges")
    for line in zone.edges(angle[0]):
        panel.plot(angle[0], line, color=EDGE, lw=1.2)
    panel.plot(angle[0], zone.ridge(angle[0]), ":", color=EDGE, lw=1.0)
    return shown


def animation(results: CardanResults, path: Path) -> None:
    """Write the free run as an interactive page for the browser; shafts, forks and cross are for display only."""
    out = np.array([np.cos(B30), np.sin(B30), 0.0])
    y, z = np.array([0, 0.3, 0]), np.array([0, 0, 0.3])
    lines: list[tuple[str, list[Array]]] = [("cross", [-y, y]), ("cross", [-z, z])]
    for name, pin, root in (("driving", y, np.array([-0.42, 0, 0])), ("driven", z, 0.42 * out)):
        lines += [(name, [root, 2.2 * root]), (name, [pin, root + pin, root - pin, -pin])]
    sketches = [Sketch("centre", name, np.array(points).tolist()) for name, points in lines]
    results.free.view(
        path,
        view=View(elevation=28, azimuth=-60, span=1.9, sketches=sketches),
        title="Two rotors that turn freely through a universal joint, 30° between the shafts",
        caption="The driven rotor runs ahead and falls behind twice a turn; energy is conserved.",
    )
