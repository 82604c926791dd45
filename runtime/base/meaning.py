"""Meaning of the fields of parts, sections and materials: unit, sign, and one line of text."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import MISSING, Field, dataclass, field
from typing import Any, TypeVar, dataclass_transform

from flexel.base.arguments import not_negative, number, positive

Described = TypeVar("Described")
CLAUSE_END = re.compile(r"(?=;|, by default|\.(?:\s|$))")
SIGNS: Mapping[str, Callable[[Any, str, str], float]] = {
    "any": number,
    "positive": positive,
    "not negative": not_negative,
}


@dataclass(frozen=True)
class Meaning:
    """Meaning of a field of a part.

    Attributes
    ----------
    text : str
        One line or a few sentences; ``[]`` marks where the unit is written.
    unit : str, optional
        Of a number or an array of numbers; None for everything else.
    sign : str, optional
        Of a number: a word of `SIGNS`.  None for arrays, which `lower` checks.
    called : str, optional
        What messages call the field; its name by default.
    spread : bool
        Whether its entries are arguments of the call, positional ones of a tuple and named ones of a mapping.
    form : str, optional
        What documentation calls its type; its annotation in words by default.
    named : callable, optional
        The object that a text stands for, such as a material; None if there is none of that name.
    """

    text: str
    unit: str | None = None
    sign: str | None = None
    called: str | None = None
    spread: bool = False
    form: str | None = None
    named: Callable[[str], Any] | None = None

    @property
    def sentence(self) -> str:
        """The text with its unit: where it is marked, otherwise at the end of the first clause."""
        if self.unit in (None, "-", ""):
            return self.text
        if "[]" in self.text:
            return self.text.replace("[]", f"[{self.unit}]", 1)
        return CLAUSE_END.sub(f" [{self.unit}]", self.text, count=1)


def quantity(unit: str, sign: str, text: str, *, default: Any = MISSING, called: str | None = None) -> Any:
    """Declare a field of a part that is one number, checked when the part is made.

    Parameters
    ----------
    unit : str
        Such as "N m²"; "-" for a number without one.
    sign : str
        "positive", "not negative" or "any".
    text : str
        What the number is, in one or a few sentences; ``[]`` marks where documentation writes the unit.
    default : optional
        Without a default the field is required.  None is accepted only if it is the default.
    called : str, optional
        What messages call the number; the name of the field by default.
    """
    return field(default=default, metadata={"meaning": Meaning(text, unit, sign, called)})


def array_quantity(unit: str, text: str, *, default: Any = MISSING, form: str | None = None) -> Any:
    """Declare a field of a part that is several numbers, of a shape that `Part.lower` checks.

    Parameters
    ----------
    unit, text, default
        As of `quantity`; the unit is "" for numbers in the units of the quantities that the part names.
    form : str, optional
        What documentation calls the type; by default the annotation in words.
    """
    return field(default=default, metadata={"meaning": Meaning(text, unit, form=form)})


def in_unit(unit: str, *, default: Any = MISSING) -> Any:
    """Declare a number of a section, a material or another object that parts are given, whose class checks it."""
    return field(default=default, metadata={"meaning": Meaning("", unit)})


def entry(
    text: str,
    *,
    default: Any = MISSING,
    spread: bool = False,
    form: str | None = None,
    named: Callable[[str], Any] | None = None,
) -> Any:
    """Declare a field of a part that is no physical quantity: a name, a node, an option, a function, a section.

    Parameters
    ----------
    text, default
        As of `quantity`.
    spread : bool
        Whether the entries are arguments of the call: ``*names`` of a tuple, ``**parameters`` of a mapping.
    form : str, optional
        What documentation calls the type; by default the annotation in words.
    named : callable, optional
        The object that a text stands for, whose numbers are then parameters; None if there is none.
    """
    return field(default=default, metadata={"meaning": Meaning(text, spread=spread, form=form, named=named)})


def meaning_of(item: Field[Any]) -> Meaning:
    """Return the meaning of a field of a part."""
    found: Meaning = item.metadata.get("meaning") or Meaning("")
    return found


@dataclass_transform(frozen_default=True, field_specifiers=(in_unit,))
def described(cls: type[Described]) -> type[Described]:
    """Make a class a frozen dataclass whose numbers state their unit; variants may have other values of them."""
    return dataclass(frozen=True)(cls)
