"""Reads the section VISUALIZATION that may follow the model in a file of the Twente dialect: how elements are shown.

Groups of lines: BEAMPROPS and elements, then CROSSTYPE and CROSSDIM; GRAPHICS and elements, then FACECOLOR and OPACITY;
DONOTDRAW and elements; INITIAL, then COLOR.  No manual at hand describes it; this is the form in which SPACAR Light
writes it (github.com/precision-utwente/spalight).
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from flexel.apps.spacar.blocks import Raw
from flexel.apps.spacar.declarations import Declaration
from flexel.apps.spacar.file_entries import ElementEntry
from flexel.apps.spacar.lexer import Line, number_in
from flexel.apps.spacar.problems import LineError, handled
from flexel.apps.spacar.sheet import Sheet
from flexel.parts.looks import LookPart
from flexel.parts.round_sections import Circle
from flexel.parts.sections import Rectangle

# curves along which a section is swept
SWEPT = ("BEAM", "BEAMNL", "BEAMW", "RBEAM", "PLBEAM", "PLBEAMNL", "TRUSS", "PLTRUSS")
SIZES: dict[str, tuple[str, Callable[..., Any]]] = {
    "RECT": ("two sizes, along the beam's y axis and across it", Rectangle),
    "CIRC": ("one diameter", Circle),
}
COLOURED = ("COLOR", "FACECOLOR")
NAMED = {  # MATLAB's names of colours, and their short forms
    name: rgb
    for names, rgb in {
        ("red", "r"): (1.0, 0.0, 0.0),
        ("green", "g"): (0.0, 1.0, 0.0),
        ("blue", "b"): (0.0, 0.0, 1.0),
        ("cyan", "c"): (0.0, 1.0, 1.0),
        ("magenta", "m"): (1.0, 0.0, 1.0),
        ("yellow", "y"): (1.0, 1.0, 0.0),
        ("black", "k"): (0.0, 0.0, 0.0),
        ("white", "w"): (1.0, 1.0, 1.0),
    }.items()
    for name in names
}
UNDOCUMENTED = ("RECTHOL", "CIRCHOL", "LINE")  # further types of sections
HEADS = ("BEAMPROPS", "GRAPHICS", "INITIAL", "DONOTDRAW")
PROPERTIES = {
    "CROSSTYPE": ("BEAMPROPS",),
    "CROSSDIM": ("BEAMPROPS",),
    "FACECOLOR": ("GRAPHICS", "BEAMPROPS"),
    "COLOR": ("GRAPHICS", "BEAMPROPS", "INITIAL"),
    "OPACITY": ("GRAPHICS", "BEAMPROPS"),
}
SECTION_HELP = (
    "is for pictures only: CROSSDIM is read as the sizes along the beam's y axis, the direction on its line, and "
    "across it (RECT), or the diameter (CIRC), colours as red, green and blue from 0 to 1"
)


@dataclass
class Group:
    """A line that begins a group, the elements that it names, and the lines that belong to it."""

    line: Line
    elements: list[ElementEntry] = field(default_factory=list)
    own: dict[str, Line] = field(default_factory=dict)


class Picture:
    """The looks of elements that the section asks for.

    Parameters
    ----------
    lines : sequence of Raw
        From the line VISUALIZATION on; none if the file has no such section.
    sheet : Sheet
        Gets the notes; nothing in this section refuses a model.

    Attributes
    ----------
    looks : list of Declaration
    """

    def __init__(self, lines: Sequence[Raw], sheet: Sheet) -> None:
        self.sheet = sheet
        self.looks: list[Declaration] = []
        self._group: Group | None = None
        self._sections: set[int] = set()
        if not lines:
            return
        first = lines[0]
        rest = [Raw(first.file, first.number, first.words[1:])] if first.words[1:] else []
        for raw in (*rest, *lines[1:]):
            with handled(self._note):
                self._take(raw)
        self._close()
        if self.looks and not sheet.problems:
            sheet.notes.add(Line(first.file, first.number, first.key, first.words[0], (), ()), SECTION_HELP)

    def _take(self, raw: Raw) -> None:
        words = raw.words[1:]
        line = Line(raw.file, raw.number, raw.key, raw.words[0], (), words)
        if raw.key in HEADS:
            self._close()
            self._group = Group(line)  # the next lines belong to it, even if it is wrong
            if raw.key != "INITIAL":
                self._group.elements = self._elements(_with_numbers(line))
        elif raw.key in PROPERTIES:
            self._property(line if raw.key == "CROSSTYPE" else self._numbered(line))
        else:
            if not words or raw.key.endswith("PROPS"):  # a group of another kind
                self._close()
                self._group = Group(line)
            similar = difflib.get_close_matches(raw.key[:99], [*HEADS, *PROPERTIES], n=1, cutoff=0.75)
            hint = f"; did you mean {similar[0]}?" if similar else ""
            self.sheet.notes.add(line, f"is not read: its meaning for pictures is not known here{hint}")

    def _elements(self, line: Line) -> list[ElementEntry]:
        """Return the elements named by a line; without names, all elements to which it can apply."""
        swept = line.keyword == "BEAMPROPS"
        if not line.values:
            if line.keyword == "DONOTDRAW":
                raise line.error("it names no elements; give their numbers, or remove the line")
            return [
                element
                for element in self.sheet.elements.values()
                if not swept or element.line.keyword in SWEPT
            ]
        found = [self.sheet.element(line, place) for place in range(len(line.values))]
        for entry in found:
            if swept and entry.line.keyword not in SWEPT:
                raise line.error(
                    f"element {entry.number} is a {entry.line.keyword}, which is not drawn as a line and has no "
                    "section; leave it out"
                )
        return found

    def _property(self, line: Line) -> None:
        """Process a line that belongs to the group before it."""
        heads, group = PROPERTIES[line.keyword], self._group
        if group is None or group.line.keyword not in heads:
            self.sheet.notes.add(
                line, f"no effect: no {' or '.join(heads)}, to which it belongs, precedes it"
            )
            return
        name = "FACECOLOR" if line.keyword == "COLOR" else line.keyword
        if name in group.own:
            raise line.error(
                f"{group.own[name].written} is already given in line {group.own[name].number}; keep one of them"
            )
        if name != "CROSSDIM":
            _check(line)
        group.own[name] = line

    def _numbered(self, line: Line) -> Line:
        """Return a line of the group with its numbers; a colour that has a name, with red, green and blue."""
        named = _named_colour(line.words) if line.keyword in COLOURED else None
        return _with_numbers(line) if named is None else replace(line, values=named)

    def _close(self) -> None:
        """End the group, if there is one."""
        group, self._group = self._group, None
        if group is not None and group.line.keyword in HEADS:
            with handled(self._note):
                self._look(group)

    def _note(self, error: LineError) -> None:
        """Note what is wrong in a line: as it is about pictures alone, no model is refused for it."""
        self.sheet.notes.add(error, f"is left out of the picture: {error.text}")

    def _look(self, group: Group) -> None:
        """Add the look of a group, or note that it has no effect."""
        head, notes = group.line.keyword, self.sheet.notes
        if head == "INITIAL":
            for line in (group.line, *group.own.values()):
                notes.add(line, "no effect: the drawn position has no colour of its own here")
            return
        options: dict[str, Any] = {"hidden": True} if head == "DONOTDRAW" else {}
        section = self._section(group)
        options |= {} if section is None else {"section": section}
        if "FACECOLOR" in group.own:
            options["colour"] = group.own["FACECOLOR"].values
        if "OPACITY" in group.own:
            options["opacity"] = group.own["OPACITY"].values[0]
        if not options:
            notes.add(group.line, "no effect: no CROSSDIM, FACECOLOR or OPACITY that is read follows it")
            return
        shown = tuple(element.name for element in group.elements if element.line.keyword != "L2MIN1")
        if shown:
            self.looks.append(Declaration.of(group.line, LookPart, shown, **options))

    def _section(self, group: Group) -> Any:
        """Return the section of a group; a rectangle if no type is given."""
        sizes, kind = group.own.get("CROSSDIM"), group.own.get("CROSSTYPE")
        word = "RECT" if kind is None else kind.words[0].upper()
        if kind is not None and word in UNDOCUMENTED:
            self.sheet.notes.add(kind, f"{word} is not read: its sizes are not documented; drawn as before")
            return None
        if sizes is None:
            if kind is not None:
                self.sheet.notes.add(kind, "no effect: no CROSSDIM belongs to it")
            return None
        what, make = SIZES[word]
        count = 2 if word == "RECT" else 1
        if len(sizes.values) != count or min(sizes.values) <= 0:
            raise sizes.error(f"a {word} takes {what}, in m and positive; give CROSSDIM so")
        again = [element.number for element in group.elements if element.number in self._sections]
        for number in again:
            self.sheet.notes.add(sizes, "replaces the section given before", number)
        self._sections |= {element.number for element in group.elements}
        return make(*sizes.values)


def _named_colour(words: Sequence[str]) -> tuple[float, ...] | None:
    """Return red, green and blue of a colour that MATLAB names, or of the codes of its letters; None for others."""
    name = " ".join(words).strip("'\"").lower()
    if all(word.isdecimal() and 32 < int(word) < 127 for word in words):
        name = "".join(chr(int(word)) for word in words).lower()
    return NAMED.get(name)


def _with_numbers(line: Line) -> Line:
    """Return the line with the numbers in its words."""
    values = tuple(number_in(line, word) for word in line.words)
    return Line(line.file, line.number, line.keyword, line.written, values, line.words)


def _check(line: Line) -> None:
    """Raise an error for an invalid type, colour or opacity."""
    known = (*SIZES, *UNDOCUMENTED)
    if line.keyword == "CROSSTYPE":
        if len(line.words) != 1 or line.words[0].upper() not in known:
            raise line.error(f"'{' '.join(line.words)}' is not a type of section; give {' or '.join(SIZES)}")
        return
    count = 1 if line.keyword == "OPACITY" else 3
    what = "one number" if count == 1 else "red, green and blue, each"
    if len(line.values) != count or not all(0 <= value <= 1 for value in line.values):
        of255 = count == 3 and len(line.values) == 3 and all(0 <= value <= 255 for value in line.values)
        hint = "; numbers up to 255 are divided by 255" if of255 else ""
        raise line.error(f"it takes {what} from 0 to 1; give these{hint}")
