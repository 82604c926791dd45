"""Figures of the published beam problems."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from flexel import State, View
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.base.arrays import Array
from flexel.examples import beams_data as data
from flexel.examples import beams_dynamic as dynamic
from flexel.examples import beams_static as static
from flexel.results.reproduction import Quantity

ELEMENTS = 16


def pictures(rows: Sequence[Quantity], out: Path) -> list[Path]:
    """Write all figures to a folder; return their paths."""
    out.mkdir(parents=True, exist_ok=True)
    names: dict[str, Callable[[Sequence[Quantity], Path], None]] = {
        "large_deflections.png": large_deflections,
        "bend_45.png": bend,
        "princeton.png": princeton,
        "convergence.png": convergence,
        "elements_needed.png": elements_needed,
        "rotation.png": rotation,
        "spin_up.png": spin_up,
        "spin_up.html": animation,
    }
    for name, make in names.items():
        make(rows, out / name)
    return [out / name for name in names]


def line(state: State, n: int) -> Array:
    """Return the positions (n + 1, dimension) of the points of a chain."""
    return np.array([state.position(f"P{i}") for i in range(n + 1)])


def large_deflections(rows: Sequence[Quantity], path: Path) -> None:
    """Draw the shapes of the elastica, of the roll-up and of the post-buckled column."""
    with figure(2, 2, size=(9.0, 7.0)) as (drawn, grid):
        axes = grid.flat
        for load, w, u in data.TIP_FORCE:
            axes[0].plot(*line(static.elastica(load, ELEMENTS), ELEMENTS).T, label=f"{load:g}")
            axes[0].plot(1 - u, w, "o", color="black", markersize=4)
        axes[0].set_title("tip force P")
        axes[0].legend(title="PL²/EI")
        for turns in (0.125, 0.25, 0.5, 0.75, 1.0):
            axes[1].plot(*line(static.rolled_up(turns, 32), 32).T, label=f"{turns:g}")
        axes[1].set_title("end moment")
        axes[1].legend(title="turns", loc="center left", bbox_to_anchor=(1.0, 0.5))
        for load, x, y in data.POST_BUCKLED:
            shape = line(static.post_buckled(load, ELEMENTS), ELEMENTS)
            axes[2].plot(*shape.T, label=f"{load:.3g}")
            axes[2].plot(x, y, "o", color="black", markersize=4)
        axes[2].set_title("column")
        axes[2].legend(title="P/Pcr", loc="center left", bbox_to_anchor=(1.0, 0.5))
        axes[3].plot([], [], color="#444444", label=f"{ELEMENTS} elements (end moment: 32)")
        axes[3].plot([], [], "o", color="black", markersize=4, label="elliptic integrals")
        axes[3].legend(loc="center")
        axes[3].set_axis_off()
        for ax in axes[:3]:
            ax.set_aspect("equal")
            ax.set(xlabel="x / L [-]", ylabel="y / L [-]")
        drawn.suptitle("Large deflections of a planar beam")
        save(drawn, path)


def bend(rows: Sequence[Quantity], path: Path) -> None:
    """Draw the 45 degree bend under its loads, from two sides."""
    a = np.linspace(0, np.pi / 4, ELEMENTS + 1)
    start = np.stack([100 * (1 - np.cos(a)), 100 * np.sin(a), 0 * a], axis=1)
    with figure(1, 2, size=(9.0, 4.2)) as (drawn, axes):
        for ax, (i, j) in zip(axes, ((0, 1), (1, 2)), strict=True):
            ax.plot(start[:, i], start[:, j], color="#999999", label="unloaded")
            for row, state in zip(data.BEND_TIPS, static.bend_states(ELEMENTS), strict=True):
                x = line(state, ELEMENTS)
                ax.plot(x[:, i], x[:, j], label=f"{row[0]:g} lbf")
                ax.plot(row[1 + i], row[1 + j], "o", color="black", markersize=4)
            ax.set(xlabel="xyz"[i] + " [in]", ylabel="xyz"[j] + " [in]", aspect="equal")
        axes[0].set_title("from above")
        axes[1].set_title("from the side")
        axes[1].plot([], [], "o", color="black", markersize=4, label="published")
        drawn.suptitle(f"45° bend, {ELEMENTS} elements")
        axes[1].legend()
        save(drawn, path)


def princeton(rows: Sequence[Quantity], path: Path) -> None:
    """Plot flatwise and edgewise deflection and twist of the Princeton beam over the angle of the load."""
    angles = np.array(static.PRINCETON_ANGLES)
    found = np.array([static.princeton_tips(angle, 16) for angle in static.PRINCETON_ANGLES])
    table = np.array(data.PRINCETON_TIPS)
    with figure(3, size=(8.0, 8.4), sharex=True) as (drawn, axes):
        names = (
            ("flatwise deflection [mm]", 2, 1e3),
            ("edgewise deflection [mm]", 1, 1e3),
            ("twist [°]", 3, 180 / np.pi),
        )
        for ax, (title, column, factor) in zip(axes, names, strict=True):
            for k, load in enumerate(sorted(set(table[:, 0]))):
                ax.plot(angles, factor * found[:, k, column], color=COLOURS[k], label=f"{load:g} N")
                exact = table[table[:, 0] == load]
                ax.plot(exact[:, 1], factor * exact[:, 2 + column], "o", color=COLOURS[k], markersize=4)
            ax.set(ylabel=title, xticks=angles)
        axes[0].plot([], [], color="#444444", label="16 elements")
        axes[0].plot([], [], "o", color="#444444", markersize=4, label="exact rod")
        axes[0].legend()
        axes[2].set_xlabel("angle of the load from the width [°]")
        drawn.suptitle("Princeton beam: tip under loads at an angle")
        save(drawn, path)


def convergence(rows: Sequence[Quantity], path: Path) -> None:
    """Plot errors over the mesh."""
    problems = {
        "elastica_1": "elastica, PL²/EI = 1",
        "elastica_10": "elastica, PL²/EI = 10",
        "bend_45": "45° bend",
        "princeton_tip": "Princeton beam",
        "lateral_buckling": "lateral buckling",
        "right_angle_frame": "right-angle frame (a leg)",
    }
    with figure(size=(7.0, 4.8)) as (drawn, ax):
        for row in rows:
            if row.name in problems:
                errors: Any = row.more["errors"]
                last: Any = row.more["elements"]
                meshes = [last / 2 ** (len(errors) - 1 - k) for k in range(len(errors))]
                ax.loglog(meshes, errors, "o-", label=problems[row.name])
        n = np.array([8.0, 32.0])
        ax.loglog(n, 0.03 / n**2, "--", color="black", label="order 2")
        ax.set(
            xlabel="number of elements [-]",
            ylabel="relative error [-]",
            title="Convergence, second-order terms on",
        )
        ax.set_xticks([4, 8, 16, 32], labels=["4", "8", "16", "32"])
        ax.minorticks_off()
        ax.legend(fontsize=8)
        save(drawn, path)


def elements_needed(rows: Sequence[Quantity], path: Path) -> None:
    """Plot the elements needed for 1 % and for 0.1 %, with and without the second-order terms."""
    counted = [row for row in rows if row.name.startswith("elements_for_")]
    place = np.arange(len(counted))
    with figure(1, 2, size=(9.0, 4.6), sharey=True) as (drawn, axes):
        for ax, bound, title in zip(axes, ("1pct", "0.1pct"), ("1 %", "0.1 %"), strict=True):
            for k, (suffix, label) in enumerate((("", "with"), ("_first_order", "without"))):
                found: list[Any] = [row.more[f"elements_{bound}{suffix}"] for row in counted]
                bars = ax.barh(
                    place + 0.4 * k, [count or 0 for count in found], 0.38, color=COLOURS[k], label=label
                )
                ax.bar_label(
                    bars,
                    labels=["none" if count is None else str(count) for count in found],
                    padding=3,
                    fontsize=8,
                )
            ax.margins(x=0.1)  # the numbers next to the bars
            ax.set(title=f"for {title}", xlabel="number of elements [-]")
        names = [row.name.removeprefix("elements_for_").replace("_", " ") for row in counted]
        axes[0].set_yticks(place + 0.2, labels=names)
        axes[0].invert_yaxis()
        axes[1].legend(title="second-order terms", loc="center right")
        drawn.suptitle("Number of elements needed for an error of 1 % and of 0.1 %")
        save(drawn, path)


def rotation(rows: Sequence[Quantity], path: Path) -> None:
    """Plot frequencies of the rotating blade and whirl frequencies of the shaft over the speed."""
    spins, speeds = np.linspace(0, 12, 13), np.linspace(0, 20, 9)
    with figure(1, 2, size=(9.0, 4.2)) as (drawn, (left, right)):
        for k, second_order in enumerate((True, False)):
            found = np.array([dynamic.blade_frequencies(4, spin, 0.0, second_order) for spin in spins])
            label = ("4 elements", "4 elements, no second-order terms")[k]
            left.plot(spins, found[:, :4], ("-", "--")[k], color=COLOURS[k], label=[label, "", "", ""])
        exact = [
            (blade[1], w) for blade in data.ROTATING_BLADES if blade[0] == 0 for w in np.sort(blade[2:])[:4]
        ]
        left.plot(*np.array(exact).T, "o", color="black", markersize=4, label="exact")
        left.set(
            xlabel="spin W √(ρA L⁴/EI) [-]", ylabel="frequency ω √(ρA L⁴/EI) [-]", title="Rotating blade"
        )
        left.legend(fontsize=8)
        whirl = np.array([dynamic.whirl(8, speed) for speed in speeds])
        exact_whirl = np.array([dynamic.whirl_reference(speed) for speed in speeds])
        for k, label in enumerate(("1 backward", "1 forward", "2 backward", "2 forward")):
            right.plot(speeds, np.abs(whirl[:, k]), color=COLOURS[k], label=label)
            right.plot(speeds, np.abs(exact_whirl[:, k]), "o", color="black", markersize=3)
        right.plot([], [], "o", color="black", markersize=3, label="exact")
        right.plot(speeds, speeds, ":", color="#888888", label="ω = W")
        right.set(
            xlabel="spin W √(ρA L⁴/EI) [-]",
            ylabel="frequency |ω| √(ρA L⁴/EI) [-]",
            title="Whirl of a Rayleigh shaft",
        )
        right.legend(fontsize=8)
        save(drawn, path)


def spin_up(rows: Sequence[Quantity], path: Path) -> None:
    """Plot tip displacements of the spin-up beams."""
    with figure(1, 2, size=(9.0, 4.0)) as (drawn, axes):
        for ax, case, title in zip(axes, ("simo", "kane"), ("Simo and Vu-Quoc", "Kane"), strict=True):
            table = dynamic.spin_case(case)[1]
            tip = dynamic.spin_tip(case, 8)
            for k, name in enumerate(("along", "across")):
                ax.plot(table[:, 0], tip[:, k], color=COLOURS[k], label=f"{name}, 8 elements")
                ax.plot(table[:, 0], table[:, 1 + k], "o", color=COLOURS[k], markersize=3, label="reference")
            ax.set(xlabel="time [s]", ylabel="tip displacement [m]", title=title)
        axes[0].legend(fontsize=8)
        drawn.suptitle("Spin-up of a flexible beam")
        save(drawn, path)


def animation(rows: Sequence[Quantity], path: Path) -> None:
    """Write the first spin-up beam as an interactive page for the browser."""
    title = "Spin-up of a flexible beam, after Simo and Vu-Quoc; 8 elements"
    dynamic.spun_up("simo", 8).view(path, view=View(trails=["P8"]), title=title)
