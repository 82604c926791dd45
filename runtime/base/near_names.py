"""Known names that a misspelt one may stand for, but none that merely shares a letter with it."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

LIKENESS = 0.6  # share of letters in common, in the same order, below which names are not alike
BAND = 0.1  # names less alike than the best by more are left out
LONGEST = 99  # letters that are compared
FEW, SEVERAL = 3, 8  # alike names, names of one node or element


def near_names(name: str, known: Iterable[str]) -> list[str]:
    """Known names that a wrong name may stand for, the best first; none rather than a poor one.

    Names are ``part.quantity`` or single words. A part alone stands for its quantities. Where a part exists, only its
    own quantities are compared; elsewhere both, part and quantity, must be alike.

    Examples
    --------
    >>> near_names("crnk.angle", ["crank.angle", "crank.bend1", "rod.angle"])
    ['crank.angle']
    >>> near_names("crank", ["crank.angle", "crank.bend1", "rod.angle"])
    ['crank.angle', 'crank.bend1']
    >>> near_names("wheel", ["crank.angle", "rod.angle"])
    []
    """
    names = list(dict.fromkeys(known))
    own = quantities_of(name, names)
    if own:
        return own[:SEVERAL]
    part, _, quantity = name.rpartition(".")
    mates = quantities_of(part, names)
    if mates:
        return _closest({z: _likeness(quantity, z.rpartition(".")[2]) for z in mates})
    return _closest({z: _alike(name, z) for z in names})


def quantities_of(part: str, known: Iterable[str]) -> list[str]:
    """Known names of the quantities of a node or element; none if there is no such part."""
    return [z for z in dict.fromkeys(known) if part and z.rpartition(".")[0] == part]


def _alike(name: str, other: str) -> float:
    """How much two names are alike whose parts differ, from 0 to 1."""
    part, dot, quantity = name.rpartition(".")
    other_part, other_dot, other_quantity = other.rpartition(".")
    if dot and other_dot:
        return min(_likeness(part, other_part), _likeness(quantity, other_quantity))
    if other_dot:  # the part alone, the quantity alone, or something else between them than a dot
        return max(_likeness(name, z) for z in (other_part, other_quantity, other))
    return _likeness(name, other)


def _likeness(a: str, b: str) -> float:
    """Share of letters in common, from 0 to 1; capitals count as small letters, and a beginning as its word."""
    a, b = a[:LONGEST].lower(), b[:LONGEST].lower()
    if a == b:
        return 1.0
    if a and b and (a.startswith(b) or b.startswith(a)):
        return max(LIKENESS, 2 * min(len(a), len(b)) / (len(a) + len(b)))
    return difflib.SequenceMatcher(None, b, a).ratio()


def _closest(likeness: dict[str, float]) -> list[str]:
    """The best and those nearly as good."""
    least = max(LIKENESS, max(likeness.values(), default=0.0) - BAND)
    found = sorted((z for z in likeness if likeness[z] >= least), key=lambda z: -likeness[z])
    return found[:FEW]
