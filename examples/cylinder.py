"""A boom on a hydraulic cylinder: the elongation of a truss as a relative coordinate (slide 10 of the SPACAR talk).

A boom turns on a hinge; a cylinder between the ground and a pin of the boom is a truss whose elongation is not rigid.
It is prescribed (the boom is driven, and its force follows), it is the degree of freedom (the boom falls), or a spring
of oil acts on it.  `reproduce` compares all three with the law of cosines and virtual work.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples.reasons import ROUNDING, STEPS
from flexel.results.reproduction import Quantity, Report

ARM = 1.0  # from the hinge to the pin, and from the hinge down to the foot of the cylinder [m]
LENGTH = 3.0  # of the boom; its outer part beyond the pin has the mass [m]
LINEAR_MASS = 4.0  # of the outer part [kg/m]
OUTER = LENGTH - ARM
MASS = LINEAR_MASS * OUTER
MOMENT = LINEAR_MASS * (LENGTH**2 - ARM**2) / 2  # mass times distance of its centre from the hinge [kg m]
INERTIA = LINEAR_MASS * (LENGTH**3 - ARM**3) / 3  # about the hinge [kg m²]
GRAVITY = 9.81  # m/s²
OIL = 1e5  # stiffness of the oil column [N/m]
SECONDS = 1.2
FREE = 0.1  # elongation from which the boom falls [m]


def stroke(t: Any) -> Any:
    """Return the prescribed elongation [m]."""
    return 0.25 * t * np.sin(2 * t)


def stroke_rates(t: Array) -> tuple[Array, Array]:
    """Return its first and second rates."""
    first = 0.25 * (np.sin(2 * t) + 2 * t * np.cos(2 * t))
    return first, np.asarray(np.cos(2 * t) - t * np.sin(2 * t))


# -- the model ------------------------------------------------------------------------------------


def crane() -> fx.Model:
    """Build the boom, drawn level, with its cylinder; nothing acts on the elongation yet."""
    m = fx.Model(gravity=(0, 0, -GRAVITY))
    O, P, T = m.point("O", (0, 0, 0), fixed=True), m.point("P", (ARM, 0, 0)), m.point("T", (LENGTH, 0, 0))
    foot = m.point("foot", (0, 0, -ARM), fixed=True)
    ground, boom = m.frame("ground", fixed=True), m.frame("boom")
    m.hinge("hinge", ground, boom, axis=(0, -1, 0))
    m.beam("inner", O, boom, P)
    m.beam("outer", P, boom, T, mass_per_length=LINEAR_MASS)
    m.truss("cylinder", foot, P)
    return m


def driven() -> fx.System:
    """Build the crane whose elongation is prescribed."""
    m = crane()
    m.prescribe("cylinder.elongation", stroke)
    return m.build()


def falling() -> fx.System:
    """Build the crane whose elongation is the degree of freedom; no force acts on it."""
    m = crane()
    m.independent("cylinder.elongation")
    m.initial("cylinder.elongation", FREE, rate=0.0)
    return m.build()


def on_oil() -> fx.System:
    """Build the crane that rests on a column of oil."""
    m = crane()
    m.independent("cylinder.elongation")
    m.spring("cylinder.elongation", OIL)
    return m.build()


# -- closed forms ---------------------------------------------------------------------------------


def angle(e: Array | float) -> Array:
    """Return the boom's angle above level by the elongation: law of cosines in the triangle foot, hinge, pin."""
    cosine = 1 - (np.sqrt(2.0) + np.asarray(e) / ARM) ** 2 / 2
    return np.asarray(np.arccos(cosine) - np.pi / 2)


def lever(e: Array | float) -> tuple[Array, Array]:
    """Return the first and second derivative of the angle by the elongation [1/m, 1/m²]."""
    phi, length = angle(e), np.sqrt(2.0) * ARM + np.asarray(e)
    slope = length / (ARM**2 * np.cos(phi))  # length² = 2 ARM² (1 + sin φ)
    return slope, np.asarray((1 + (ARM * slope) ** 2 * np.sin(phi)) / (ARM**2 * np.cos(phi)))


def force(e: Array | float, ed: Array | float, edd: Array | float) -> Array:
    """Push of the cylinder [N], by virtual work."""
    slope, bend = lever(e)
    acceleration = slope * edd + bend * np.square(ed)
    return np.asarray((INERTIA * acceleration + MOMENT * GRAVITY * np.cos(angle(e))) * slope)


def oil_frequency(e: float) -> float:
    """Return the angular frequency about the equilibrium on the oil [rad/s]."""
    phi, slope = float(angle(e)), float(lever(e)[0])
    length, arm = np.sqrt(2.0) * ARM + e, 1 / slope
    second = (-(ARM**2) * np.sin(phi) - arm**2) / length  # second derivative of the length by the angle
    push = float(force(e, 0.0, 0.0))
    stiffness = OIL * arm**2 - push * second - MOMENT * GRAVITY * np.sin(phi)
    return float(np.sqrt(stiffness / INERTIA))


# -- the table ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class CylinderResults:
    """All computed results, for the table and for the figures."""

    driven: fx.Motion
    start: fx.State  # of the fall
    fall: fx.Motion
    rest: fx.State  # on oil
    frequency: float


def analyse() -> CylinderResults:
    """Run all analyses."""
    free, sprung = falling(), on_oil()
    rest = sprung.steady()
    return CylinderResults(
        driven=driven().simulate(SECONDS, samples=121),
        start=free.initial,
        fall=free.simulate(0.3, samples=61),
        rest=rest,
        frequency=float(sprung.linearize(rest).eigenvalues().imag.max()),
    )


def rows(found: CylinderResults) -> list[Quantity]:
    """Return every quantity with its closed form."""
    motion = found.driven
    e, (ed, edd) = stroke(motion.t), stroke_rates(motion.t)
    slope, bend = lever(e)
    phi, cosines, work = angle(e), "law of cosines, largest error of the motion", "virtual work"
    fall, oil = found.fall, float(found.rest["cylinder.elongation"])
    energy = INERTIA * fall.rate("hinge.angle") ** 2 / 2 + MOMENT * GRAVITY * np.sin(fall["hinge.angle"])
    lost = float(np.abs(energy - energy[0]).max()) / (MOMENT * GRAVITY)

    def worst(
        name: str, computed: Array, closed: Array, unit: str, source: str, tolerance: float
    ) -> Quantity:
        largest = float(np.abs(computed - closed).max())
        return Quantity(name, largest, 0.0, tolerance, unit, source, kind="closed form", reason=ROUNDING)

    push = motion.drive("cylinder.elongation")
    first = -GRAVITY * MOMENT * float(np.cos(angle(FREE))) / INERTIA
    return [
        worst("angle_max_error", motion["hinge.angle"], phi, "rad", cosines, 1e-12),
        worst("rate_max_error", motion.rate("hinge.angle"), slope * ed, "rad/s", cosines, 1e-12),
        worst(
            "acceleration_max_error", motion.acceleration("hinge.angle"), slope * edd + bend * ed**2,
            "rad/s2", cosines, 1e-12,
        ),
        worst("force_max_error", push, force(e, ed, edd), "N", f"{work}, forces up to {push.max():.0f} N", 3e-10),
        Quantity("acceleration_in_free_fall", found.start.acceleration("hinge.angle"), first, 1e-12, "rad/s2",
                 "physical pendulum, elongation as degree of freedom", kind="closed form"),
        Quantity("energy_of_the_fall", lost, 0.0, 2e-10, "", "of the physical pendulum, over its weight at level",
                 kind="closed form", reason=STEPS),
        Quantity("force_on_oil", -found.rest.force("cylinder.elongation"), float(force(oil, 0.0, 0.0)), 1e-12, "N",
                 work, kind="closed form"),
        Quantity("frequency_on_oil", found.frequency, oil_frequency(oil), 1e-12, "rad/s",
                 "effective stiffness about the equilibrium", kind="closed form"),
    ]  # fmt: skip


def reproduce(out: Path | None = None) -> Report:
    """Compute all quantities with their closed forms; write figures to `out`, if given."""
    found = analyse()
    files: list[Path] = []
    if out is not None:
        from flexel.examples.cylinder_figures import pictures

        files = pictures(found, out)
    return Report("cylinder", rows(found), files)
