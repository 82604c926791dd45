"""Reports the output of UT SPACAR's mode 0: constraints and degrees of freedom of a mechanism, and their condition."""

from __future__ import annotations

import numpy as np

from flexel.apps.spacar.reading import Spacar
from flexel.base.errors import ConstraintError


def count_lines(file: Spacar) -> tuple[list[str], float]:
    """Report counts, over- and under-constraint and the table of degrees of freedom, and return the condition number.

    The condition is that of the rows of constraints and degrees of freedom; infinite if they do not determine a
    motion.
    """
    coordinates, deformations = file.coordinates, file.deformations
    lines = [
        f"{len(coordinates)} coordinates of {len({n for n, _ in coordinates})} nodes",
        f"{len(deformations)} deformations of {len({e for e, _ in deformations})} elements",
    ]
    report = file.model.constraint_report()
    try:
        system = file.system
    except ConstraintError as error:  # the purpose of mode 0
        return [*lines, str(report), str(error)], np.inf
    roles, places = system.roles, _in_file(file)
    lines += [
        f"{system.structure.n - system.structure.nf} coordinates are fixed, {roles.prescribed.size} motions given, "
        f"{roles.rigid.size} conditions rigid (norms of orientations among them), {report.dofs} degrees of freedom "
        "left",
        "degrees of freedom",
        *(
            f"  {i:<4} {places[name]:<10} {name}"
            for i, name in enumerate(system.dynamic + system.kinematic, 1)
        ),
    ]
    rows = system.initial.J[roles.position_rows][:, : system.structure.nf]
    condition = float(np.linalg.cond(rows)) if rows.size else 1.0
    return [*lines, f"condition number {condition:.3e}"], condition


def _in_file(file: Spacar) -> dict[str, str]:
    """Return node and component, or element and mode, of all quantities of a file by their names."""
    places = {name: f"X {n} {i}" for (n, i), name in file.coordinates.items()}
    return places | {name: f"E {e} {i}" for (e, i), (name, _) in file.deformations.items()}
