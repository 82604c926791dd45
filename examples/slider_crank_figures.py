"""Pictures of the slider-crank, after slides 23 to 30 of the talk."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from flexel import Box, Cylinder, View
from flexel.base.arrays import Array
from flexel.examples import slider_crank_data as data
from flexel.examples.slider_crank import CONVERGED, Results, deflection
from flexel.examples.slider_crank_branch import Branches
from flexel.examples.slider_crank_branch_figures import excitations, floquet, folds, resonances
from flexel.linear import periodic
from flexel.pictures.figures import COLOURS, figure, save

ENLARGED = 4.0  # deflection in the picture of the mechanism
LABEL = "midpoint deflection / l [-]"


def pictures(results: Results, followed: Branches, out: Path) -> list[Path]:
    """Write all figures into a folder; returns what was written."""
    out.mkdir(parents=True, exist_ok=True)
    names: dict[str, Callable[[Results, Path], None]] = {
        "slider_crank_mechanism.png": mechanism,
        "slider_crank_transient.png": transients,
        "slider_crank_periodic.png": motions,
        "slider_crank_sweep.png": sweep,
        "slider_crank_harmonics.png": harmonics,
        "slider_crank_motion.html": animation,
    }
    for name, make in names.items():
        make(results, out / name)
    more: dict[str, Callable[[Branches, Path], None]] = {
        "slider_crank_excitation.png": excitations,
        "slider_crank_fold.png": folds,
        "slider_crank_floquet.png": floquet,
    }
    for name, draw in more.items():
        draw(followed, out / name)
    return [out / name for name in (*names, *more)]


def shape(motion: Any, k: int) -> tuple[Array, Array]:
    """Points (2, n) of the deformed rod with its deflection enlarged, and its straight chord, at sample k."""
    state = motion[k]
    nodes = np.array([state.position(z) for z in ("A", *(f"p{i}" for i in range(1, CONVERGED + 1)))])
    along = np.linspace(0.0, 1.0, CONVERGED + 1)
    straight = nodes[0] + along[:, None] * (nodes[-1] - nodes[0])
    fine = np.linspace(0.0, 1.0, 60)
    bent = straight + ENLARGED * (nodes - straight)
    curve = [np.polyval(np.polyfit(along, column, CONVERGED), fine) for column in bent.T]
    return np.array(curve), straight.T


def mechanism(results: Results, path: Path) -> None:
    """The mechanism at six crank angles of the last turn, deflection enlarged."""
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


def deflection_at(results: Results, k: int) -> float:
    """Midpoint deflection of the 2 % transient at a sample."""
    return float(deflection(results.transients[0.02], CONVERGED)[k])


def transients(results: Results, path: Path) -> None:
    """From rest of the rod to periodic motion."""
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


def motions(results: Results, path: Path) -> None:
    """One period: linearized and nonlinear, and the harmonics."""
    with figure(1, 2, size=(9.0, 4.4)) as (drawn, (left, right)):
        curves = (
            (results.converged[0.02], f"nonlinear, {CONVERGED} elements", "-"),
            (results.converged_linearized, f"linearized, {CONVERGED} elements", "--"),
            (results.periodic[0.02], "nonlinear, 2 elements of first order", ":"),
        )
        for j, (series, label, style) in enumerate(curves):
            y = periodic.refined(series)
            left.plot(np.linspace(0, 360, y.size, endpoint=False), y, style, color=COLOURS[j], label=label)
            a = np.hypot(*periodic.cosine_sine(series, 8).T)
            right.bar(np.arange(9) + 0.27 * (j - 1), a, 0.25, color=COLOURS[j])
        left.set(xlabel="crank angle [°]", ylabel=LABEL, xlim=(0, 360), xticks=range(0, 361, 60))
        left.set_ylim(-0.0145, 0.019)
        left.legend(loc="upper right")
        right.set(
            xlabel="harmonic of the crank speed [-]",
            ylabel="amplitude of " + LABEL,
            yscale="log",
            xticks=range(9),
        )
        drawn.suptitle(f"Periodic motion at {data.SPEED:g} rad/s, 2 % damping")
        save(drawn, path)


def sweep(results: Results, path: Path) -> None:
    """Largest deflection over the speed: linearized beside nonlinear, as on slide 29."""
    reference = np.array(data.SWEEP)
    with figure(2, size=(8.0, 7.6), sharex=True, sharey=True) as (drawn, axes):
        for j, (zeta, column) in enumerate(((0.01, 1), (0.02, 2))):
            axes[0].plot(results.swept_linearized[zeta].speeds, results.swept_linearized[zeta].largest,
                         color=COLOURS[j], label=f"damping {100 * zeta:g} %")  # fmt: skip
            axes[1].plot(results.swept[zeta].speeds, results.swept[zeta].largest, ".-", color=COLOURS[j],
                         label=f"damping {100 * zeta:g} %")  # fmt: skip
            axes[1].plot(reference[:, 0], reference[:, column], "o", mfc="none", ms=7, color=COLOURS[j], lw=0)
        for panel, title in zip(axes, ("Linearized", "Nonlinear"), strict=True):
            panel.set(title=title, ylabel="largest " + LABEL, ylim=(0, 0.14))
            resonances(panel, 0.139)
            panel.legend(loc="upper left")
        axes[1].plot([], [], "o", mfc="none", ms=7, color="#444444", label="reference")
        axes[1].legend(loc="upper left")
        axes[1].set_xlabel("crank speed ω [rad/s]")
        drawn.suptitle("Largest midpoint deflection over the speed")
        save(drawn, path)


def harmonics(results: Results, path: Path) -> None:
    """Amplitude of each harmonic over the speed, with the quasi-static solution, as on slide 30."""
    with figure(2, size=(8.0, 7.6), sharex=True, sharey=True) as (drawn, axes):
        linear, full = results.swept_linearized[0.02], results.swept[0.02]
        for k in range(1, 7):
            colour = COLOURS[k - 1]
            axes[0].plot(linear.speeds, linear.harmonics[:, k], color=colour, label=f"{k}")
            axes[0].plot(linear.speeds, linear.quasi_static[:, k], "--", color=colour, lw=0.9)
            axes[1].plot(full.speeds, full.harmonics[:, k], ".-", color=colour, label=f"{k}")
        for panel, title in zip(axes, ("Linearized (dashed: quasi-static)", "Nonlinear"), strict=True):
            panel.set(title=title, ylabel="amplitude of " + LABEL, ylim=(0, 0.06))
            resonances(panel, 0.0595)
            panel.legend(loc="upper left", title="harmonic", ncols=2)
        axes[1].set_xlabel("crank speed ω [rad/s]")
        drawn.suptitle("Harmonics of the midpoint deflection, 2 % damping")
        save(drawn, path)


def animation(results: Results, path: Path) -> None:
    """The motion from the straight rod, to be turned and played in a browser."""
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
