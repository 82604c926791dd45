"""Figures of the bicycle: root loci, kicks, tracks, manoeuvre M1, stable ranges, and an animation."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from flexel import View
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.apps.view.plot import Cylinder, Sketch, draw, root_loci
from flexel.apps.view.scene import canvas
from flexel.base.arrays import Array
from flexel.examples import bicycle_data as data
from flexel.examples.bicycle import BicycleResults, eigenvalues, kick, manoeuvre_m1
from flexel.examples.bicycle_file import matrices, speeds

FASTEST = 10.0  # of the root loci [m/s]
SPIRAL_SECONDS = 111.0  # the bicycle at 6.3 m/s leans 40 degrees then
SHOWN_SECONDS = 8.0  # of the animation


def pictures(results: BicycleResults, out: Path) -> list[Path]:
    """Write all figures and the animation to a folder; return their paths."""
    out.mkdir(parents=True, exist_ok=True)
    names: dict[str, Callable[[BicycleResults, Path], None]] = {
        "model.png": model,
        "root_loci.png": loci,
        "kicks.png": histories,
        "tracks.png": tracks,
        "manoeuvre_m1.png": manoeuvre,
        "stable_ranges.png": ranges,
        "kick_3.5.html": animation,
    }
    for name, make in names.items():
        make(results, out / name)
    return [out / name for name in names]


def model(results: BicycleResults, path: Path) -> None:
    """Draw the mechanism with its beams, wheels and mass centres, and the outline of bicycle and rider."""
    view = View(elevation=14, azimuth=-66, centre=(0.5, 0.0, -0.8), span=2.3, sketches=lines(data.BENCHMARK))
    with canvas(results.system.initial, (7.0, 5.2)) as (drawn, axes):
        draw(results.system.initial, axes, view)
        note = "Two wheels, two beams (blue), six hinges; mass centres orange.\nThe grey outline is for display only."
        drawn.text(0.02, 0.03, note, fontsize=9)
        save(drawn, path)


def loci(results: BicycleResults, path: Path) -> None:
    """Plot eigenvalues of lean and steer over the forward speed, each speed linearized about its steady motion."""
    speeds = np.linspace(0.0, FASTEST, 401)
    weave, capsize = results.range
    marks = {"weave": weave} | ({} if capsize is None else {"capsize": capsize})
    root_loci(
        speeds,
        eigenvalues(results.system, speeds),
        path,
        label="forward speed [m/s]",
        marks=marks,
        limits=(-10.0, 6.5),
        title="Eigenvalues of the steady upright motion, 2007 benchmark bicycle",
        names={"weave": (2.6, 2.6), "capsize": (8.2, 0.65), "castering": (2.2, -8.0)},
    )


def histories(results: BicycleResults, path: Path) -> None:
    """Plot lean, steer and yaw rate after the side kick at the three speeds."""
    rows = (("lean.angle", "lean [rad]"), ("steer.angle", "steer [rad]"), ("yaw.angle'", "yaw rate [rad/s]"))
    titles = ("below the weave speed", "in the stable range", "above the capsize speed")
    with figure(3, 3, size=(9.0, 6.4), sharex=True) as (drawn, axes):
        for j, (v, motion) in enumerate(results.kicks.items()):
            for i, (name, label) in enumerate(rows):
                values = motion.rate(name[:-1]) if name.endswith("'") else motion[name]
                axes[i, j].plot(motion.t, values, color=COLOURS[j])
                axes[i, j].axhline(0, color="#222222", lw=0.6)
                if j == 0:
                    axes[i, j].set_ylabel(label)
            axes[0, j].set_title(f"{v} m/s: {titles[j]}", fontsize=11)
            axes[2, j].set_xlabel("time [s]")
            axes[2, j].set_xlim(0, motion.t[-1])
        drawn.suptitle(f"After a side kick: rolling upright, roll rate {data.ROLL_RATE} rad/s at t = 0")
        drawn.align_ylabels()
        save(drawn, path)


def tracks(results: BicycleResults, path: Path) -> None:
    """Draw the tracks of the wheels on the ground, seen from above."""
    spiral = kick(results.system, 6.3, SPIRAL_SECONDS, rtol=1e-8)
    runs = [*results.kicks.values(), spiral]
    titles = [
        f"{v} m/s, {motion.t[-1]:.0f} s" + ", y enlarged" * (v > 4) for v, motion in results.kicks.items()
    ]
    titles.append(
        f"6.3 m/s, {spiral.t[-1]:.0f} s: the turn tightens, lean {np.degrees(spiral['lean.angle'][-1]):.0f}°"
    )
    with figure(2, 2, size=(9.0, 6.4)) as (drawn, axes):
        for k, (panel, motion, title) in enumerate(zip(axes.flat, runs, titles, strict=True)):
            for wheel, width, style in (("rear", 1.6, "-"), ("front", 1.0, "--")):
                x, y, _ = motion.position(f"{wheel} contact").T
                panel.plot(x, y, style, color=COLOURS[min(k, 2)], lw=width, label=f"{wheel} wheel")
            panel.set_title(title)
            panel.set_xlabel("x, forward [m]")
            panel.set_ylabel("y, to the right [m]")
            panel.invert_yaxis()
            if k in (0, 3):
                panel.set_aspect("equal", adjustable="datalim")
        axes[0, 0].legend(loc="best")
        drawn.suptitle("Ground tracks after the side kick, from above")
        save(drawn, path)


def manoeuvre(results: BicycleResults, path: Path) -> None:
    """Plot manoeuvre M1 with its reference, and the difference."""
    motion, reference = results.m1, np.array(data.M1)
    difference = np.abs(manoeuvre_m1(motion) - reference)
    labels = ("lean", "steer", "yaw")
    with figure(2, size=(8.0, 6.0), sharex=True, height_ratios=(3, 2)) as (drawn, (above, below)):
        for k, label in enumerate(labels):
            above.plot(motion.t, motion[f"{label}.angle"], color=COLOURS[k], label=label)
            above.plot(reference[:, 0], reference[:, k + 1], "o", color=COLOURS[k], mfc="white", ms=5)
            below.semilogy(
                reference[1:, 0],
                np.maximum(difference[1:, k + 1], 1e-13),
                "o-",
                color=COLOURS[k],
                ms=4,
                lw=0.8,
            )
        above.plot(5.0, data.M1_STEER_5S, "s", color=COLOURS[1], mfc="white", ms=6)
        below.plot(5.0, abs(motion[-1]["steer.angle"] - data.M1_STEER_5S), "s", color=COLOURS[1], ms=5)
        above.plot([], [], "o", color="#444444", mfc="white", label="reference")
        above.plot([], [], "s", color="#444444", mfc="white", label="reference, second program")
        above.set_ylabel("angle [rad]")
        above.legend(loc="upper left", ncols=2)
        above.set_title("Manoeuvre M1: 4 m/s, roll rate 0.05 rad/s at t = 0")
        below.set_ylabel("|difference| [rad]")
        below.axhspan(1e-13, 5e-12, color="#8a8f94", alpha=0.15, lw=0)
        below.text(4.08, 4e-13, "rounding of the\nreference (1e-11)", fontsize=9, color="#555555")
        below.set_ylim(1e-13, 1e-8)
        below.set_xlabel("time [s]")
        below.set_xlim(0, 5.1)
        save(drawn, path)


def ranges(results: BicycleResults, path: Path) -> None:
    """Plot stable speed ranges: the talk's bicycle, the benchmark, and measured bicycles."""
    edge = 9.0
    _, weave, capsize = speeds(matrices())
    rows: list[tuple[str, float, float | None, str]] = [
        ("talk, and page of 2003", *data.TALK_RANGE, "#8a8f94")
    ]
    rows += [("file on that page", weave, capsize, COLOURS[1])]
    rows += [("2007 benchmark, with rider", *results.range, COLOURS[2])]
    rows += [(f"{name}, no rider", *pair, COLOURS[0]) for name, pair in results.measured.items()]
    with figure(size=(9.0, 5.4)) as (drawn, axes):
        axes.axvspan(*data.TALK_RANGE, color="#8a8f94", alpha=0.15, lw=0)
        for k, (_, start, end, colour) in enumerate(rows):
            hatch = {"hatch": "////", "edgecolor": "white"} if k == 0 else {}
            axes.barh(k, (end or edge) - start, left=start, height=0.6, color=colour, **hatch)
            axes.text(
                start - 0.06, k, f"{start:.2f}" if k else f"{start:.1f}", ha="right", va="center", fontsize=9
            )
            text = "no capsize" if end is None else f"{end:.2f}" if k else f"{end:.1f}"
            axes.text(
                (end or edge - 1.2) + 0.06,
                k,
                text,
                va="center",
                fontsize=9,
                color="white" if end is None else "k",
            )
        axes.set_yticks(range(len(rows)), [row[0] for row in rows])
        axes.invert_yaxis()
        axes.grid(False, axis="y")
        axes.set_xlim(2.5, edge)
        axes.set_xlabel("forward speed [m/s]")
        drawn.suptitle("Where the uncontrolled bicycle is stable: from the weave speed to the capsize speed")
        drawn.supxlabel("The talk and the page of 2003 state 4.1 to 5.7 m/s (grey). The file on that page gives "
                        "another range:\nit belongs to another version. All ranges but the grey one are computed.",
                        fontsize=9)  # fmt: skip
        save(drawn, path)


# -- the animation --------------------------------------------------------------------------------


@dataclass(frozen=True)
class Outline:
    """Lines of the bicycle and of its rider in global axes, for display; they have no part in the mechanics.

    Attributes
    ----------
    frame, front : list of ndarray (k, 3)
        On the rear and the front frame [m].
    rider : list of (ndarray (k, 3), float)
        Lines of trunk, legs and arms on the rear frame, and their thickness [m].
    head : ndarray (3,)
        Its middle [m].
    """

    frame: list[Array]
    front: list[Array]
    rider: list[tuple[Array, float]]
    head: Array


def outline(p: dict[str, float]) -> Outline:
    """Return frame, saddle, rider, fork and handlebar for the parameters of a bicycle."""
    axis = np.array([np.sin(p["lam"]), 0, np.cos(p["lam"])])
    foot = np.array([p["w"] + p["c"], 0, 0])

    def steering(height: float, side: float = 0.0, back: float = 0.0) -> Array:
        return np.asarray(foot - axis * height / axis[2] + np.array([-back, side, 0]))

    hub, crank, saddle, hip = (0, 0, -p["rR"]), (0.42, 0, -0.28), (0.28, 0, -0.86), (0.26, 0, -0.93)
    shoulder, neck = np.array([0.45, 0, -1.42]), (0.49, 0, -1.52)
    top, low, bar = steering(0.88), steering(0.72), steering(1.0)
    rider: list[tuple[Any, float]] = [([hip, shoulder, neck], 0.13)]
    for side in (-1, 1):
        rider.append(([hip, (0.6, 0.1 * side, -0.62), (0.42, 0.09 * side, -0.2)], 0.07))
        rider.append(
            ([shoulder, shoulder + (0, 0.17 * side, 0.03), steering(1.02, 0.24 * side, 0.22)], 0.045)
        )
    front = [[low, (p["w"], 0, -p["rF"])], [low, bar]]
    front.append(
        [steering(1.02, 0.26 * side, back) for side, back in ((-1, 0.25), (-1, 0), (1, 0), (1, 0.25))]
    )
    frame = [[hub, crank, saddle, hub], [saddle, top, low, crank]]
    return Outline(
        frame=[np.array(line, dtype=float) for line in frame],
        front=[np.array(line, dtype=float) for line in front],
        rider=[(np.array(line, dtype=float), d) for line, d in rider],
        head=np.array([0.53, 0, -1.63]),
    )


def lines(p: dict[str, float]) -> list[Sketch]:
    """Return the the outline as lines, for a figure."""
    found = outline(p)
    angles = np.linspace(0, 2 * np.pi, 17)
    skull = found.head + np.column_stack([0.09 * np.cos(angles), 0 * angles, 0.12 * np.sin(angles)])
    rear = [*found.frame, *(line for line, _ in found.rider), skull]
    return _sketched(rear, "rear hub", "rear frame") + _sketched(found.front, "head", "front frame")


def _sketched(drawn: list[Array], point: str, frame: str) -> list[Sketch]:
    return [Sketch(point, frame, line.tolist()) for line in drawn]


def solids(p: dict[str, float]) -> list[Sketch | Cylinder]:
    """Return the the outline with tubes and limbs, for the viewer."""
    found = outline(p)
    pieces = [("rear hub", "rear frame", line, 0.016, "#8fa3b3") for line in found.frame]
    pieces += [("head", "front frame", line, 0.016, "#8fa3b3") for line in found.front]
    pieces += [("rear hub", "rear frame", line, d, "#b98a68") for line, d in found.rider]
    skull = found.head + np.array([(0, 0, -0.12), (0.01, 0, 0.11)])
    pieces.append(("rear hub", "rear frame", skull, 0.09, "#b98a68"))
    return [
        Cylinder(point, frame, a.tolist(), b.tolist(), radius, colour=colour)
        for point, frame, line, radius, colour in pieces
        for a, b in zip(line, line[1:], strict=False)
    ]


def animation(results: BicycleResults, path: Path) -> None:
    """Write the kick at 3.5 m/s as an interactive page for the browser: the weave grows."""
    view = View(
        elevation=18,
        azimuth=-115,
        centre="head",
        span=2.4,
        trails=("rear contact", "front contact"),
        sketches=solids(data.BENCHMARK),
    )
    results.kicks[3.5].view(
        path,
        between=(0.0, SHOWN_SECONDS),
        view=view,
        plots=["lean.angle", "steer.angle"],
        title="Uncontrolled bicycle, kicked from the side at 3.5 m/s",
        caption="Below the weave speed of 4.29 m/s the oscillation of lean and steer grows. Nonlinear motion, energy "
        "conserved to 1e-11; the rider is rigid and keeps the hands off.",
    )
