"""Figures of balls in contact: impact, from sliding to rolling, off a cylinder."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from flexel import View
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.examples.contact import MASS, SPEED, V0, A, ContactResults, G, cosines, pressed_rolling, rolling


def pictures(found: ContactResults, out: Path) -> list[Path]:
    """Write all figures to a folder; return their paths."""
    out.mkdir(parents=True, exist_ok=True)
    overview, page = out / "contact.png", out / "contact.html"
    with figure(3, size=(8.0, 9.6)) as (drawn, axes):
        impact(found, axes[0])
        sliding(found, axes[1])
        drum(found, axes[2])
        save(drawn, overview)
    found.drums[3.0].view(page, view=View(trails=["ball"]), title="A ball rolls off a turning cylinder")
    return [overview, page]


def impact(found: ContactResults, axes: Any) -> None:
    """Plot force over penetration, without and with dissipation."""
    for label, motion, colour in (
        ("elastic", found.elastic, COLOURS[0]),
        ("with dissipation", found.damped, COLOURS[1]),
    ):
        axes.plot(-1e3 * motion["touch.gap"], -1e-3 * motion.force("touch.gap"), color=colour, label=label)
    axes.set(
        xlabel="penetration [mm]", ylabel="force [kN]", title=f"Impact at {SPEED} m/s", xlim=(-0.05, None)
    )
    axes.legend(loc="upper left")


def sliding(found: ContactResults, axes: Any) -> None:
    """Plot the speed of the centre and of the rim of the ball and the disc, until they roll."""
    for label, motion, slip, share, colour in (
        ("ball", found.ball, "touch.x", 2 / 5, COLOURS[0]),
        ("disc", found.disc, "touch.tangential", 1 / 2, COLOURS[1]),
    ):
        speed, time = rolling(share)
        centre = motion.rate("ball.x")
        axes.plot(motion.t, centre, color=colour, label=f"{label}: centre")
        axes.plot(
            motion.t, centre - motion.rate(slip), "--", color=colour, label=f"{label}: turning times radius"
        )
        axes.plot(time, speed, "o", ms=6, mfc="none", color=colour)
    axes.plot([], [], "o", ms=6, mfc="none", color="#222222", label="closed form: it rolls")
    axes.set(xlabel="time [s]", ylabel="speed [m/s]", title="Thrown along a floor", ylim=(0, 1.05 * V0))
    axes.legend(loc="lower right", ncols=2)


def drum(found: ContactResults, axes: Any) -> None:
    """Plot the normal force over the angle from the top, until the ball leaves."""
    for (spin, motion), colour, style in zip(found.drums.items(), COLOURS, ("-", "--"), strict=False):
        angle = np.degrees(np.arccos(cosines(motion)))
        force = -motion.force("touch.gap") / (MASS * G)
        axes.plot(angle, force, style, color=colour, label=f"cylinder turns at {spin:g} rad/s")
    angle = np.linspace(angle[0], 60, 15)
    exact = pressed_rolling(np.cos(np.radians(angle))) / (MASS * G)
    axes.plot(angle[exact > 0], exact[exact > 0], "o", ms=5, mfc="none", color="#222222", label="closed form")
    axes.set(xlabel="angle from the top [°]", ylabel="normal force / weight [-]", xlim=(angle[0], 65))
    axes.set_title(f"A ball of {A:g} m rolls off a cylinder")
    axes.legend(loc="upper right")
