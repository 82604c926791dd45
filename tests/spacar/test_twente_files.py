"""Files of UT SPACAR as people write them: blocks, lists of components, values, numbers beyond those known."""

from pathlib import Path

import numpy as np
import pytest
from spacar_declarations import declared
from spacar_lines import file

import flexel as fx

HEAD = ["BEAM 1 1 2 3 4 0 1 0", "X 3 1 0 0", "FIX 1", "FIX 2"]
TAIL = ["EM 1 1.0", "XM 3 2.0", "XM 4 1 0 0 1 0 1", "ESTIFF 1 1e6 10 20 30"]
ENDS = {
    "two lines": ["END", "HALT"],
    "one line": ["END HALT"],
    "small, apart": ["", "end", "", "Halt  % dynamics"],
}


@pytest.mark.parametrize("end", ENDS)
@pytest.mark.parametrize("last", [["END", "END"], ["END END"], ["END"], []], ids=str)
def test_end_and_halt_are_words_over_any_lines(end: str, last: list[str], tmp_path: Path) -> None:
    lines = [*HEAD, "DYNE 1", "INPUTX 4 2", *ENDS[end], *TAIL, "INPUTX 4 2 0.25 0.5", *last]
    found = file(tmp_path, *lines)
    assert found.dialect == "twente"
    assert declared(found, "prescribe") == ['m.prescribe("o4.lambda1", fx.Polynomial((0.25, 0.5)))']


def test_a_picture_alone_determines_the_dialect(tmp_path: Path) -> None:
    """Its keywords are not those of the model, and END in it ends nothing."""
    found = file(tmp_path, *HEAD, "END", "VISUALIZATION", "MASS 1", "END", "END HALT", "FIX 99")
    assert found.dialect == "twente"
    unknown = [note.split(" is not read")[0] for note in found.notes if "is not read" in note]
    assert unknown == ["line 7: MASS", "lines 8, 9: END", "line 10: FIX"]


def test_further_blocks_hold_inputs_and_outputs(tmp_path: Path) -> None:
    blocks = [
        *HEAD,
        "DYNE 1",
        "END",
        "HALT",
        *TAIL,
        "END",
        "HALT",
        "INPUTF 1 3 3",
        "OUTX 1 3 3",
        "END",
        "END",
    ]
    found = file(tmp_path, *blocks, "", "VISUALIZATION", "BEAMPROPS 1", "CROSSDIM 0.02 0.01", "anything")
    assert [signal.name for signal in (*found.inputs, *found.outputs)] == ["p3.z", "p3.z"]
    assert any("VISUALIZATION is for pictures only" in note for note in found.notes)
    assert any("anything is not read" in note for note in found.notes)


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (
            [*HEAD, "END", *TAIL, "END"],
            r"line 6: EM: comes after END in line 5, which occurs alone.*END HALT",
        ),
        ([*HEAD, "HALT", *TAIL], r"line 5: HALT: there is no END before it; write END HALT"),
        ([*HEAD, "END HALT", *TAIL, "END END", "FIX 3"], r"line 11: FIX: comes after END END in line 10"),
        ([*HEAD, "END HALT", *TAIL, "END END END"], r"line 10: END: the model ended in line 10"),
        ([*HEAD, "END of kinematics", *TAIL], r"line 5: END: is followed by OF; only END and HALT"),
    ],
)
def test_ends_that_make_no_blocks_are_reported(lines: list[str], message: str, tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match=message):
        file(tmp_path, *lines, dialect="twente")


def test_before_halt_the_numbers_of_inputs_are_components(tmp_path: Path) -> None:
    found = file(tmp_path, *HEAD, "DYNE 1", "INPUTX 4 2 3 4", "END", "HALT", *TAIL)
    assert declared(found, "prescribe") == [f'm.prescribe("o4.lambda{i}", 0.0)' for i in (1, 2, 3)]
    found = file(tmp_path, *HEAD, "INPUTE 1 3 4", "END", "HALT", *TAIL, "INPUTE 1 3 0.5 1.5 4")
    assert declared(found, "prescribe") == [
        'm.prescribe("beam1.bend1", fx.Polynomial((0.5, 1.5, 2.0)))',
        'm.prescribe("beam1.bend2", 0.0)',
    ]


def test_values_in_the_first_block_are_not_taken_for_components(tmp_path: Path) -> None:
    with pytest.raises(
        fx.ModelError, match=r"line 5: INPUTX: 0.25 is not a component.* values follow after END HALT"
    ):
        file(tmp_path, *HEAD, "INPUTX 3 1 0.25", "END", "HALT", *TAIL)


@pytest.mark.parametrize("values", ["INPUTX 3 1 0.5", "INPUTE 1 2 0.5"])
def test_values_of_what_is_not_an_input_are_reported(values: str, tmp_path: Path) -> None:
    with pytest.raises(
        fx.ModelError, match=r"line 13: INPUT.: it gives the motion of an input, which this is not"
    ):
        file(tmp_path, *HEAD, "DYNE 1 1", "END", "HALT", *TAIL, "DELINPE 1 3 1", values)


def test_values_without_numbers_are_reported(tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match=r"line 8: INPUTX: 2 numbers given; write INPUTX n i x0"):
        file(tmp_path, *HEAD, "INPUTX 3 1", "END", "HALT", "INPUTX 3 1", *TAIL)


ALL = {
    "RLSE 1": "m.beam(",
    "DYNE 1": 'm.independent("beam1.elongation", "beam1.torsion", "beam1.bend1", "beam1.bend2", "beam1.bend3", '
    '"beam1.bend4")',
    "DYNX 3": 'm.independent("p3.x", "p3.y", "p3.z")',
    "DYNX 4": 'm.independent("o4.lambda1", "o4.lambda2", "o4.lambda3")',
    "KINX 3": 'm.kinematic("p3.x", "p3.y", "p3.z")',
    "INPUTX 3": 'm.prescribe("p3.x", 1.0)',
    "INPUTE 1": 'm.prescribe("beam1.bend4", 0.0)',
    "FIX 4": 'm.frame("o4", fixed=True)',
}


@pytest.mark.parametrize("line", ALL)
def test_keywords_without_components_mean_all(line: str, tmp_path: Path) -> None:
    found = file(tmp_path, *HEAD, line, "END", "HALT", *TAIL)
    assert any(text.startswith(ALL[line]) for text in declared(found))


def test_all_of_an_orientation_is_noted(tmp_path: Path) -> None:
    found = file(tmp_path, *HEAD, "INPUTX 4", "END", "HALT", *TAIL)
    assert any("line 5: INPUTX 4: without components: 2, 3 and 4" in note for note in found.notes)


def test_the_second_number_of_iterstep_counts_the_load_steps(tmp_path: Path) -> None:
    lines = [*HEAD, "DYNE 1", "END", "HALT", *TAIL, "DELXF 3 0 0 1"]
    found = file(tmp_path, *lines, "ITERSTEP 10 9 0.0000005 1 3 0", "TIMESTEP 2.0 50")
    assert (found.increments, found.steps) == (9, 50)
    assert len(found.static_steps()[1]) == 10
    with pytest.raises(fx.ModelError, match=r"ITERSTEP: 1 numbers given; write ITERSTEP iterations"):
        file(tmp_path, *lines, "ITERSTEP 10")
    with pytest.raises(fx.ModelError, match=r"line 13: ITERSTEP: 0 is not a number of steps"):
        file(tmp_path, *lines, "ITERSTEP 10 0")
    with pytest.raises(fx.ModelError, match=r"1e9 steps are more than the 1000000 that can be kept"):
        file(tmp_path, *lines, "ITERSTEP 10 1e9")


def test_numbers_of_warping_are_left_out_on_a_plain_beam(tmp_path: Path) -> None:
    plain = file(tmp_path, *HEAD, "DYNE 1", "END", "HALT", "ESTIFF 1 1e6 10 20 30 0 1e-3", "EM 1 1 2 1 1 0")
    more = file(
        tmp_path, *HEAD, "DYNE 1", "END", "HALT", "ESTIFF 1 1e6 10 20 30 0 1e-3 5", "EM 1 1 2 1 1 0 6"
    )
    assert declared(plain) == declared(more)
    assert not any("warping" in note for note in plain.notes)
    assert [note.split(": ")[0] for note in more.notes if "belong to warping" in note] == ["line 8", "line 9"]


def test_estiff_and_em_without_numbers_mean_none(tmp_path: Path) -> None:
    without = file(tmp_path, *HEAD, "RLSE 1", "END", "HALT", *TAIL[1:3])
    empty = file(tmp_path, *HEAD, "RLSE 1", "END", "HALT", *TAIL[1:3], "ESTIFF 1", "EM 1")
    assert declared(without) == declared(empty)


def test_too_many_numbers_elsewhere_are_reported(tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match=r"ESTIFF: 3 values given; a PLBEAM has EA, EI"):
        file(tmp_path, "PLBEAM 1 1 2 3 4", "X 3 1 0", "FIX 1", "END", "HALT", "ESTIFF 1 1 2 3")
    with pytest.raises(fx.ModelError, match=r"EM: 7 numbers given; write EMASS e rhoA"):
        file(tmp_path, "RBEAM 1 1 2 3 0 1 0", "X 3 1 0 0", "END", "HALT", "EM 1 1 2 3 4 5 6")


def test_initial_stresses_are_those_of_the_drawing(tmp_path: Path) -> None:
    lines = [*HEAD, "DYNE 1 1 3 4", "END", "HALT", *TAIL]
    found = file(tmp_path, *lines, "ESIG 1 7.0 0 0.5 -0.25")
    state = found.system.initial
    assert [found.stress(state, 1, i) for i in (1, 3, 4)] == pytest.approx([7.0, 0.5, -0.25])
    rest = found.system.equilibrium()
    assert found.deformation(rest, 1, 1) == pytest.approx(-7.0 / 1e6)
    bends = np.linalg.solve(20.0 * np.array([[4, -2], [-2, 4]]), [-0.5, 0.25])
    assert [found.deformation(rest, 1, i) for i in (3, 4)] == pytest.approx(bends.tolist(), rel=1e-4)
    with pytest.raises(fx.ModelError, match=r"line 12: ESIG: mode 2 of element 1 is rigid, so its stress"):
        file(tmp_path, *lines, "ESIG 1 7.0 1.0")
    with pytest.raises(fx.ModelError, match=r"line 12: ESIG: 2 stresses given; a TRUSS has 1 modes"):
        file(tmp_path, *lines, "ESIG 2 7.0 1.0", "TRUSS 2 1 3")


def test_numbers_may_have_gaps_and_nodes_may_be_unused(tmp_path: Path) -> None:
    lines = [
        "BEAM 40 100 7 9 300 0 1 0",
        "X 9 1 0 0",
        "X 5 1 2 3",
        "X 6 1 2 3",
        "FIX 100",
        "FIX 7",
        "DYNE 40",
    ]
    found = file(tmp_path, *lines, "END", "HALT", "EM 40 1 1 1 1", "ESTIFF 40 1e6 10 20 30")
    assert found.system.dynamic[0] == "beam40.elongation"
    assert any(note.startswith("lines 3, 4: X 5, 6: no effect") for note in found.notes)
    found = file(tmp_path, *lines, "FIX 5", "END", "HALT", "EM 40 1 1 1 1", "ESTIFF 40 1e6 10 20 30")
    assert found.system.dynamic[0] == "beam40.elongation"
    assert any(note.startswith("line 8: FIX 5: no effect") for note in found.notes)


def test_inputs_and_outputs_may_have_gaps_in_their_numbers(tmp_path: Path) -> None:
    lines = [*HEAD, "DYNE 1", "END", "HALT", *TAIL, "END", "HALT"]
    found = file(tmp_path, *lines, "INPUTS 4 1 2", "INPUTS 1 1 1", "INPUTF 3 3 3", "OUTE 7 1 1", "END", "END")
    assert [entry.number for entry in found.inputs] == [1, 3, 4] and found.state_space()[1].shape == (12, 3)
    assert any("inputs have the numbers 1, 3, 4" in note for note in found.notes)
    with pytest.raises(
        fx.ModelError, match=r"line 15: INPUTS: input 4 is already given in line 14; give another"
    ):
        file(tmp_path, *lines, "INPUTS 4 1 2", "INPUTS 4 1 1")


@pytest.mark.parametrize("first", [["DYNE 1 3 4", "INPUTE 1 4"], ["INPUTE 1 4", "DYNE 1"]])
def test_an_input_on_a_dynamic_mode_has_no_effect_as_in_spacar(first: list[str], tmp_path: Path) -> None:
    found = file(tmp_path, *HEAD, *first, "END", "HALT", *TAIL, "INPUTE 1 4 0.5 1")
    assert not declared(found, "prescribe")
    assert [note for note in found.notes if "no effect, as in SPACAR, on a mode that is DYNE" in note][
        0
    ].startswith("line")
    delft = [*HEAD, *first, "EMASS 1 1.0"]
    with pytest.raises(fx.ModelError, match="is a(n input| dynamic coordinate) here and a"):
        file(tmp_path, *delft)


def test_a_note_is_given_once_for_all_elements(tmp_path: Path) -> None:
    beams = [f"BEAM {i} {2 * i - 1} {2 * i} {2 * i + 1} {2 * i + 2} 0 1 0" for i in range(1, 31)]
    places = [f"X {2 * i + 1} {i} 0 0" for i in range(1, 31)]
    found = file(tmp_path, *beams, *places, "FIX 1", "FIX 2", "END", "HALT", "EM 3 1.0")
    assert [note for note in found.notes if "second order" in note] == [
        "lines 1 to 30: BEAM 1 to 30: with all terms of second order in its deformations, torsion included"
    ]


def test_stiffness_of_rigid_modes_is_noted(tmp_path: Path) -> None:
    found = file(tmp_path, *HEAD, "DYNE 1 3 4", "END", "HALT", *TAIL)
    assert "line 11: ESTIFF 1: its stiffness has no effect in modes 1, 2, 5, 6, rigid here" in found.notes
