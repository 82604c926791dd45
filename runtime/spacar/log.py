"""The log of a file as SPACAR writes one: counts, degrees of freedom in their order, what is fixed and dependent."""

from __future__ import annotations

from collections.abc import Sequence

from flexel.base.errors import ConstraintError
from flexel.spacar.count import count_lines
from flexel.spacar.reading import Spacar
from flexel.spacar.vectors import Place

# in the order in which SPACAR counts them, in NXP and NEP of its .sbd files
PARTS = ("fixed", "dependent", "prescribed", "dynamic", "kinematic")
PER_LINE = 6


def log_lines(file: Spacar, mode: int) -> list[str]:
    """The log of a file; of one whose coordinates do not determine a motion, the counts and the reason."""
    lines = [
        f"{file.path.name}: SPACAR, {file.dialect} dialect, mode {mode}",
        *(f"note: {z}" for z in file.notes),
        "",
        *count_lines(file)[0],
    ]
    try:
        coordinates, deformations = parts(file)
    except ConstraintError:  # which the counts report
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
    rows = [names[i : i + PER_LINE] for i in range(0, len(names), PER_LINE)]
    return (
        [f"  {title}:", *("    " + " ".join(f"{z:<12}" for z in row).rstrip() for row in rows)]
        if rows
        else []
    )


def parts(file: Spacar) -> tuple[dict[str, list[Place]], dict[str, list[Place]]]:
    """Coordinates and deformations by what determines them, in SPACAR's order; without norms.

    Of an orientation that is fixed the first component is dependent, as in SPACAR: it follows from the norm.

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
