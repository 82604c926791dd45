"""From text to lines of keyword and numbers, and which dialect they are in; nothing is executed."""

from __future__ import annotations

import difflib
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from flexel.base.errors import ModelError
from flexel.spacar.encoding import file_lines
from flexel.spacar.keywords import DELFT_ONLY, ENDS_OF_TWENTE, KEYWORDS, SYNONYMS, TWENTE_ONLY, UNSUPPORTED

DIALECTS = ("delft", "twente")


@dataclass(frozen=True)
class Line:
    """One line of the file.

    Attributes
    ----------
    file : str
        Name of the file.
    number : int
        Number of the line, from 1.
    keyword : str
        In capitals, of the Delft dialect where both have one.
    written : str
        The keyword as it is spelt in the file.
    values : tuple of float
    words : tuple of str
        What follows the keyword, as written.
    """

    file: str
    number: int
    keyword: str
    written: str
    values: tuple[float, ...]
    words: tuple[str, ...]

    def error(self, message: str) -> ModelError:
        """An error that names file, line and keyword."""
        return ModelError(f"{self.file}, line {self.number}: {self.written}: {message}")

    def whole(self, place: int, what: str) -> int:
        """A positive whole number among the values: of a node, an element, a mode."""
        value = self.values[place]
        if value != round(value) or value < 1:
            raise self.error(f"{what} {self.words[place]} is not a positive whole number; correct it")
        return int(value)


def read_lines(path: Path, dialect: str | None) -> tuple[str, list[Line]]:
    """The dialect of a file and its lines up to the end of its model.

    Parameters
    ----------
    dialect : "delft", "twente" or None
        None: recognized by the keywords.

    Raises
    ------
    ModelError
        Text that is not a SPACAR file; names file and line.
    """
    if dialect is not None and (not isinstance(dialect, str) or dialect not in DIALECTS):
        raise ModelError(f"read_spacar: dialect {dialect!r} is unknown; give 'delft' or 'twente'")
    if not path.is_file():
        raise ModelError(
            f"read_spacar '{path}': the file does not exist; give the path of a SPACAR input file"
        )
    raw = [(i, words) for i, line in enumerate(file_lines(path), 1) if (words := _words(line))]
    if dialect is None:
        dialect = _recognized(path.name, raw)
    return dialect, _model(path.name, raw, dialect)


def _words(line: str) -> list[str]:
    """Words of a line without comments: from %, # or ; on, or all of a line that begins with an asterisk."""
    if line.startswith("*"):
        return []
    for mark in "%#;":
        line = line.partition(mark)[0]
    return line.split()


def _recognized(file: str, raw: Sequence[tuple[int, list[str]]]) -> str:
    """The dialect that the keywords of a file belong to; Delft where they fit both."""
    seen = {_sign(words): number for number, words in reversed(raw)}
    delft = sorted(seen.keys() & DELFT_ONLY)
    twente = sorted(seen.keys() & TWENTE_ONLY) + sorted(seen.keys() & ENDS_OF_TWENTE)
    if delft and twente:
        raise ModelError(
            f"{file}, line {seen[twente[0]]}: {twente[0]} is a keyword of the Twente dialect, but {delft[0]} in line "
            f"{seen[delft[0]]} of the Delft one; say which it is: dialect='delft' or dialect='twente' (they differ in "
            "the order of TIMESTEP and in the terms of BEAM)"
        )
    return "twente" if twente else "delft"


def _sign(words: Sequence[str]) -> str:
    """The words that identify the dialect of a line: its keyword, for END with the next word."""
    return " ".join(words[: 2 if words[0].upper() == "END" else 1]).upper()


def _model(file: str, raw: Sequence[tuple[int, list[str]]], dialect: str) -> list[Line]:
    """The lines of the one model in a file, without the ends of blocks."""
    lines: list[Line] = []
    ended, pictures = 0, False
    for number, words in raw:
        key = words[0].upper()
        if key == "VISUALIZATION":
            pictures = True
            lines.append(Line(file, number, key, words[0], (), ()))
        elif pictures:
            continue  # noted below: the appearance of a picture is not part of the model
        elif key == "EOF":
            return lines
        elif ended:
            raise ModelError(
                f"{file}, line {number}: {words[0]} comes after END in line {ended}, where a second run would start; "
                "put each run into a separate file"
            )
        elif key != "END":
            lines.append(_line(file, number, words))
        elif dialect == "delft" or words[1:2] in (["END"], ["end"]):
            ended = number
        elif len(words) != 2 or words[1].upper() not in ("HALT", "END"):
            raise ModelError(
                f"{file}, line {number}: END stands alone, but the file is read as one of the Twente dialect; write "
                "END HALT or END END, or give dialect='delft' (--dialect delft)"
            )
    return lines


def _line(file: str, number: int, words: list[str]) -> Line:
    written, rest = words[0], tuple(words[1:])
    key = SYNONYMS.get(written.upper(), written.upper())
    here = Line(file, number, key, written, (), rest)
    if key in UNSUPPORTED:
        raise here.error(f"is not supported; {UNSUPPORTED[key]}")
    if key not in KEYWORDS:
        near = difflib.get_close_matches(key, [*KEYWORDS, *SYNONYMS], n=3, cutoff=0.5)
        hint = f"did you mean {', '.join(near)}?" if near else "correct it or remove the line"
        raise here.error(f"unknown keyword; {hint}")
    usage = KEYWORDS[key]
    if usage.text:
        return here
    values = tuple(_number(here, word) for word in rest)
    if not usage.least <= len(values) <= usage.most:
        raise here.error(f"{len(values)} numbers given; it is written {key} {usage.form}")
    return Line(file, number, key, written, values, rest)


def _number(line: Line, word: str) -> float:
    """A number in Fortran's or C's notation; Python's underscores and digits of other scripts are not accepted."""
    try:
        value = float("" if "_" in word or not word.isascii() else word.lower().replace("d", "e"))
    except ValueError:
        raise line.error(f"'{word}' is not a number; correct it (comments begin with %, # or ;)") from None
    if not math.isfinite(value):
        raise line.error(f"'{word}' is not finite; correct it")
    return value
