"""The table of the road vehicle: every quantity with its reference, and the reason for their difference."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

import flexel as fx
from flexel.examples import vehicle_data as data
from flexel.examples.reasons import PRINTED, ROUNDING
from flexel.examples.vehicle_runs import VehicleResults, mode_name, moving
from flexel.examples.vehicle_signals import (
    SIGNALS,
    at_stop,
    history,
    lifted,
    load_histories,
    loads,
)
from flexel.integration.ranges import outside
from flexel.mechanics.modes import sort_eigenvalues
from flexel.results.linearization import Linearization
from flexel.results.reproduction import Kind, Quantity

DEGREES = {"roll", "pitch", "yaw", "side_slip"}
UNITS = (
    {"yaw_rate": "rad/s", "lateral_acceleration": "m/s2", "z": "m", "speed": "m/s"}
    | dict.fromkeys(DEGREES, "deg")
    | dict.fromkeys(("tyre", "tyre_front", "tyre_rear"), "N")
)
STRAIGHT_BELOW = "tyre loads straight below the wheels' centres: the reading that statics uses"
IN_PLANE = "tyre springs in the planes of the wheels: a second reading of the data"


def quantities(results: VehicleResults) -> list[Quantity]:
    """Return the whole table."""
    parts = (counts, statics, linear, steering, sines, bumps, speed_and_energy)
    return [row for part in parts for row in part(results)]


def counts(results: VehicleResults) -> list[Quantity]:
    """Return the size of the model; the talk's has other elements for the same 10 degrees of freedom."""
    system = results.system
    s = system.structure
    found = system.counts
    sizes = {
        "elements": sum(instance.spec.name not in ("norm", "body", "rotation") for instance in s.instances),
        "deformations": found["deformations"],
        "nodes": len(s.nodes),
        "coordinates": found["coordinates"],
    }
    zero_slip = results.steering[30, "zero slip"].system.counts["degrees_of_freedom"]
    return [
        Quantity("degrees_of_freedom", found["degrees_of_freedom"], 10, 0, "", data.TALK, kind="published"),
        Quantity(
            "degrees_of_freedom_zero_slip",
            zero_slip,
            found["degrees_of_freedom"] - len(data.AXLES),
            0,
            "",
            "one less for each axle, whose mean lateral slip is zero; the talk gives no number for it",
            kind="closed form",
        ),
        *(Quantity(name, n, source=f"the talk's model has {data.TALK_COUNTS[name]}") for name, n in sizes.items()),
        *(Quantity(f"{kind}_nodes", sum(node.kind == kind for node in s.nodes), source=data.TALK_NODES[kind])
          for kind in ("point", "frame")),
        *(Quantity(name, found[name],
                   source="free coordinates are as many as these conditions and the degrees of freedom")
          for name in ("free_coordinates", "rigid_deformations", "norms", "prescribed")),
    ]  # fmt: skip


def suspension_forces(state: fx.State) -> dict[str, float]:
    """Return the forces of the suspension, tension positive, by the names of the table."""
    found: dict[str, float] = {}
    for axle in data.AXLES:
        corner = f"{axle} right"
        found[f"tyre_{axle}"] = loads(state)[data.CORNERS.index(corner)]
        found[f"unit_{axle}"] = state.force(f"{corner} unit.elongation")
        found[f"leaf_{axle}"] = -state.force(f"{corner} leaf.across2")
        found[f"link_{axle}"] = state.force(f"{corner} upper link.along")
    return found


def statics(results: VehicleResults) -> list[Quantity]:
    """Compare forces in the nominal position, and static equilibrium."""
    nominal = suspension_forces(results.nominal)
    nominal |= {"leaf": nominal["leaf_front"], "unit": nominal["unit_front"]}
    printed: Any = {"kind": "published", "tolerance_kind": "absolute", "reason": PRINTED}
    rows = [
        Quantity(f"nominal_{name}", nominal[name], data.NOMINAL[name], 0.05, "N", data.PAPER, **printed)
        for name in ("leaf", "unit")
    ]
    rows += [
        Quantity(
            f"nominal_{name}",
            nominal[name],
            unit="N",
            source=f"published: {data.NOMINAL[name]}, of the level vehicle",
        )
        for name in ("tyre_front", "tyre_rear")
    ]
    rows += [
        Quantity(
            f"level_{name}",
            value,
            data.NOMINAL[name],
            0.05,
            "N",
            f"{data.PAPER}; here by the lever rule",
            **printed,
        )
        for name, value in lever_rule().items()
    ]
    found = suspension_forces(results.equilibrium) | height(results.equilibrium)
    other = suspension_forces(results.in_plane) | height(results.in_plane)
    for name, (value, unit) in data.EQUILIBRIUM.items():
        kind: Kind = "other program" if name == "pitch" else "own"
        rows.append(Quantity(name, found[name], value, data.EQUILIBRIUM_TOLERANCES[name], unit, data.RECOMPUTED,
                             kind=kind, tolerance_kind="absolute"))  # fmt: skip
    rows += [
        Quantity(
            f"{name}_in_plane",
            other[name],
            unit=unit,
            source=IN_PLANE,
            more={"change": other[name] / found[name] - 1},
        )
        for name, (_, unit) in data.EQUILIBRIUM.items()
    ]
    return rows


def height(state: fx.State) -> dict[str, float]:
    """Drop and pitch of the chassis."""
    return {"drop": state["chassis.z"] - data.HEIGHT, "pitch": state["pitch.angle"]}


def lever_rule() -> dict[str, float]:
    """Return the tyre loads of the level vehicle [N] by moments about the axles."""
    front, rear = data.AXLES["front"], data.AXLES["rear"]
    arm, wheel, chassis = (float(part["mass"]) for part in (data.ARM, data.WHEEL, data.CHASSIS))
    own = data.GRAVITY * (arm + wheel)
    body = data.GRAVITY * chassis / (2 * (front - rear))
    return {"tyre_front": own - rear * body, "tyre_rear": own + front * body}


SYMMETRIC = ("hop bounce", "hop pitch", "bounce", "pitch")


def named(lin: Linearization, names: Iterable[str] = SYMMETRIC) -> list[complex]:
    """Return eigenvalues of modes by name, of the symmetric ones by default: both hops, bounce and pitch."""
    found = {
        mode_name(mode): mode.eigenvalue for mode in reversed(lin.modes()) if mode.eigenvalue.imag > 1e-6
    }
    return [found[name] for name in names]


def linear(results: VehicleResults) -> list[Quantity]:
    """Compare the eigenvalues at 20 m/s, and their confirmation."""
    lin = results.linear
    difference = (
        np.abs(lin.state_matrix - results.differentiated).max() / np.abs(results.differentiated).max()
    )
    modes = {
        mode_name(m): [m.eigenvalue.real, m.eigenvalue.imag] for m in lin.modes() if m.eigenvalue.imag > 1e-6
    }
    rightmost = np.array([moving(lin).real.max() for lin in results.straight])
    growing = f"5 ... 40 m/s, {np.count_nonzero(rightmost > 0) or 'no'} speed(s) with a growing mode"
    indicative = "; toe and camber change differ there"
    return [
        Quantity("eigenvalues_20", sort_eigenvalues(lin.eigenvalues()), unit="1/s", source="10 degrees of freedom",
                 more={"modes": modes}),
        Quantity("eigenvalues_20_symmetric", named(lin), list(data.SYMMETRIC), 5e-3, "1/s",
                 data.INDICATIVE + indicative, kind="own"),
        Quantity("eigenvalues_20_no_side_force", named(results.no_side_force),
                 list(data.SYMMETRIC_NO_SIDE_FORCE), 1.5e-3, "1/s", data.INDICATIVE + indicative, kind="own"),
        Quantity("eigenvalues_20_no_side_force_all", named(results.no_side_force, data.NO_SIDE_FORCE),
                 list(data.NO_SIDE_FORCE.values()), 1.2e-3, "1/s", f"{data.ANOTHER}: {', '.join(data.NO_SIDE_FORCE)}",
                 kind="own"),
        Quantity("linearization_error", difference, 0.0, 3e-11, "", "differences of the nonlinear equations",
                 kind="own", reason=ROUNDING),
        Quantity("root_loci_rightmost", rightmost, unit="1/s", source=growing),
    ]  # fmt: skip


def steering(results: VehicleResults) -> list[Quantity]:
    """Compare the ramp-to-step manoeuvre at its end and its peaks, both models."""
    rows = []
    for (v, tyres), motion in results.steering.items():
        compared = tyres == "calspan"
        end, suffix = motion[-1], "" if compared else "_zero_slip"
        source = "" if compared else "no lateral slip in the mean of each axle"
        found = {
            f"{signal}_5s": (signal, SIGNALS[signal](end))
            for signal in ("yaw_rate", "lateral_acceleration", "roll", "speed")
        }
        for signal in data.STEER_PEAKS[v]:
            found[f"{signal}_peak"] = signal, -float(np.abs(history(motion, signal)).max())
        for name, (signal, value) in found.items():
            expected = (data.STEER_PEAKS if name.endswith("peak") else data.STEER_ENDS)[v][signal]
            rows.append(
                rerun(f"{name}_{v}", value, expected, data.STEER_TOLERANCES[name][v], signal)
                if compared
                else Quantity(f"{name}_{v}{suffix}", value, unit=UNITS[signal], source=source)
            )
        slip = SIGNALS["side_slip"](end)
        rows.append(Quantity(f"side_slip_5s_{v}{suffix}", slip, unit="deg", source=source))
        rows.append(
            rerun(f"tyre_loads_5s_{v}", loads(end), data.STEER_LOADS[v], data.LOADS_TOLERANCES[v], "tyre")
            if compared
            else Quantity(f"tyre_loads_5s_{v}{suffix}", loads(end), unit="N", source=source)
        )
    rows += [
        Quantity(
            f"{signal}_5s_30_drop",
            SIGNALS[signal](results.dropped),
            unit=UNITS[signal],
            source=STRAIGHT_BELOW,
        )
        for signal in ("yaw_rate", "roll")
    ]
    return rows


def rerun(name: str, found: ArrayLike, reference: ArrayLike, tolerance: float, signal: str) -> Quantity:
    """Return the row of a number with another program's, known to few digits."""
    reason = PRINTED if tolerance == data.LAST_DIGITS.get(signal) else ""
    return Quantity(name, found, reference, tolerance, UNITS[signal], data.RERUN, kind="other program",
                    tolerance_kind="absolute", reason=reason)  # fmt: skip


def sines(results: VehicleResults) -> list[Quantity]:
    """Compare the range of the yaw rate in sine steering."""
    rows = []
    for mm, motion in results.sines.items():
        rate = history(motion, "yaw_rate")
        found = (float(rate.min()), float(rate.max()))
        name, tolerance = f"sine_steer_{mm}mm_yaw_rate", data.SINE_TOLERANCES[mm]
        rows.append(rerun(name, found, data.SINE_STEER[mm], tolerance, "yaw_rate"))
    return rows


def bumps(results: VehicleResults) -> list[Quantity]:
    """Compare extremes over the bump, wheels that lift off, tyres outside the range of their data."""
    rows = []
    for (v, mirrored), motion in results.bumps.items():
        name = f"bump_{'antiphase' if mirrored else 'in_phase'}_{v}"
        expected = (data.ANTIPHASE if mirrored else data.IN_PHASE)[v]
        forces = load_histories(motion)
        for signal, extremes in expected.items():
            if signal.startswith("tyre"):
                values = forces[:, 1 if signal.endswith("front") else 3]
            else:
                values = history(motion, signal)
            found = (float(values.min()), float(values.max()))
            if mirrored:
                said = f"another program has {extremes[0]:g} ... {extremes[1]:g}, with other forces on slopes"
                rows.append(Quantity(f"{name}_{signal}", found, unit=UNITS[signal], source=said,
                                     more={"other_program": list(extremes)}))  # fmt: skip
            else:
                tolerance = data.IN_PHASE_TOLERANCES[v][signal]
                rows.append(rerun(f"{name}_{signal}", found, extremes, tolerance, signal))
        notes = {"lifted": lifted(motion), "outside_range": outside(motion.system, list(motion))}
        said = (
            "; ".join(f"{key}: {', '.join(named)}" for key, named in notes.items() if named)
            or "all wheels on the road"
        )
        rows.append(Quantity(f"{name}_wheels_lifted", len(notes["lifted"]), source=said, more=notes))
        stopped = at_stop(motion)
        said = f"at the stop: {', '.join(stopped) or 'none'}"
        rows.append(Quantity(f"{name}_leaf_springs_at_stop", len(stopped), source=said))
    return rows


def speed_and_energy(results: VehicleResults) -> list[Quantity]:
    """Compare energy and times of computation."""
    relative = "0; gained + dissipated - driven, relative to what went round"
    lifting = (
        "three quarters of a second at 10 m/s, wheels leave the road and land, leaf springs reach their stops"
    )
    budget = {True: "processor time; budget 0.02 s", False: "processor time; budget 5 s"}
    return [
        Quantity("energy_gap", results.energy, 0.0, 2e-6, "", f"half a second over the bump at 5 m/s: {relative}",
                 kind="closed form"),
        Quantity("energy_gap_lift_off", results.energy_lift_off, 0.0, 6e-5, "", f"{lifting}: {relative}",
                 kind="closed form"),
        *(Quantity(f"seconds_{name}", t, unit="s", source=budget[name == "linearization"])
          for name, t in results.seconds.items()),
    ]  # fmt: skip
