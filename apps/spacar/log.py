"""Writes the log of a file as SPACAR does: counts, degrees of freedom in order, fixed and dependent quantities."""

from __future__ import annotations

from collections.abc import Sequence

from flexel.apps.spacar.count import count_lines
from flexel.apps.spacar.reading import Spacar
from flexel.apps.spacar.vectors import Place
from flexel.base.errors import ConstraintError

# in the order in which SPACAR counts them, in NXP and NEP of its .sbd files
PARTS = ("fixed", "dependent", "prescribed", "dynamic", "kinematic")
NAMES_PER_LINE = 6


def log_lines(file: Spacar, mode: int) -> list[str]:
    """Write the log of a file; if its coordinates do not determine a motion, the counts and the reason."""
    lines = [
        f"{file.path.name}: SPACAR, {file.dialect} dialect, mode {mode}",
        *(f"note: {note}" for note in file.notes),
        "",
        *count_lines(file)[0],
    ]
    try:
        coordinates, deformations = parts(file)
    except ConstraintError:  # reported by the counts
        return lines
    norms = sorted({n for n, i in file.coordinates if i == 4})
    for what, subject, found in (
        ("coordinates (node coordinate)", "X", coordinates),
        ("deformations (element mode)", "E", deformations),
    ):
        extra = len(norms) if subject == "E" else 0
        counts = [f"{part} {len(found[part]) + (extra if part == 'fixed' else 0)}" for part in PARTS]
        lines += ["", what, f"  {', '.join(counts)}"]
        for part in PARTS:
            lines += _listed(part, [f"{subject} {n} {i}" for n, i in found[part]])
        if extra:
            lines += _listed("fixed, norms of orientation nodes", [str(n) for n in norms])
    return lines


def _listed(title: str, names: Sequence[str]) -> list[str]:
    rows = [names[i : i + NAMES_PER_LINE] for i in range(0, len(names), NAMES_PER_LINE)]
    return (
        [f"  {title}:", *("    " + " ".join(f"{cell:<12}" for cell in row).rstrip() for row in rows)]
        if rows
        else []
    )


def parts(file: Spacar) -> tuple[dict[str, list[Place]], dict[str, list[Place]]]:
    """Return coordinates and deformations by what determines them, in SPACAR's order; without norms.

    The first component of a fixed orientation is dependent, as in SPACAR: it follows from the norm.

    Raises
    ------
    ConstraintError
        Coordinates that do not determine a motion.
    """
    system = file.system
    names, roles = system.structure.names, system.roles
    role: dict[str, str] = {}
    for part, places in (
        ("fixed", [*roles.rigid, *roles.zero]),
        ("prescribed", roles.prescribed),
        ("dynamic", roles.dynamic),
        ("kinematic", roles.kinematic),
    ):
        role |= {names[i]: part for i in places}
    for node in system.structure.nodes:
        held = [name for name, fixed in zip(node.coordinates, node.fixed, strict=True) if fixed]
        role |= dict.fromkeys(held[1:] if len(held) == 4 else held, "fixed")
    coordinates: dict[str, list[Place]] = {part: [] for part in PARTS}
    deformations: dict[str, list[Place]] = {part: [] for part in PARTS}
    for place, name in file.coordinates.items():
        coordinates[role.get(name, "dependent")].append(place)
    for place, (name, _) in file.deformations.items():
        deformations[role.get(name, "dependent")].append(place)
    return coordinates, deformations
