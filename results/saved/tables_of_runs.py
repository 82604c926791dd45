"""Recognizes the tables that a SPACAR run writes in addition to its motion, which cannot be loaded as results."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from flexel.base.errors import ModelError

HISTORY = re.compile(
    r"[xes]_\d+_\d+"
)  # column of a coordinate, a deformation or a stress in SPACAR's numbering
STATE_SPACE = frozenset("ABCD")


def motion_beside(table: Path) -> Path:
    """Return the path of the motion of the run whose tables are in that file."""
    return table.with_name(f"{table.stem}_motion.npz")


def refuse_table(path: Path, names: Iterable[str]) -> None:
    """Raise an error that refers to the motion if the file is a table of a SPACAR run; ignore other files.

    Parameters
    ----------
    names : iterable of str
        Of its arrays or columns.

    Raises
    ------
    ModelError
    """
    found = set(names)
    if not (found >= STATE_SPACE or any(HISTORY.fullmatch(name) for name in found)):
        return
    motion = motion_beside(path)
    where = f"give '{motion}', its motion" if motion.is_file() else "its motion is not next to this file"
    raise ModelError(
        f"load '{path}': this is a table of a SPACAR run, numbers without the mechanism; {where}"
    )
