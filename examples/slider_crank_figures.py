"""Figures of the converged slider-crank, and the list of all figures."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from flexel import Box, Cylinder, View
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.base.arrays import Array
from flexel.examples import slider_crank_data as data
from flexel.examples import slider_crank_talk_figures as talk_figures
from flexel.examples.slider_crank import CONVERGED, SliderCrankResults, deflection
from flexel.examples.slider_crank_branch import SweptBranches
from flexel.examples.slider_crank_branch_figures import excitations, floquet, folds
from flexel.examples.slider_crank_talk_figures import LABEL, Slides
from flexel.linear import periodic

ENLARGED = 4.0  # deflection in the picture of the mechanism


def pictures(results: SliderCrankResults, followed: SweptBranches, slides: Slides, out: Path) -> list[Path]:
    """Write all figures to a folder; return their paths."""
    out.mkdir(parents=True, exist_ok=True)
    draw: dict[str, Callable[[Path], None]] = {
        "slider_crank_mechanism.png": lambda path: mechanism(results, path),
        "slider_crank_transient.png": lambda path: transients(results, path),
        "slider_crank_periodic.png": lambda path: motions(results, path),
        "slider_crank_talk.png": lambda path: talk_figures.motions(results, slides, path),
        "slider_crank_sweep.png": lambda path: talk_figures.sweep(results, followed, slides, path),
        "slider_crank_harmonics.png": lambda path: talk_figures.harmonics(results, followed, slides, path),
        "slider_crank_motion.html": lambda path: animation(results, path),
        "slider_crank_excitation.png": lambda path: excitations(followed, path),
        "slider_crank_fold.png": lambda path: folds(followed, path),
        "slider_crank_floquet.png": lambda path: floquet(followed, path),
    }
    for name, make in draw.items():
        make(out / name)
    return [out / name for name in draw]


def shape(motion: Any, k: int) -> tuple[Array, Array]:
    """Return points (2, n) of the deformed rod with its deflection enlarged, and its straight chord, at sample k."""
    state = motion[k]
    nodes = np.array([state.position(name) for name in ("A", *(f"p{i}" for i in range(1, CONVERGED + 1)))])
    along = np.linspace(0.0, 1.0, CONVERGED + 1)
    straight = nodes[0] + along[:, None] * (nodes[-1] - nodes[0])
    fine = np.linspace(0.0, 1.0, 60)
    bent = straight + ENLARGED * (nodes - straight)
    curve = [np.polyval(np.polyfit(along, column, CONVERGED), fine) for column in bent.T]
    return np.array(curve), straight.T


def mechanism(results: SliderCrankResults, path: Path) -> None:
    """Draw the mechanism at six crank angles of the last turn, deflection enlarged."""
    motion = results.transients[0.02]
    period = 2 * np.pi / data.SPEED
    with figure(2, 3, size=(9.0, 5.0), sharex=True, sharey=True) as (drawn, axes):
        for j, panel in enumerate(axes.flat):
            t = period * (1 + j / 6)
            k = int(np.argmin(np.abs(motion.t - t)))
            curve, straight = shape(motion, k)
            panel.plot(
                [0, straight[0, 0]], [0, straight[1, 0]], color=COLOURS[5], lw=4, solid_capstyle="round"
            )
            panel.plot(*straight, "--", color="#999999", lw=0.8)
            panel.plot(*curve, color=COLOURS[0], lw=2)
            panel.plot(*straight[:, [0]], "o", color="white", mec="#222222", zorder=3)
            panel.plot(0, 0, "o", color="white", mec="#222222", zorder=3)
            panel.plot(*straight[:, [-1]], "s", ms=11, color=COLOURS[4], zorder=2)
            panel.axhline(0, color="#999999", lw=0.6)
            panel.set_aspect("equal")
            panel.set_title(f"{60 * j}°, deflection/l = {deflection_at(results, k):+.4f}", fontsize=10)
        drawn.suptitle(
            f"Second turn at {data.SPEED:g} rad/s, 2 % damping; deflection enlarged {ENLARGED:g} times"
        )
        drawn.supxlabel("x [m]", fontsize=10)
        drawn.supylabel("y [m]", fontsize=10)
        save(drawn, path)


def deflection_at(results: SliderCrankResults, k: int) -> float:
    """Return the midpoint deflection of the 2 % transient at a sample."""
    return float(deflection(results.transients[0.02], CONVERGED)[k])


def transients(results: SliderCrankResults, path: Path) -> None:
    """Plot transients from rest of the rod to periodic motion."""
    with figure(2, size=(9.0, 6.0), sharex=True, sharey=True) as (drawn, axes):
        for panel, (zeta, motion) in zip(axes, results.transients.items(), strict=True):
            panel.plot(motion.t, deflection(motion, CONVERGED), color=COLOURS[0], label="transient")
            steady = periodic.refined(results.converged[zeta])
            phase = np.mod(motion.t * data.SPEED / (2 * np.pi), 1.0)
            around = np.append(steady, steady[0])
            held = np.interp(phase, np.linspace(0, 1, around.size), around)
            panel.plot(motion.t, held, "--", color=COLOURS[1], lw=1.2, label="periodic")
            panel.set_title(f"damping {100 * zeta:g} %", loc="left")
            panel.set_ylabel(LABEL)
        axes[0].legend(loc="upper right", ncols=2)
        axes[1].set_xlabel("time [s]")
        axes[1].set_xlim(0, motion.t[-1])
        drawn.suptitle(f"Flexible slider-crank at {data.SPEED:g} rad/s, nonlinear motion")
        save(drawn, path)


def motions(results: SliderCrankResults, path: Path) -> None:
    """Plot one period: linearized and nonlinear, and the harmonics."""
    with figure(1, 2, size=(9.0, 4.4)) as (drawn, (left, right)):
        curves = (
            (results.converged[0.02], "full", "-"),
            (results.converged_linearized[0.02], "linearized", "--"),
        )
        for j, (series, label, style) in enumerate(curves):
            y = periodic.refined(series)
            left.plot(np.linspace(0, 360, y.size, endpoint=False), y, style, color=COLOURS[j], label=label)
            a = np.hypot(*periodic.cosine_sine(series, 8).T)
            right.bar(np.arange(9) + 0.4 * (j - 0.5), a, 0.36, color=COLOURS[j])
        left.set(xlabel="crank angle [°]", ylabel=LABEL, xlim=(0, 360), xticks=range(0, 361, 60))
        left.set_ylim(-0.0145, 0.019)
        left.legend(loc="upper right")
        right.set(
            xlabel="harmonic of the crank speed [-]",
            ylabel="amplitude of " + LABEL,
            yscale="log",
            xticks=range(9),
        )
        drawn.suptitle(f"Periodic motion at {data.SPEED:g} rad/s, 2 % damping, {CONVERGED} elements")
        save(drawn, path)


def animation(results: SliderCrankResults, path: Path) -> None:
    """Write the motion from the straight rod as an interactive page for the browser."""
    p = data.DATA
    end = (p["r"] + p["l"], 0.0, 0.0)
    disc = Cylinder(
        "O", "crank arm", (0, 0, -0.03 * p["l"]), (0, 0, -0.05 * p["l"]), 1.1 * p["r"], colour="#c3ccd4"
    )
    piston = Box(f"p{CONVERGED}", None, end, (0.14 * p["l"], 0.1 * p["l"], 0.08 * p["l"]), colour="#6f8fae")
    results.transients[0.02].view(
        path,
        view=View(trails=["p2"], sketches=[disc, piston]),
        title=f"Slider-crank with a flexible connecting rod, {data.SPEED:g} rad/s",
        caption="2 % damping, from the straight rod; deflections are true to scale.",
    )
