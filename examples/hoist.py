"""A hoist whose steel wire rope runs from a drum over two movable sheaves and a fixed one: 30 s of load and lift.

The system of Cao, Du, Ma and Liu (2017); `hoist_data` says which numbers are the paper's and which are chosen here.
The load is applied at once to a rope that is just taut (0 to 10 s), lifted faster and faster (10 to 20 s), and then at
a constant speed (20 to 30 s).
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import hoist_model
from flexel.examples.hoist_data import HOIST, SOURCE, Hoist
from flexel.examples.hoist_model import BEARING_STIFFNESS, CONTACT, Model, axial_frequency, free_length
from flexel.results.report import Quantity, Report

STEP, SAMPLES_PER_SECOND = 4e-3, 50
CLEAR = 0.3  # of the fall at the drum, left out at both ends [m]: elements that bend there stretch unevenly
OURS = "of this model"


@dataclass(frozen=True)
class Results:
    """The motion of the hoist and what is read from it.

    Attributes
    ----------
    tension : ndarray (nt,)
        Mean tension of the straight rope next to the drum [N].
    seconds : float
        That the simulation took.
    """

    model: Model
    motion: fx.Motion
    tension: Array
    seconds: float

    def mean(self, values: Array, begin: float, end: float) -> float:
        """Mean of a history between two times."""
        chosen = (self.motion.t >= begin) & (self.motion.t <= end)
        return float(values[chosen].mean())


def simulate(data: Hoist = HOIST, end: float | None = None) -> Results:
    """Lay the rope, apply the load, and lift it."""
    model = hoist_model.hoist(data)
    begin = time.perf_counter()
    motion = lift(model, end)
    return Results(model, motion, drum_tension(model, motion), time.perf_counter() - begin)


def lift(model: Model, end: float | None = None) -> fx.Motion:
    """The motion from the laid rope on, by default to the end [s] of the data."""
    duration = model.data.end if end is None else end
    return model.system.simulate(
        duration,
        method="generalized-alpha",
        start=model.start,
        step=STEP,
        samples=int(duration * SAMPLES_PER_SECOND) + 1,
    )


def drum_tension(model: Model, motion: fx.Motion) -> Array:
    """Mean tension (nt,) of the straight part of the fall between the drum and the first movable sheave [N]."""
    data, path = model.data, model.rope.path
    s, T = model.rope.tension(motion)
    stretch = path.length / model.rope.s[-1]
    leaves = path.spans()[0][2] / stretch + data.pitch * motion["drive.angle"]
    height = -motion["block.y"]
    found = np.zeros(len(motion))
    for i in range(len(motion)):
        straight = (s > leaves[i] + CLEAR) & (s < leaves[i] + height[i] - CLEAR)
        found[i] = T[i, straight].mean()
    return found


def dynamic_factor(data: Hoist = HOIST) -> float:
    """Largest over static tension where all but a share p of the load is applied at once: p + (1 - p)(1 + exp(…))."""
    zeta, p = data.damping_ratio, data.first_load
    return p + (1 - p) * (1 + float(np.exp(-np.pi * zeta / np.sqrt(1 - zeta**2))))


def hoisting_factor(data: Hoist = HOIST) -> float:
    """Tension at the drum over that without losses, 4/(1 + η + η² + η³): each sheave passes on η of the tension."""
    return 4 / sum(data.efficiency**i for i in range(4))


def settling(data: Hoist = HOIST) -> float:
    """Compliance [m/N] of what carries the rope, at the load: bearings of three sheaves, and the rope's seat on them.

    A rope that carries T presses on a sheave with T/R per length and lies (T/(R k))^(2/3) deep.
    """
    T = data.weight / 4
    depth = CONTACT.depth(T / data.pitch, 0.0)
    return 3 / (4 * BEARING_STIFFNESS) + 3 * float(np.pi) * depth / (CONTACT.exponent * T) / 16


def frequency_with_rope(data: Hoist = HOIST) -> float:
    """Of the load on the rope, whose falls move in proportion to the distance from their upper ends [rad/s]."""
    fall = data.mass_per_length * data.depth
    below = data.mass_per_length * 2 * np.pi * data.pitch
    moving = data.load + 2 * data.sheave_mass + 4 * fall / 3 + below
    return float(1 / np.sqrt((free_length(data) / (16 * data.EA) + settling(data)) * moving))


def measured_frequency(results: Results) -> float:
    """Undamped frequency [rad/s] from the times at which the load turns in half a second; later the bearings stick."""
    t, v = results.motion.t, results.motion.rate("block.y")
    i = np.flatnonzero((v[:-1] * v[1:] < 0) & (t[1:] < 0.5))
    turns = t[i] - v[i] * (t[i + 1] - t[i]) / (v[i + 1] - v[i])
    damped = np.pi / float(np.mean(np.diff(turns)))
    return damped / float(np.sqrt(1 - results.model.data.damping_ratio**2))


def balance_error(motion: fx.Motion) -> float:
    """Largest error of the energy balance over the work and the losses."""
    balance = motion.energy_balance()
    moved = float(np.abs(balance["work"]).max() + np.abs(balance["dissipated"]).max())
    return float(np.abs(balance["error"]).max()) / moved


def quantities(results: Results) -> list[Quantity]:
    """The table."""
    data, motion, T = results.model.data, results.motion, results.tension
    static = data.weight / 4
    strain = T / data.EA
    v, angle = motion.rate("block.y"), float(motion["drive.angle"][-1])
    turned = data.turns + angle / (2 * np.pi)
    budget = {"falls": 4, "turns at the start": data.turns, "turns at the end": round(turned, 3)}
    wound = f"4 falls; {data.turns:g} turns on the drum at the start, {turned:.2f} at the end, in one layer"
    paper = f"{SOURCE}: a reading, 'about 1.8'"
    rows = [
        Quantity("peak_dynamic_factor", T.max() / static, source=paper),
        Quantity("peak_dynamic_factor_ours", T.max() / static, dynamic_factor(data), 0.04, "", OURS,
                 kind="closed form"),
        Quantity("hoisting_factor", results.mean(T, 20, 30) / static, source=f"{SOURCE}: a reading, 'about 1.3'"),
        Quantity("hoisting_factor_ours", results.mean(T, 20, 30) / static, hoisting_factor(data), 3e-3, "", OURS,
                 kind="closed form"),
        Quantity(
            "axial_frequency", measured_frequency(results), frequency_with_rope(data), 0.025, "rad/s",
            f"{OURS}, with the rope's mass, its seat, the bearings; of the massless rope {axial_frequency(data):.3f}",
            kind="closed form",
        ),
        Quantity("static_strain", results.mean(strain, 8, 10), static / data.EA, 5e-3, "", f"{OURS}, W/(4 EA)",
                 kind="closed form"),
        Quantity("peak_strain", strain.max(), source=f"{SOURCE}: a reading, 'can reach 0.004'"),
        Quantity("load_speed_final", results.mean(v, 25, 30), data.speed * data.pitch / 4, 2.5e-3, "m/s", OURS,
                 kind="closed form"),
        Quantity("load_speed_expected", data.speed * data.pitch / 4, None, 0.0, "m/s", "drum and tackle"),
        Quantity("energy_balance_error", balance_error(motion), 0.0, 4e-5, "", "zero; over the work",
                 kind="closed form"),
        Quantity("lift", motion["block.y"][-1] - motion["block.y"][0], None, 0.0, "m", wound, budget),
        Quantity("rope_elements", len(results.model.rope.elements), None, 0.0, "", "56 in the paper"),
        Quantity("contact_points", sum(map(len, results.model.rope.contacts.values())), None, 0.0, "", "1120 there"),
        Quantity("seconds", results.seconds, None, 0.0, "s", "time of the simulation"),
    ]  # fmt: skip
    return rows


def reproduce(out: Path | None = None) -> Report:
    """All quantities beside their references; figures and an animation in `out`, if given."""
    results = simulate()
    files: list[Path] = []
    if out is not None:
        from flexel.examples.hoist_figures import pictures

        files = pictures(results, out)
    return Report("hoist", quantities(results), files)
