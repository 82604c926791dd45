"""Converts elements of the sheet to parts: geometry, mass, stiffness and damping of each type."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from flexel.apps.spacar.declarations import Declaration
from flexel.apps.spacar.element_laws import (
    BEAM_MODES,
    beam_stiffnesses,
    coefficients,
    initial_stresses,
    law_parts,
)
from flexel.apps.spacar.file_entries import ElementEntry, NodeEntry, length, quantity
from flexel.apps.spacar.keywords import KEYWORDS
from flexel.apps.spacar.warping_beams import warping_parts
from flexel.base.errors import ModelError
from flexel.base.quaternions import in_frame, matrix, triad
from flexel.parts.beams import Beam
from flexel.parts.couplings import PlanarBelt, PlanarGear, PlanarWheel, Quadric, RotaryInertia
from flexel.parts.elements import ElementPart
from flexel.parts.joints import Bearing, BodyPoint, Hinge, Truss
from flexel.parts.nodes import Angle, Frame, Point, Warping
from flexel.parts.roles import Fix, Rigid
from flexel.parts.wheels import Wheel

TWENTE_BEAMS = ("BEAM", "BEAMW")  # of second order in the Twente dialect, with lumped rotary inertia
# stiffnesses that make modes flexible together, and these modes, of spatial and planar beams
SPATIAL_GROUPS = {"EA": {1}, "GJ": {2}, "EIy": {3, 4}, "EIz": {5, 6}}
WARPING_GROUPS = SPATIAL_GROUPS | {"GJ": {2, 7, 8}, "EIw": {2, 7, 8}}
PLANAR_GROUPS = {"EA": {1}, "EIz": {2, 3}}


def element_parts(entry: ElementEntry, dialect: str) -> list[Declaration]:
    """Return the parts of an element, with its mass, its roles and its laws; none for an automatic norm."""
    keyword = entry.line.keyword
    return [] if keyword == "L2MIN1" else MAKERS[keyword](entry, dialect)


def check_line(entry: ElementEntry, given: str) -> None:
    """Check that an element can have a line of the keyword `given`, with these numbers.

    Raises
    ------
    LineError
    """
    allowed = USES.get(entry.line.keyword, ())
    if given not in allowed:
        raise entry.lines[given].error(
            f"a {entry.line.keyword} takes {', '.join(allowed) or 'none'}; remove the line"
        )
    if given in ("ESTIFF", "EDAMPP"):
        coefficients(entry, given)
    if given == "ESIG":
        initial_stresses(entry)


# -- types ---------------------------------------------------------------------------------------


def _direction(entry: ElementEntry) -> dict[str, Any]:
    return {"direction": entry.numbers} if entry.numbers else {}


def _axis(entry: ElementEntry) -> tuple[float, ...]:
    if not entry.numbers:
        raise entry.line.error("its axis is missing; give x y z after the nodes, or a line DIR")
    return entry.numbers


def _beam(entry: ElementEntry, dialect: str) -> list[Declaration]:
    """Return a beam, by its stiffnesses if whole groups of modes deform, otherwise rigid with a separate law."""
    planar = entry.line.keyword.startswith("PL")
    warps = entry.line.keyword == "BEAMW"
    lumped = dialect == "twente" and (planar or entry.line.keyword in TWENTE_BEAMS)
    second = entry.line.keyword.endswith("NL") or (lumped and not planar) or warps
    options: dict[str, Any] = {} if planar else _direction(entry)
    options |= _mass(entry, planar, lumped)
    options |= {} if second else {"second_order": False}
    inertias = (_lumped_planar_inertia if planar else _lumped_inertia)(entry) if lumped else []
    groups = PLANAR_GROUPS if planar else WARPING_GROUPS if warps else SPATIAL_GROUPS
    stiffness = _whole_groups(entry, groups)
    if warps:
        return [*warping_parts(entry, stiffness, options), *inertias]
    if stiffness is None:
        rigid = Declaration.of(entry.line, Beam, entry.name, *entry.ends, rigid=True, **options)
        return [rigid, *law_parts(entry), *inertias]
    return [Declaration.of(entry.line, Beam, entry.name, *entry.ends, **stiffness, **options), *inertias]


def _lumped_inertia(entry: ElementEntry) -> list[Declaration]:
    """Return rotary inertia as in UT SPACAR: that of half the length at each node, in the axes of the section there."""
    Jxx, Jyy, Jzz, Jyz = (*entry.values("EMASS")[1:5], 0.0, 0.0, 0.0, 0.0)[:4]
    if not (Jxx or Jyy or Jzz or Jyz):
        return []
    l0, line, found = length(entry), entry.lines["EMASS"], []
    J = np.array([[Jxx, 0.0, 0.0], [0.0, Jyy, Jyz], [0.0, Jyz, Jzz]]) * l0 / 2
    p, frame_p, q, frame_q = entry.nodes[:4]
    try:
        axes = triad((q.x - p.x) / l0, entry.numbers or None, f"beam '{entry.name}'")
    except ModelError as error:
        raise entry.line.error(str(error)) from error
    for end, frame in (("p", frame_p), ("q", frame_q)):
        T = matrix(in_frame(frame.x, axes))
        A = T @ J @ T.T
        six = tuple(float(A[i, j]) + 0.0 for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))
        found.append(Declaration.of(line, RotaryInertia, f"{entry.name}_{end}", frame.name, six))
    return found


def _lumped_planar_inertia(entry: ElementEntry) -> list[Declaration]:
    """Return rotary inertia of a planar beam in the same way, from the second number of EM: J per length."""
    J = (*entry.values("EMASS")[1:2], 0.0)[0]
    if not J:
        return []
    half, line = J * length(entry) / 2, entry.lines["EMASS"]
    return [
        Declaration.of(line, RotaryInertia, f"{entry.name}_{end}", angle.name, half)
        for end, angle in (("p", entry.nodes[1]), ("q", entry.nodes[3]))
    ]


def _whole_groups(entry: ElementEntry, groups: dict[str, set[int]]) -> dict[str, float] | None:
    """Return stiffnesses and damping in the form of `Model.beam`; None if they cannot be expressed so."""
    if any(entry.values("ESIG")):
        return None
    given = beam_stiffnesses(entry.kind, entry.values("ESTIFF"))
    chosen = {key: given[key] for key, modes in groups.items() if modes & entry.free and key in given}
    if not chosen or set().union(*(groups[key] for key in chosen)) != entry.free:
        return None
    if "EIw" in groups and not {"GJ", "EIw"} <= chosen.keys():
        return None
    for bending, shear in (("EIy", "GAz"), ("EIz", "GAy")):
        if bending in chosen and shear in given:
            chosen[shear] = given[shear]
    S, D = coefficients(entry, "ESTIFF"), coefficients(entry, "EDAMPP")
    grid = np.ix_([i - 1 for i in sorted(entry.free)], [i - 1 for i in sorted(entry.free)])
    ratio = float(D[grid][0, 0] / S[grid][0, 0])
    if np.max(np.abs(D[grid] - ratio * S[grid])) > 1e-12 * np.max(np.abs(D[grid]), initial=0.0):
        return None
    return chosen | ({"damping": ratio} if ratio else {})


def _mass(entry: ElementEntry, planar: bool, lumped: bool = False) -> dict[str, Any]:
    """Return mass per length, and rotary inertia per length unless it is lumped at the nodes."""
    values = entry.values("EMASS")
    if not values:
        return {}
    line = entry.lines["EMASS"]
    if len(values) > (6 if entry.line.keyword == "BEAMW" else 5):
        raise line.error(f"{len(values) + 1} numbers given; write EMASS {KEYWORDS['EMASS'].form}")
    if len(values) > 4 and values[4] and not lumped:
        raise line.error(
            "a product of inertia of the section is not supported; turn the section to its principal axes"
        )
    options: dict[str, Any] = {"mass_per_length": values[0]}
    if planar and lumped and any(values[2:]):
        raise line.error(
            "a planar beam takes rhoA and its rotary inertia per length; remove the other numbers"
        )
    if any(values[5:]):
        options["warping_inertia_per_length"] = values[5]
    if any(values[1:4]) and not lumped:
        inertia = (*values[1:4], 0.0, 0.0)[:3]
        if planar:
            raise line.error(
                "it takes rhoA alone here, a PLBEAM of the Twente dialect also J; remove the inertias"
            )
        options["inertia_per_length"] = inertia
    return options


def _rigid_beam(entry: ElementEntry, dialect: str) -> list[Declaration]:
    options = _direction(entry) | _mass(entry, planar=False)
    return [
        Declaration.of(entry.line, Beam, entry.name, *entry.ends, rigid=True, **options),
        *law_parts(entry),
    ]


def _truss(entry: ElementEntry, dialect: str) -> list[Declaration]:
    options = _mass(entry, planar=True)
    if "LENGTH0" not in entry.lines:
        return [Declaration.of(entry.line, Truss, entry.name, *entry.ends, **options), *law_parts(entry)]
    l0 = entry.values("LENGTH0")[0]
    if l0 <= 0:
        raise entry.lines["LENGTH0"].error(f"the length {l0:g} is not positive; correct it")
    length(entry)  # checks that it has a direction, whatever its unstrained length
    values = {"l0": l0, "rhoA": options.get("mass_per_length", 0.0)}
    kind = "planar_truss" if entry.line.keyword == "PLTRUSS" else "truss"
    return [
        Declaration.of(entry.lines["LENGTH0"], ElementPart, entry.name, kind, entry.ends, values),
        *law_parts(entry),
    ]


def _hinge(entry: ElementEntry, dialect: str) -> list[Declaration]:
    options = {} if entry.line.keyword == "PLHINGE" else {"axis": _axis(entry)}
    angle = (quantity(entry, 1)[0],)
    held = [] if 1 in entry.free else [Declaration.of(entry.line, Rigid, angle)]  # it is free by default here
    return [Declaration.of(entry.line, Hinge, entry.name, *entry.ends, **options), *held, *law_parts(entry)]


def _bearing(entry: ElementEntry, dialect: str) -> list[Declaration]:
    planar = entry.line.keyword == "PLBEAR"
    angle = 3 if planar else 4
    held = [] if angle in entry.free else [Declaration.of(entry.line, Rigid, (quantity(entry, angle)[0],))]
    options = {} if planar else {"axis": _axis(entry)}
    return [Declaration.of(entry.line, Bearing, entry.name, *entry.ends, **options), *held, *law_parts(entry)]


def _body_point(entry: ElementEntry, dialect: str) -> list[Declaration]:
    options = {"body_axes": True} if entry.free else {}
    return [Declaration.of(entry.line, BodyPoint, entry.name, *entry.ends, **options), *law_parts(entry)]


def _wheel(entry: ElementEntry, dialect: str) -> list[Declaration]:
    hub, _, contact = entry.nodes
    axle = _axis(entry)
    radius, height = float(np.linalg.norm(contact.x - hub.x)), float(hub.x[2] - contact.x[2])
    if not height:
        raise entry.line.error(
            "hub and contact point have the same height as drawn; correct their coordinates"
        )
    upward = float(np.sign(height))  # up, where z points down as well
    options = {
        "radius": radius,
        "axle": axle,
        "normal": (0.0, 0.0, upward),
        "height": upward * float(contact.x[2]) + 0.0,
    }
    return [Declaration.of(entry.line, Wheel, entry.name, *entry.ends, **options), *law_parts(entry)]


def _planar_wheel(entry: ElementEntry, dialect: str) -> list[Declaration]:
    radius, x, y = entry.numbers
    options = {"radius": radius, "direction": (x, y)}
    return [Declaration.of(entry.line, PlanarWheel, entry.name, *entry.ends, **options), *law_parts(entry)]


def _belt(entry: ElementEntry, dialect: str) -> list[Declaration]:
    options = dict(zip(("radius_p", "radius_q"), entry.numbers, strict=True))
    return [Declaration.of(entry.line, PlanarBelt, entry.name, *entry.ends, **options), *law_parts(entry)]


def _gear(entry: ElementEntry, dialect: str) -> list[Declaration]:
    options = dict(zip(("radius_p", "radius_q"), entry.numbers, strict=True))
    quantity(entry, 1)  # raises for opposite radii
    return [Declaration.of(entry.line, PlanarGear, entry.name, *entry.ends, **options), *law_parts(entry)]


def _surface(entry: ElementEntry, dialect: str) -> list[Declaration]:
    xx, yy, zz, xy, yz, xz, *rest = entry.numbers
    options = {"quadratic": (xx, yy, zz, xy, xz, yz), "linear": tuple(rest[:3]), "constant": rest[3]}
    return [Declaration.of(entry.line, Quadric, entry.name, *entry.ends, **options), *law_parts(entry)]


MAKERS: dict[str, Callable[[ElementEntry, str], list[Declaration]]] = {
    **dict.fromkeys(BEAM_MODES, _beam),
    "RBEAM": _rigid_beam,
    "TRUSS": _truss,
    "PLTRUSS": _truss,
    "HINGE": _hinge,
    "PLHINGE": _hinge,
    "BEARING": _bearing,
    "PLBEAR": _bearing,
    "PINBODY": _body_point,
    "PLPINBOD": _body_point,
    "WHEEL": _wheel,
    "PLWHEEL": _planar_wheel,
    "PLBELT": _belt,
    "GEAR": _gear,
    "SURFACE": _surface,
}
_LAW = ("ESTIFF", "EDAMPP", "ESIG")
USES: dict[str, Sequence[str]] = {
    **dict.fromkeys(BEAM_MODES, ("EMASS", *_LAW)),
    "RBEAM": ("EMASS",),
    "TRUSS": ("EMASS", "LENGTH0", *_LAW),
    "PLTRUSS": ("EMASS", "LENGTH0", *_LAW),
    **dict.fromkeys(("HINGE", "PLHINGE", "BEARING", "PLBEAR", "PLBELT", "GEAR"), _LAW),
}


def node_parts(node: NodeEntry) -> list[Declaration]:
    """Return a node, and what fixes some of its coordinates."""
    x = tuple(float(value) for value in node.x)
    whole = len(node.fixed) == len(x)
    options = {"fixed": True} if whole else {}
    if node.kind == "warping":  # drawn without twist
        return [Declaration.of(node.line, Warping, node.name, **options)]
    kind = {"frame": Frame, "planar_angle": Angle}.get(node.kind, Point)
    made = [Declaration.of(node.line, kind, node.name, x if len(x) > 1 else x[0], **options)]
    if node.fixed and not whole:
        held = tuple(f"{node.name}.{node.components[i - 1]}" for i in sorted(node.fixed))
        made.append(Declaration.of(node.line, Fix, held))
    return made
