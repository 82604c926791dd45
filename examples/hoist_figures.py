"""Pictures of the hoist: speed of the load, tension over time and along the rope, contact forces, the motion.

Imports numpy and flexel; matplotlib is imported by `flexel.pictures.figures` when a picture is drawn.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from flexel.examples.hoist import Results
from flexel.pictures.figures import COLOURS, figure, save

TIMES = (9.9, 15.0, 25.0)


def pictures(results: Results, out: Path) -> list[Path]:
    """Write all figures into a folder; returns what was written."""
    out.mkdir(parents=True, exist_ok=True)
    names = {
        "hoist_motion.png": motion,
        "hoist_rope.png": along_the_rope,
        "hoist_contact.png": contact,
        "hoist.html": animation,
    }
    for name, make in names.items():
        make(results, out / name)
    return [out / name for name in names]


def motion(results: Results, path: Path) -> None:
    """Speed of the load and tension at the drum over time."""
    m, static = results.motion, results.model.data.weight / 4
    with figure(2, 1, (8.0, 6.0), sharex=True) as (drawn, axes):
        axes[0].plot(m.t, m.rate("block.y"), color=COLOURS[0])
        axes[0].set_ylabel("speed of the load [m/s]")
        axes[1].plot(m.t, results.tension / static, color=COLOURS[1])
        axes[1].set_ylabel("tension at the drum over W/4")
        axes[1].set_xlabel("t [s]")
        save(drawn, path)


def along_the_rope(results: Results, path: Path) -> None:
    """Tension along the rope at rest, while the load is accelerated, and at constant speed.

    Lines join the means of the elements, dots are their Gauss points.
    """
    m, rope = results.motion, results.model.rope
    with figure(1, 1, (8.0, 4.5)) as (drawn, axes):
        for t, colour in zip(TIMES, COLOURS, strict=False):
            state = m.nearest(t)
            s, T = rope.tension(state)
            axes.plot(s, T / 1e3, ".", color=colour, markersize=2, alpha=0.5)
            s, T = rope.tension(state, mean=True)
            axes.plot(s, T / 1e3, color=colour, label=f"t = {t:g} s")
        axes.set_xlabel("length along the rope from its anchor on the drum [m]")
        axes.set_ylabel("tension [kN]")
        axes.legend()
        save(drawn, path)


def contact(results: Results, path: Path) -> None:
    """Normal force per length on drum and sheaves at constant speed."""
    m, rope = results.motion, results.model.rope
    state = m.nearest(TIMES[-1])
    with figure(1, 1, (8.0, 4.5)) as (drawn, axes):
        for (name, points), colour in zip(rope.contacts.items(), COLOURS, strict=False):
            s, N = rope.contact_force(state, name)
            line = N / np.array([p.weight for p in points]) / 1e3
            touching = line > 0
            axes.plot(s[touching], line[touching], ".-", color=colour, label=name, linewidth=0.8)
        axes.set_xlabel("length along the rope [m]")
        axes.set_ylabel("contact force per length [kN/m]")
        axes.legend()
        save(drawn, path)


def animation(results: Results, path: Path) -> None:
    """The whole lift as a page for the browser, coloured by tension."""
    results.motion.view(path, frames=121, title="Hoist with a steel wire rope")
