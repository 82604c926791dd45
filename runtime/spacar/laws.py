"""Stiffness, damping and initial stresses of the elements of a file, as calls of `Model`."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.declare import warping
from flexel.declare.beams import bending_block
from flexel.spacar.entries import ElementEntry, quantity
from flexel.spacar.problems import FollowingError
from flexel.spacar.statements import Call

BEAMS = ("BEAM", "BEAMNL", "BEAMW", "PLBEAM", "PLBEAMNL")


def length(entry: ElementEntry) -> float:
    """Distance between the first and the last position node as drawn; an error if there is none."""
    points = [node for node in entry.nodes if node.kind.endswith("point")]
    if any(node.unread for node in points):
        raise FollowingError(f"{entry.name}: a line about its nodes could not be read; correct that")
    distance = float(np.linalg.norm(points[-1].x - points[0].x))
    if not distance:
        first, last = points[0].number, points[-1].number
        raise entry.line.error(
            f"the nodes {first} and {last} coincide as drawn and the element has no length; give their coordinates"
        )
    return distance


def coefficients(entry: ElementEntry, keyword: str) -> Array:
    """Matrix of all modes of the element from a line ESTIFF or EDAMPP, for SPACAR's deformations."""
    given, kind = entry.values(keyword), entry.kind
    if len(given) > len(kind.stiffness):
        raise entry.lines[keyword].error(
            f"{len(given)} values given; a {entry.line.keyword} has {', '.join(kind.stiffness)}"
        )
    if any(value < 0 for value in given):
        raise entry.lines[keyword].error("a value is negative; give zero or positive ones")
    K = np.zeros((len(kind.modes),) * 2)
    if entry.line.keyword not in BEAMS:
        along = entry.line.keyword in ("TRUSS", "PLTRUSS", "PLBELT")
        for i, value in enumerate(given):
            K[i, i] = value / tangent_length(entry) if along else value
        return K
    l0 = length(entry)
    values = dict(zip(kind.stiffness, given, strict=False))
    K[0, 0] = values.get("EA", 0.0) / l0
    if "EI" in kind.stiffness:
        K[1:, 1:] = bending_block(values.get("EI", 0.0), 0.0, l0)
        return K
    K[1, 1] = values.get("GJ", 0.0) / l0**3
    K[2:4, 2:4] = bending_block(values.get("EIy", 0.0), 12 * values.get("EIy/GAk", 0.0) / l0**2, l0)
    K[4:6, 4:6] = bending_block(values.get("EIz", 0.0), 12 * values.get("EIz/GAk", 0.0) / l0**2, l0)
    if "EIw" in kind.stiffness:
        K[6:, 6:] = warping.stiffness(l0, values.get("GJ", 0.0), values.get("EIw", 0.0))
    return K


def tangent_length(entry: ElementEntry) -> float:
    """Length of a bar without strain, or of the straight part of a belt."""
    if entry.line.keyword == "PLBELT":
        a, b = entry.numbers
        return float(np.sqrt(max(length(entry) ** 2 - (a - b) ** 2, 0.0))) or length(entry)
    return entry.values("LENGTH0")[0] if "LENGTH0" in entry.lines else length(entry)


def law_calls(entry: ElementEntry) -> list[Call]:
    """The linear law of the modes that are not rigid, and the release of those without one.

    Angles of hinges and bearings need no release.
    """
    S, D, sigma = coefficients(entry, "ESTIFF"), coefficients(entry, "EDAMPP"), initial_stresses(entry)
    acting = np.any(S, axis=1) | np.any(D, axis=1) | (sigma != 0.0)
    used = [i for i in sorted(entry.free) if i not in entry.kind.slips and acting[i - 1]]
    # a law takes six deformations at most; those of warping, 7 and 8, are coupled with no other
    calls = [
        _law(entry, part, S, D, sigma)
        for part in ([i for i in used if i <= 6], [i for i in used if i > 6])
        if part
    ]
    others = [
        name
        for i in sorted(entry.free)
        if i not in used and not (name := quantity(entry, i)[0]).endswith(".angle")
    ]
    if others:
        calls.append(Call("release", tuple(others), {}, entry.line))
    return calls


def _law(entry: ElementEntry, used: list[int], S: Array, D: Array, sigma: Array) -> Call:
    """The linear law of some modes together."""
    names, factors = zip(*(quantity(entry, i) for i in used), strict=True)
    grid = np.ix_([i - 1 for i in used], [i - 1 for i in used])
    ours = np.outer(factors, factors)
    line = next(entry.lines[z] for z in ("ESTIFF", "EDAMPP", "ESIG") if z in entry.lines)
    given: dict[str, Any] = {"stiffness": _numbers(S[grid] * ours)}
    if np.any(D[grid]):
        given["damping"] = _numbers(D[grid] * ours)
    if np.any(sigma[[i - 1 for i in used]]):
        preload = [float(sigma[i - 1] * f) for i, f in zip(used, factors, strict=True)]
        given["preload"] = preload if len(used) > 1 else preload[0]
    return Call("spring", (names[0] if len(used) == 1 else list(names),), given, line)


def initial_stresses(entry: ElementEntry) -> Array:
    """Stresses of all modes as drawn, of a line ESIG; only modes that are not rigid can have one."""
    given, modes = entry.values("ESIG"), len(entry.kind.modes)
    if len(given) > modes:
        raise entry.lines["ESIG"].error(
            f"{len(given)} stresses given; a {entry.line.keyword} has {modes} modes"
        )
    for i, value in enumerate(given, 1):
        if value and i not in entry.free:
            raise entry.lines["ESIG"].error(
                f"mode {i} of element {entry.number} is rigid, and its stress a reaction; release it (RLSE), or give 0"
            )
    return np.array([*given, *([0.0] * (modes - len(given)))])


def _numbers(A: Array) -> float | list[list[float]]:
    """A matrix in the form of `Model.spring`: rows, or one number if it has only one."""
    return float(A[0, 0]) if A.size == 1 else [[float(z) for z in row] for row in A]
