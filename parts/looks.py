"""How pictures show an element: its section, colour and opacity, or not at all.

For display only: the mechanics is not affected.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass, fields, replace
from string import hexdigits
from typing import Any

from flexel.base.arguments import array, flag, names, unknown
from flexel.base.arrays import Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import entry, quantity
from flexel.model.lowering import Lowering
from flexel.model.part import Part, part
from flexel.model.profiles import Section

LINES = ("", "bar", "beam", "rope")  # pictures of elements that are a line, along which a section is swept


@dataclass(frozen=True)
class Look:
    """Appearance of an element, set by `Model.look`; None means the default.

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


@part
class LookPart(Part[None]):
    """Set how the viewer and the plots show elements; the mechanics is not affected.

    Properties that are not given keep their earlier or default values.

    Raises
    ------
    ModelError
        An element that does not exist; a section for an element that is not a line; an invalid colour.

    Examples
    --------
    >>> m.look("rod", section=fx.Circle(8e-3), colour="#0b5fa5")  # doctest: +SKIP
    >>> m.look(["left", "right"], colour=(0.8, 0.1, 0.1), opacity=0.5)  # doctest: +SKIP
    """

    elements: str | Sequence[str] = entry("Names of elements.")
    _: KW_ONLY
    section: Section | None = entry(
        "Section swept along a beam, truss or cable in the viewer, instead of the section used in the calculation.",
        default=None,
    )
    colour: str | Vector | None = entry(
        'Colour: "#0b5fa5", or red, green and blue from 0 to 1.', default=None
    )
    opacity: float | None = quantity(
        "-",
        "any",
        "Opacity of lines and of the sections swept along them, from 0 (invisible) to 1.",
        default=None,
    )
    hidden: bool | None = entry("Do not draw the elements.", default=None)

    @property
    def owner(self) -> str:
        """The look, by the first of its elements."""
        chosen = [self.elements] if isinstance(self.elements, str) else self.elements
        return f"look of '{chosen[0]}'" if isinstance(chosen, (list, tuple)) and chosen else "look"

    def lower(self, to: Lowering) -> None:
        """Change the look of the elements."""
        chosen = (
            (self.elements,) if isinstance(self.elements, str) else names(self.elements, "look: elements")
        )
        for name in chosen:
            if name not in to.instances:
                raise ModelError(f"look: {unknown(name, to.instances, 'element')}")
        if not chosen:
            raise ModelError("look: elements is an empty list; give names of elements")
        given = _checked(self)
        changes = {item.name: getattr(given, item.name) for item in fields(given)}
        changes = {name: value for name, value in changes.items() if value is not None}
        if not changes:
            raise ModelError(
                f"{self.owner}: no property is given; give section=, colour=, opacity= or hidden="
            )
        if given.section is not None:
            _check_lines(to, chosen)
        for name in chosen:
            instance = to.instances[name]
            before = instance.look if isinstance(instance.look, Look) else Look()
            to.instances[name] = replace(instance, look=replace(before, **changes))


def _checked(given: LookPart) -> Look:
    """Return what is given of a look; None for the rest."""
    owner = given.owner
    return Look(
        None if given.section is None else _swept(given.section, owner),
        None if given.colour is None else colour_of(given.colour, owner),
        None if given.opacity is None else _opacity(given.opacity, owner),
        None if given.hidden is None else flag(given.hidden, owner, "hidden"),
    )


def _check_lines(to: Lowering, chosen: Sequence[str]) -> None:
    """Check that elements are drawn as lines, along which a section is swept."""
    for name in chosen:
        spec = to.instances[name].spec
        if spec.picture not in LINES:
            raise ModelError(
                f"look of '{name}': a {spec.name} is not drawn as a line and has no section; leave section out"
            )


def colour_of(given: Any, owner: str) -> str:
    """Return a colour "#rrggbb" as it is, or from red, green and blue between 0 and 1; else raise a ModelError."""
    if isinstance(given, str):
        if len(given) != 7 or given[0] != "#" or any(digit not in hexdigits for digit in given[1:]):
            raise ModelError(f"{owner}: colour {given!r:.40} is not of the form '#rrggbb'; give one that is")
        return given
    parts = array(given, owner, "colour")
    if parts.shape != (3,) or (parts < 0).any() or (parts > 1).any():
        raise ModelError(
            f"{owner}: colour {given!r:.60} is not red, green and blue from 0 to 1; give these, or '#rrggbb'"
        )
    return "#" + "".join(f"{round(255 * share):02x}" for share in parts.tolist())


def _swept(section: Any, owner: str) -> Section:
    if not isinstance(section, Section):
        raise ModelError(
            f"{owner}: {section!r:.60} is not a section; give Rectangle, Circle, Tube or IBeam, or an object with "
            "their properties"
        )
    return section


def _opacity(value: float, owner: str) -> float:
    if not 0 <= value <= 1:
        raise ModelError(f"{owner}: opacity {value:g} is not between 0 and 1; give a number that is")
    return value
