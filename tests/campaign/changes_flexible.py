"""How beams, cables, ropes and tyres change with the model; see `changes`."""

from dataclasses import replace

import numpy as np

import flexel as fx
from campaign.case import Case
from campaign.changes import Change, Inapplicable, changer, having, listed, numbers, sized
from campaign.changes_of_parts import deformation, sign_of, unit_of
from campaign.known_lines import KnownLine
from flexel.parts.beams import Beam
from flexel.parts.cables import Cable, Slope
from flexel.parts.laws import AttachedLaw
from flexel.parts.loads import DistributedLoad
from flexel.parts.roles import Initial
from flexel.parts.rope_contacts import RopeContact
from flexel.parts.rope_surfaces import Sheave
from flexel.parts.springs import MassDamping
from flexel.parts.wheels import Tyre

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
CABLE = {
    "length": "L",
    "EA": "M L T-2",
    "EI": BENDING,
    "mass_per_length": "M L-1",
    "damping": "T",
    "bending_damping": "T",
}
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


@changer(Beam)
def _beam(change: Change, part: Beam, case: Case) -> Beam:
    new = sized(change, part, BEAM)
    if part.direction is not None:
        new = having(new, direction=change.vector(part.direction))
    if part.initial_curvature is not None:
        bend = np.array(part.initial_curvature) / change.length
        turned = (
            np.array([-1.0, -1.0, 1.0]) if bend.size == 3 else -1.0
        )  # the z axis of the section is turned over
        bend = bend * turned if change.mirror else bend
        new = having(new, initial_curvature=bend if bend.ndim else float(bend))
    return new


@changer(DistributedLoad)
def _distributed_load(change: Change, part: DistributedLoad, case: Case) -> DistributedLoad:
    return having(part, value=change.vector(change.size("M T-2", part.value)))


@changer(MassDamping)
def _mass_damping(change: Change, part: MassDamping, case: Case) -> MassDamping:
    return sized(change, part, {"rate": "T-1"})


@changer(Initial)
def _initial(change: Change, part: Initial, case: Case) -> Initial:
    new = change.size(unit_of(case, deformation(case, part.name)), part.value)
    return replace(part, value=new * sign_of(change, case, part.name))


@changer(Slope)
def _slope(change: Change, part: Slope, case: Case) -> Slope:
    return replace(part, direction=listed(change.vector(part.direction)))


@changer(Cable)
def _cable(change: Change, part: Cable, case: Case) -> Cable:
    return sized(change, part, CABLE)


@changer(Sheave)
def _sheave(change: Change, part: Sheave, case: Case) -> Sheave:
    new = having(sized(change, part, {"radius": "L"}), axle=change.axial(part.axle))
    if isinstance(groove := part.groove, fx.RoundGroove):
        new = replace(new, groove=replace(groove, radius=change.size("L", groove.radius)))
    return new


@changer(KnownLine)
def _line(change: Change, part: KnownLine, case: Case) -> KnownLine:
    return sized(change, part, {"s": "L", "radius": "L"})


@changer(RopeContact)
def _rope_contact(change: Change, part: RopeContact, case: Case) -> RopeContact:
    contact = part.contact
    if change.time != 1 and contact.bristle_stiffness is not None:
        raise Inapplicable("bristles off the surface straighten at a rate that is always the same")
    # a force per length and depth^exponent, which need not be whole
    new = contact.stiffness * change.mass / change.time**2 / change.length**contact.exponent
    sizes = {
        key: change.size(unit, value)
        for key, unit in CONTACT.items()
        if (value := getattr(contact, key)) is not None
    }
    return replace(part, contact=replace(contact, stiffness=new, **sizes))


@changer(Tyre)
def _tyre(change: Change, part: Tyre, case: Case) -> Tyre:
    # the axle points to the wheel's left, also in the mirror
    new = having(sized(change, part, {"radius": "L", "crown": "L"}), axle=change.axial(part.axle))
    if part.road is not None:
        return replace(new, road=_waves(change, part.road))
    normal = change.vector(part.normal) / np.linalg.norm(part.normal)
    height = float(change.length * part.height + normal @ np.array(change.shift))
    return replace(new, normal=listed(normal), height=height)


def _waves(change: Change, road: fx.Waves) -> fx.Waves:
    """Waves, which rise along the global z axis."""
    if change.vector(UP)[2] < 1 - 1e-12:
        raise Inapplicable("waves of a road rise along z")
    heading = change.vector((*road.heading, 0.0))[:2]
    return replace(
        road,
        amplitude=change.size("L", road.amplitude),
        wavelength=change.size("L", road.wavelength),
        start=change.length * road.start + float(heading @ np.array(change.shift)[:2]),
        heading=listed(heading),
        height=change.length * road.height + change.shift[2],
    )


@changer(AttachedLaw)
def _attach(change: Change, part: AttachedLaw, case: Case) -> AttachedLaw:
    law, given = part.law, part.parameters or {}
    if law not in LAWS:
        raise Inapplicable(f"no change of the law {law}")
    new = numbers(change, given, TYRE | LAWS[law])
    if law == "magic_formula":  # the second number of its trail has no unit
        new["trail"] = (change.size("L", given["trail"][0]), given["trail"][1])
    force = change.size(FORCE, 1.0)
    if law == "calspan_tyre":
        powers = {"A": (1, 0, 1, 0, 1), "B": (-1, 0, -2)}
        for key, n in powers.items():
            new[key] = listed(np.array(given[key]) * force ** np.array(n, float))
        new["AF"] = change.size("L", tuple(np.array(given["AF"]) / force))
    initial = part.initial
    if initial is not None:
        initial = {**initial, "tan_alpha": change.sign * initial["tan_alpha"]}
    return replace(part, parameters=new, initial=initial)
