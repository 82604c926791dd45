"""The object that a declaration returns to the user; it has a name, by which parts keep it."""

from __future__ import annotations

from flexel.base.copies import Constant


class Handle(Constant):
    """Base of nodes, rigid bodies, surfaces and ropes; ``name`` finds them in their model."""

    name: str


def name_of(part: str | Handle) -> str:
    """Return the name of a part that is given by its name or itself."""
    return part.name if isinstance(part, Handle) else part
