"""Elements of the sheet as calls of `Model`: geometry, mass, stiffness and damping of each type."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from flexel.base.errors import ModelError
from flexel.base.quaternions import in_frame, matrix, triad
from flexel.spacar.entries import ElementEntry, NodeEntry, quantity
from flexel.spacar.keywords import KEYWORDS
from flexel.spacar.laws import BEAMS, coefficients, initial_stresses, law_calls, length
from flexel.spacar.statements import Call
from flexel.spacar.warping import warping_calls

TWENTE_BEAMS = ("BEAM", "BEAMW")  # of second order in the Twente dialect, with lumped rotary inertia
# stiffnesses that make modes flexible together, and these modes, of beams in space and in the plane
SPATIAL_GROUPS = {"EA": {1}, "GJ": {2}, "EIy": {3, 4}, "EIz": {5, 6}}
WARPING_GROUPS = SPATIAL_GROUPS | {"GJ": {2, 7, 8}, "EIw": {2, 7, 8}}
PLANAR_GROUPS = {"EA": {1}, "EIz": {2, 3}}


def element_calls(entry: ElementEntry, dialect: str) -> list[Call]:
    """Calls that make an element with its mass, its roles and its laws; none for an automatic norm."""
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


def _beam(entry: ElementEntry, dialect: str) -> list[Call]:
    """A beam, by its stiffnesses if whole groups of modes deform, else rigid with a separate law."""
    planar = entry.line.keyword.startswith("PL")
    warps = entry.line.keyword == "BEAMW"
    lumped = dialect == "twente" and entry.line.keyword in TWENTE_BEAMS
    second = entry.line.keyword.endswith("NL") or lumped or warps
    options: dict[str, Any] = {} if planar else _direction(entry)
    options |= _mass(entry, planar, lumped)
    options |= {} if second else {"second_order": False}
    inertias = _lumped_inertia(entry) if lumped else []
    groups = PLANAR_GROUPS if planar else WARPING_GROUPS if warps else SPATIAL_GROUPS
    stiffness = _whole_groups(entry, groups)
    if warps:
        return [*warping_calls(entry, stiffness, options), *inertias]
    if stiffness is None:
        rigid = Call("beam", (entry.name, *entry.ends), {"rigid": True} | options, entry.line)
        return [rigid, *law_calls(entry), *inertias]
    return [Call("beam", (entry.name, *entry.ends), stiffness | options, entry.line), *inertias]


def _lumped_inertia(entry: ElementEntry) -> list[Call]:
    """Rotary inertia as in UT SPACAR: that of half the length at each node, in the axes of the section there."""
    Jxx, Jyy, Jzz, Jyz = (*entry.values("EMASS")[1:5], 0.0, 0.0, 0.0, 0.0)[:4]
    if not (Jxx or Jyy or Jzz or Jyz):
        return []
    l0, line, calls = length(entry), entry.lines["EMASS"], []
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
        calls.append(Call("rotary_inertia", (f"{entry.name}_{end}", frame.name, six), {}, line))
    return calls


def _whole_groups(entry: ElementEntry, groups: dict[str, set[int]]) -> dict[str, float] | None:
    """Stiffnesses and damping in the form of `Model.beam`; None if they cannot be expressed so."""
    if any(entry.values("ESIG")):
        return None
    given = dict(zip(entry.kind.stiffness, entry.values("ESTIFF"), strict=False))
    if "EI" in given:
        given["EIz"] = given.pop("EI")
    chosen = {
        key: given[key] for key, modes in groups.items() if modes & entry.free and given.get(key, 0.0) > 0
    }
    if not chosen or set().union(*(groups[key] for key in chosen)) != entry.free:
        return None
    if "EIw" in groups and not {"GJ", "EIw"} <= chosen.keys():
        return None
    for bending, key, shear in (("EIy", "EIy/GAk", "GAz"), ("EIz", "EIz/GAk", "GAy")):
        if bending in chosen and given.get(key, 0.0) > 0:
            chosen[shear] = given[bending] / given[key]
    S, D = coefficients(entry, "ESTIFF"), coefficients(entry, "EDAMPP")
    grid = np.ix_([i - 1 for i in sorted(entry.free)], [i - 1 for i in sorted(entry.free)])
    ratio = float(D[grid][0, 0] / S[grid][0, 0])
    if np.max(np.abs(D[grid] - ratio * S[grid])) > 1e-12 * np.max(np.abs(D[grid]), initial=0.0):
        return None
    return chosen | ({"damping": ratio} if ratio else {})


def _mass(entry: ElementEntry, planar: bool, lumped: bool = False) -> dict[str, Any]:
    """Mass per length, and rotary inertia per length unless it is lumped at the nodes."""
    values = entry.values("EMASS")
    if not values:
        return {}
    line = entry.lines["EMASS"]
    if len(values) > (6 if entry.line.keyword == "BEAMW" else 5):
        raise line.error(f"{len(values) + 1} numbers given; it is written EMASS {KEYWORDS['EMASS'].form}")
    if len(values) > 4 and values[4] and not lumped:
        raise line.error(
            "a product of inertia of the section is not supported; turn the section to its principal axes"
        )
    options: dict[str, Any] = {"mass_per_length": values[0]}
    if any(values[5:]):
        options["warping_inertia_per_length"] = values[5]
    if any(values[1:4]) and not lumped:
        inertia = (*values[1:4], 0.0, 0.0)[:3]
        if planar:
            raise line.error("a planar element takes rhoA alone; remove the inertias")
        options["inertia_per_length"] = inertia
    return options


def _rigid_beam(entry: ElementEntry, dialect: str) -> list[Call]:
    options = _direction(entry) | _mass(entry, planar=False)
    return [Call("beam", (entry.name, *entry.ends), {"rigid": True} | options, entry.line), *law_calls(entry)]


def _truss(entry: ElementEntry, dialect: str) -> list[Call]:
    options = _mass(entry, planar=True)
    if "LENGTH0" not in entry.lines:
        return [Call("truss", (entry.name, *entry.ends), options, entry.line), *law_calls(entry)]
    l0 = entry.values("LENGTH0")[0]
    if l0 <= 0:
        raise entry.lines["LENGTH0"].error(f"the length {l0:g} is not positive; correct it")
    length(entry)  # it must have a direction, whatever its unstrained length
    values = {"l0": l0, "rhoA": options.get("mass_per_length", 0.0)}
    kind = "planar_truss" if entry.line.keyword == "PLTRUSS" else "truss"
    return [
        Call("element", (entry.name, kind, *entry.ends), values, entry.lines["LENGTH0"]),
        *law_calls(entry),
    ]


def _hinge(entry: ElementEntry, dialect: str) -> list[Call]:
    options = {} if entry.line.keyword == "PLHINGE" else {"axis": _axis(entry)}
    rigid = [quantity(entry, 1)[0]] if 1 not in entry.free else []
    held = [Call("rigid", tuple(rigid), {}, entry.line)] if rigid else []  # the angle is free by default here
    return [Call("hinge", (entry.name, *entry.ends), options, entry.line), *held, *law_calls(entry)]


def _bearing(entry: ElementEntry, dialect: str) -> list[Call]:
    planar = entry.line.keyword == "PLBEAR"
    angle = 3 if planar else 4
    held = [] if angle in entry.free else [Call("rigid", (quantity(entry, angle)[0],), {}, entry.line)]
    options = {} if planar else {"axis": _axis(entry)}
    return [Call("bearing", (entry.name, *entry.ends), options, entry.line), *held, *law_calls(entry)]


def _body_point(entry: ElementEntry, dialect: str) -> list[Call]:
    options = {"body_axes": True} if entry.free else {}
    return [Call("body_point", (entry.name, *entry.ends), options, entry.line), *law_calls(entry)]


def _wheel(entry: ElementEntry, dialect: str) -> list[Call]:
    hub, _, contact = entry.nodes
    axle = _axis(entry)
    radius, height = float(np.linalg.norm(contact.x - hub.x)), float(hub.x[2] - contact.x[2])
    if not height:
        raise entry.line.error(
            "hub and contact point have the same height as drawn; correct their coordinates"
        )
    z = float(np.sign(height))  # up, where z points down as well
    options = {
        "radius": radius,
        "axle": axle,
        "normal": (0.0, 0.0, z),
        "height": z * float(contact.x[2]) + 0.0,
    }
    return [Call("wheel", (entry.name, *entry.ends), options, entry.line), *law_calls(entry)]


def _planar_wheel(entry: ElementEntry, dialect: str) -> list[Call]:
    radius, x, y = entry.numbers
    options = {"radius": radius, "direction": (x, y)}
    return [Call("planar_wheel", (entry.name, *entry.ends), options, entry.line), *law_calls(entry)]


def _belt(entry: ElementEntry, dialect: str) -> list[Call]:
    options = dict(zip(("radius_p", "radius_q"), entry.numbers, strict=True))
    return [Call("planar_belt", (entry.name, *entry.ends), options, entry.line), *law_calls(entry)]


def _gear(entry: ElementEntry, dialect: str) -> list[Call]:
    options = dict(zip(("radius_p", "radius_q"), entry.numbers, strict=True))
    quantity(entry, 1)  # refuses opposite radii
    return [Call("planar_gear", (entry.name, *entry.ends), options, entry.line), *law_calls(entry)]


def _surface(entry: ElementEntry, dialect: str) -> list[Call]:
    xx, yy, zz, xy, yz, xz, *rest = entry.numbers
    options = {"quadratic": (xx, yy, zz, xy, xz, yz), "linear": tuple(rest[:3]), "constant": rest[3]}
    return [Call("quadric", (entry.name, *entry.ends), options, entry.line), *law_calls(entry)]


MAKERS: dict[str, Callable[[ElementEntry, str], list[Call]]] = {
    **dict.fromkeys(BEAMS, _beam),
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
    **dict.fromkeys(BEAMS, ("EMASS", *_LAW)),
    "RBEAM": ("EMASS",),
    "TRUSS": ("EMASS", "LENGTH0", *_LAW),
    "PLTRUSS": ("EMASS", "LENGTH0", *_LAW),
    **dict.fromkeys(("HINGE", "PLHINGE", "BEARING", "PLBEAR", "PLBELT", "GEAR"), _LAW),
}


def node_calls(nodes: Sequence[NodeEntry]) -> list[Call]:
    """Calls that make the nodes and fix them, completely or in part."""
    methods = {"point": "point", "planar_point": "point", "frame": "frame", "planar_angle": "angle"}
    calls = []
    for node in nodes:
        x = tuple(float(z) for z in node.x)
        whole = len(node.fixed) == len(x)
        options = {"fixed": True} if whole else {}
        if node.kind == "warping":  # drawn without twist
            calls.append(Call("warping", (node.name,), options, node.line))
            continue
        calls.append(Call(methods[node.kind], (node.name, x if len(x) > 1 else x[0]), options, node.line))
        if node.fixed and not whole:
            held = tuple(f"{node.name}.{node.components[i - 1]}" for i in sorted(node.fixed))
            calls.append(Call("fix", held, {}, node.line))
    return calls
