"""BEAMW, a beam whose sections warp, as calls of `Model`."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.errors import ModelError
from flexel.base.quaternions import in_frame, triad
from flexel.spacar.entries import ElementEntry
from flexel.spacar.laws import law_calls, length
from flexel.spacar.statements import Call

FIRST_NODE = 4  # of warping, among those of our element


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
