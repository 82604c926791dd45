"""Figures of the boom on its cylinder."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from flexel import View
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.examples.cylinder import CylinderResults, angle, force, stroke, stroke_rates


def pictures(found: CylinderResults, out: Path) -> list[Path]:
    """Write all figures to a folder; return their paths."""
    out.mkdir(parents=True, exist_ok=True)
    names = "cylinder_motion.png", "cylinder_shapes.png", "cylinder.html"
    for name, make in zip(names, (motion, shapes, animation), strict=True):
        make(found, out / name)
    return [out / name for name in names]


def motion(found: CylinderResults, path: Path) -> None:
    """Plot elongation, angle of the boom and force of the cylinder over time, with the closed forms."""
    run = found.driven
    e, (ed, edd) = stroke(run.t), stroke_rates(run.t)
    rows = (
        ("elongation [m]", run["cylinder.elongation"], e),
        ("angle of the boom [°]", np.degrees(run["hinge.angle"]), np.degrees(angle(e))),
        ("push of the cylinder [N]", -run.force("cylinder.elongation"), force(e, ed, edd)),
    )
    with figure(3, size=(8.0, 6.6), sharex=True) as (drawn, axes):
        for panel, (label, computed, closed) in zip(axes, rows, strict=True):
            panel.plot(run.t, computed, color=COLOURS[0], label="flexel")
            panel.plot(
                run.t[::10], closed[::10], "o", ms=5, mfc="none", color=COLOURS[1], label="closed form"
            )
            panel.set_ylabel(label)
        axes[0].legend(loc="upper left")
        axes[-1].set(xlabel="time [s]", xlim=(0, run.t[-1]))
        drawn.suptitle("The elongation of the cylinder is prescribed")
        save(drawn, path)


def shapes(found: CylinderResults, path: Path) -> None:
    """Draw the crane at the start, half-way and at its highest."""
    run = found.driven
    k = [0, run.t.size // 2, int(np.argmax(run["hinge.angle"]))]
    with figure(size=(7.0, 5.0)) as (drawn, axes):
        for j, i in enumerate(k):
            O, P, T, foot = (run[i].position(name)[[0, 2]] for name in ("O", "P", "T", "foot"))
            label = f"elongation {run['cylinder.elongation'][i]:+.3f} m"
            axes.plot(*np.column_stack([O, T]), color=COLOURS[j], lw=4, solid_capstyle="round", label=label)
            axes.plot(*np.column_stack([foot, P]), color=COLOURS[j], lw=2, ls="-")
            axes.plot(*P, "o", color="white", mec="#222222", zorder=3)
        for point in (O, foot):
            axes.plot(*point, "^", ms=10, color="#222222", zorder=3)
        axes.set_aspect("equal")
        axes.set(xlabel="x [m]", ylabel="z [m]", title="A boom on a hydraulic cylinder")
        axes.legend(loc="lower right")
        save(drawn, path)


def animation(found: CylinderResults, path: Path) -> None:
    """Write the driven motion as an interactive page for the browser."""
    found.driven.view(path, view=View(trails=["T"]), title="A boom on a hydraulic cylinder")
