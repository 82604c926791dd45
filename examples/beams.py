"""Published problems of flexible beams: large deflections, buckling, frequencies, rotation.

`reproduce` compares each with its closed form or with a solution computed by other means, gives the order of
convergence, and counts the elements that each needs for 1 % and for 0.1 %, with and without the second-order terms
of the deformations.
The analyses are in `flexel.examples.beams_static` and `flexel.examples.beams_dynamic`, the pictures
in `flexel.examples.beams_figures`.
"""

from __future__ import annotations

from pathlib import Path

from flexel.examples import beams_dynamic as dynamic
from flexel.examples import beams_static as static
from flexel.results.reproduction import Report


def reproduce(out: Path | None = None) -> Report:
    """Compute all problems with their references; write figures to `out`, if given."""
    rows = [
        *static.large_deflections(),
        *static.buckling(),
        *dynamic.vibrations(),
        *dynamic.spin_up(),
        *static.meshes_needed(),
    ]
    files: list[Path] = []
    if out is not None:
        from flexel.examples.beams_figures import pictures

        files = pictures(rows, out)
    return Report("beams", rows, files)
