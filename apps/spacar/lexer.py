"""Splits text into lines of keyword and numbers, and finds their dialect; nothing is executed."""

from __future__ import annotations

import difflib
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from flexel.apps.spacar.blocks import Raw, blocks, picture_at, recognized
from flexel.apps.spacar.encoding import file_lines
from flexel.apps.spacar.keywords import DIALECTS, KEYWORDS, SYNONYMS, UNSUPPORTED, VALUES
from flexel.apps.spacar.problems import LineError, Problems
from flexel.base.errors import ModelError

MAX_VALUE = 1e150


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
        In capitals, that of the Delft dialect if both have one; for values of inputs those of `keywords.VALUES`.
    written : str
        The keyword as it is spelt in the file.
    values : tuple of float
    words : tuple of str
        The rest of the line, as written.
    block : int
        Number of the block, from 0.
    """

    file: str
    number: int
    keyword: str
    written: str
    values: tuple[float, ...]
    words: tuple[str, ...]
    block: int = 0

    def error(self, message: str) -> LineError:
        """Make an error that names file, line and keyword."""
        return LineError.at(self.file, self.number, self.written, message)

    def whole(self, place: int, what: str) -> int:
        """Return a positive whole number among the values: of a node, an element, a mode."""
        value = self.values[place]
        if value != round(value) or value < 1:
            raise self.error(f"{what} {self.words[place]} is not a positive whole number; correct it")
        return int(value)


def read_lines(path: Path, dialect: str | None, problems: Problems) -> tuple[str, list[Line], Sequence[Raw]]:
    """Return the dialect of a file, its lines up to the end of its model, and those from VISUALIZATION on.

    Errors in the lines of the model are collected.

    Parameters
    ----------
    dialect : "delft", "twente" or None
        None: recognized by the keywords.

    Raises
    ------
    ModelError
        Text that is not a SPACAR file, or whose dialect is not clear.
    """
    if dialect is not None and (not isinstance(dialect, str) or dialect not in DIALECTS):
        raise ModelError(f"read_spacar: dialect {dialect!r} is unknown; give 'delft' or 'twente'")
    if not path.is_file():
        raise ModelError(
            f"read_spacar '{path}': the file does not exist; give the path of a SPACAR input file"
        )
    raw = [
        Raw(path.name, i, tuple(words))
        for i, line in enumerate(file_lines(path), 1)
        if (words := _words(line))
    ]
    if dialect is None:
        dialect = recognized(raw)
    found: list[Line] = []
    for block, line in blocks(raw, dialect, problems):
        read = problems.each(partial(_line, block=block), [line])
        found += read
        if not read:
            problems.unread |= {
                int(word) for word in line.words[1:] if word.isascii() and word.isdecimal() and len(word) < 10
            }
    return dialect, found, raw[picture_at(raw) :]


def _words(line: str) -> list[str]:
    """Return the words of a line without comments: from %, # or ; on, or a whole line that begins with an asterisk."""
    if line.lstrip().startswith("*"):
        return []
    for mark in "%#;":
        line = line.partition(mark)[0]
    return line.split()


def _line(raw: Raw, block: int) -> Line:
    """Return a line of known keyword, with as many numbers as it takes."""
    written, rest = raw.words[0], raw.words[1:]
    key = SYNONYMS.get(written.upper(), written.upper())
    here = Line(raw.file, raw.number, key, written, (), rest, block)
    if key in UNSUPPORTED:
        raise here.error(f"is not supported; {UNSUPPORTED[key]}")
    if key not in KEYWORDS:
        similar = difflib.get_close_matches(key[:99], [*KEYWORDS, *SYNONYMS], n=3, cutoff=0.5)
        hint = f"did you mean {', '.join(similar)}?" if similar else "correct it or remove the line"
        raise here.error(f"unknown keyword; {hint}")
    usage = VALUES[key] if block and key in VALUES else KEYWORDS[key]
    values = () if usage.text else tuple(number_in(here, word) for word in rest)
    if not usage.least <= len(rest) <= usage.most:
        what = "words" if usage.text else "numbers"
        raise here.error(f"{len(rest)} {what} given; write {key} {usage.form}")
    return Line(raw.file, raw.number, usage.meaning or key, written, values, rest, block)


def number_in(line: Line, word: str) -> float:
    """Parse a number in Fortran's or C's notation; Python's underscores and digits of other scripts are refused."""
    try:
        value = float("" if "_" in word or not word.isascii() else word.lower().replace("d", "e"))
    except ValueError:
        hint = (
            "numbers are separated by blanks, decimals by a point"
            if "," in word
            else "comments begin with %, # or ;"
        )
        raise line.error(f"'{word}' is not a number; correct it ({hint})") from None
    if not math.isfinite(value):
        raise line.error(f"'{word}' is not finite; correct it")
    if abs(value) > MAX_VALUE:
        raise line.error(f"'{word}' is too large to calculate with; give at most {MAX_VALUE:g}")
    return value
