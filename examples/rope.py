"""Ropes compared with closed forms: hanging, over drums and sheaves, striking a plane.

`reproduce` gives the relative error of each problem on its finest mesh, with the order of convergence.
The problems are in `flexel.examples.rope_hanging`, `rope_waves`, `rope_swings`,
`rope_pendulums`, `rope_sheaves`, `rope_hoists`, `rope_drums` and `rope_belts`.
"""

from __future__ import annotations

from pathlib import Path

from flexel.examples import rope_belts as belts
from flexel.examples import rope_drums as drums
from flexel.examples import rope_hanging as hanging
from flexel.examples import rope_hoists as hoists
from flexel.examples import rope_pendulums as pendulums
from flexel.examples import rope_sheaves as sheaves
from flexel.examples import rope_swings as swings
from flexel.examples import rope_waves as waves
from flexel.results.reproduction import Report


def reproduce(out: Path | None = None) -> Report:
    """Compute all problems with their closed forms; write figures to `out`, if given."""
    parts = (hanging, waves, swings, pendulums, sheaves, hoists, drums, belts)
    rows = [row for part in parts for row in part.rows()]
    files: list[Path] = []
    if out is not None:
        from flexel.examples.rope_figures import pictures

        files = pictures(rows, out)
    return Report("rope", rows, files)
