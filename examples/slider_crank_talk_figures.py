"""Figures after slides 23 to 30 of the talk: its model, next to the converged one."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import flexel as fx
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.base.arrays import Array
from flexel.examples import slider_crank_data as data
from flexel.examples.slider_crank import CONVERGED, TIMES, SliderCrankResults, Sweep, amplitudes, deflection
from flexel.examples.slider_crank_branch import Motions, SweptBranches, deflections
from flexel.examples.slider_crank_branch_figures import resonances
from flexel.examples.slider_crank_talk import ELEMENTS, TalkResults
from flexel.linear import periodic

LABEL = "midpoint deflection / l [-]"
Slides = dict[float, TalkResults]
TITLES = "two beams without second-order terms", f"converged: {CONVERGED} beams"
NEAR_FIFTH = 120.0, 185.0  # speeds of the enlarged part [rad/s]
ORDERS = range(1, 7)


def motions(results: SliderCrankResults, slides: Slides, path: Path) -> None:
    """Plot transient and periodic motion, linearized and full, as on slides 23, 25 and 28."""
    with figure(2, 2, size=(11.0, 7.0), sharex="col", sharey=True, width_ratios=(2, 1)) as (drawn, axes):
        for (left, right), (zeta, found) in zip(axes, slides.items(), strict=True):
            for panel, x, curves in (
                (
                    left,
                    TIMES,
                    (deflection(results.transients[zeta]), found.transient, found.linear_transient),
                ),
                (right, None, (results.converged[zeta], found.periodic, found.linear_periodic)),
            ):
                labels = (
                    f"full, converged: {CONVERGED} beams",
                    f"full, {ELEMENTS} beams",
                    f"linearized, {ELEMENTS} beams",
                )
                styles: Any = (
                    {"color": "#bbbbbb", "lw": 3},
                    {"color": COLOURS[0]},
                    {"color": COLOURS[1], "ls": "--"},
                )
                for y, label, style in zip(curves, labels, styles, strict=True):
                    fine = y if x is not None else periodic.refined(y)
                    along = x if x is not None else np.linspace(0, 360, fine.size, endpoint=False)
                    panel.plot(along, fine, label=label, **style)
                panel.axhline(0, color="#999999", lw=0.6)
            left.set_title(f"damping {100 * zeta:g} %: transient", loc="left")
            right.set_title("periodic", loc="left")
            left.set_ylabel(LABEL)
        axes[0, 0].set(xlim=(0, TIMES[-1]), ylim=(-0.0165, 0.022))
        axes[0, 0].legend(loc="upper right", ncols=3)
        axes[1, 0].set_xlabel("time [s]")
        axes[1, 1].set(xlabel="crank angle [°]", xlim=(0, 360), xticks=range(0, 361, 90))
        drawn.suptitle(f"Slides 23, 25 and 28: two beams without second-order terms at {data.SPEED:g} rad/s")
        save(drawn, path)


def sweep(results: SliderCrankResults, followed: SweptBranches, slides: Slides, path: Path) -> None:
    """Plot the largest deflection over the speed, linearized and full on one axis, as on slide 29."""
    with figure(2, 2, size=(11.0, 8.4), sharex="row", sharey="row") as (drawn, axes):
        for row in axes:
            for j, (zeta, found) in enumerate(slides.items()):
                converged, branch = results.swept[zeta], followed.followed[zeta]
                label, colour = f"{100 * zeta:g} %", COLOURS[j]
                _curve(row[0], found.swept, found.maxima, colour, label)
                speeds, values = _speeds(found.slow), deflections(found.slow, ELEMENTS)
                tops = found.full_maxima[found.full_maxima[:, 0] < speeds[-1]]
                row[0].plot(*_inserted(speeds, values, tops), lw=2.0, color=colour)
                _full(row[0], found.fast, deflections(found.fast, ELEMENTS), colour, label)
                _curve(row[1], results.swept_linearized[zeta], results.maxima[zeta], colour, label)
                below = converged.speeds < branch.omega[0] - 1
                speeds = np.append(converged.speeds[below], branch.omega[0])
                values = np.append(converged.largest[below], followed.deflections[zeta][0])
                row[1].plot(speeds, values, lw=2.0, color=colour)
                _full(row[1], branch, followed.deflections[zeta], colour, label)
        for panel, title in zip(axes[0], TITLES, strict=True):
            panel.set_title(title)
            resonances(panel, 0.174)
        for panel in axes[1]:
            resonances(panel, 0.0239, (6, 5))
            panel.set_xlabel("crank speed ω [rad/s]")
        axes[0, 0].set(xlim=(50, 330), ylim=(0, 0.175))
        axes[1, 0].set(xlim=NEAR_FIFTH, ylim=(0.006, 0.024))
        for panel in axes[:, 0]:
            panel.set_ylabel("largest " + LABEL)
        axes[0, 0].legend(loc="upper left")
        drawn.suptitle("Slide 29: largest midpoint deflection over the speed")
        save(drawn, path)


def _inserted(speeds: Array, values: Array, maxima: Array) -> tuple[Array, Array]:
    """Return a curve with its maxima, which lie between its speeds."""
    x, y = np.append(speeds, maxima[:, 0]), np.append(values, maxima[:, 1])
    order = np.argsort(x)
    return x[order], y[order]


def _curve(panel: Any, swept: Sweep, maxima: Array, colour: str, label: str) -> None:
    """Plot the linearized sweep with its maxima."""
    x, y = _inserted(swept.speeds, swept.largest, maxima)
    panel.plot(x, y, "--", lw=1.4, color=colour, label=f"linearized, {label}")


def _full(panel: Any, branch: fx.PeriodicBranch, values: Array, colour: str, label: str) -> None:
    """Plot the full motions of a branch, unstable ones thin."""
    for i, (part, stable) in enumerate(branch.stretches):
        named = f"full, {label}" if i == 0 else None
        panel.plot(branch.omega[part], values[part], lw=2.0 if stable else 0.8, color=colour, label=named)


def _speeds(motions: Motions) -> Array:
    """Return the speeds (n,) of motions [rad/s]."""
    return np.array([motion.omega for motion in motions])


def _amplitudes(motions: Motions, elements: int) -> Array:
    """Return the amplitudes (n, 7) of the harmonics of motions."""
    return np.array([amplitudes(deflection(found.motion, elements)) for found in motions])


def harmonics(results: SliderCrankResults, followed: SweptBranches, slides: Slides, path: Path) -> None:
    """Plot each harmonic over the speed: linearized, quasi-static and full, as on slide 30."""
    with figure(2, 2, size=(11.0, 8.8), sharex=True, sharey=True) as (drawn, axes):
        for row, (zeta, found) in zip(axes, slides.items(), strict=True):
            converged, branch = results.swept[zeta], followed.followed[zeta]
            below = converged.speeds < branch.omega[0] - 1
            panels = (
                (
                    found.swept,
                    np.append(_speeds(found.slow), found.fast.omega),
                    np.vstack([_amplitudes(found.slow, ELEMENTS), _amplitudes(found.fast, ELEMENTS)]),
                ),
                (
                    results.swept_linearized[zeta],
                    np.append(converged.speeds[below], branch.omega),
                    np.vstack([converged.harmonics[below], _amplitudes(branch, CONVERGED)]),
                ),
            )
            for panel, (swept, speeds, full), title in zip(row, panels, TITLES, strict=True):
                for n in ORDERS:
                    colour = COLOURS[n - 1]
                    panel.plot(swept.speeds, swept.harmonics[:, n], color=colour, label=f"{n}")
                    panel.plot(swept.speeds, swept.quasi_static[:, n], "--", color=colour, lw=0.9)
                    panel.plot(speeds, full[:, n], ":", color=colour, lw=1.4)
                panel.set_title(f"{100 * zeta:g} %, {title}", fontsize=11)
                resonances(panel, 0.19)
            row[0].set_ylabel("amplitude of " + LABEL)
        axes[0, 0].set(xlim=(50, 330), yscale="log", ylim=(2e-6, 0.2))
        axes[0, 0].legend(loc="lower right", title="harmonic", ncols=3)
        for panel in axes[1]:
            panel.set_xlabel("crank speed ω [rad/s]")
        drawn.suptitle("Slide 30: harmonics; linearized, quasi-static (dashed) and full (dotted)")
        save(drawn, path)
