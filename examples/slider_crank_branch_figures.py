"""Figures of the slider-crank's excitation, of its nonlinear motions past the fold, and of their stability."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import flexel as fx
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.base.arrays import Array
from flexel.examples import slider_crank_data as data
from flexel.examples.slider_crank import CONVERGED, omega0
from flexel.examples.slider_crank_branch import BOTH, SweptBranches, peaks

NEAR = 245.0, 285.0  # speeds shown about the folds [rad/s]


def resonances(panel: Any, top: float, orders: tuple[int, ...] = (6, 5, 4, 3)) -> None:
    """Mark fractions of the first natural frequency."""
    w = omega0(CONVERGED)
    for n in orders:
        panel.axvline(w / n, color="#999999", lw=0.8, ls="--")
        panel.text(
            w / n, top, f"$\\omega_0/{n}$", ha="right", va="top", rotation=90, fontsize=10, color="#444444"
        )


def excitations(found: SweptBranches, path: Path) -> None:
    """Plot the excitation of each harmonic of the first mode: directly, by varying stiffness, and together."""
    titles = f"{CONVERGED} elements", "2 elements without second-order terms"
    with figure(1, 2, size=(9.0, 4.6), sharey=True) as (drawn, axes):
        for panel, rows, title in zip(axes, (found.excited, found.excited_first_order), titles, strict=True):
            for j, label in enumerate(("direct", "by varying stiffness", "together")):
                panel.bar(
                    rows[:, 0] + 0.27 * (j - 1), np.abs(rows[:, j + 1]), 0.25, color=COLOURS[j], label=label
                )
            panel.set(yscale="log", xlabel="harmonic of the crank speed [-]", ylim=(1e-7, 3e-2), title=title)
        axes[0].set_ylabel("static midpoint deflection / l [-]")
        axes[1].legend(loc="upper right")
        drawn.suptitle("Excitation of the first mode by harmonic n at the speed ω₀/n")
        save(drawn, path)


def _curve(panel: Any, branch: fx.PeriodicBranch, values: Array, colour: str, label: str) -> None:
    """Plot values over the speed, dashed where unstable, with the folds."""
    w = branch.omega
    for i, (part, stable) in enumerate(branch.stretches):
        panel.plot(
            w[part], values[part], "-" if stable else "--", color=colour, label=label if not i else None
        )
    panel.plot(w[branch.folds], values[branch.folds], "o", ms=5, color=colour)


def folds(found: SweptBranches, path: Path) -> None:
    """Plot the largest deflection over the speed through the folds, with the reference and two stable motions."""
    reference = np.array(data.SWEEP)
    with figure(2, size=(8.0, 8.0), sharey=True) as (drawn, axes):
        for panel in axes:
            for j, (zeta, branch) in enumerate(found.followed.items()):
                _curve(panel, branch, found.deflections[zeta], COLOURS[j], f"damping {100 * zeta:g} %")
                panel.plot(reference[:, 0], reference[:, 1 + j], "o", mfc="none", ms=7, color=COLOURS[j])
            panel.plot([], [], "--", color="#444444", label="unstable")
            panel.plot([], [], "o", ms=5, color="#444444", label="fold")
            panel.plot([], [], "o", mfc="none", ms=7, color="#444444", label="reference")
            panel.set(xlabel="crank speed ω [rad/s]", ylabel="largest midpoint deflection / l [-]")
        one = found.followed[0.01]
        axes[0].set(xlim=(one.omega.min(), one.omega.max()), ylim=(0, 0.125))
        resonances(axes[0], 0.1245, (4, 3))
        axes[1].legend(loc="lower right")
        axes[1].set_xlim(NEAR)
        axes[1].axvline(BOTH, color="#999999", lw=0.8)
        axes[1].text(BOTH, 0.002, f"{BOTH:g} rad/s", rotation=90, va="bottom", ha="right", color="#444444")
        for i, place in zip(one.folds, ((40, -40), (-30, 10)), strict=True):
            axes[1].annotate(
                f"{one.omega[i]:.2f}", (one.omega[i], found.deflections[0.01][i]), place, ha="center",
                textcoords="offset points", arrowprops={"arrowstyle": "-", "color": "#999999"},
            )  # fmt: skip
        drawn.suptitle("Nonlinear periodic motions followed by arc length")
        save(drawn, path)


def floquet(found: SweptBranches, path: Path) -> None:
    """Plot moduli of the largest Floquet multipliers along the branches."""
    with figure(size=(9.0, 4.8)) as (drawn, axes):
        for j, (zeta, branch) in enumerate(found.followed.items()):
            _curve(axes, branch, branch.modulus, COLOURS[j], f"damping {100 * zeta:g} %")
            for w, modulus in peaks(branch):
                axes.plot(w, modulus, "v", ms=6, color=COLOURS[j])
                place = 8, -12 if 0.95 < modulus < 1 else 3  # clear of the line at 1
                axes.annotate(f"{modulus:.3f}", (w, modulus), place, textcoords="offset points")
            speeds = np.linspace(branch.omega.min(), branch.omega.max(), 200)
            damped = np.exp(-zeta * omega0(CONVERGED) * 2 * np.pi / speeds)
            axes.plot(speeds, damped, ":", color=COLOURS[j], lw=1)
        axes.plot([], [], ":", color="#444444", lw=1, label="rod at rest: exp(-ζ ω₀ T)")
        axes.plot([], [], "v", ms=6, color="#444444", label="largest")
        axes.axhline(1, color="#222222", lw=0.8)
        axes.set(
            xlabel="crank speed ω [rad/s]", ylabel="modulus of the largest multiplier [-]", ylim=(0.5, 1.5)
        )
        axes.legend(loc="upper left")
        axes.set_title("Floquet multipliers of the nonlinear motions: stable below 1")
        save(drawn, path)
