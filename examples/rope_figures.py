"""Figures of the rope problems with their closed forms."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from flexel.apps.view.figures import COLOURS, figure, save
from flexel.base.arrays import Array
from flexel.examples import rope_data as data
from flexel.examples import rope_drums as drums
from flexel.examples import rope_exact as exact
from flexel.examples import rope_hanging as hanging
from flexel.examples import rope_hoists as hoists
from flexel.examples import rope_models as models
from flexel.examples import rope_pendulums as pendulums
from flexel.examples import rope_sheaves as sheaves
from flexel.examples import rope_swings as swings
from flexel.examples import rope_waves as waves
from flexel.model.state import State
from flexel.parts.cable_results import cable_tension
from flexel.results.reproduction import Quantity


def pictures(rows: Sequence[Quantity], out: Path) -> list[Path]:
    """Write all figures to a folder; return their paths."""
    out.mkdir(parents=True, exist_ok=True)
    names: dict[str, Callable[[Path], None]] = {
        "rope_catenary.png": catenary,
        "rope_pulse.png": pulse,
        "rope_pendulum.png": pendulum,
        "rope_wrapping.png": wrapping,
        "rope_capstan.png": capstan,
        "rope_atwood.png": atwood,
        "rope_winding_hoist.png": winding_hoist,
        "rope_drum.png": drum,
        "rope_convergence.png": lambda path: convergence(rows, path),
    }
    for name, make in names.items():
        make(out / name)
    return [out / name for name in names]


def curve(state: State, name: str, n: int) -> Array:
    """Return the centre line (9 n, 2) of a planar cable line of n elements."""
    return np.concatenate([state.outputs(f"{name}{i + 1}")["line"] for i in range(n)])


def catenary(path: Path) -> None:
    """Plot a hanging cable of six elements on the closed form, and its tension."""
    case, n = exact.CATENARY, 6
    state = hanging.catenary(case, n)
    u = np.linspace(0, 1, 61)
    closed = np.array([case(value) for value in u])
    with figure(1, 2, (9.0, 3.8)) as (drawn, axes):
        axes[0].plot(*closed.T, color=COLOURS[5], lw=1, label="closed form (Irvine)")
        axes[0].plot(*curve(state, "rope", n).T, "--", color=COLOURS[0], label="6 elements")
        points = np.array([state.position(f"rope_p{i}") for i in range(n + 1)])
        axes[0].plot(*points.T, "o", color=COLOURS[0], ms=4)
        axes[0].set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
        axes[0].legend(loc="upper left")
        axes[1].plot(u * case.L0, np.hypot(case.H, case.V - case.w * u * case.L0), color=COLOURS[5], lw=1)
        for i in range(n):
            s, T = cable_tension(state, f"rope{i + 1}")
            axes[1].plot(i * case.L0 / n + s, T, "o", color=COLOURS[0], ms=3)
        axes[1].set(xlabel="undeformed length [m]", ylabel="tension [N]", title="tension at the Gauss points")
        drawn.suptitle("A hanging cable of six elements")
        save(drawn, path)


def pulse(path: Path) -> None:
    """Plot a pulse of tension that passes the middle of the rope and comes back from a heavier or lighter one."""
    with figure(2, 1, (8.0, 5.5), sharex=True) as (drawn, axes):
        for panel, ratio in zip(axes, (4.0, 0.25), strict=True):
            t, T, given = waves.pulse(20, ratio)
            panel.plot(t, T, color=COLOURS[0], label="20 elements")
            panel.plot(t[::10], given[::10], "o", ms=3, color=COLOURS[1], label="d'Alembert")
            panel.set(ylabel="tension / Z₁v [-]", title=f"second rope of {ratio:g} times the mass")
        axes[0].legend()
        axes[1].set_xlabel("time t c/L [-]")
        save(drawn, path)


def pendulum(path: Path) -> None:
    """Draw shapes of the soft pendulum of the literature, and the tip of a stiffer one with its reference."""
    n, E = 32, 0.7e9
    motion = swings.pendulum(swings.SOFT, n)
    with figure(1, 2, (9.0, 4.2)) as (drawn, axes):
        for i in range(0, 21, 2):
            shade = 0.25 + 0.75 * i / 20
            axes[0].plot(*curve(motion[i], "rod", n).T, color=COLOURS[0], alpha=shade)
        axes[0].set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title="E = 0.7 MPa, every 0.1 s")
        t = np.linspace(0, 1, 21)
        for k, label in enumerate("xy"):
            axes[1].plot(t, swings.tip(E, 8, 1e-3)[:, k], color=COLOURS[k], label=f"{label}, 8 elements")
            axes[1].plot(t, data.TIPS[E][:, k], "o", ms=4, color=COLOURS[k], label=f"{label}, assumed modes")
        axes[1].set(xlabel="time [s]", ylabel="position of the tip [m]", title="E = 0.7 GPa")
        drawn.suptitle("Flexible pendulums released from the horizontal")
        axes[1].legend(fontsize=8)
        save(drawn, path)


def wrapping(path: Path) -> None:
    """Draw bobs that swing on ropes over a sheave, one held at its other end, one with a mass there."""
    cases = {"held at its other end": pendulums.HELD, "1.2 kg at its other end": pendulums.TURNING}
    with figure(1, 2, (9.0, 4.8)) as (drawn, axes):
        for panel, (title, case) in zip(axes, cases.items(), strict=True):
            motion, rope = pendulums.motion(case, 56)
            for i, colour in ((0, COLOURS[3]), (37, COLOURS[0])):
                shape = np.array([motion[i].position(point.name) for point in rope.points])
                panel.plot(*shape.T, color=colour, label=f"rope at {motion.t[i]:g} s")
            given = pendulums.exact(case, np.linspace(0, case.duration, 301))
            panel.plot(*given.T, color=COLOURS[5], lw=1, label="Lagrange's equations")
            panel.plot(
                *pendulums.path(case, 56)[::5].T, "o", ms=3, color=COLOURS[1], label="bob, every 0.1 s"
            )
            angle = np.linspace(0, 2 * np.pi, 90)
            panel.plot(models.WHEEL * np.cos(angle), models.WHEEL * np.sin(angle), color=COLOURS[4], lw=0.8)
            panel.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title=title)
        axes[0].legend(fontsize=8)
        drawn.suptitle("Bobs that swing on ropes over a sheave")
        save(drawn, path)


def capstan(path: Path) -> None:
    """Plot the ratio of the tensions over the wrap."""
    wraps = np.linspace(0, 560, 57)
    with figure(1, 1, (8.0, 4.5)) as (drawn, panel):
        for mu, colour in zip(sheaves.FRICTIONS, COLOURS, strict=False):
            panel.plot(wraps, np.exp(mu * np.radians(wraps)), color=colour, label=f"μ = {mu:g}")
            found = [
                sheaves.capstan_ratio(mu, wrap, sheaves.capstan_elements(wrap)) for wrap in sheaves.WRAPS
            ]
            panel.plot(sheaves.WRAPS, found, "o", color=colour)
        panel.set(
            xlabel="wrap [°]", ylabel="tension held over tension pulled [-]", yscale="log", xlim=(0, 560)
        )
        panel.set_title("A drum that slides under a rope (dots) and exp(μφ) (lines)")
        panel.legend()
        save(drawn, path)


def atwood(path: Path) -> None:
    """Plot fall and tensions at both ends, with a heavy and with a light rope."""
    t = np.linspace(0, 0.3, 61)
    with figure(1, 2, (9.0, 4.0)) as (drawn, axes):
        for mass, colour in ((1.0, COLOURS[0]), (0.01, COLOURS[1])):
            motion, rope = sheaves.atwood_motion(56, mass)
            L = float(rope.s[-1])
            fall = exact.atwood_fall(t, rope=mass, length=L, radius=models.WHEEL, **sheaves.ATWOOD)
            axes[0].plot(t, fall, color=colour, label=f"rope of {mass * L:.2g} kg")
            axes[0].plot(motion.t, motion["A.y"][0] - motion["A.y"], "o", ms=3, color=colour)
            tension = rope.tension(list(motion))[1]
            for end, style in ((0, "-"), (-1, "--")):
                axes[1].plot(motion.t, tension[:, end], style, color=colour)
        axes[0].set(xlabel="time [s]", ylabel="fall of 3 kg against 2 kg [m]")
        axes[0].legend(title="closed form; 56 elements (dots)")
        drawn.suptitle("Atwood's machine with a rope")
        axes[1].set(xlabel="time [s]", ylabel="tension at 3 kg, at 2 kg (dashed) [N]")
        save(drawn, path)


def winding_hoist(path: Path) -> None:
    """Plot depth of the load and tension while a drum winds the rope up."""
    n = hoists.MESHES[-1]
    t, depth, tension = hoists.wound_up(n)
    fine = np.linspace(0, 3, 1201)
    given = hoists.reduced(fine, True)
    labels = "depth of the load [m]", "tension over the weight [-]"
    with figure(2, 1, (8.0, 5.5), sharex=True) as (drawn, axes):
        for panel, found, closed, label in zip(axes, (depth, tension), given, labels, strict=True):
            panel.plot(fine, closed, color=COLOURS[5], lw=0.9, label="one degree of freedom")
            panel.plot(t, found, "o", ms=3, color=COLOURS[0], label=f"{n + 3} elements on a drum")
            panel.set_ylabel(label)
        axes[1].legend()
        axes[0].set_title("A drum winds up a rope with a load")
        axes[1].set_xlabel("time [s]")
        save(drawn, path)


def drum(path: Path) -> None:
    """Draw a rope on a drum with a helical groove before, while and after it is wound up, and its axial position."""
    motion, rope = drums.wound()
    with figure(1, 2, (9.0, 4.8)) as (drawn, axes):
        for i, colour in zip((0, 10, 20), COLOURS, strict=False):
            nodes = np.array([motion[i].position(point.name) for point in rope.points])
            label = f"{abs(motion['axle.angle'][i]) / (2 * np.pi):.0f}"
            axes[0].plot(nodes[:, 0], nodes[:, 2], color=colour, label=label)
            along, radius, angle = drums.places(motion[i], rope).T
            on = radius < 1.001 * drums.RADIUS
            axes[1].plot(
                (angle[on] - angle[on].min()) / (2 * np.pi), along[on], "o", ms=4, color=colour, label=label
            )
        axes[0].set(xlabel="along the axle [m]", ylabel="height [m]", xlim=(-0.12, 0.08), ylim=(-0.6, 0.25))
        axes[0].set_title("seen from the side on which the load hangs")
        drawn.suptitle("A rope wound up in the helical groove of a drum")
        axes[0].locator_params(axis="x", nbins=4)
        axes[1].set(xlabel="angle from the end of the wound part [turns]")
        axes[1].set(ylabel="along the axle [m]", title="wound part, lead 0.03 m")
        axes[0].legend(title="turns of the drum", loc="lower right")
        save(drawn, path)


def convergence(rows: Sequence[Quantity], path: Path) -> None:
    """Plot errors over the meshes of all problems that have them."""
    listed = [row.more for row in rows]
    names = [row.name for row in rows]
    with figure(1, 1, (9.0, 6.0)) as (drawn, panel):
        drawn_rows = [(name, row) for name, row in zip(names, listed, strict=True) if "errors" in row]
        for i, (name, more) in enumerate(drawn_rows):
            style: Any = {"color": COLOURS[i % len(COLOURS)], "marker": "osv^D*"[i // len(COLOURS)], "ms": 4}
            label = f"{name.removesuffix('_error')} ({more['order']:.1f})"
            panel.plot(more["meshes"], more["errors"], lw=1, label=label, **style)
        panel.set(
            xscale="log",
            yscale="log",
            xlabel="elements (steps: hertz, sudden_load) [-]",
            ylabel="relative error [-]",
        )
        panel.legend(title="order at the last two", fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
        save(drawn, path)
