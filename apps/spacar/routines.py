"""Writes functions to fill in for a user's routines USERINP and USERSIG, which change nothing as they are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flexel.base.time_functions import Polynomial
from flexel.parts.model_program import literal
from flexel.parts.roles import Prescribe


def input_lines(part: Prescribe, routine: str) -> list[str]:
    """Return a function of time in place of an input's motion, with that motion, and the call that prescribes it."""
    name, motion = part.name, part.motion
    own = f"userinp_{name.replace('.', '_')}"
    terms = motion.coefficients if isinstance(motion, Polynomial) else (motion, 0.0)
    powers = ("", " * t", " * t**2")
    formula = " + ".join(f"{float(c)!r}{power}" for c, power in zip(terms, powers, strict=False))
    return [
        "",
        "",
        f"def {own}(t):",
        f"    # fill in what the routine '{routine}' computes; this is the motion given in the file",
        f"    return {formula}",
        "",
        "",
        f"m.prescribe({literal(name)}, {own})",
    ]


def stress_lines(routines: Mapping[str, str], deformations: Sequence[str]) -> list[str]:
    """Return a function that adds the stresses and forces of USERSIG, and its call; none without USERSIG."""
    if "USERSIG" not in routines:
        return []
    example = f"model.law({literal(deformations[0] if deformations else 'beam1.elongation')}, lambda e, ed: 2e4 * e)"
    return [
        "",
        "",
        "def usersig(model):",
        f"    # fill in what the routine '{routines['USERSIG']}' computes, with calls such as",
        f"    # {example}",
        "    return",
        "",
        "",
        "usersig(m)",
    ]
