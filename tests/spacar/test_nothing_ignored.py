"""Nothing in a file is ignored in silence: each number and each line changes what is read, a note, or is an error."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from longer import longer
from spacar_lines import file

import flexel as fx
from flexel.parts.model_program import statement

DATA = Path(__file__).parent.parent / "data"
FILES = sorted(path.name for path in DATA.glob("*.dat"))
# a line of each further keyword that has numbers
TWENTE = """
BEAM 1 1 2 3 4 0 1 0
RBEAM 2 3 4 5 0 1 0
HINGE 3 4 6 0 0 1
TRUSS 4 5 1
PINBODY 5 5 6 7
X 3 1 0 0
X 5 2 0 0
X 7 2 1 0
LAMBDA 2 0.8 0.6 0 0
FIX 1
FIX 2 1 2 3 4
DYNE 1 3 4
DYNX 3 1
RLSE 1 1 2
RLSE 4
INPUTE 1 5 6
INPUTE 1 4
INPUTX 5 1
KINE 3 1
END HALT
ESTIFF 1 1e6 10 20 30 1e-3 2e-3 7
EDAMP 1 1e2 1 2 3
ESTIFF 4 100
ESIG 1 0.1 0.2 0.3 0.4 0.5
EM 1 1 1e-3 2e-3 3e-3 1e-4 9
EM 2 2 1e-3 2e-3 3e-3
XM 3 0.5
XM 4 1 0.1 0.1 2 0.1 3
XF 5 1 2 3
XF 4 1 2 3
DELXF 5 0 0 1
INPUTX 5 1 0.1 0.2 0.3
INPUTE 1 5 0.1 0.2 0.3
DELINPX 5 1 0.5
DELINPE 1 6 0.5
STARTDE 1 3 0.1 0.2
GRAVITY 0.1 0.2 -9.81
TIMESTEP 1.5 30
ITERSTEP 10 5 1e-6 1 3 0
ERROR 1e-3 1e-4
OUTLEVEL 1 0
END HALT
INPUTF 1 3 2
INPUTS 3 1 2
OUTX 1 5 2
OUTXP 2 5 3
OUTE 3 1 2
OUTEP 5 1 1
END END
VISUALIZATION
BEAMPROPS 1 4
CROSSTYPE RECT
CROSSDIM 0.02 0.01
GRAPHICS 2 5
FACECOLOR 0.2 0.4 0.6
OPACITY 0.7
DONOTDRAW 3
"""


def content(found: fx.Spacar) -> tuple[object, ...]:
    """All that is read from a file."""
    parts = [statement(part, "m", {}) for part in (*found.model.parts, *found.still, *found.load_steps)]
    gravity = tuple(found.model.gravity)
    numbers = (found.start, found.duration, found.steps, found.increments, found.max_step, gravity)
    return parts, numbers, found.inputs, found.outputs, found.notes, found.routines, found.linearized


def changed(words: list[str]) -> Iterator[list[str]]:
    """A line with one number changed, for each of them."""
    for i, word in enumerate(words[1:], 1):
        yield [*words[:i], repr(float(word) + 1.0), *words[i + 1 :]]


def effect(tmp_path: Path, lines: list[str], dialect: str, before: tuple[object, ...]) -> bool:
    """Whether the lines are read as something else, or refused."""
    try:
        return content(file(tmp_path, *lines, dialect=dialect)) != before
    except fx.ModelError:
        return True


def silent(tmp_path: Path, text: str) -> list[str]:
    """Changes of a file that make no difference."""
    lines = [line.split("#")[0].split("%")[0].split(";")[0] for line in text.splitlines()]
    lines = [line for line in lines if line.strip() and not line.startswith("*")]
    whole = file(tmp_path, *lines)
    before = content(whole)
    noted = {
        int(number)
        for note in whole.notes
        if "effect" in note or "not read" in note
        for number in _numbers(note)
    }
    found = []
    for i, line in enumerate(lines):
        words = line.split()
        # a mode may be released by several lines
        if words[0].upper() in ("END", "HALT", "EOF", "RLSE", "CROSSTYPE") or i + 1 in noted:
            continue
        for other in changed(words):
            if not effect(tmp_path, [*lines[:i], " ".join(other), *lines[i + 1 :]], whole.dialect, before):
                found.append(f"{line.strip()} -> {' '.join(other)}")
    return found


def _numbers(note: str) -> Iterator[int]:
    """The lines that a note is about."""
    for part in note.split(":")[0].replace("lines", "").replace("line", "").split(","):
        first, _, last = part.partition(" to ")
        yield from range(int(first), int(last or first) + 1)


@pytest.mark.parametrize(
    "name", longer(FILES, "spacar_cantilever.dat", "spacar_guide.dat", "spacar_leaf.dat")
)
def test_each_number_of_the_files_has_an_effect_or_a_note(name: str, tmp_path: Path) -> None:
    assert silent(tmp_path, (DATA / name).read_text()) == []


def test_each_number_of_all_keywords_has_an_effect_or_a_note(tmp_path: Path) -> None:
    """But those of warping, of which a note speaks whatever they are."""
    assert [change.split(" ->")[0] for change in silent(tmp_path, TWENTE)] == [
        "ESTIFF 1 1e6 10 20 30 1e-3 2e-3 7",
        "EM 1 1 1e-3 2e-3 3e-3 1e-4 9",
    ]
