"""Suggestions for a misspelt name: known names that resemble it, not names that share only a few letters."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

MIN_LIKENESS = 0.6  # share of common letters, in the same order, below which names are not similar
LIKENESS_BAND = 0.1  # names whose likeness is lower than the best by more than this are left out
MAX_LETTERS = 99  # letters that are compared
MAX_SIMILAR, MAX_OF_OWNER = 3, 8  # similar names; quantities of one node or element


def near_names(name: str, known: Iterable[str]) -> list[str]:
    """Suggest known names for an unknown one, the best first; return none rather than a poor match.

    Names are ``part.quantity`` or single words. A part alone suggests its quantities. If a part exists, only its
    quantities are compared; otherwise both part and quantity must be similar.

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
        return own[:MAX_OF_OWNER]
    part, _, quantity = name.rpartition(".")
    mates = quantities_of(part, names)
    if mates:
        return _closest({mate: _begun(quantity, mate.rpartition(".")[2]) for mate in mates})
    return _closest({other: _alike(name, other) for other in names})


def quantities_of(part: str, known: Iterable[str]) -> list[str]:
    """Return the known quantities of a node or element; none if there is no such part."""
    return [name for name in dict.fromkeys(known) if part and name.rpartition(".")[0] == part]


def _alike(name: str, other: str) -> float:
    """Compute the similarity, from 0 to 1, of two names with different parts."""
    part, dot, quantity = name.rpartition(".")
    other_part, other_dot, other_quantity = other.rpartition(".")
    if dot and other_dot:
        return min(_likeness(part, other_part), _likeness(quantity, other_quantity))
    if other_dot:  # the part or the quantity alone, or a wrong separator
        return max(_likeness(name, candidate) for candidate in (other_part, other_quantity, other))
    return _likeness(name, other)


def _begun(a: str, b: str) -> float:
    """Compute the similarity, counting the beginning of a word as the whole word."""
    return max(_likeness(a, b), MIN_LIKENESS if a and b.startswith(a) else 0.0)


def _likeness(a: str, b: str) -> float:
    """Compute the share of common letters, from 0 to 1, ignoring case."""
    a, b = a[:MAX_LETTERS].lower(), b[:MAX_LETTERS].lower()
    return difflib.SequenceMatcher(None, b, a).ratio()


def _closest(likeness: dict[str, float]) -> list[str]:
    """Return the best names and those nearly as good."""
    least = max(MIN_LIKENESS, max(likeness.values(), default=0.0) - LIKENESS_BAND)
    found = sorted(
        (candidate for candidate in likeness if likeness[candidate] >= least),
        key=lambda candidate: -likeness[candidate],
    )
    return found[:MAX_SIMILAR]
