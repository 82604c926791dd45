"""Collects the problems of a file: all of them together, each only once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, field
from typing import Protocol, TypeVar

from flexel.base.errors import ModelError

MAX_RANGES_SHOWN = 6  # most numbers or ranges in a message
MAX_ERRORS_SHOWN = 60  # most errors of a file that are written out

Given = TypeVar("Given")
Result = TypeVar("Result")


class LineError(ModelError):
    """An error in a line of a file.

    Attributes
    ----------
    file, written, text : str
        Name of the file, the keyword as it is spelt there, and the message without them.
    number : int
        Number of the line.
    """

    file, written, text, number = "", "", "", 0

    @classmethod
    def at(cls, file: str, number: int, written: str, text: str) -> LineError:
        """Make the error that names file, line and keyword."""
        error = cls(f"{file}, line {number}: {written}: {text}")
        error.file, error.number, error.written, error.text = file, number, written, text
        return error


class FollowingError(ModelError):
    """An error that only follows from one that is already known."""


@contextmanager
def handled(handle: Callable[[LineError], None]) -> Iterator[None]:
    """Hand an error in a line to a function; drop one that follows from another."""
    try:
        yield
    except FollowingError:
        return
    except LineError as error:
        handle(error)


class Problems:
    """The errors found so far in a file.

    Attributes
    ----------
    cut : bool
        The rest of the file was not read, so its contents are unknown.
    unread : set of int
        Numbers of nodes and elements in lines that could not be read; what refers to them may be right.
    """

    def __init__(self) -> None:
        self._found: list[LineError] = []
        self.unread: set[int] = set()
        self.cut = False

    def __bool__(self) -> bool:
        return bool(self._found)

    def collected(self) -> AbstractContextManager[None]:
        """Keep an error in a line until all are reported; drop one that follows from another."""
        return handled(self._found.append)

    def each(self, handle: Callable[[Given], Result], given: Iterable[Given]) -> list[Result]:
        """Return a function's results for several items, leaving out those in which it finds an error."""
        found = []
        for item in given:
            with self.collected():
                found.append(handle(item))
        return found

    def report(self) -> None:
        """Raise one error with all collected errors, in the order of the lines.

        Raises
        ------
        ModelError
        """
        if not self._found:
            return
        groups: dict[tuple[str, str, str], list[int]] = {}
        for error in sorted(self._found, key=lambda error: error.number):
            lines = groups.setdefault((error.file, error.written, error.text), [])
            if error.number not in lines:
                lines.append(error.number)
        messages = [
            f"{file}, {numbered('line', lines)}: {written}: {text}"
            for (file, written, text), lines in groups.items()
        ]
        more = len(messages) - MAX_ERRORS_SHOWN
        raise ModelError(
            "\n".join([*messages[:MAX_ERRORS_SHOWN], *([f"… and {more} more errors"] if more > 0 else [])])
        )


def numbered(what: str, numbers: Sequence[int]) -> str:
    """Write numbers in words: line 3; lines 3, 4; lines 3 to 12, 17 and 20 more."""
    return f"{what}{'s' if len(set(numbers)) > 1 else ''} {listed(numbers)}"


def listed(numbers: Sequence[int]) -> str:
    """Write numbers and ranges of them, the first few."""
    ranges: list[list[int]] = []
    for number in sorted(set(numbers)):
        if ranges and number == ranges[-1][-1] + 1:
            ranges[-1].append(number)
        else:
            ranges.append([number])
    parts: list[tuple[str, int]] = []
    for own in ranges:
        parts += [(f"{own[0]} to {own[-1]}", len(own))] if len(own) > 2 else [(str(i), 1) for i in own]
    rest = sum(count for _, count in parts[MAX_RANGES_SHOWN:])
    return ", ".join(part for part, _ in parts[:MAX_RANGES_SHOWN]) + (f" and {rest} more" if rest else "")


class SourceLine(Protocol):
    """A line of a file."""

    @property
    def number(self) -> int:
        """Number of the line."""

    @property
    def written(self) -> str:
        """Its keyword, as it is spelt."""


@dataclass
class Notes:
    """The reader's remarks about a file; equal remarks about several lines or elements are one note."""

    _found: dict[tuple[str, str], tuple[list[int], list[int]]] = field(default_factory=dict)

    def add(self, line: SourceLine, text: str, element: int | None = None) -> None:
        """Record a note about a line, or about an element."""
        lines, elements = self._found.setdefault((line.written, text), ([], []))
        lines.append(line.number)
        if element is not None:
            elements.append(element)

    def __iter__(self) -> Iterator[str]:
        for (written, text), (lines, elements) in sorted(
            self._found.items(), key=lambda entry: (min(entry[1][0]), entry[0])
        ):
            subject = f"{written} {listed(elements)}:" if elements else written
            yield f"{numbered('line', lines)}: {subject} {text}"
