"""Checks whether ropes stay on their sheaves and drums and do not run to their ends, by gaps at the stored states."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from flexel.integration.outcome import States
from flexel.model.instances import Instance
from flexel.model.structure import Structure

CLEAR = 0.01  # distance of all points from a sheave that the rope has left, over the length of an element


@dataclass
class _Wrap:
    """The contact of one rope with one sheave or drum: all gaps, and those of each last element of the rope."""

    rope: str
    surface: str
    length: float
    gaps: list[int] = field(default_factory=list)
    ends: dict[str, list[int]] = field(default_factory=dict)
    anchored: set[str] = field(default_factory=set)  # last elements that are meant to wind on it


def at_their_ends(structure: Structure, states: States) -> Iterator[str]:
    """Describe ropes that have left a sheave since the start, or have run to their end on one."""
    wraps = _wraps(structure)
    if not wraps:
        return
    e, times = states.deformations, states.times
    for wrap in wraps:
        gaps = e[:, wrap.gaps]
        clear = np.asarray(gaps.min(axis=1) > CLEAR * wrap.length)
        if gaps[0].min() < 0 and clear.any():
            yield (
                f"rope '{wrap.rope}' has left '{wrap.surface}' at t = {_first(clear, times):g} s: no point of it "
                "touches there; keep it taut, or end the motion earlier"
            )
        for element, rows in wrap.ends.items():
            touching = e[:, rows] < 0
            some, off = np.any(touching, axis=1), np.all(e[:, rows] > 0, axis=1)
            if off[0] and some.any() and element not in wrap.anchored:
                yield (
                    f"rope '{wrap.rope}' has run to its end on '{wrap.surface}' at t = {_first(some, times):g} s: its "
                    f"last element '{element}' touches it; give a longer rope, or end the motion earlier"
                )
            if np.all(touching[0]) and off.any():
                yield (
                    f"rope '{wrap.rope}' has run off '{wrap.surface}' to its end at t = {_first(off, times):g} s: its "
                    f"last element '{element}', which lay on it, is free; give more turns, or end the motion earlier"
                )


def _first(where: NDArray[np.bool_], times: list[float]) -> float:
    return times[int(np.argmax(where))]


def _wraps(structure: Structure) -> list[_Wrap]:
    """Return the contacts of all ropes except those on planes; their elements are named cable@surface#i."""
    if "gap" not in structure.kinds:
        return []
    ends = _last_elements(structure)
    found: dict[tuple[str, str], _Wrap] = {}
    first = 0
    for instance in structure.instances:
        rows = range(first, first + len(instance.spec.deformations))
        first = rows.stop
        if "@" not in instance.name or not _is_sheave(instance):
            continue
        cable, _, rest = instance.name.partition("@")
        rope, surface = cable.rstrip("0123456789"), rest.rpartition("#")[0]
        wrap = found.setdefault((rope, surface), _Wrap(rope, surface, float(instance.parameters["l0"][0])))
        wrap.gaps.extend(rows)
        if cable in ends:
            if cable not in wrap.ends and _is_anchored(structure, ends[cable], instance.nodes[-2:]):
                wrap.anchored.add(cable)
            wrap.ends.setdefault(cable, []).extend(rows)
    return list(found.values())


def _is_sheave(instance: Instance) -> bool:
    """Whether an element is the contact of a cable, which has a length, with a sheave or drum, which have a radius."""
    return instance.spec.gaps and {"l0", "radius"} <= instance.parameters.keys()


def _last_elements(structure: Structure) -> dict[str, set[str]]:
    """Return elements of cables with points that no other element has, and these points."""
    cables = [instance for instance in structure.instances if instance.spec.reports("tension")]
    counts = Counter(node for cable in cables for node in (cable.nodes[0], cable.nodes[2]))
    ends = {
        cable.name: {node for node in (cable.nodes[0], cable.nodes[2]) if counts[node] == 1}
        for cable in cables
    }
    return {name: points for name, points in ends.items() if points}


def _is_anchored(structure: Structure, points: set[str], body: tuple[str, ...]) -> bool:
    """Whether an end of a rope is held in the body of a surface: it is meant to wind on that."""
    return bool(points & set(body)) or any(
        points & set(instance.nodes) and set(body) & set(instance.nodes)
        for instance in structure.instances
        if not (instance.spec.gaps or instance.spec.reports("tension"))
    )
