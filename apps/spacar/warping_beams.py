"""Converts BEAMW, a beam with warping sections, to parts."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.apps.spacar.declarations import Declaration
from flexel.apps.spacar.element_laws import beam_stiffnesses, law_parts
from flexel.apps.spacar.file_entries import ElementEntry, NodeEntry, deformation_of, length
from flexel.apps.spacar.sheet import Sheet
from flexel.base.errors import ModelError
from flexel.base.quaternions import in_frame, triad
from flexel.parts.beam_laws import NO_SHEAR
from flexel.parts.beams import Beam
from flexel.parts.couplings import RotaryInertia
from flexel.parts.elements import ElementPart

FIRST_NODE = 4  # of warping, among those of our element
TORSION, WARPS = 2, {7, 8}  # modes


def unnamed_warping(sheet: Sheet) -> list[NodeEntry]:
    """Free the modes of warping that no line names, and return the nodes that are then dynamic coordinates.

    Files written by SPACAR Light name only the modes 1 to 6, and have as many releases as without warping: so modes 7
    and 8 are not conditions there, and free warping nodes are degrees of freedom.  If a beam is rigid in
    torsion, its warping nodes are held.
    """
    beams = [element for element in sheet.elements.values() if element.line.keyword == "BEAMW"]
    own = [beam for beam in beams if sheet.dialect == "twente" and not beam.free & WARPS]
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
    for entry in beams:  # a rigid mode 7 or 8 holds its node
        for i in WARPS - entry.free:
            entry.nodes[entry.kind.modes[i - 1].node or 0].fixed.add(1)
        entry.free |= WARPS
    others = {node.number for beam in beams if beam not in own for node in beam.nodes}
    nodes = {node.number: node for beam in own for node in beam.nodes[FIRST_NODE:] if not node.fixed}
    return [node for n, node in nodes.items() if n not in others | named]


def warping_parts(
    entry: ElementEntry, stiffness: dict[str, float] | None, options: dict[str, Any]
) -> list[Declaration]:
    """Return the beam, by its stiffnesses if whole groups of modes deform, else as the bare element with separate laws.

    In SPACAR the inertia of warping is lumped at the nodes, half of it at each, and a twist does not shorten the beam;
    in flexel's own beam the inertia is spread over the length, and the twist shortens it.

    Parameters
    ----------
    stiffness : dict, optional
        Stiffnesses and damping in the form of `Model.beam`.
    options : dict
        Direction and inertia in the form of `Model.beam`.
    """
    inertias = [] if entry.vlasov else _lumped(entry, options.pop("warping_inertia_per_length", 0.0))
    if stiffness is None:
        values = _parameters(entry, options)
        bare = Declaration.of(entry.line, ElementPart, entry.name, "beam_warping", entry.ends, values)
        return [bare, *law_parts(entry), *inertias]
    nodes, warps = entry.ends[:FIRST_NODE], entry.ends[FIRST_NODE:]
    options |= {} if entry.vlasov else {"twist_shortens": False}
    beam = Declaration.of(entry.line, Beam, entry.name, *nodes, **stiffness, **options, warping=warps)
    return [beam, *inertias]


def _lumped(entry: ElementEntry, Jw: float) -> list[Declaration]:  # noqa: N803
    """Return the inertia of warping at both nodes, from that per length."""
    half = Jw * length(entry) / 2
    ends = zip("pq", entry.ends[FIRST_NODE:], strict=True) if half else ()
    line = entry.lines.get("EMASS", entry.line)
    return [
        Declaration.of(line, RotaryInertia, f"{entry.name}_warping_{end}", node, half) for end, node in ends
    ]


def _parameters(entry: ElementEntry, options: dict[str, Any]) -> dict[str, Any]:
    """Return the parameters of the bare element."""
    l0, (p, frame_p, q, frame_q) = length(entry), entry.nodes[:FIRST_NODE]
    try:
        axes = triad((q.x - p.x) / l0, entry.numbers or None, f"beam '{entry.name}'")
    except ModelError as error:
        raise entry.line.error(str(error)) from error
    given = beam_stiffnesses(entry.kind, entry.values("ESTIFF"))
    modes = {"EA": {1}, "EIy": {3, 4}, "EIz": {5, 6}}
    known = entry.vlasov and all(key in given and own & entry.free for key, own in modes.items())
    stiffnesses = {key: given[key] for key in modes} if known else {"EA": NO_SHEAR, "EIy": 0.0, "EIz": 0.0}
    return {
        "l0": l0,
        "tp": tuple(map(float, in_frame(frame_p.x, axes))),
        "tq": tuple(map(float, in_frame(frame_q.x, axes))),
        "rhoA": options.get("mass_per_length", 0.0),
        "rhoJ": tuple(map(float, np.array(options.get("inertia_per_length", (0.0, 0.0, 0.0))))),
        "rhoIw": options.get("warping_inertia_per_length", 0.0),
        **stiffnesses,
        "GAy": NO_SHEAR,
        "GAz": NO_SHEAR,
    }


def warped_stresses(entry: ElementEntry) -> list[tuple[tuple[int, int], dict[str, float]]]:
    """Return the stresses of modes 2, 7 and 8 as sums of flexel's; its modes 7 and 8 are SPACAR's less the torsion."""
    torsion, *warps = (deformation_of(entry, i)[0] for i in (TORSION, *sorted(WARPS)))
    sums = {TORSION: {torsion: 1.0} | dict.fromkeys(warps, -1.0)}
    sums |= {i: {warp: 1.0} for i, warp in zip(sorted(WARPS), warps, strict=True)}
    return [((entry.number, i), terms) for i, terms in sums.items()]
