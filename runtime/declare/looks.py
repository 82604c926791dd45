"""How pictures show an element: a section, a colour, how opaque it is, or not at all.

For display only: the mechanics is not affected.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

from flexel.base.arguments import array, flag, names, number, unknown
from flexel.base.arrays import Vector
from flexel.base.errors import ModelError
from flexel.declare.declarations import Declarations
from flexel.declare.sections import Section

LINES = ("", "bar", "beam", "rope")  # pictures of elements that are a line, along which a section is swept


@dataclass(frozen=True)
class Look:
    """Appearance of an element, set by `Model.look`; None stands for the default.

    Parameters
    ----------
    section : Section, optional
    colour : str, optional
        As "#rrggbb".
    opacity : float, optional
    hidden : bool, optional
    """

    section: Section | None = None
    colour: str | None = None
    opacity: float | None = None
    hidden: bool | None = None


class Looks(Declarations):
    """The appearance of elements in pictures."""

    def look(
        self,
        elements: str | Sequence[str],
        *,
        section: Section | None = None,
        colour: str | Vector | None = None,
        opacity: float | None = None,
        hidden: bool | None = None,
    ) -> None:
        """Set how the viewer and the plots show elements; the mechanics is not affected.

        Properties that are not given keep their earlier or default values.

        Parameters
        ----------
        elements : str or sequence of str
            Names of elements.
        section : Section, optional
            Swept along a beam, truss or cable in the viewer, in place of the section that it is calculated with.
        colour : str or sequence of float (3,), optional
            As "#0b5fa5", or red, green and blue from 0 to 1.
        opacity : float, optional
            From 0, not visible, to 1; of lines and of what is swept along them.
        hidden : bool, optional
            True: not drawn.

        Raises
        ------
        ModelError
            An element that does not exist, or is not a line and is given a section; an invalid colour.

        Examples
        --------
        >>> m.look("rod", section=fx.Circle(8e-3), colour="#0b5fa5")  # doctest: +SKIP
        >>> m.look(["left", "right"], colour=(0.8, 0.1, 0.1), opacity=0.5)  # doctest: +SKIP
        """
        chosen = (elements,) if isinstance(elements, str) else names(elements, "look: elements")
        for name in chosen:
            if name not in self.instances:
                raise ModelError(f"look: {unknown(name, self.instances, 'element')}")
        if not chosen:
            raise ModelError("look: elements is an empty list; give names of elements")
        owner = f"look of '{chosen[0]}'"
        given = Look(
            None if section is None else _swept(section, owner),
            None if colour is None else colour_of(colour, owner),
            None if opacity is None else _opacity(opacity, owner),
            None if hidden is None else flag(hidden, owner, "hidden"),
        )
        changes = {z.name: v for z in fields(given) if (v := getattr(given, z.name)) is not None}
        if not changes:
            raise ModelError(f"{owner}: no property is given; give section=, colour=, opacity= or hidden=")
        if given.section is not None:
            for name in chosen:
                if self.instances[name].spec.picture not in LINES:
                    kind = self.instances[name].spec.name
                    raise ModelError(
                        f"look of '{name}': a {kind} is not drawn as a line and has no section; leave section out"
                    )
        for name in chosen:
            instance = self.instances[name]
            before = instance.look if isinstance(instance.look, Look) else Look()
            self.instances[name] = replace(instance, look=replace(before, **changes))


def colour_of(given: Any, owner: str) -> str:
    """A colour "#rrggbb" as it is, or from red, green and blue between 0 and 1; a ModelError otherwise."""
    if isinstance(given, str):
        if len(given) != 7 or given[0] != "#" or any(z not in "0123456789abcdefABCDEF" for z in given[1:]):
            raise ModelError(f"{owner}: colour {given!r:.40} is not of the form '#rrggbb'; give one that is")
        return given
    parts = array(given, owner, "colour")
    if parts.shape != (3,) or (parts < 0).any() or (parts > 1).any():
        raise ModelError(
            f"{owner}: colour {given!r:.60} is not red, green and blue from 0 to 1; give these, or '#rrggbb'"
        )
    return "#" + "".join(f"{round(255 * z):02x}" for z in parts.tolist())


def _swept(section: Any, owner: str) -> Section:
    if not isinstance(section, Section):
        raise ModelError(
            f"{owner}: {section!r:.60} is not a section; give Rectangle, Circle, Tube or IBeam, or an object with "
            "their properties"
        )
    return section


def _opacity(given: Any, owner: str) -> float:
    value = number(given, owner, "opacity")
    if not 0 <= value <= 1:
        raise ModelError(f"{owner}: opacity {value:g} is not between 0 and 1; give a number that is")
    return value
