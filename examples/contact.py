"""Points, balls and discs in contact with surfaces: impact, sliding, rolling, a ball between the flanks of a groove.

`reproduce` compares each with its closed form.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples.reasons import STEPS
from flexel.examples.rope_exact import hertz
from flexel.results.reproduction import Quantity, Report

G = 9.81  # m/s²
A, MASS = 0.1, 2.0  # radius [m] and mass [kg] of the ball
STIFFNESS = 1e7  # N/m^1.5
SPEED, RESTITUTION = 0.5, 0.8  # of the impact [m/s]
V0, MU = 2.0, 0.25  # of the ball that is thrown along the floor: speed [m/s] and friction
INCLINE, INCLINE_MU, PUSHED = (
    0.6,
    0.3,
    0.5,
)  # angle [rad], friction and first speed [m/s] of the point on an incline
DRUM, TOP = 1.0, 0.3  # radius [m] of the cylinder, and angle [rad] from the top where the ball starts
OPENING, SHEAVE, DRIVE = 1.0, 0.4, 2.0  # of the V groove [rad], radius [m] and speed [rad/s] of the sheave
PRESSED = 1e-4  # how much nearer the idler's axle lies than that of a ball that just touches [m]


def depth(stiffness: float, load: float) -> float:
    """Return the penetration [m] under a load [N]."""
    return float((load / stiffness) ** (2 / 3))


# -- models -----------------------------------------------------------------------------------------


def ground(gravity: tuple[float, ...]) -> fx.Model:
    """Build a model with a fixed point O and a fixed orientation, in space or in the plane."""
    m = fx.Model(gravity=gravity)
    planar = len(gravity) == 2
    m.point("O", (0, 0) if planar else (0, 0, 0), fixed=True)
    (m.angle if planar else m.frame)("ground", fixed=True)
    return m


def add_ball(m: fx.Model, centre: tuple[float, ...] | Array, fixed: bool = False) -> None:
    """Add a uniform ball, or a disc in the plane."""
    m.point("ball", centre, fixed=fixed)
    if len(centre) == 2:
        m.angle("R")
        m.body("mass", "ball", "R", mass=MASS, inertia=MASS * A**2 / 2)
    else:
        m.frame("R")
        m.body("mass", "ball", "R", mass=MASS, inertia=[0.4 * MASS * A**2] * 3)


def dropped(contact: fx.Contact) -> fx.Motion:
    """Drop a ball onto a floor, without gravity."""
    m = ground((0, 0, 0))
    m.plane("floor", "O", "ground")
    add_ball(m, (0, 0, A))
    m.contact("touch", "ball", "floor", contact, frame="R", radius=A)
    m.initial("ball.z", rate=-SPEED)
    duration = 1.3 * hertz(STIFFNESS, MASS, SPEED)[1]
    return m.build().simulate(duration, samples=4001, rtol=1e-10, atol=1e-13)


def thrown(planar: bool = False, slip_speed: float = 1e-3) -> fx.Motion:
    """Throw a ball, or a disc, so that it slides along a floor at first."""
    up = (0.0, 1.0) if planar else (0.0, 0.0, 1.0)
    m = ground(tuple(-G * component for component in up))
    m.plane("floor", "O", "ground", normal=up)
    add_ball(m, (A - depth(STIFFNESS, MASS * G)) * np.array(up))
    contact = fx.Contact(STIFFNESS, friction=MU, slip_speed=slip_speed)
    m.contact("touch", "ball", "floor", contact, frame="R", radius=A)
    m.initial("ball.x", rate=V0)
    return m.build().simulate(1.5 * V0 / (3 * MU * G), samples=501)


def incline(contact: fx.Contact, angle: float) -> fx.Model:
    """Push a point mass downhill on an inclined plane, as deep as its weight presses it."""
    m = ground((0, 0, -G))
    n = np.array([np.sin(angle), 0, np.cos(angle)])
    m.plane("slope", "O", "ground", normal=n)
    m.point("P", -depth(STIFFNESS, MASS * G * np.cos(angle)) * n)
    m.point_mass("mass", "P", MASS)
    m.contact("touch", "P", "slope", contact)
    m.initial("P.x", rate=PUSHED * np.cos(angle))
    m.initial("P.z", rate=-PUSHED * np.sin(angle))
    return m


def on_drum(spin: float) -> fx.Motion:
    """Roll a ball off a cylinder, which turns at a constant speed [rad/s]; it starts at rest, rolling."""
    stiffness = 1e9
    m = ground((0, 0, -G))
    m.frame("F")
    m.hinge("axle", "ground", "F", axis=(0, 1, 0))
    m.prescribe("axle.angle", lambda t: spin * t)
    m.sheave("drum", "O", "F", radius=DRUM, axle=(0, 1, 0))
    distance = DRUM + A - depth(stiffness, MASS * G * np.cos(TOP))
    add_ball(m, distance * np.array([np.sin(TOP), 0, np.cos(TOP)]))
    contact = fx.Contact(stiffness, dissipation=1.0, friction=8.0, slip_speed=1e-3)
    m.contact("touch", "ball", "drum", contact, frame="R", radius=A)
    m.initial(f"{m.angular_velocity('R')}.wy", rate=-spin * DRUM / A)
    return m.build().simulate(1.2, samples=2401)


def idler() -> fx.Motion:
    """Press a ball with its axle into the V groove of a driven sheave."""
    m = ground((0, 0, 0))
    m.frame("F")
    m.hinge("axle", "ground", "F", axis=(0, 0, 1))
    m.prescribe("axle.angle", lambda t: DRIVE * t)
    m.sheave("sheave", "O", "F", radius=SHEAVE, groove=fx.VGroove(OPENING))
    add_ball(m, (SHEAVE + A - PRESSED, 0, 0), fixed=True)
    m.hinge("idler", "ground", "R", axis=(0, 0, 1))
    m.contact("touch", "ball", "sheave", fx.Contact(STIFFNESS, friction=0.3), frame="R", radius=A)
    return m.build().simulate(2.0, samples=101)


# -- closed forms ---------------------------------------------------------------------------------


def leaving_speed(dissipation: float) -> float:
    """Return the speed after an impact by Hunt and Crossley: F(v) = v/a - ln(1 + a v)/a² is the same at both ends."""

    def F(v: float) -> float:  # noqa: N802
        return float(v / dissipation - np.log1p(dissipation * v) / dissipation**2)

    return float(brentq(lambda v: F(-v) - F(SPEED), 1e-6, SPEED, xtol=1e-15))


def rolling(share: float) -> tuple[float, float]:
    """Return the speed and time at which a body with the moment of inertia share m a² begins to roll."""
    return V0 / (1 + share), share / (1 + share) * V0 / (MU * G)


def pressed_rolling(cosine: Array) -> Array:
    """Return the normal force [N] on the ball that rolls off the cylinder, by the cosine of its angle from the top."""
    return np.asarray(MASS * G * (17 * cosine - 10 * np.cos(TOP)) / 7)


def ratio() -> float:
    """Return the idler's speed over the sheave's: a ball between flanks rolls on circles of radius a sin(opening/2)."""
    lever = A * np.sin(OPENING / 2)
    return float(-(SHEAVE + A - PRESSED - lever) / lever)


# -- the table ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ContactResults:
    """All computed results, for the table and for the figures."""

    elastic: fx.Motion
    damped: fx.Motion
    ball: fx.Motion
    disc: fx.Motion
    point: fx.Motion
    drums: dict[float, fx.Motion]  # by the speed of the cylinder
    idler: fx.Motion


def damped_contact() -> fx.Contact:
    """Return the the contact with dissipation."""
    return fx.Contact.restitution(STIFFNESS, RESTITUTION, SPEED)


def analyse() -> ContactResults:
    """Run all analyses."""
    slope = incline(fx.Contact(STIFFNESS, friction=INCLINE_MU, slip_speed=1e-4), INCLINE)
    return ContactResults(
        elastic=dropped(fx.Contact(STIFFNESS)),
        damped=dropped(damped_contact()),
        ball=thrown(),
        disc=thrown(planar=True),
        point=slope.build().simulate(0.5, samples=11),
        drums={spin: on_drum(spin) for spin in (0.0, 3.0)},
        idler=idler(),
    )


def parting(motion: fx.Motion) -> float:
    """Return the time at which an impact ends [s]."""
    gap = motion["touch.gap"]
    last = int(np.flatnonzero(gap < 0)[-1])
    return float(motion.t[last] - gap[last] / motion.rate("touch.gap")[last])


def sliding_time(motion: fx.Motion, slip: str) -> float:
    """Return the time [s] at which sliding would end at its first rate: the sliding velocity falls evenly."""
    fast = motion.rate(slip) > 0.05 * V0
    line = np.polyfit(motion.t[fast], motion.rate(slip)[fast], 1)
    return float(-line[1] / line[0])


def cosines(motion: fx.Motion) -> Array:
    """Return the cosine of the ball's angle from the top of the cylinder, over time."""
    return np.asarray(motion["ball.z"] / np.hypot(motion["ball.x"], motion["ball.z"]))


def drum_rows(spin: float, motion: fx.Motion) -> list[Quantity]:
    """Compare the normal force down to a fifth of the weight, and where the ball leaves."""
    cosine, name = cosines(motion), "turning" if spin else "resting"
    exact = pressed_rolling(cosine)
    early = exact > 0.2 * MASS * G
    error = float(np.abs(motion.force("touch.gap") + exact)[early].max()) / (MASS * G)
    first = int(np.flatnonzero(motion["touch.gap"] > 0)[0])
    source = f"rolling without slip on a {name} cylinder"
    return [
        Quantity(f"drum_{name}_force_error", error, 0.0, 6.2e-5, "", f"{source}, over the weight", kind="closed form"),
        Quantity(f"drum_{name}_leaves", cosine[first], 10 / 17 * np.cos(TOP), 7.4e-3, "",
                 f"{source}, rigid; a Hertzian contact opens a few milliseconds later", kind="closed form"),
    ]  # fmt: skip


def rows(found: ContactResults) -> list[Quantity]:
    """Return every quantity with its closed form."""
    approach, duration = hertz(STIFFNESS, MASS, SPEED)
    left, down = leaving_speed(damped_contact().dissipation), np.sin(INCLINE) - INCLINE_MU * np.cos(INCLINE)

    def row(
        name: str,
        computed: float,
        exact: float,
        tolerance: float,
        unit: str,
        source: str,
        reason: str = STEPS,
    ) -> Quantity:
        return Quantity(name, computed, exact, tolerance, unit, source, kind="closed form", reason=reason)

    made = [
        row("impact_depth", -float(found.elastic["touch.gap"].min()), approach, 3.6e-7, "m", "Hertz 1882", ""),
        row("impact_duration", parting(found.elastic), duration, 2e-9, "s", "Hertz 1882"),
        row("impact_speed", float(found.damped.rate("ball.z")[-1]), left, 5e-8, "m/s",
            "Hunt and Crossley 1975, integrated once"),
        row("incline_speed", float(found.point.rate("touch.x")[-1]), PUSHED + G * down * float(found.point.t[-1]),
            3e-8, "m/s", "v0 + g (sin - mu cos) t"),
        row("groove_ratio", float(found.idler.rate("idler.angle")[-1]) / DRIVE, ratio(), 1e-10, "",
            "rolling at the contacts with both flanks"),
    ]  # fmt: skip
    for name, motion, slip, share in (
        ("ball", found.ball, "touch.x", 2 / 5),
        ("disc", found.disc, "touch.tangential", 1 / 2),
    ):
        speed, time = rolling(share)
        made += [
            row(f"{name}_rolls_with", float(motion.rate("ball.x")[-1]), speed, 2e-9, "m/s", "v0/(1 + k), I = k m a²"),
            row(f"{name}_slides_for", sliding_time(motion, slip), time, 2.5e-6, "s", "k v0/((1 + k) mu g)", ""),
        ]  # fmt: skip
    for spin, motion in found.drums.items():
        made += drum_rows(spin, motion)
    return made


def reproduce(out: Path | None = None) -> Report:
    """Compute all quantities with their closed forms; write figures to `out`, if given."""
    found = analyse()
    files: list[Path] = []
    if out is not None:
        from flexel.examples.contact_figures import pictures

        files = pictures(found, out)
    return Report("contact", rows(found), files)
