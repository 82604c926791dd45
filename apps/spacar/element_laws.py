"""Converts stiffness, damping and initial stresses of the elements of a file to parts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from flexel.apps.spacar.declarations import Declaration
from flexel.apps.spacar.file_entries import ElementEntry, deformation_of, length
from flexel.apps.spacar.keywords import ElementType
from flexel.base.arrays import Array
from flexel.parts.beam_matrix import beam_matrix
from flexel.parts.beams import MODES
from flexel.parts.roles import Release
from flexel.parts.springs import Spring

PLANAR_MODES = ("elongation", "bend1", "bend2")
BEAM_MODES = {"BEAM": MODES, "BEAMNL": MODES, "BEAMW": (*MODES, "warp1", "warp2")}
BEAM_MODES |= {"PLBEAM": PLANAR_MODES, "PLBEAMNL": PLANAR_MODES}


def coefficients(entry: ElementEntry, keyword: str) -> Array:
    """Return the matrix of all modes of the element from a line ESTIFF or EDAMPP, for SPACAR's deformations."""
    given, kind = entry.values(keyword), entry.kind
    if len(given) > len(kind.stiffness):
        raise entry.lines[keyword].error(
            f"{len(given)} values given; a {entry.line.keyword} has {', '.join(kind.stiffness)}"
        )
    if any(value < 0 for value in given):
        raise entry.lines[keyword].error("a value is negative; give zero or positive values")
    K = np.zeros((len(kind.modes),) * 2)
    if entry.line.keyword not in BEAM_MODES:
        along = entry.line.keyword in ("TRUSS", "PLTRUSS", "PLBELT")
        for i, value in enumerate(given):
            K[i, i] = value / tangent_length(entry) if along else value
        return K
    stiffnesses = beam_stiffnesses(kind, given)
    if "EIw" in kind.stiffness:
        stiffnesses.setdefault("EIw", 0.0)  # uneven twist has the stiffness of torsion all the same
    planar = entry.line.keyword.startswith("PL")
    return beam_matrix(length(entry), BEAM_MODES[entry.line.keyword], stiffnesses, planar)


def beam_stiffnesses(kind: ElementType, given: Sequence[float]) -> dict[str, float]:
    """Return the nonzero stiffnesses of a beam in the form of `Model.beam`, from the numbers of a file."""
    values = {key: value for key, value in zip(kind.stiffness, given, strict=False) if value}
    if "EI" in values:
        values["EIz"] = values.pop("EI")
    for bending, shear in (("EIy", "GAz"), ("EIz", "GAy")):
        ratio = values.pop(f"{bending}/GAk", 0.0)
        if ratio and bending in values:
            values[shear] = values[bending] / ratio
    return values


def tangent_length(entry: ElementEntry) -> float:
    """Return the length of a bar without strain, or of the straight part of a belt."""
    if entry.line.keyword == "PLBELT":
        a, b = entry.numbers
        return float(np.sqrt(max(length(entry) ** 2 - (a - b) ** 2, 0.0))) or length(entry)
    return entry.values("LENGTH0")[0] if "LENGTH0" in entry.lines else length(entry)


def law_parts(entry: ElementEntry) -> list[Declaration]:
    """Return the linear law of the modes that are not rigid, and the release of those without one.

    Angles of hinges and bearings need no release.
    """
    S, D, sigma = coefficients(entry, "ESTIFF"), coefficients(entry, "EDAMPP"), initial_stresses(entry)
    acting = np.any(S, axis=1) | np.any(D, axis=1) | (sigma != 0.0)
    used = [i for i in sorted(entry.free) if i not in entry.kind.slips and acting[i - 1]]
    # a law takes six deformations at most; those of warping, 7 and 8, are coupled with no other
    found = [
        _law(entry, part, S, D, sigma)
        for part in ([i for i in used if i <= 6], [i for i in used if i > 6])
        if part
    ]
    others = [
        name
        for i in sorted(entry.free)
        if i not in used and not (name := deformation_of(entry, i)[0]).endswith(".angle")
    ]
    if others:
        found.append(Declaration.of(entry.line, Release, tuple(others)))
    return found


def _law(entry: ElementEntry, used: list[int], S: Array, D: Array, sigma: Array) -> Declaration:
    """Return the linear law of some modes together."""
    names, factors = zip(*(deformation_of(entry, i) for i in used), strict=True)
    grid = np.ix_([i - 1 for i in used], [i - 1 for i in used])
    ours = np.outer(factors, factors)
    line = next(entry.lines[keyword] for keyword in ("ESTIFF", "EDAMPP", "ESIG") if keyword in entry.lines)
    given: dict[str, Any] = {"stiffness": _numbers(S[grid] * ours)}
    if np.any(D[grid]):
        given["damping"] = _numbers(D[grid] * ours)
    if np.any(sigma[[i - 1 for i in used]]):
        preload = [float(sigma[i - 1] * f) for i, f in zip(used, factors, strict=True)]
        given["preload"] = preload if len(used) > 1 else preload[0]
    return Declaration.of(line, Spring, names[0] if len(used) == 1 else list(names), **given)


def initial_stresses(entry: ElementEntry) -> Array:
    """Return the stresses of all modes as drawn, from a line ESIG; only modes that are not rigid can have one."""
    given, modes = entry.values("ESIG"), len(entry.kind.modes)
    if len(given) > modes:
        raise entry.lines["ESIG"].error(
            f"{len(given)} stresses given; a {entry.line.keyword} has {modes} modes"
        )
    for i, value in enumerate(given, 1):
        if value and i not in entry.free:
            raise entry.lines["ESIG"].error(
                f"mode {i} of element {entry.number} is rigid, so its stress is a reaction; "
                "release it (RLSE), or give 0"
            )
    found = np.array([*given, *([0.0] * (modes - len(given)))])
    if entry.line.keyword == "BEAMW":  # conjugate to e7 and e8 without the torsion, which our modes contain
        found[1] += found[6] + found[7]
    return found


def _numbers(A: Array) -> float | list[list[float]]:
    """Convert a matrix to the form of `Model.spring`: rows, or one number if it has only one."""
    return float(A[0, 0]) if A.size == 1 else [[float(value) for value in row] for row in A]
