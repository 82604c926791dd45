"""A hoist whose steel wire rope runs from a drum over two movable sheaves and a fixed one: load and lift.

The system of Cao, Du, Ma and Liu (2017); `hoist_data` says which numbers are from the paper and which are chosen here.
The load is applied at once to a rope that is just taut (0 to 1 s), lifted faster and faster (1 to 2 s), and then at
a constant speed (2 to 3 s).  A variant takes 30 s, the other reading of the paper's duration.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import hoist_model, hoist_rest
from flexel.examples.hoist_data import HOIST, LONG, WORN, Hoist
from flexel.examples.hoist_model import (
    BEARING_STIFFNESS,
    CONTACT,
    HoistModel,
    Pages,
    axial_frequency,
    free_length,
)
from flexel.results.reproduction import Quantity, Report

STEP, SAMPLES_PER_SECOND = 4e-3, 50
BLOW, BLOW_STEP = 0.2, 1e-3  # the first part, with the peak, and its step [s]
FINE = 112  # elements of the finer mesh
LONG_STEP = 5e-3  # of the 30 s [s]
BUILT_IN: Pages = (None, None)  # the element and law of the rope
FALLS = ("drum to first sheave", "first to upper sheave", "upper to second sheave", "second sheave to anchor")


@dataclass(frozen=True)
class HoistResults:
    """The motion of the hoist and its evaluation.

    Attributes
    ----------
    tension : ndarray (nt, 4)
        In the middle of each fall [N].
    seconds : float
        That the simulation took.
    """

    model: HoistModel
    motion: fx.Motion
    tension: Array
    seconds: float

    def mean(self, values: Array, begin: float, end: float) -> float:
        """Return the mean of a history between two times."""
        chosen = (self.motion.t >= begin) & (self.motion.t <= end)
        return float(values[chosen].mean())

    @property
    def rest(self) -> fx.State:
        """The state just before the lift."""
        return self.motion.nearest(self.model.data.starts)

    @property
    def lifted(self) -> float:
        """Mean tension [N] at the drum while the load is lifted at constant speed."""
        data = self.model.data
        return self.mean(self.tension[:, 0], data.constant, data.end)


def simulate(
    data: Hoist = HOIST,
    end: float | None = None,
    step: float = STEP,
    rate: int = SAMPLES_PER_SECOND,
    pages: Pages = BUILT_IN,
) -> HoistResults:
    """Lay the rope, apply the load, and lift it; by default to the end [s] of the data."""
    model = hoist_model.hoist(data, pages)
    begin = time.perf_counter()
    motion = lift(model, data.end if end is None else end, step, rate)
    return HoistResults(model, motion, fall_tensions(model, motion), time.perf_counter() - begin)


def lift(model: HoistModel, duration: float, step: float = STEP, rate: int = SAMPLES_PER_SECOND) -> fx.Motion:
    """Simulate the motion from the laid rope on, with samples per second from the release of the load on."""
    return model.system.simulate(
        duration + hoist_model.BEFORE,
        method="generalized-alpha",
        start=model.start,
        step=step,
        times=np.arange(round(duration * rate) + 1) / rate,
    )


def fall_tensions(model: HoistModel, motion: fx.Motion) -> Array:
    """Return the tension (nt, 4) in the middle of each fall [N]."""
    data, path = model.data, model.rope.path
    s, T = model.rope.tension(motion)
    stretch = path.length / model.rope.s[-1]
    leaves = path.spans()[0][2] / stretch + data.pitch * motion["drive.angle"]
    height = -motion["block.y"]
    middles = [leaves + height / 2 + k * (height + np.pi * data.pitch) for k in range(3)]
    middles.append(model.rope.s[-1] - (height + data.anchor) / 2)
    return np.array(
        [[np.interp(length, s, T[i]) for length in row] for i, row in enumerate(np.transpose(middles))]
    )


def blow(elements: int, pages: Pages = BUILT_IN) -> HoistResults:
    """Return the motion after the load is applied, with samples close enough for its largest tension."""
    data = replace(HOIST, elements=elements)
    return simulate(data, BLOW, BLOW_STEP, round(1 / BLOW_STEP), pages)


def blow_factor(results: HoistResults) -> float:
    """Return the dynamic factor: the largest tension at the drum over a quarter of the load."""
    return peak(results.tension[:, 0]) / (HOIST.weight / 4)


def blow_factor_by_radau(model: HoistModel) -> float:
    """Return the dynamic factor by another method, of order 5 in minimal coordinates."""
    samples = round(BLOW / 2 / BLOW_STEP) + 1
    motion = model.system.simulate(BLOW / 2, method="Radau", rtol=1e-4, start=model.start, samples=samples)
    return peak(fall_tensions(model, motion)[:, 0]) / (HOIST.weight / 4)


def largest_strain(results: HoistResults) -> float:
    """Return the largest strain of the whole rope at any time."""
    return peak(results.model.rope.strain(results.motion)[1].max(axis=1))


def element_tensions(results: HoistResults, states: fx.Motion | list[fx.State]) -> tuple[Array, Array]:
    """Return mean tension (nt, n) of each element and the local ones (nt, n, places), over a quarter of the load."""
    T = results.model.rope.tension(states)[1] / (results.model.data.weight / 4)
    local = T.reshape(len(T), len(results.model.rope.elements), -1)
    weights = np.polynomial.legendre.leggauss(local.shape[2])[1] / 2
    return local @ weights, local


def peak(values: Array) -> float:
    """Return the largest value of a history at equal steps, on a parabola through the largest sample and neighbours."""
    i = int(np.argmax(values))
    below, top, above = values[i - 1 : i + 2]
    return float(top - (above - below) ** 2 / (8 * (above - 2 * top + below)))


def dynamic_factor(data: Hoist = HOIST) -> float:
    """Return largest over static tension where all but a share p of the load acts at once: p + (1 - p)(1 + exp(…))."""
    zeta, p = data.damping_ratio, data.first_load
    return p + (1 - p) * (1 + float(np.exp(-np.pi * zeta / np.sqrt(1 - zeta**2))))


def hoisting_factor(data: Hoist = HOIST) -> float:
    """Return the tension at the drum over that without losses, 4/(1 + η + η² + η³): each sheave passes on η of it."""
    return 4 / sum(data.efficiency**i for i in range(4))


def static_tension(data: Hoist = HOIST) -> float:
    """Return a quarter of what hangs on the rope: the load and the two movable sheaves [N]."""
    return (data.weight + 2 * data.sheave_mass * 9.81) / 4


def settling(data: Hoist = HOIST) -> float:
    """Return the compliance [m/N] at the load of what carries the rope: bearings of three sheaves, and the rope's seat.

    A rope that carries T presses on a sheave with T/R per length and lies (T/(R k))^(2/3) deep.
    """
    T = data.weight / 4
    depth = CONTACT.depth(T / data.pitch, 0.0)
    return 3 / (4 * BEARING_STIFFNESS) + 3 * float(np.pi) * depth / (CONTACT.exponent * T) / 16


def frequency_with_rope(data: Hoist = HOIST) -> float:
    """Return the frequency [rad/s] with a rope whose falls move in proportion to the distance from their upper ends."""
    fall = data.mass_per_length * data.depth
    below = data.mass_per_length * 2 * np.pi * data.pitch
    moving = data.load + 2 * data.sheave_mass + 4 * fall / 3 + below
    return float(1 / np.sqrt((free_length(data) / (16 * data.EA) + settling(data)) * moving))


def measured_frequency(results: HoistResults) -> float:
    """Return the undamped frequency [rad/s] from the load's turning times in half a second; later bearings stick."""
    t, v = results.motion.t, results.motion.rate("block.y")
    i = np.flatnonzero((v[:-1] * v[1:] < 0) & (t[:-1] > 0) & (t[1:] < 0.5))
    turns = t[i] - v[i] * (t[i + 1] - t[i]) / (v[i + 1] - v[i])
    damped = np.pi / float(np.mean(np.diff(turns)))
    return damped / float(np.sqrt(1 - results.model.data.damping_ratio**2))


def balance_error(motion: fx.Motion) -> float:
    """Return the largest error of the energy balance over the work and the losses."""
    balance = motion.energy_balance()
    moved = float(np.abs(balance["work"]).max() + np.abs(balance["dissipated"]).max())
    return float(np.abs(balance["error"]).max()) / moved


def quantities(results: HoistResults) -> list[Quantity]:
    """Return the table."""
    at_blow, fine, long = blow(HOIST.elements), blow(FINE), simulate(LONG, step=LONG_STEP)
    return [
        *_blow_rows(results, at_blow, fine),
        *_rest_rows(long),
        *_lift_rows(results, long),
        *_paper_rows(results, at_blow, fine),
        *_size_rows(results),
    ]


def _blow_rows(results: HoistResults, at_blow: HoistResults, fine: HoistResults) -> list[Quantity]:
    """Compare the application of the load."""
    factor, strain, data = blow_factor(at_blow), largest_strain(at_blow), results.model.data
    by_radau = blow_factor_by_radau(at_blow.model)
    oscillator = (
        "closed form of an oscillator; over W/4; the rope's mass and its seat on the sheaves are not in it"
    )
    late = results.tension[(results.motion.t > 0.9 * data.starts) & (results.motion.t <= data.starts), 0]
    left = np.ptp(late) / 2 / (data.weight / 4)
    return [
        Quantity("peak_dynamic_factor", factor, dynamic_factor(), 0.025, "", oscillator, kind="closed form"),
        Quantity("peak_dynamic_factor_radau", by_radau, factor, 6e-4, "", "generalized-alpha, steps of 1 ms",
                 kind="own"),
        Quantity(f"peak_dynamic_factor_{FINE}", blow_factor(fine), factor, 4e-3, "", "56 elements", kind="own"),
        Quantity("peak_strain", strain, dynamic_factor() * HOIST.weight / 4 / HOIST.EA, 0.06, "",
                 "the oscillator's factor times W/(4 EA); the largest of the whole rope", kind="closed form"),
        Quantity("axial_frequency", measured_frequency(results), frequency_with_rope(data), 0.02, "rad/s",
                 f"the rope's mass, its seat, the bearings; of the massless rope {axial_frequency(data):.3f}",
                 kind="closed form"),
        Quantity("vibration_left", left, None, 0.0, "",
                 "half the range of the tension at the drum from 0.9 to 1 s, over W/4; the paper: stable at about 1 s"),
    ]  # fmt: skip


def _rest_rows(results: HoistResults) -> list[Quantity]:
    """Compare the load at rest."""
    model, rest, data = results.model, results.rest, results.model.data
    ratios, pressure = (
        hoist_rest.tension_ratios(model, rest),
        hoist_rest.worst(hoist_rest.pressure_ratios(model, rest)),
    )
    layer, edge = hoist_rest.boundary_layer(model)
    free = "mean of each free part, in proportion over the arcs"
    return [
        Quantity("tension_at_rest_min_ratio", ratios.min(), 1.0, 0.02, "", free, kind="closed form"),
        Quantity("tension_at_rest_max_ratio", ratios.max(), 1.0, 0.02, "", free, kind="closed form"),
        Quantity("contact_pressure_worst_ratio", pressure, 1.0, 0.1, "",
                 "T/R, two elements and more from run-on and run-off", kind="closed form"),
        Quantity("static_strain", results.mean(results.tension[:, 0], data.starts - 2, data.starts) / data.EA,
                 static_tension(data) / data.EA, 2.4e-3, "", "load and sheaves, over 4 EA", kind="closed form"),
        Quantity("wire_bending_stress", hoist_rest.wire_stress(model, rest), data.wire_stress(1 / data.pitch), 0.04,
                 "N/m²", "E d_wire/D, wires that slide on one another", kind="closed form"),
        Quantity("boundary_layer", layer, None, 0.0, "m", "sqrt(EI/T): a seventeenth of an element, not resolved"),
        Quantity("edge_force", edge, None, 0.0, "N", "sqrt(EI T)/R at run-on and run-off, not resolved"),
    ]  # fmt: skip


def _lift_rows(results: HoistResults, long: HoistResults) -> list[Quantity]:
    """Compare the lift of the load."""
    data, motion = results.model.data, results.motion
    v, angle = motion.rate("block.y"), float(motion["drive.angle"][-1])
    turned = data.turns + angle / (2 * np.pi)
    budget = {"falls": 4, "turns at the start": data.turns, "turns at the end": round(turned, 3)}
    wound = f"4 falls; {data.turns:g} turns on the drum at the start, {turned:.2f} at the end, in one layer"
    worn, expected = simulate(WORN), data.speed * data.pitch / 4
    losses = "4/(1 + η + η² + η³), η = {:g}; over the load and the movable sheaves"
    slow = long.mean(long.motion.rate("block.y"), LONG.constant + 5, LONG.end)
    return [
        Quantity("hoisting_factor", results.lifted / static_tension(data), hoisting_factor(data), 1.5e-4, "",
                 losses.format(data.efficiency), kind="closed form"),
        Quantity("hoisting_factor_30_s", long.lifted / static_tension(LONG), hoisting_factor(LONG), 2e-3, "",
                 losses.format(LONG.efficiency), kind="closed form"),
        Quantity("hoisting_factor_closed_form", hoisting_factor(data), None, 0.0, "", losses.format(data.efficiency)),
        Quantity("hoisting_factor_worn", worn.lifted / static_tension(WORN), hoisting_factor(WORN), 1.2e-3, "",
                 losses.format(WORN.efficiency), kind="closed form"),
        Quantity("load_speed_final", results.mean(v, data.constant + 0.5, data.end), expected, 5e-3, "m/s",
                 "drum and tackle", kind="closed form"),
        Quantity("load_speed_final_30_s", slow, expected, 1.2e-3, "m/s", "drum and tackle", kind="closed form"),
        Quantity("load_speed_expected", expected, None, 0.0, "m/s", "drum and tackle"),
        Quantity("energy_balance_error", balance_error(motion), 0.0, 5e-4, "", "zero; over the work",
                 kind="closed form"),
        Quantity("energy_balance_error_30_s", balance_error(long.motion), 0.0, 5e-5, "", "zero; over the work",
                 kind="closed form"),
        Quantity("lift", motion["block.y"][-1] - motion["block.y"][0], None, 0.0, "m", wound, budget),
    ]  # fmt: skip


def _paper_rows(results: HoistResults, at_blow: HoistResults, fine: HoistResults) -> list[Quantity]:
    """Compare the paper's element, equation (8), with the built-in one: means of elements and local values over W/4."""
    from flexel.examples.hoist_paper_element import paper_element  # SymPy

    pages, places = paper_element(), "five places of each element"
    hit, hit_fine = blow(HOIST.elements, pages), blow(FINE, pages)
    lifted = simulate(end=HOIST.end, pages=pages)
    rows = []
    for name, theirs, own in (("", hit, at_blow), (f"_{FINE}", hit_fine, fine)):
        means, local = element_tensions(theirs, theirs.motion)
        reference = peak(element_tensions(own, own.motion)[0].max(axis=1))
        rows += [
            Quantity(f"paper_element_peak{name}", peak(means.max(axis=1)), reference, 0.03 if not name else 4e-3, "",
                     "flexel's element; the largest mean of an element of the whole rope", kind="own"),
            Quantity(f"paper_element_peak_local{name}", local.max(), None, 0.0, "", f"the largest of {places}"),
        ]  # fmt: skip
    for case, found in (("", results), ("paper_", lifted)):
        for when, states in (
            ("rest", [found.rest]),
            ("lifting", list(found.motion)[-SAMPLES_PER_SECOND // 2 :]),
        ):
            local = element_tensions(found, states)[1]
            rows += [
                Quantity(f"{case}element_{when}_least", local.min(), None, 0.0, "", "local, over W/4"),
                Quantity(f"{case}element_{when}_most", local.max(), None, 0.0, "", "local, over W/4"),
            ]
    rows.append(Quantity("paper_element_strain", largest_strain(hit), None, 0.0, "",
                         "its strain on the sheaves is wrong; the paper: .4, 0.004 by one reading"))  # fmt: skip
    return rows


def _size_rows(results: HoistResults) -> list[Quantity]:
    """Compare size and cost."""
    rope = results.model.rope
    return [
        Quantity("rope_elements", len(rope.elements), None, 0.0, "", "56 in the paper"),
        Quantity("contact_points", sum(map(len, rope.contacts.values())), None, 0.0, "", "1120 in the paper"),
        Quantity("seconds", results.seconds, None, 0.0, "s", "time of the simulation"),
    ]  # fmt: skip


def reproduce(out: Path | None = None) -> Report:
    """Compute all quantities with their references; write figures and an animation to `out`, if given."""
    results = simulate()
    files: list[Path] = []
    if out is not None:
        from flexel.examples.hoist_figures import pictures

        files = pictures(results, out)
    return Report("hoist", quantities(results), files)
