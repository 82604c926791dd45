"""Splits a file into blocks: END and HALT are separate words, on one line or on several.

Delft: END ends the model, EOF the file.  Twente: END HALT ends a block, END END the model; a picture may follow.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from flexel.apps.spacar.keywords import DELFT_ONLY, ENDS_OF_TWENTE, PICTURE, TWENTE_ONLY
from flexel.apps.spacar.problems import LineError, Problems
from flexel.base.errors import ModelError

ENDS = ("END", "HALT")


@dataclass(frozen=True)
class Raw:
    """A line of the file: its number, and its words without comments."""

    file: str
    number: int
    words: tuple[str, ...]

    @property
    def key(self) -> str:
        """Its first word in capitals."""
        return self.words[0].upper()

    def error(self, message: str) -> LineError:
        """Make an error that names file, line and first word."""
        return LineError.at(self.file, self.number, self.words[0], message)


def picture_at(raw: Sequence[Raw]) -> int:
    """Return the index of the line where the appearance of a picture begins; the number of lines if there is none."""
    found = next((i for i, line in enumerate(raw) if line.key in (*PICTURE, "EOF")), len(raw))
    return len(raw) if found < len(raw) and raw[found].key == "EOF" else found


def recognized(raw: Sequence[Raw]) -> str:
    """Return the dialect to which the keywords of a file belong; Delft if they fit both.

    Raises
    ------
    ModelError
        Keywords of both.
    """
    seen: dict[str, int] = {}
    model = raw[: picture_at(raw) + 1]  # other keywords follow
    for line in model:
        if line.key not in ENDS:
            seen.setdefault(line.key, line.number)
    for sign, number in _ends(model):
        seen.setdefault(sign, number)
    delft = sorted(seen.keys() & DELFT_ONLY)
    twente = sorted(seen.keys() & TWENTE_ONLY) + sorted(seen.keys() & ENDS_OF_TWENTE)
    if delft and twente:
        raise ModelError(
            f"{raw[0].file}, line {seen[twente[0]]}: {twente[0]} is a keyword of the Twente dialect, but {delft[0]} in "
            f"line {seen[delft[0]]} of the Delft one; say which it is: dialect='delft' or dialect='twente' (they "
            "differ in the order of TIMESTEP and in the terms of BEAM)"
        )
    return "twente" if twente else "delft"


def _ends(raw: Sequence[Raw]) -> Iterator[tuple[str, int]]:
    """Return pairs of END and HALT with nothing between them, with the line of the first; HALT may occur alone."""
    before: int | None = None
    for line in raw:
        for word in line.words if line.key in ENDS else ("",):
            if word.upper() in ENDS and (before is not None or word.upper() == "HALT"):
                yield f"{'END ' if before is not None else ''}{word.upper()}", before or line.number
            before = line.number if word.upper() == "END" else None


def blocks(raw: Sequence[Raw], dialect: str, problems: Problems) -> Iterator[tuple[int, Raw]]:
    """Return the lines of the model with the numbers of their blocks, from 0; wrong ends are collected as errors."""
    reader = _BlockReader(dialect)
    for line in raw:
        with problems.collected():
            reader.take(line)
        if reader.done:
            problems.cut = reader.cut
            return
        if line.key not in ENDS:
            yield reader.block, line
        if line.key in PICTURE:
            return  # the appearance of a picture is not part of the model


class _BlockReader:
    """Reads the ends of blocks.

    Attributes
    ----------
    block : int
        Number of the block.
    done, cut : bool
        The rest is not read, although it may belong to the model.
    """

    def __init__(self, dialect: str) -> None:
        self.twente = dialect == "twente"
        self.block, self.done, self.cut = 0, False, False
        self._pending: Raw | None = None  # an END that may be the first of two
        self._ended: Raw | None = None

    def take(self, line: Raw) -> None:
        """Process the meaning of a line for the blocks."""
        if line.key in ENDS:
            for word in line.words:
                self._end(line, word.upper())
        elif line.key == "EOF":
            self.done = True
        elif line.key in PICTURE:
            return
        elif self._ended is not None:
            self.done = self.cut = True
            raise line.error(
                f"comes after END in line {self._ended.number}, where a second run would start; put each run into a "
                "separate file"
                if not self.twente
                else f"comes after END END in line {self._ended.number}, where the model ends; move it before, or "
                "into a separate file"
            )
        elif self._pending is not None:
            number, self._pending = self._pending.number, None
            self.block += 1
            raise line.error(
                f"comes after END in line {number}, which occurs alone, but the file is read as one of the Twente "
                "dialect; write END HALT before a further block and END END at the end, or give dialect='delft' "
                "(--dialect delft)"
            )

    def _end(self, line: Raw, word: str) -> None:
        if word not in ENDS:
            raise line.error(
                f"is followed by {word}; only END and HALT may be on this line, or a comment after %"
            )
        if not self.twente:
            self._ended = self._ended or line
        elif self._ended is not None:
            raise line.error(f"the model ended in line {self._ended.number}; remove the line")
        elif word == "HALT":
            if self._pending is None:
                raise line.error("there is no END before it; write END HALT")
            self._pending, self.block = None, self.block + 1
        elif self._pending is None:
            self._pending = line
        else:
            self._ended = line
