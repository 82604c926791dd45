"""Sets the appearance of elements in pictures from the tables of a flexure mechanism."""

from __future__ import annotations

from collections.abc import Sequence

from flexel.apps.flexures.input_tables import FlexureTables, group_owner
from flexel.base.arguments import flag
from flexel.base.errors import ModelError
from flexel.parts.model import Model


def show(m: Model, beams: Sequence[str], tables: FlexureTables, element: int) -> None:
    """Give the beams of an element the look of its group."""
    group = tables.group(element)
    if group is None:
        return
    owner = group_owner(tables.group_of[element])
    hidden = flag(group.hidden, owner, "hidden")
    if group.colour is None and group.opacity is None and not hidden:
        return
    try:
        m.look(beams, colour=group.colour, opacity=group.opacity, hidden=hidden)
    except ModelError as error:
        raise ModelError(f"{owner}: {error}") from error
