"""The section VISUALIZATION of a Twente file: sections, colours and what is hidden, in pictures alone."""

import re
from pathlib import Path

import pytest
from coarse import COARSE_MESH
from spacar_lines import CRANK, file

import flexel as fx
from flexel.apps.spacar.python_program import convert_spacar
from flexel.apps.view import drawing
from flexel.parts.looks import LookPart
from flexel.parts.model_program import statement

MODEL = [
    "X 1 0 0 0",
    "X 4 0 0.1 0",
    "X 7 0.1 0.1 0",
    "X 10 0.1 0 0",
    "BEAM 1 1 2 4 5 0 0 1",
    "BEAM 2 4 5 7 8 0 0 1",
    "BEAM 3 10 11 7 8 0 0 1",
    "HINGE 4 8 12 0 0 1",
    "DYNE 1 1 2 3 4 5 6",
    "RLSE 3 1 2 3 4 5 6",
    *("FIX 1", "FIX 2", "FIX 10", "FIX 11"),
    *("END", "HALT"),
    *(f"ESTIFF {i} 2.1e6 9.3e-3 7e-3 437.5" for i in (1, 3)),
    *(f"EM {i} 0.078 1.6e-5 2.6e-10 1.6e-5 0" for i in (1, 3)),
    "XM 7 0.1",
    "DELXF 4 4 0 0",
    "ITERSTEP 10 3 0.0000005 1 3 0",
    *("END", "END"),
]
AS_LIGHT = """
VISUALIZATION

INITIAL
COLOR\t\t0.00\t0.00\t0.00

BEAMPROPS\t  1\t  3
CROSSTYPE\t  RECT
CROSSDIM\t  0.050000\t0.000500

GRAPHICS\t  1\t  3
FACECOLOR\t  0.8 0.2 0.0   # red
OPACITY\t0.70

BEAMPROPS\t  2
crosstype\t  circ
CROSSDIM\t  0.012

GRAPHICS  2
FACECOLOR  0.000000 0.486275 0.690196
DONOTDRAW 4
modeshape
maximum 20
""".splitlines()


def looks(found: fx.Spacar) -> list[str]:
    """The declarations that give elements their looks, as the program of the model has them."""
    return [statement(part, "m", {}) for part in found.model.parts if isinstance(part, LookPart)]


def noted(found: fx.Spacar, word: str) -> list[str]:
    """The notes in which a word occurs."""
    return [note for note in found.notes if word in note]


def test_the_form_in_which_spacar_light_writes_it(tmp_path: Path) -> None:
    found = file(tmp_path, *MODEL, *AS_LIGHT)
    assert looks(found) == [
        'm.look(("beam1", "beam3"), section=fx.Rectangle(0.05, 0.0005))',
        'm.look(("beam1", "beam3"), colour=(0.8, 0.2, 0.0), opacity=0.7)',
        'm.look(("beam2",), section=fx.Circle(0.012))',
        'm.look(("beam2",), colour=(0.0, 0.486275, 0.690196))',
        'm.look(("hinge4",), hidden=True)',
    ]
    line = len(MODEL) + 2
    (how,) = noted(found, "for pictures only")
    assert how.startswith(f"line {line}: VISUALIZATION") and "(RECT), or the diameter (CIRC)" in how
    assert noted(found, "INITIAL") == [
        f"line {line + 2}: INITIAL no effect: the drawn position has no colour of its own here"
    ]
    assert len(noted(found, "modeshape is not read")) == len(noted(found, "maximum is not read")) == 1


@COARSE_MESH
def test_sections_and_colours_are_what_pictures_show_and_the_mechanics_is_the_same(tmp_path: Path) -> None:
    plain = file(tmp_path, *MODEL)
    system, states = file(tmp_path, *MODEL, *AS_LIGHT).static_steps()
    assert states[-1].x == pytest.approx(plain.static_steps()[1][-1].x, rel=0, abs=0)
    shapes = {
        shape.name: shape for shape in drawing.shapes(states[-1]) if shape.style in ("beam", "bar", "hinge")
    }
    assert sorted(shapes) == ["beam1", "beam2", "beam3"]
    leaf, body = shapes["beam1"], shapes["beam2"]
    assert leaf.outline is not None and body.outline is not None
    # the leaf is wide along the direction on its line, z, and thin across it
    assert leaf.outline.max(axis=0) == pytest.approx([0.025, 0.00025])
    assert leaf.across is not None and leaf.across[0] == pytest.approx([0, 0, 1])
    assert (leaf.colour, leaf.opacity) == ("#cc3300", 0.7)
    assert (body.colour, body.opacity, body.outline.max()) == ("#007cb0", 1.0, pytest.approx(0.006))


def test_the_converted_program_shows_the_same(tmp_path: Path) -> None:
    file(tmp_path, *MODEL, *AS_LIGHT)
    path = convert_spacar(tmp_path / "model.dat", tmp_path / "model.py")
    names: dict[str, object] = {"__name__": "converted"}
    exec(path.read_text(), names)
    m = names["m"]
    assert isinstance(m, fx.Model)
    own = fx.read_spacar(tmp_path / "model.dat").model
    assert {k: instance.look for k, instance in m.instances.items()} == {
        k: instance.look for k, instance in own.instances.items()
    }
    assert m.instances["beam1"].look is not None


def test_groups_without_elements_are_about_all_of_them(tmp_path: Path) -> None:
    found = file(
        tmp_path, *MODEL, "VISUALIZATION", "BEAMPROPS", "CROSSDIM 0.02 0.01", "GRAPHICS", "COLOR 0 1 0"
    )
    assert looks(found) == [
        'm.look(("beam1", "beam2", "beam3"), section=fx.Rectangle(0.02, 0.01))',
        'm.look(("beam1", "beam2", "beam3", "hinge4"), colour=(0.0, 1.0, 0.0))',
    ]


def test_what_comes_after_the_end_of_the_file_is_not_read(tmp_path: Path) -> None:
    found = file(tmp_path, *CRANK, "END", "EOF", "VISUALIZATION", "GRAPHICS 99", "OPACITY 7", dialect="delft")
    assert looks(found) == [] and found.notes == ()


def test_the_section_may_begin_on_the_line_of_its_name(tmp_path: Path) -> None:
    found = file(tmp_path, *MODEL, "visualization graphics 2", "opacity 0.5")
    assert looks(found) == ['m.look(("beam2",), opacity=0.5)']


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (["BEAMPROPS 1", "CROSSTYPE HEXA"], "CROSSTYPE: 'HEXA' is not a type of section; give RECT or CIRC"),
        (["BEAMPROPS 1", "CROSSDIM 0.01"], "CROSSDIM: a RECT takes two sizes, along .*in m and positive"),
        (
            ["BEAMPROPS 1", "CROSSTYPE CIRC", "CROSSDIM 0.01 0.02"],
            "CROSSDIM: a CIRC takes one diameter, in m and positive",
        ),
        (["BEAMPROPS 1", "CROSSDIM 0.01 -0.02"], "CROSSDIM: a RECT takes two sizes"),
        (["BEAMPROPS 1", "CROSSDIM 1,5 0.02"], "CROSSDIM: '1,5' is not a number; correct it"),
        (
            ["BEAMPROPS 9", "CROSSDIM 0.01 0.02"],
            "BEAMPROPS: element 9 does not exist; elements are 1, 2, 3, 4",
        ),
        (
            ["BEAMPROPS 4", "CROSSDIM 0.01 0.02"],
            "BEAMPROPS: element 4 is a HINGE, which is not drawn as a line",
        ),
        (["BEAMPROPS 1.5"], "BEAMPROPS: element 1.5 is not a positive whole number"),
        (
            ["GRAPHICS 1", "FACECOLOR 255 0 0"],
            "FACECOLOR: it takes red, green and blue, each from 0 to 1; give these; numbers up to 255 are divided",
        ),
        (["GRAPHICS 1", "FACECOLOR 0.5 0.5"], "FACECOLOR: it takes red, green and blue, each from 0 to 1"),
        (["GRAPHICS 1", "FACECOLOR -0.1 0 0"], "FACECOLOR: it takes red, green and blue, each from 0 to 1"),
        (["GRAPHICS 1", "OPACITY 7"], "OPACITY: it takes one number from 0 to 1"),
        (
            ["GRAPHICS 1", "FACECOLOR 0 0 0", "COLOR 1 0 0"],
            f"line {len(MODEL) + 4}: COLOR: FACECOLOR is already given in line {len(MODEL) + 3}",
        ),
        (["DONOTDRAW"], "DONOTDRAW: it names no elements; give their numbers"),
    ],
    ids=lambda words: words if isinstance(words, str) else " / ".join(words),
)
def test_counts_and_values_that_do_not_fit_are_noted(lines: list[str], message: str, tmp_path: Path) -> None:
    """They refuse no model: the section is for pictures alone."""
    found = file(tmp_path, *MODEL, "VISUALIZATION", *lines)
    notes = [note.replace(" is left out of the picture:", ":") for note in found.notes if "left out" in note]
    assert len([note for note in notes if re.search(message, note)]) == 1
    assert found.system.dynamic


def test_errors_of_the_model_are_reported_without_those_of_the_section(tmp_path: Path) -> None:
    lines = [*MODEL[:5], "TRUSS 9 1 77 88", *MODEL[5:]]
    with pytest.raises(fx.ModelError) as found:
        file(tmp_path, *lines, "VISUALIZATION", "BEAMPROPS 1", "CROSSDIM 0", "GRAPHICS 1", "OPACITY 2")
    assert [line.split(": ")[1] for line in str(found.value).splitlines()] == ["TRUSS"]


@pytest.mark.parametrize(
    ("words", "rgb"),
    [
        ("98 108 117 101", (0, 0, 1)),
        ("'blue'", (0, 0, 1)),
        ("Red", (1, 0, 0)),
        ("121 101 108 108 111 119", (1, 1, 0)),
        ("k", (0, 0, 0)),
        ("0 1 0", (0, 1, 0)),
    ],
)
def test_colours_may_be_names_or_the_codes_of_their_letters(
    words: str, rgb: tuple[int, ...], tmp_path: Path
) -> None:
    found = file(tmp_path, *MODEL, "VISUALIZATION", "GRAPHICS 1", f"FACECOLOR {words}")
    [look] = [part for part in found.model.parts if type(part).__name__ == "LookPart"]
    assert look.colour == rgb


@pytest.mark.parametrize(
    ("lines", "note"),
    [
        (["CROSSDIM 0.1 0.1"], "CROSSDIM no effect: no BEAMPROPS, to which it belongs, precedes it"),
        (["GRAPHICS 1", "CROSSDIM 1 1"], "CROSSDIM no effect: no BEAMPROPS"),
        (["BEAMPROPS 1", "HINGEPROPS 4", "CROSSDIM 1 1"], "CROSSDIM no effect: no BEAMPROPS"),
        (["BEAMPROPS 1", "CROSSTYPE RECT"], "CROSSTYPE no effect: no CROSSDIM belongs to it"),
        (["GRAPHICS 1 2"], "GRAPHICS no effect: no CROSSDIM, FACECOLOR or OPACITY that is read follows it"),
        (["BEAMPROPS 1", "CROSSTYPE RECTHOL", "CROSSDIM 1 1 1 1"], "CROSSTYPE RECTHOL is not read"),
        (["GRAPHICS 1", "FACECOLR 0 0 0"], "FACECOLR is not read: .*; did you mean FACECOLOR\\?"),
        (
            ["BEAMPROPS 1", "CROSSDIM 1 1", "BEAMPROPS 1 2", "CROSSDIM 2 2"],
            "CROSSDIM 1: replaces the section given before",
        ),
    ],
    ids=lambda words: words if isinstance(words, str) else " / ".join(words),
)
def test_what_has_no_effect_is_noted(lines: list[str], note: str, tmp_path: Path) -> None:
    notes = file(tmp_path, *MODEL, "VISUALIZATION", *lines).notes
    assert len([line for line in notes if re.search(note, line)]) == 1
