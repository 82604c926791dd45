"""A flexible two-link manipulator: linearized along its workspace, regulated by a linear design, run nonlinearly.

Two slender links in a horizontal plane, each of two beam elements, with motors at shoulder and elbow and a payload.
Each motor works between its link and a frame that is turned as commanded, so that the measured joint angles are the
errors.  A linear-quadratic regulator of joints and bending, designed at one position of the elbow, is compared
with proportional-derivative control of the joints alone, which is all that a rigid arm would need.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy.linalg import solve_continuous_are

import flexel as fx
from flexel.base.arrays import Array

JOINTS = ("shoulder.angle", "elbow.angle")
BENDS = tuple(f"{link}{i}.bend{j}" for link in ("upper", "lower") for i in (1, 2) for j in (1, 2))
TIP = ("lower end.x", "lower end.y", "lower end.x'", "lower end.y'")
MEASURED = (*JOINTS, *BENDS)
ELBOWS = np.radians(np.arange(10.0, 131.0, 10.0))  # workspace; folded further, the arm needs other gains
DESIGN = np.radians(90.0)  # elbow at which the regulator is designed
START, END, SECONDS = np.radians([0.0, 120.0]), np.radians([80.0, 40.0]), 1.0  # shoulder and elbow, duration


@dataclass(frozen=True)
class Arm:
    """Data of the manipulator: links, motors and payload in SI units."""

    length: float = 1.0
    mass_per_length: float = 0.8
    EI: float = 60.0
    damping: float = 2e-4  # ratio of damping to stiffness [s]
    hub: float = 0.05  # inertia of each motor [kg m²]
    motor: float = 1.0  # mass of each motor [kg]
    payload: float = 0.5


@dataclass(frozen=True)
class Gains:
    """u = -P y - D y' on the joints, y the measured angles and bending."""

    P: Array
    D: Array
    measured: tuple[str, ...] = MEASURED


# -- models ---------------------------------------------------------------------------------------


def manipulator(
    shoulder: Any = 0.0,
    elbow: Any = 0.0,
    gains: Gains | None = None,
    arm: Arm | None = None,
    rigid: bool = False,
) -> fx.System:
    """Build the arm with joints commanded to given angles (numbers or functions of time), with or without control."""
    arm = arm or Arm()
    m = fx.Model()
    m.point("base", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    for name in ("shoulder frame", "hub", "elbow frame", "root"):
        m.angle(name)
    _link(m, "upper", "base", "hub", 0.0, arm, rigid)
    _link(m, "lower", "upper end", "root", arm.length, arm, rigid)
    m.hinge("shoulder command", "ground", "shoulder frame")
    m.hinge("shoulder", "shoulder frame", "hub")
    m.hinge("elbow command", "hub" if rigid else "upper end angle", "elbow frame")
    m.hinge("elbow", "elbow frame", "root")
    m.body("shoulder motor", "base", "hub", mass=arm.motor, inertia=arm.hub)
    m.body("elbow motor", "upper end", "root", mass=arm.motor, inertia=arm.hub)
    m.point_mass("payload", "lower end", arm.payload)
    m.prescribe("shoulder command.angle", shoulder)
    m.prescribe("elbow command.angle", elbow)
    m.independent(*(JOINTS if rigid else MEASURED))
    if gains is not None:
        inputs = [*gains.measured, *(f"{name}'" for name in gains.measured)]
        m.controller(np.hstack([gains.P, gains.D]), inputs=inputs, outputs=JOINTS)
    return m.build()


def _link(m: fx.Model, name: str, start: str, root: str, x: float, arm: Arm, rigid: bool) -> None:
    """Add a link of two beam elements, drawn along the x axis."""
    mid, end = f"{name} mid", f"{name} end"
    m.point(mid, (x + arm.length / 2, 0))
    m.point(end, (x + arm.length, 0))
    if rigid:
        m.beam(f"{name}1", start, root, mid, rigid=True, mass_per_length=arm.mass_per_length)
        m.beam(f"{name}2", mid, root, end, rigid=True, mass_per_length=arm.mass_per_length)
        return
    m.angle(f"{mid} angle")
    m.angle(f"{end} angle")
    data: Any = {"EIz": arm.EI, "mass_per_length": arm.mass_per_length, "damping": arm.damping}
    m.beam(f"{name}1", start, root, mid, f"{mid} angle", **data)
    m.beam(f"{name}2", mid, f"{mid} angle", end, f"{end} angle", **data)


def move(start: float, end: float, seconds: float) -> Callable[[Any], Any]:
    """Return a command from rest to rest, by the polynomial of least jerk."""

    def angle(t: Any) -> Any:
        fraction = np.minimum(np.maximum(t / seconds, 0.0), 1.0)
        return start + (end - start) * fraction**3 * (10 - 15 * fraction + 6 * fraction**2)

    return angle


# -- design ---------------------------------------------------------------------------------------


def workspace(elbows: Sequence[float] | Array = ELBOWS, gains: Gains | None = None) -> list[fx.Linearization]:
    """Linearize at rest over the positions of the elbow; the shoulder's position does not matter."""
    return [manipulator(0.0, float(elbow), gains).linearize() for elbow in elbows]


def regulator(lin: fx.Linearization, lead: float = 0.15, effort: float = 1e-5) -> Gains:
    """Return the linear-quadratic regulator: displacement and velocity of the payload against the torques.

    Parameters
    ----------
    lead : float
        Weight of the velocity of the payload against its displacement [s].
    effort : float
        Weight of the torques against the displacement [1/N²].
    """
    A, B, C, _ = lin.state_space(JOINTS, TIP)
    weights = np.diag([1.0, 1.0, lead, lead])
    Q = (weights @ C).T @ (weights @ C)
    R = effort * np.eye(len(JOINTS))
    X = solve_continuous_are(A, B, Q, R)
    D, P = np.split(np.linalg.solve(R, B.T @ X), 2, axis=1)
    return Gains(P, D, lin.dynamic)


def joint_control(lin: fx.Linearization, omega: float = 8.0) -> Gains:
    """Return proportional-derivative control of the joints alone, critically damped at `omega` [rad/s] if rigid."""
    joints = [lin.dynamic.index(name) for name in JOINTS]
    M = lin.M[np.ix_(joints, joints)]
    return Gains(omega**2 * M, 2 * omega * M, JOINTS)


def manoeuvre(gains: Gains, seconds: float = 3.0, samples: int = 301, tolerance: float = 1e-5) -> fx.Motion:
    """Simulate the nonlinear closed loop while both joints are commanded to new angles, and after.

    The implicit method follows it: bending vibrations of the links that are of no interest make the loop stiff.
    """
    shoulder, elbow = (move(a, b, SECONDS) for a, b in zip(START, END, strict=True))
    return manipulator(shoulder, elbow, gains).simulate(
        seconds, method="generalized-alpha", samples=samples, rtol=tolerance
    )


def tip_error(motion: fx.Motion) -> Array:
    """Return the distance (nt,) of the payload from where rigid links would hold it at the commanded angles [m]."""
    a, b = motion["shoulder command.angle"], motion["elbow command.angle"]
    l = Arm().length
    wanted = l * np.column_stack([np.cos(a) + np.cos(a + b), np.sin(a) + np.sin(a + b)])
    return np.asarray(np.linalg.norm(motion.position("lower end") - wanted, axis=1))


# -- pictures -------------------------------------------------------------------------------------


def pictures(out: Path) -> list[Path]:
    """Plot poles over the workspace, tip errors and torques of both controllers, and the arm on its way."""
    from flexel.apps.view.figures import COLOURS, figure, save

    out.mkdir(parents=True, exist_ok=True)
    design = manipulator(0.0, DESIGN).linearize()
    both = {"joints only": joint_control(design), "regulator": regulator(design)}
    with figure(1, 2, (9.0, 4.6), sharey=True) as (drawn, axes):
        for panel, (name, gains) in zip(axes, both.items(), strict=True):
            for elbow, lin in zip(ELBOWS, workspace(ELBOWS, gains), strict=True):
                w = lin.eigenvalues()
                panel.scatter(w.real, w.imag, c=np.full(w.size, np.degrees(elbow)), cmap="viridis", vmin=0, vmax=180,
                              marker="x", s=22)  # fmt: skip
            panel.set(xlim=(-40, 2), ylim=(0, 120), title=name, xlabel="real part [1/s]")
            panel.axvline(0, color="#222222", lw=0.8)
        axes[0].set_ylabel("imaginary part [rad/s]")
        drawn.colorbar(axes[1].collections[0], ax=axes, label="angle of the elbow [°]")
        drawn.suptitle("Closed-loop eigenvalues over the pose")
    save(drawn, out / "manipulator_poles.png")
    motions = {name: manoeuvre(gains) for name, gains in both.items()}
    with figure(3, 1, (8.0, 7.0), sharex=True) as (drawn, axes):
        for colour, (name, motion) in zip(COLOURS, motions.items(), strict=False):
            axes[0].plot(motion.t, 1e3 * tip_error(motion), color=colour, label=name)
            for panel, joint in zip(axes[1:], JOINTS, strict=True):
                panel.plot(motion.t, -motion.force(joint), color=colour, label=name)
                panel.set_ylabel(f"moment, {joint.removesuffix('.angle')} [N m]")
        axes[0].set_ylabel("error of the tip [mm]")
        axes[0].legend(loc="upper right")
        axes[-1].set_xlabel("time [s]")
        axes[0].set_title("The same manoeuvre with two controllers")
    save(drawn, out / "manipulator_closed_loop.png")
    motions["regulator"].plot_shapes(0.0, 0.25, 0.5, 0.75, 1.0, path=out / "manipulator_shapes.png")
    return [out / f"manipulator_{name}.png" for name in ("poles", "closed_loop", "shapes")]


def main(out: Path) -> fx.Motion:
    """Draw everything under a folder and return the motion with the regulator; `flexel run` calls this and keeps it."""
    for file in pictures(out):
        print(f"wrote {file}")
    return manoeuvre(regulator(manipulator(0.0, DESIGN).linearize()))


if __name__ == "__main__":
    main(Path("out/manipulator"))
