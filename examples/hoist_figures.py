"""Figures of the hoist: speeds and tensions over time; tension, contact, strain and wire stress along the rope."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import flexel as fx
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.examples import hoist_rest
from flexel.examples.hoist import FALLS, HoistResults

TIMES = (0.98, 1.5, 2.5)
DENSITY = 7850.0  # of steel [kg/m³]
ALONG = "length along the rope from its anchor on the drum [m]"


def pictures(results: HoistResults, out: Path) -> list[Path]:
    """Write all figures to a folder; return their paths."""
    out.mkdir(parents=True, exist_ok=True)
    names: dict[str, Callable[[HoistResults, Path], None]] = {
        "hoist_motion.png": motion,
        "hoist_rope.png": along_the_rope,
        "hoist_contact.png": contact,
        "hoist_strain.png": strain,
        "hoist.html": animation,
    }
    for name, make in names.items():
        make(results, out / name)
    return [out / name for name in names]


def motion(results: HoistResults, path: Path) -> None:
    """Plot the histories of the paper's four figures: speed of drum and load, tension, contact forces."""
    m, static = results.motion, results.model.data.weight / 4
    with figure(4, 1, (8.0, 10.0), sharex=True) as (drawn, axes):
        axes[0].plot(m.t, m.rate("drive.angle"), color=COLOURS[0])
        axes[0].set_ylabel("speed of the drum [rad/s]")
        axes[1].plot(m.t, m.rate("block.y"), color=COLOURS[0])
        axes[1].set_ylabel("speed of the load [m/s]")
        for tension, colour, name in zip(results.tension.T, COLOURS, FALLS, strict=False):
            axes[2].plot(m.t, tension / static, color=colour, linewidth=0.8, label=name)
        axes[0].set_title("Lift of the hoist: drum, load, the four falls, contact")
        axes[2].set_ylabel("tension over W/4 [-]")
        rope = results.model.rope
        for name, colour in zip(rope.contacts, COLOURS, strict=False):
            axes[3].plot(m.t, rope.resultant(m, name) / 1e3, color=colour, linewidth=0.8, label=name)
        axes[3].set_ylabel("sum of contact forces [kN]")
        axes[3].set_xlabel("time [s]")
        for row in axes[2:]:
            row.legend(fontsize="small", ncol=2)
        save(drawn, path)


def along_the_rope(results: HoistResults, path: Path) -> None:
    """Plot the tension along the rope at rest, while the load is accelerated, and at constant speed, with statics."""
    model = results.model
    with figure(1, 1, (8.0, 4.5)) as (drawn, axes):
        for state, colour in _states(results):
            s, T = model.rope.tension(state)
            axes.plot(s, T / 1e3, ".", color=colour, markersize=3, label=f"t = {state.t:.3g} s")
            ends, free = hoist_rest.free_tensions(model, state)
            axes.plot(ends.ravel(), np.repeat(free, 2) / 1e3, color=colour, linewidth=0.8)
        axes.plot([], [], color="#444444", linewidth=0.8, label="statics of the free parts")
        axes.set_title("Tension along the rope at rest, accelerating and at constant speed")
        _labelled(axes, "tension [kN]")
        save(drawn, path)


def contact(results: HoistResults, path: Path) -> None:
    """Plot the normal force per length on drum and sheaves at three times, compared with T/R."""
    rope, R = results.model.rope, results.model.data.pitch
    with figure(3, 1, (8.0, 8.0), sharex=True) as (drawn, axes):
        for row, (state, _) in zip(axes, _states(results), strict=True):
            for (name, points), colour in zip(rope.contacts.items(), COLOURS, strict=False):
                s, N = rope.contact_force(state, name)
                line, on = N / np.array([p.weight for p in points]) / 1e3, N > 0
                row.plot(s[on], line[on], ".-", color=colour, label=name, linewidth=0.6, markersize=3)
                pressed = hoist_rest.statics(results.model, state, s[on]) / R / 1e3
                row.plot(s[on], pressed, color="black", linewidth=0.8)
            row.plot([], [], color="black", linewidth=0.8, label="T/R")
            row.set_title(f"t = {state.t:.3g} s")
            row.set_ylabel("contact force [kN/m]")
        axes[0].legend(fontsize="small", ncol=5, loc="lower center")
        drawn.suptitle("Contact with drum and sheaves, and tension over radius")
        axes[-1].set_xlabel(ALONG)
        save(drawn, path)


def strain(results: HoistResults, path: Path) -> None:
    """Plot strain of the rope and bending stress of its wires along the rope, at three times."""
    rope, data = results.model.rope, results.model.data
    with figure(2, 1, (8.0, 6.5), sharex=True) as (drawn, axes):
        for state, colour in _states(results):
            s, found = rope.strain(state)
            axes[0].plot(s, 1e3 * found, ".", color=colour, markersize=3, label=f"t = {state.t:.3g} s")
            s, found = rope.curvature(state)
            axes[1].plot(
                s, data.wire_stress(1.0) * found / 1e6, ".-", color=colour, markersize=3, linewidth=0.6
            )
        axes[1].axhline(data.wire_stress(1 / data.pitch) / 1e6, color="black", linewidth=0.8, label="E d/D")
        axes[0].set(ylabel="strain [10⁻³]", title="Strain of the rope and bending stress of its wires")
        axes[0].legend()
        _labelled(axes[1], "bending stress of a wire [MPa]")
        save(drawn, path)


def _states(results: HoistResults) -> list[tuple[fx.State, str]]:
    """Return the states at rest, in the acceleration and at constant speed, each with a colour."""
    return [(results.motion.nearest(t), colour) for t, colour in zip(TIMES, COLOURS, strict=False)]


def _labelled(axes: Any, quantity: str) -> None:
    axes.set_xlabel(ALONG)
    axes.set_ylabel(quantity)
    axes.legend()


def animation(results: HoistResults, path: Path) -> None:
    """Write the whole lift as a page for the browser, coloured by tension."""
    data = results.model.data
    R, r, low = data.pitch, data.sheave_radius, -data.depth
    side = float(np.cbrt(data.load / DENSITY))  # of a cube of steel
    hook = low - 1.3 * r
    block = [  # two cheeks with a hook between the sheaves' axles, the load on it, and the frame that carries the drum
        fx.Box("block", None, (2 * R, low, z), (4 * R + r, 0.6 * r, 0.1 * r), colour="#d9a441")
        for z in (-0.4 * r, 0.4 * r)
    ]
    load = fx.Box("block", None, (2 * R, hook - side / 2, 0), (side, side, side), colour="#8a5a44")
    rod = fx.Cylinder("block", None, (2 * R, low, 0), (2 * R, hook, 0), 0.12 * r, colour="#55606a")
    beam = fx.Box("frame", None, (1.5 * R, 1.9 * r, 0), (9 * R, 0.5 * r, 0.8 * r), colour="#b9c2ca")
    results.motion.view(
        path,
        frames=121,
        title="Hoist with a steel wire rope",
        caption=f"The load of {data.load / 1000:g} t is drawn as a cube of steel.",
        view=fx.View(elevation=8, azimuth=-70, sketches=[*block, load, rod, beam]),
        plots=["block.y'", "drive.angle'"],
    )
