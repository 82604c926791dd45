"""Figures of the road vehicle: model, root loci, steering with CALSPAN tyres and without slip, sines, bumps."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from flexel import Box, View
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.apps.view.loci import plot_loci
from flexel.apps.view.plot import animate, draw
from flexel.apps.view.scene import canvas
from flexel.examples import vehicle_data as data
from flexel.examples.vehicle_runs import LOCI, VehicleResults, mode_name
from flexel.examples.vehicle_signals import history, load_histories
from flexel.linear.tracking import Branches
from flexel.results.linearization import Linearization

LABELS = {
    "lateral_acceleration": "lateral acceleration [m/s²]",
    "yaw_rate": "yaw rate [rad/s]",
    "roll": "roll [°]",
    "side_slip": "side-slip angle [°]",
}
TYRES = {"calspan": "CALSPAN tyres", "zero slip": "tyres without slip"}


def pictures(results: VehicleResults, out: Path) -> list[Path]:
    """Write all figures and the animation to a folder; return their paths."""
    out.mkdir(parents=True, exist_ok=True)
    names: dict[str, Callable[[VehicleResults, Path], None]] = {
        "model.png": model,
        "root_loci.png": loci,
        "steer_30.png": steering,
        "sine_steer.png": sines,
        "bumps.png": bumps,
        "bump_antiphase_5.html": animation,
    }
    for name, make in names.items():
        make(results, out / name)
    return [out / name for name in names]


def model(results: VehicleResults, path: Path) -> None:
    """Draw the mechanism in static equilibrium."""
    view = View(elevation=16, azimuth=-62, span=3.0, sketches=bodywork())
    with canvas(results.equilibrium, (7.6, 5.2)) as (drawn, axes):
        draw(results.equilibrium, axes, view)
        note = "Four corners by one function: arm, leaf end as upper link, upright, tie rod, unit, tyre.\n"
        note += "Grey: for display only."
        drawn.text(0.02, 0.03, note, fontsize=9)
        save(drawn, path)


def loci(results: VehicleResults, path: Path) -> None:
    """Plot the eigenvalues of straight running over the speed."""
    followed = branches(results.straight)
    plot_loci(
        followed,
        path,
        label="speed [m/s]",
        names=patterns(followed, results.straight[-1]),
        limits=(-40.0, 1.0),
        title="Eigenvalues of steady straight running, CALSPAN tyres",
    )


def branches(straight: Sequence[Linearization]) -> Branches:
    """Follow eigenvalues over the speed by their modes' shapes, without what nothing restores: place and heading."""
    first = straight[0]
    found = Branches.of(
        np.array(LOCI), [lin.state_matrix for lin in straight], (*first.dynamic, *first.dofs, *first.internal)
    )
    size = np.abs(found.eigenvalues).max(axis=0)
    kept = np.sort(np.argsort(size)[4:])
    assert found.shares is not None
    return replace(found, eigenvalues=found.eigenvalues[:, kept], shares=found.shares[:, kept], matrices=None)


def patterns(followed: Branches, fast: Linearization) -> list[str]:
    """Name the moving parts in each branch at the highest speed, numbered where that says the same of several."""
    modes = fast.modes()
    ends = [followed.eigenvalues[-1, family[0]] for family in followed.families]
    names = [
        mode_name(min(modes, key=lambda m: min(abs(m.eigenvalue - w), abs(m.eigenvalue - w.conj()))))
        for w in ends
    ]
    count = Counter(names)
    return [
        name if count[name] == 1 else f"{name} ({names[: i + 1].count(name)})" for i, name in enumerate(names)
    ]


def steering(results: VehicleResults, path: Path) -> None:
    """Plot ramp-to-step steering at 30 m/s with both kinds of tyres, as in the talk."""
    with figure(3, 2, size=(9.0, 8.0), sharex=True) as (drawn, axes):
        for colour, (tyres, name) in zip(COLOURS, TYRES.items(), strict=False):
            motion = results.steering[30, tyres]
            for panel, signal in zip(axes.flat, LABELS, strict=False):
                panel.plot(motion.t, history(motion, signal), color=colour, label=name)
                panel.set_ylabel(LABELS[signal])
        for panel, (tyres, name) in zip(axes[2], TYRES.items(), strict=True):
            motion = results.steering[30, tyres]
            for corner, load, colour in zip(data.CORNERS, load_histories(motion).T, COLOURS, strict=False):
                panel.plot(motion.t, load / 1000, color=colour, label=corner)
            panel.set_ylabel("tyre loads [kN]")
            panel.set_title(name)
            panel.set_xlabel("time [s]")
        axes[0, 0].legend()
        axes[2, 1].legend()
        drawn.suptitle("Ramp-to-step steering at 30 m/s: 2 mm of the rack in half a second")
        drawn.align_ylabels()
        save(drawn, path)


def sines(results: VehicleResults, path: Path) -> None:
    """Plot the yaw rate in sine steering."""
    with figure(1, size=(8.0, 4.0)) as (drawn, panel):
        for colour, (mm, motion) in zip(COLOURS, results.sines.items(), strict=False):
            panel.plot(motion.t, history(motion, "yaw_rate"), color=colour, label=f"{mm} mm")
        panel.set_xlabel("time [s]")
        panel.set_ylabel("yaw rate [rad/s]")
        panel.legend()
        panel.set_title("Sine steering at 20 m/s, 1 Hz")
        save(drawn, path)


def bumps(results: VehicleResults, path: Path) -> None:
    """Plot height, angle and tyre loads over the cosine bump, in phase and in anti-phase."""
    with figure(3, 2, size=(9.0, 8.0), sharex="col") as (drawn, axes):
        for column, mirrored in enumerate((False, True)):
            for colour, v in zip(COLOURS, (5, 10), strict=False):
                motion = results.bumps[v, mirrored]
                x = motion["chassis.x"]
                axes[0, column].plot(x, 1000 * history(motion, "z"), color=colour, label=f"{v} m/s")
                angle = "roll" if mirrored else "pitch"
                axes[1, column].plot(x, history(motion, angle), color=colour)
                axes[1, column].set_ylabel(f"{angle} [°]")
                loads = load_histories(motion) / 1000
                axes[2, column].plot(x, loads[:, 1], color=colour)
                axes[2, column].plot(x, loads[:, 3], "--", color=colour)
            axes[0, column].set_ylabel("height of chassis [mm]")
            axes[2, column].set_ylabel("load of left tyres [kN]")
            axes[2, column].set_xlabel("x of the chassis [m]")
            axes[0, column].set_title("in anti-phase" if mirrored else "in phase")
        axes[0, 0].legend()
        for label, style in (("front", "-"), ("rear", "--")):
            axes[2, 0].plot([], [], style, color="#444444", label=label)
        axes[2, 0].legend()
        drawn.suptitle("Over a cosine bump: both wheels of an axle in phase, and in anti-phase")
        drawn.align_ylabels()
        save(drawn, path)


def bodywork() -> list[Box]:
    """Return frame and cabin as boxes on the chassis; they have no part in the mechanics."""
    front, rear = data.AXLES["front"], data.AXLES["rear"]
    middle, length = (front + rear) / 2, abs(front - rear)
    sign = float(np.sign(front - rear))
    boxes = [  # colour, centre, sides
        ("#6f8fae", (middle, 0, 0.5), (length + 0.5, 0.3, 0.16)),
        ("#6f8fae", (middle - sign * 0.12 * length, 0, 0.62), (0.55 * length, 0.9, 0.1)),
        ("#9fb6cc", (middle - sign * 0.12 * length, 0, 0.92), (0.42 * length, 0.8, 0.5)),
        ("#6f8fae", (front + sign * 0.05, 0, 0.64), (0.5, 0.3, 0.16)),
    ]
    return [Box("chassis", "body", centre, sides, colour=colour) for colour, centre, sides in boxes]


def animation(results: VehicleResults, path: Path) -> None:
    """Write a page of the drive over the bump with the left wheels, through the hollow with the right, at 5 m/s."""
    view = View(elevation=14, azimuth=-125, centre="chassis", span=3.4, sketches=bodywork())
    title = "Over a bump with the left wheels, through a hollow with the right ones, at 5 m/s"
    animate(results.bumps[5, True], path, fps=15, view=view, title=title)
