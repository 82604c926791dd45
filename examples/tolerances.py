"""Tolerances of a flexure stage: how far its natural frequencies scatter when it is made many times.

The parallel leaf-spring guide of `flexel.examples.flexures`, with the thickness of each leaf spring, their
free length, Young's modulus and the mass of the shuttle drawn from normal distributions: a Latin hypercube of
stages, each built and analysed by `fx.sweep`.  The lowest frequency has a closed form at each point, and its
scatter follows from the propagation of errors; the frequencies of the leaf springs themselves are reported.
`fx.sweep` needs joblib and xarray, the extra ``sweep``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import flexures_exact as exact
from flexel.examples.flexures import GUIDE, SPACING, STEEL, leaf
from flexel.examples.reasons import SAMPLE
from flexel.parts.materials import Profile
from flexel.results.reproduction import Quantity, Report

COUNT = 256  # stages
ELEMENTS = 2  # of each leaf spring: four change the lowest frequency by 2e-7 of it, the others by 1.5 %
MODES = 3
PERCENTILES = (5, 50, 95)
DEVIATIONS = {  # standard deviations over the values themselves
    "left": 0.01,  # thickness of a leaf spring: 4 µm of 0.4 mm
    "right": 0.01,
    "length": 0.5e-3,  # 0.05 mm of 100 mm
    "modulus": 0.01,
    "mass": 4e-3,  # 2 g of 0.5 kg
}
NOMINAL = {
    "left": GUIDE.section.height,
    "right": GUIDE.section.height,
    "length": GUIDE.length,
    "modulus": STEEL.E,
    "mass": GUIDE.mass,
}


def build(left: float, right: float, length: float, modulus: float, mass: float) -> fx.Model:
    """Build the guide with leaf springs of these thicknesses [m], their length [m], modulus [Pa], and its mass [kg]."""
    m, material = fx.Model(), replace(STEEL, E=modulus)
    m.point(GUIDE.point, (length / 2, 0, 0))
    m.frame(GUIDE.frame)
    m.body("shuttle body", GUIDE.point, GUIDE.frame, mass=mass, inertia=(GUIDE.inertia,) * 3)
    for name, y, thickness in (("left", -SPACING / 2, left), ("right", SPACING / 2, right)):
        ends = np.array([0, y, 0.0]), np.array([length, y, 0.0])
        section = replace(GUIDE.section, height=thickness)
        leaf(m, name, ends, (GUIDE.point, GUIDE.frame), section, None, ELEMENTS, material)
    return m


def analyse(system: fx.System) -> dict[str, Any]:
    """Compute the lowest natural frequencies [Hz]."""
    from xarray import DataArray

    found = np.array([mode.omega for mode in system.vibrations(count=MODES)]) / (2 * np.pi)
    return {"frequency": DataArray(found, {"mode": range(1, MODES + 1)}, "mode", attrs={"units": "Hz"})}


def stages(count: int = COUNT) -> fx.Points:
    """Draw the sample: the same at each call."""
    from scipy.stats import norm

    return fx.sample(
        {name: norm(NOMINAL[name], DEVIATIONS[name] * NOMINAL[name]) for name in NOMINAL}, count, seed=2017
    )


def expected(point: Mapping[str, float]) -> float:
    """Return the lowest frequency [Hz] in closed form, for two equal leaf springs of the mean stiffness and mass."""
    material = replace(STEEL, E=point["modulus"])
    profiles = [Profile(replace(GUIDE.section, height=point[side]), material) for side in ("left", "right")]
    EI = float(np.mean([profile.stiffness()["EIz"] for profile in profiles]))
    rhoA = float(np.mean([profile.mass()[0] for profile in profiles]))
    return exact.guided_frequency(EI, point["length"], rhoA, point["mass"] / 2) / (2 * np.pi)


def spread() -> float:
    """Return the relative standard deviation of the lowest frequency to first order: f² is as E (t1³ + t2³)/(L³ m)."""
    parts = (
        1.5 * DEVIATIONS["left"],
        1.5 * DEVIATIONS["right"],
        3 * DEVIATIONS["length"],
        DEVIATIONS["modulus"],
        DEVIATIONS["mass"],
    )
    return 0.5 * float(np.linalg.norm(parts))


def reproduce(out: Path | None = None) -> Report:
    """Compare percentiles and scatter with their closed forms; a figure of the distribution in `out`, if given."""
    points = stages()
    found = fx.sweep(build, points, analyse).frequency.values
    closed = np.array([expected(points.point(i)) for i in range(len(points))])
    files: list[Path] = []
    if out is not None:
        from flexel.examples.tolerances_figures import distribution

        files = [distribution(found, closed, out / "tolerances.png")]
    return Report("tolerances", rows(found, closed), files)


def rows(found: Array, closed: Array) -> list[Quantity]:
    """Return the table, from frequencies (points, modes) and those of the closed form (points,)."""
    lowest = found[:, 0]
    table = [
        Quantity(f"lowest_p{p}", float(np.percentile(lowest, p)), float(np.percentile(closed, p)),
                 7e-5, "Hz", exact.FREQUENCY, kind="closed form")
        for p in PERCENTILES
    ]  # fmt: skip
    table.append(
        Quantity("largest_difference", float(np.abs(lowest / closed - 1).max()), 0.0, 7e-5, "",
                 exact.FREQUENCY, kind="closed form")
    )  # fmt: skip
    table.append(
        Quantity("scatter", float(lowest.std(ddof=1) / lowest.mean()), spread(), 0.13, "",
                 "propagation of errors, first order", kind="closed form", reason=SAMPLE)
    )  # fmt: skip
    for mode in range(1, MODES):
        table += [
            Quantity(f"mode_{mode + 1}_p{p}", float(np.percentile(found[:, mode], p)), unit="Hz")
            for p in PERCENTILES
        ]
    return table
