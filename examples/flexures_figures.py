"""Figures of the flexure mechanisms: shapes, stiffness, frequencies, stress and buckling over the range."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from textwrap import fill
from typing import Any

import numpy as np

import flexel as fx
from flexel.apps.view.drawing import shapes
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.apps.view.page import view_modes
from flexel.examples.flexures import (
    CASES,
    GUIDE,
    IDEAL,
    PIVOT,
    STEEL,
    Design,
    FlexureResults,
    RangePoint,
    critical,
    expected_stiffness,
    guided_directions,
)
from flexel.linear.tracking import Branches

NAMES = {"turn x": "about x", "turn y": "about y", "turn z": "about z"}


def pictures(results: FlexureResults, out: Path) -> list[Path]:
    """Write all figures to a folder; return their paths."""
    out.mkdir(parents=True, exist_ok=True)
    files = [out / "flexures_guide.png", out / "flexures_pivot.png"]
    overview(results, GUIDE, files[0], "Parallel leaf-spring guide")
    overview(results, PIVOT, files[1], "Cross-flexure pivot")
    return files + [modes(make, d, out) for make, d in CASES]


def modes(make: Callable[..., fx.Model], d: Design, out: Path) -> Path:
    """Write the lowest modes at rest as an interactive page for the browser."""
    system = make().build()
    state = system.equilibrium()
    path = out / f"flexures_{d.case}_modes.html"
    return view_modes(state, path, system.vibrations(state, count=6), title=f"Modes of the {d.case} at rest")


def overview(results: FlexureResults, d: Design, path: Path, title: str) -> None:
    """Plot six panels of one mechanism."""
    stations = results.guide if d is GUIDE else results.pivot
    travel = np.array([station.travel for station in stations]) * (1e3 if d is GUIDE else 180 / np.pi)
    label = "travel [mm]" if d is GUIDE else "rotation [°]"
    with figure(3, 2, size=(9.0, 10.8)) as (drawn, grid):
        axes = grid.reshape(2, 3)
        _shapes(axes[0, 0], stations, d)
        _stiffness(axes[0, 1], stations, travel, d)
        _frequencies(axes[0, 2], stations, travel)
        _stress(axes[1, 0], stations, travel)
        _buckling(axes[1, 1], stations, travel, d)
        _payload(axes[1, 2], results, d)
        for axis in (axes[0, 1], axes[0, 2], axes[1, 0], axes[1, 1]):
            axis.set_xlabel(label)
            axis.set_xlim(0, travel[-1])
        s = d.section
        drawn.supxlabel(fill(_constrained(d), 105), fontsize=9)
        drawn.suptitle(
            f"{title}: two leaf springs of spring steel, {d.length * 1e3:g} × {s.width * 1e3:g} × {s.height * 1e3:g} mm"
        )
        save(drawn, path)


def _constrained(d: Design) -> str:
    """Describe what is overconstrained if the leaf springs are rigid in their planes."""
    make = next(make for make, design in CASES if design is d)
    found = make(flexible=IDEAL, elements=1).constraint_report()
    names = "; ".join(", ".join(names) for names in found.redundant)
    times = {1: "once", 2: "twice"}.get(len(found.redundant), f"{len(found.redundant)} times")
    return (
        f"With leaf springs rigid in their own planes it is overconstrained {times}: {names} are "
        f"redundant together; releasing {', '.join(found.release)} removes this"
    )


def _shapes(axis: Any, stations: list[RangePoint], d: Design) -> None:
    """Draw the mechanism from above at rest, half way and at the end."""
    chosen = (stations[0], stations[len(stations) // 2], stations[-1])
    for station, shade in zip(chosen, ("#c3ccd4", "#7fa6c9", COLOURS[0]), strict=True):
        _outline(axis, station.state, shade)
    axis.set_aspect("equal")
    axis.set_xlabel("x [mm]")
    axis.set_ylabel("y [mm]")
    axis.set_title("undriven, at half and at full drive")


def _outline(axis: Any, state: fx.State, colour: str) -> None:
    for part in shapes(state):
        if part.style not in ("beam", "bar"):
            continue
        for line in part.lines:
            width = 1.8 if part.style == "beam" else 0.9
            axis.plot(
                1e3 * line[:, 0], 1e3 * line[:, 1], color=colour, lw=width, ls="-" if width > 1 else "--"
            )


def _stiffness(axis: Any, stations: list[RangePoint], travel: Any, d: Design) -> None:
    """Plot the stiffness in the guided directions over that at rest, the drive's travel held."""
    for colour, direction in zip(COLOURS, guided_directions(d), strict=False):
        found = np.array([s.held.stiffness()[direction] for s in stations])
        unit = "N/m" if direction in "xyz" else "N m/rad"
        axis.semilogy(
            travel,
            found / found[0],
            color=colour,
            label=f"{NAMES.get(direction, direction)}: {found[0]:.3g} {unit}",
        )
    axis.set(title="stiffness, drive locked (legend: undriven)", ylabel="stiffness / undriven stiffness [-]")
    axis.legend(fontsize=8)


def _frequencies(axis: Any, stations: list[RangePoint], travel: Any) -> None:
    """Plot natural frequencies, the drive's force constant."""
    found = np.array([station.frequencies for station in stations]) / (2 * np.pi)
    found = np.abs(Branches.of(travel, 1j * found).eigenvalues)  # by continuation, where they cross
    found = found[:, np.argsort(found[-1])]
    for i in range(found.shape[1]):
        axis.semilogy(travel, found[:, i], color=COLOURS[i % len(COLOURS)])
        if i == 0 or found[-1, i] > 1.15 * found[-1, i - 1]:
            axis.text(
                travel[-1], found[-1, i], f" {found[-1, i]:.3g}", fontsize=8, va="center", clip_on=False
            )
    axis.set(title="natural frequencies, drive free", ylabel="frequency [Hz]")


def _stress(axis: Any, stations: list[RangePoint], travel: Any) -> None:
    """Plot the largest equivalent stress."""
    axis.plot(travel, [station.stress.mises / 1e6 for station in stations], color=COLOURS[0])
    axis.set_ylim(bottom=0)
    worst = stations[-1].stress
    safety = f"; safety {worst.safety:.1f}" if worst.safety is not None else ""
    axis.set_ylabel("equivalent stress [MPa]")
    axis.set_title(f"largest stress (yield {(STEEL.strength or np.nan) / 1e6:g} MPa{safety})")


def _buckling(axis: Any, stations: list[RangePoint], travel: Any, d: Design) -> None:
    """Plot the payload along x that buckles the mechanism at each point of the range."""
    for k, (name, exact) in enumerate(zip(("-x", "+x"), critical(d), strict=True)):
        found = np.array([station.buckling[k] for station in stations])
        if np.isfinite(exact):
            axis.plot(travel, found, color=COLOURS[k], label=f"payload in {name}")
            axis.plot(0, exact, "o", color=COLOURS[k], mfc="white", clip_on=False, zorder=5)
    axis.plot([], [], "o", color="#444444", mfc="white", label="closed form")
    axis.set_ylim(bottom=0)
    axis.set(title="buckling payload along x", ylabel="payload [N]")
    axis.legend(fontsize=8)


def _payload(axis: Any, results: FlexureResults, d: Design) -> None:
    """Plot the stiffness of the drive at rest under payload."""
    push, pull = critical(d)
    grid = np.linspace(-push, min(push, pull), 201)[:-1] + 1e-6 * push
    rest = expected_stiffness(d, 1e-6 * push)
    axis.plot(
        grid, [expected_stiffness(d, float(p)) / rest for p in grid], color="#8a8f94", label="closed form"
    )
    loads, found = results.payload[d.case]
    axis.plot(loads, found / rest, "o", color=COLOURS[1], label="computed")
    axis.axhline(0, color="#444444", lw=0.8)
    axis.set_xlabel("payload in +x [N]")
    axis.set(title="stiffness of the drive under payload", ylabel="stiffness / unloaded stiffness [-]")
    axis.legend(fontsize=8)
