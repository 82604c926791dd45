"""How the calls of beams, cables, ropes and tyres change with the model; see `changes`."""

from dataclasses import replace
from typing import Any

import numpy as np

from campaign.calls import Call, Case, Made
from campaign.changes import Change, Inapplicable, changer, options
from campaign.changes_of_calls import deformation, sign_of, unit_of
from campaign.parts_ropes import Line

UP = (0.0, 0.0, 1.0)
BENDING = "M L3 T-2"
BEAM = {
    "EA": "M L T-2",
    "GJ": BENDING,
    "EIy": BENDING,
    "EIz": BENDING,
    "GAy": "M L T-2",
    "GAz": "M L T-2",
    "damping": "T",
    "mass_per_length": "M L-1",
    "inertia_per_length": "M L",
}
CABLE = {"EA": "M L T-2", "EI": BENDING, "mass_per_length": "M L-1", "damping": "T", "bending_damping": "T"}
CONTACT = {
    "dissipation": "T L-1",
    "slip_speed": "L T-1",
    "bristle_stiffness": "L-1",
    "bristle_damping": "T L-1",
}
FORCE = "M L T-2"
TYRE = {"stiffness": "M T-2", "damping": "M T-1", "standstill": "L T-1"}
LAWS: dict[str, dict[str, str]] = {
    "vertical_tyre": {},
    "linear_tyre": {"cornering": FORCE, "camber_stiffness": FORCE, "trail": "L"},
    "calspan_tyre": {},
    "magic_formula": {"load0": FORCE, "rolling_radius": "L", "relaxation": "L"},
}


def _numbers(values: Any) -> tuple[float, ...]:
    return tuple(np.asarray(values).tolist())


def _sized(change: Change, call: Call, units: dict[str, str]) -> Call:
    """The options that have a unit."""
    return options(
        call, **{key: change.size(u, call.options[key]) for key, u in units.items() if key in call.options}
    )


@changer("beam")
def _beam(change: Change, call: Call, case: Case) -> Call:
    new = _sized(change, call, BEAM)
    if "direction" in call.options:
        new = options(new, direction=_numbers(change.vector(call.options["direction"])))
    if "initial_curvature" in call.options:
        bend = np.array(call.options["initial_curvature"]) / change.length
        turned = (
            np.array([-1.0, -1.0, 1.0]) if bend.size == 3 else -1.0
        )  # the z axis of the section is turned over
        new = options(new, initial_curvature=bend * turned if change.mirror else bend)
    return new


@changer("distributed_load")
def _distributed_load(change: Change, call: Call, case: Case) -> Call:
    name, value = call.args
    return replace(call, args=(name, _numbers(change.vector(change.size("M T-2", value)))))


@changer("mass_damping")
def _mass_damping(change: Change, call: Call, case: Case) -> Call:
    return replace(call, args=(call.args[0], change.size("T-1", call.args[1])))


@changer("initial")
def _initial(change: Change, call: Call, case: Case) -> Call:
    name, value = call.args
    new = change.size(unit_of(case, deformation(case, name)), value)
    return replace(call, args=(name, new * sign_of(change, case, name)))


@changer("slope")
def _slope(change: Change, call: Call, case: Case) -> Call:
    return replace(call, args=(call.name, _numbers(change.vector(call.args[1]))))


@changer("cable")
def _cable(change: Change, call: Call, case: Case) -> Call:
    *args, length = call.args
    return _sized(change, replace(call, args=(*args, change.size("L", length))), CABLE)


@changer("clamp", "anchor")
def _same(change: Change, call: Call, case: Case) -> Call:
    return call


@changer("sheave")
def _sheave(change: Change, call: Call, case: Case) -> Call:
    new = _sized(change, call, {"radius": "L"})
    if "axle" in call.options:
        new = options(new, axle=_numbers(change.axial(call.options["axle"])))
    groove = call.options.get("groove")
    if groove is not None and groove.name == "RoundGroove":
        bottom, opening = groove.args
        new = options(new, groove=Made("RoundGroove", (change.size("L", bottom), opening)))
    return new


@changer("rope_contact")
def _rope_contact(change: Change, call: Call, case: Case) -> Call:
    line, surface, contact = call.args
    name, elements, _, _, s, radius = line.args
    (stiffness,), given = contact.args, contact.options
    if change.time != 1 and "bristle_stiffness" in given:
        raise Inapplicable("bristles off the surface straighten at a rate that is always the same")
    # a force per length and depth^exponent, which need not be whole
    new = stiffness * change.mass / change.time**2 / change.length ** given["exponent"]
    sized = {key: change.size(CONTACT[key], z) if key in CONTACT else z for key, z in given.items()}
    moved = Line(name, elements, change.size("L", s), change.size("L", radius))
    return replace(call, args=(moved, surface, Made("Contact", (new,), sized)))


@changer("tyre")
def _tyre(change: Change, call: Call, case: Case) -> Call:
    z = call.options
    new: dict[str, Any] = {
        "radius": change.size("L", z["radius"]),
        "crown": change.size("L", z.get("crown", 0.0)),
        "axle": _numbers(change.axial(z["axle"])),  # to the wheel's left, also in the mirror
    }
    if "road" in z:
        new["road"] = _waves(change, z["road"])
    else:
        normal = change.vector(z.get("normal", UP)) / np.linalg.norm(z.get("normal", UP))
        new["normal"] = _numbers(normal)
        new["height"] = float(change.length * z.get("height", 0.0) + normal @ np.array(change.shift))
    return replace(call, options=new)


def _waves(change: Change, road: Made) -> Made:
    """Waves, which rise along the global z axis."""
    if change.vector(UP)[2] < 1 - 1e-12:
        raise Inapplicable("waves of a road rise along z")
    (amplitude, wavelength), z = road.args, road.options
    heading = change.vector((*z["heading"], 0.0))[:2]
    start = change.length * z["start"] + float(heading @ np.array(change.shift)[:2])
    height = change.length * z.get("height", 0.0) + change.shift[2]
    sizes = (change.size("L", amplitude), change.size("L", wavelength))
    return Made("Waves", sizes, {**z, "start": start, "height": height, "heading": _numbers(heading)})


@changer("attach")
def _attach(change: Change, call: Call, case: Case) -> Call:
    law = call.args[0]
    if law not in LAWS:
        raise Inapplicable(f"no change of the law {law}")
    z = call.options
    new = _sized(change, call, TYRE | LAWS[law])
    force = change.size(FORCE, 1.0)
    if law == "calspan_tyre":
        powers = {"A": (1, 0, 1, 0, 1), "B": (-1, 0, -2)}
        new = options(
            new,
            **{key: _numbers(np.array(z[key]) * force ** np.array(n, float)) for key, n in powers.items()},
        )
        new = options(new, AF=change.size("L", tuple(np.array(z["AF"]) / force)))
    if law == "magic_formula":
        new = options(new, trail=(change.size("L", z["trail"][0]), z["trail"][1]))
        side = change.sign * z["initial"]["tan_alpha"]
        new = options(new, initial={**z["initial"], "tan_alpha": side})
    return new
