"""BEAMW, a beam whose sections warp, as calls of `Model`."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.errors import ModelError
from flexel.base.quaternions import in_frame, triad
from flexel.spacar.entries import ElementEntry, NodeEntry
from flexel.spacar.laws import law_calls, length
from flexel.spacar.sheet import Sheet
from flexel.spacar.statements import Call

FIRST_NODE = 4  # of warping, among those of our element
TORSION, WARPS = 2, {7, 8}  # modes


def unnamed_warping(sheet: Sheet) -> list[NodeEntry]:
    """Free the modes of warping that no line names, and return the nodes that are dynamic coordinates then.

    Files that SPACAR Light writes name the modes 1 to 6 only, and have as many releases as without warping: so modes 7
    and 8 are not conditions there, and free nodes of warping are degrees of freedom.  Of a beam that is rigid in
    torsion, the nodes are held.
    """
    beams = [z for z in sheet.elements.values() if z.line.keyword == "BEAMW"]
    own = [z for z in beams if sheet.dialect == "twente" and not z.free & WARPS]
    named = {line.values[0] for line in sheet.of("INPUTX", "DYNX", "KINX")}
    for entry in own:
        text = "modes 7 and 8 are not named: read as free, and free nodes of warping as dynamic coordinates"
        if TORSION not in entry.free:
            text = "modes 7 and 8 are not named: its nodes of warping are read as held, as it does not twist"
            for node in entry.nodes[FIRST_NODE:]:
                if node.number not in named:
                    node.fixed.add(1)
        sheet.notes.add(entry.line, text, entry.number)
        entry.free |= WARPS
    others = {node.number for z in beams if z not in own for node in z.nodes}
    nodes = {node.number: node for z in own for node in z.nodes[FIRST_NODE:] if not node.fixed}
    return [node for n, node in nodes.items() if n not in others | named]


def warping_calls(
    entry: ElementEntry, stiffness: dict[str, float] | None, options: dict[str, Any]
) -> list[Call]:
    """The beam, by its stiffnesses if whole groups of modes deform, else as the bare element with separate laws.

    Parameters
    ----------
    stiffness : dict, optional
        Stiffnesses and damping in the form of `Model.beam`.
    options : dict
        Direction and inertia in the form of `Model.beam`.
    """
    if stiffness is None:
        ends = ("beam_warping", *entry.ends)
        return [
            Call("element", (entry.name, *ends), _parameters(entry, options), entry.line),
            *law_calls(entry),
        ]
    nodes, warps = entry.ends[:FIRST_NODE], entry.ends[FIRST_NODE:]
    return [Call("beam", (entry.name, *nodes), stiffness | options | {"warping": warps}, entry.line)]


def _parameters(entry: ElementEntry, options: dict[str, Any]) -> dict[str, Any]:
    """Parameters of the bare element."""
    l0, (p, frame_p, q, frame_q) = length(entry), entry.nodes[:FIRST_NODE]
    try:
        axes = triad((q.x - p.x) / l0, entry.numbers or None, f"beam '{entry.name}'")
    except ModelError as error:
        raise entry.line.error(str(error)) from error
    given = dict(zip(entry.kind.stiffness, entry.values("ESTIFF"), strict=False))
    modes = {"EA": {1}, "EIy": {3, 4}, "EIz": {5, 6}}
    flexible = {key: given.get(key, 0.0) for key, own in modes.items() if own & entry.free}
    known = flexible.keys() == modes.keys() and all(flexible.values())
    polar = (flexible["EIy"] + flexible["EIz"]) / flexible["EA"] if known else 0.0
    return {
        "l0": l0,
        "tp": tuple(map(float, in_frame(frame_p.x, axes))),
        "tq": tuple(map(float, in_frame(frame_q.x, axes))),
        "rhoA": options.get("mass_per_length", 0.0),
        "rhoJ": tuple(map(float, np.array(options.get("inertia_per_length", (0.0, 0.0, 0.0))))),
        "rhoIw": options.get("warping_inertia_per_length", 0.0),
        "polar": polar,
        "phi_y": 0.0,
        "phi_z": 0.0,
    }
