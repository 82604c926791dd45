"""SPACAR files with mistakes as people make them: what is changed, and the verdict on reading and running them."""

import random
import re
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from bad_calls import OWN_WARNINGS

import flexel as fx
from flexel.apps.spacar.analysis_modes import MODES
from flexel.apps.spacar.keywords import KEYWORDS, UNSUPPORTED
from flexel.apps.spacar.picture import HEADS, PROPERTIES
from flexel.apps.spacar.python_program import python_source

DATA = Path(__file__).parent / "data"
FILES = [path.name for path in sorted(DATA.glob("*.dat"))]
STEPS = 20  # most load steps that are tried
NUMBERS = (
    "0",
    "-1",
    "1",
    "2",
    "3",
    "7",
    "99",
    "1.5",
    "-0.0",
    "1e-300",
    "1e300",
    "1d3",
    ".5",
    "1e10",
    "4000000000",
)
JUNK = ("nan", "1,5", "x", "--", "1_0", "é", "1e999", "END", "HALT", "%", "*", "\t", "\x1a", "\ufeff")
MODES_TRIED = (0, 7, 8, 9, 10)

Lines = list[list[str]]


class UnplacedError(Exception):
    """An error of the reader that names no place in the file."""


@dataclass(frozen=True)
class Mistake:
    """A file, and the seed of what is changed in it."""

    file: str
    seed: int

    def __str__(self) -> str:
        return f"{self.file} {self.seed}"


def _place(lines: Lines, r: random.Random) -> tuple[int, int]:
    i = r.choice([i for i, words in enumerate(lines) if words])
    return i, r.randrange(len(lines[i]))


def _other_word(lines: Lines, r: random.Random) -> None:
    i, j = _place(lines, r)
    lines[i][j] = r.choice(NUMBERS if r.random() < 0.7 else JUNK)


def _less(lines: Lines, r: random.Random) -> None:
    i, j = _place(lines, r)
    del lines[i][j]


def _more(lines: Lines, r: random.Random) -> None:
    i, _ = _place(lines, r)
    lines[i] += r.choices(NUMBERS, k=r.choice((1, 1, 4)))


def _other_keyword(lines: Lines, r: random.Random) -> None:
    i, _ = _place(lines, r)
    lines[i][0] = r.choice(
        [*KEYWORDS, *UNSUPPORTED, *HEADS, *PROPERTIES, "XM", "EM", "XF", "EDAMP", "PLBEAN"]
    )


def _new_line(lines: Lines, r: random.Random) -> None:
    keyword = r.choice([*KEYWORDS])
    lines.insert(r.randrange(len(lines)), [keyword, *r.choices(NUMBERS[2:6], k=r.randrange(6))])


def _without(lines: Lines, r: random.Random) -> None:
    del lines[_place(lines, r)[0]]


def _twice(lines: Lines, r: random.Random) -> None:
    lines.insert(r.randrange(len(lines)), [*lines[_place(lines, r)[0]]])


def _elsewhere(lines: Lines, r: random.Random) -> None:
    lines.insert(r.randrange(len(lines)), lines.pop(_place(lines, r)[0]))


def _end(lines: Lines, r: random.Random) -> None:
    lines.insert(
        r.randrange(len(lines)), r.choice((["END"], ["HALT"], ["END", "HALT"], ["END", "END"], ["EOF"]))
    )


CHANGES: tuple[Callable[[Lines, random.Random], None], ...] = (
    _other_word,
    _other_word,
    _less,
    _more,
    _other_keyword,
    _new_line,
    _without,
    _twice,
    _elsewhere,
    _end,
)


def cases(count: int) -> list[Mistake]:
    """That many mistakes in each file."""
    return [Mistake(file, i) for i in range(count) for file in FILES]


def prepare() -> None:
    """The folder of the files."""
    Path("mistakes").mkdir(exist_ok=True)


def mistaken(mistake: Mistake) -> Path:
    """The file with one to three mistakes in it."""
    r = random.Random(str(mistake))
    text = (DATA / mistake.file).read_text()
    lines = [line.split() for line in text.splitlines()]
    for _ in range(r.choice((1, 1, 2, 3))):
        r.choice(CHANGES)(lines, r)
    path = Path("mistakes") / mistake.file
    end = r.choice(("\n", "\n", "\r\n", "\n\n"))
    path.write_bytes((end.join(r.choice((" ", "\t")).join(words) for words in lines) + end).encode())
    return path


def verdict(mistake: Mistake) -> str:
    """What is wrong with what flexel does about a file; empty if it gives results, or says what is wrong."""
    path = mistaken(mistake)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            _use(path, mistake.seed)
        except UnplacedError as error:
            return str(error)
        except fx.FlexelError as error:
            if len(str(error)) < 20 or "Error:" in str(error):
                return f"says only {error!s}"
        except Exception as error:
            return f"{type(error).__name__}: {error}"[:300]
    foreign = [warning for warning in caught if not issubclass(warning.category, OWN_WARNINGS)]
    return f"warning {foreign[0].category.__name__}: {foreign[0].message}"[:300] if foreign else ""


def _use(path: Path, seed: int) -> None:
    """Read a file, convert it, and run it in one of the modes that need no motion."""
    try:
        file = fx.read_spacar(path)
    except fx.ModelError as error:
        if not all(re.match(rf"{path.name}(, lines? \d|: )|… and", line) for line in str(error).splitlines()):
            raise UnplacedError(f"does not say where: {error!s}") from error
        raise
    compile(python_source(file), "converted.py", "exec")
    mode = MODES_TRIED[seed % len(MODES_TRIED)]
    if mode == 9 and file.duration is not None:
        mode = 0
    if mode == 10 and file.increments > STEPS:
        mode = 7
    MODES[mode](file)
