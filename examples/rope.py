"""Ropes beside closed forms: hanging, over drums and sheaves, striking a plane.

`reproduce` gives the relative error of each problem on its finest mesh, with the order of convergence.
Imports flexel; the problems are in `flexel.examples.rope_hanging` and `flexel.examples.rope_sheaves`.
"""

from __future__ import annotations

from pathlib import Path

from flexel.examples import rope_hanging as hanging
from flexel.examples import rope_sheaves as sheaves
from flexel.report import Report


def reproduce(out: Path | None = None) -> Report:
    """All problems beside their closed forms; figures in `out`, if given."""
    return Report("rope", [*hanging.rows(), *sheaves.rows()])
