"""Adapts docstrings for Sphinx: one attribute a line, no bars, and no colon in the first line of a property."""

from __future__ import annotations

import re
from collections.abc import Sequence

SHARED = re.compile(r"(\w+(?:, \w+)+) : (.+)")  # names that share a line
OUTSIDE = re.compile(r", (?![^(]*\))")  # a comma that is not within parentheses


def process(app: object, what: str, name: str, obj: object, options: object, lines: list[str]) -> None:
    """Change the lines of a docstring in place, before its sections are read."""
    lines[:] = escaped(separated(lines))
    if what in ("property", "attribute") and lines:  # text before a colon would become its type
        lines[0] = lines[0].replace(": ", " – ")


def escaped(lines: Sequence[str]) -> list[str]:
    """Escape bars: |x| is a length in the docstrings, not a substitution of reStructuredText."""
    return [line if line.lstrip().startswith(">>>") else line.replace("|", "\\|") for line in lines]


def separated(lines: Sequence[str]) -> list[str]:
    """Give attributes that share a line separate lines with the same text: a field of Sphinx has one name.

    Types are shared too, unless there are as many as names.
    """
    found: list[str] = []
    section = ""
    for i, line in enumerate(lines):
        if i + 1 < len(lines) and lines[i + 1] and set(lines[i + 1]) == {"-"}:
            section = line
        shared = SHARED.fullmatch(line) if section == "Attributes" else None
        if shared is None:
            found.append(line)
            continue
        names, types = shared[1].split(", "), OUTSIDE.split(shared[2])
        if len(types) != len(names) or "optional" in types:
            types = [shared[2]] * len(names)
        text = described(lines[i + 1 :])
        for name, kind in zip(names[:-1], types[:-1], strict=True):
            found += [f"{name} : {kind}", *text]
        found.append(f"{names[-1]} : {types[-1]}")
    return found


def described(lines: Sequence[str]) -> list[str]:
    """Return the indented lines at the start."""
    end = next((i for i, line in enumerate(lines) if not line.startswith(" ")), len(lines))
    return list(lines[:end])
