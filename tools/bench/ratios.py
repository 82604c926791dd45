"""Ratios of times: each program beside flexel, at its best."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import inf
from typing import Protocol


class Times(Protocol):
    """Times of a program: of the largest size, and of each size if the row has sizes."""

    @property
    def value(self) -> float | None:
        """Of the largest size."""

    @property
    def values(self) -> Sequence[float | None]:
        """Of each size."""


def peer_ratios(row: Times, peers: Mapping[str, Times | None]) -> dict[str, float]:
    """Return the time of each peer relative to flexel's, for the largest size that both can run."""
    found = {}
    for name, other in peers.items():
        if other is None:
            continue
        pairs = zip(other.values or [other.value], row.values or [row.value], strict=False)
        both = [time / own for time, own in pairs if time is not None and own]
        if both:
            found[name] = both[-1]
    return found


def program(name: str) -> str:
    """Return the name of a program without the way it is used: exudyn for "exudyn, full Newton"."""
    return name.partition(", ")[0]


def best(values: Mapping[str, float]) -> dict[str, float]:
    """Return, for each program, the smallest value of all its ways, by the name with the way."""
    found: dict[str, str] = {}
    for name, value in values.items():
        if value < values.get(found.get(program(name), ""), inf):
            found[program(name)] = name
    return {name: values[name] for name in found.values()}
