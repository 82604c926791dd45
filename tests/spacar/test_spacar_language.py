"""The input language: two dialects, and the errors reported for invalid lines."""

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from spacar_declarations import declared
from spacar_lines import CRANK, file

import flexel as fx
from flexel.apps.cli.main import main
from flexel.apps.spacar.keywords import KEYWORDS, UNSUPPORTED


def test_delft_and_twente_say_the_same_in_their_words(tmp_path: Path) -> None:
    delft = file(tmp_path, *CRANK, "END", "EOF", "whatever comes here is not read")
    twente = file(
        tmp_path,
        "plbeam 1 1 2 3 4  % a comment",
        "X 3 0.5 0  # another",
        "; and one more",
        "* the whole line",
        "FIX 1",
        "INPUTX 2 1",
        "END HALT",
        "XM 3 2.0",
        "INPUTX 2 1 0 1.5",
        "TIMESTEP 2.0 100",
        "END END",
        "VISUALIZATION",
        "COLOR 1 0.5 0.5",
    )
    assert (delft.dialect, twente.dialect) == ("delft", "twente")
    assert declared(delft) == declared(twente)
    assert (delft.duration, delft.steps) == (twente.duration, twente.steps) == (2.0, 100)
    assert delft.notes == () and "COLOR no effect: no GRAPHICS" in twente.notes[0]


def test_dialect_can_be_given_and_decides_the_order_of_timestep(tmp_path: Path) -> None:
    assert file(tmp_path, *CRANK[:-1], "TIMESTEP 2 100", dialect="twente").duration == 2.0
    assert file(tmp_path, *CRANK[:-1], "TIMESTEP 2 100", dialect="delft").duration == 100.0
    with pytest.raises(
        fx.ModelError, match=r"line 7: TIMESTEP: 0.5 is not a number of steps; the delft dialect writes n T"
    ):
        file(tmp_path, *CRANK[:-1], "TIMESTEP 0.5 100")
    with pytest.raises(fx.ModelError, match="dialect 'dutch' is unknown; give 'delft' or 'twente'"):
        file(tmp_path, *CRANK, dialect="dutch")
    with pytest.raises(
        fx.ModelError, match=r"line 8: XF is a keyword of the Twente dialect, but MASS in line 4"
    ):
        file(tmp_path, *CRANK, "XF 3 1 0")


def test_inputs_of_delft_list_components(tmp_path: Path) -> None:
    found = file(tmp_path, *CRANK[:4], "INPUTX 3 1 2", "RLSE 1 1")
    assert len(declared(found, "prescribe")) == 2
    assert found.notes == (
        "line 5: INPUTX its numbers are components; values are given in lines X, XD, XDD, E, ED, EDD",
    )


def test_numbers_may_be_fortrans(tmp_path: Path) -> None:
    found = file(tmp_path, *CRANK[:3], "MASS 3 2.5D-1", *CRANK[4:])
    assert found.model.instances["mass3"].p[0] == 0.25


def test_motion_of_an_input_starts_at_the_time_of_the_file(tmp_path: Path) -> None:
    found = file(tmp_path, *CRANK, "XDD 2 1 0.4", "TIME 2.0")
    state = found.system.initial
    assert state.t == 2.0
    assert np.allclose(
        [state["o2.angle"], state.rate("o2.angle"), state.acceleration("o2.angle")], [0.0, 1.5, 0.4]
    )


@pytest.mark.parametrize(
    ("lines", "rate"),
    [
        (["STARTDE 1 1 0.3"], 0.0),
        (["STARTDE 1 1 0.3 0.2"], 0.2),
        (["ED 1 1 0.2", "STARTDE 1 1 0.3"], 0.2),
    ],
)
@pytest.mark.parametrize("role", ["INPUTE 1 1", "DYNE 1 1"])
def test_a_value_at_the_start_is_not_a_rate(role: str, lines: list[str], rate: float, tmp_path: Path) -> None:
    found = file(
        tmp_path, "PLHINGE 1 1 2", "PLBEAM 2 3 2 4 5", "X 4 1 0", "FIX 1", "FIX 3", "XM 4 1", role, *lines
    )
    state = found.system.initial
    assert abs(found.deformation(state, 1, 1) - 0.3) < 1e-15
    assert abs(state.rate("plhinge1.angle") - rate) < 1e-15


WRONG = {
    "SPRING 1 2 3": r"line 8: SPRING: unknown keyword",
    "PLBAEM 2 3 5 6 7": r"line 8: PLBAEM: unknown keyword; did you mean .*PLBEAM",
    "PLBEAM 2 3 5 6": r"line 8: PLBEAM: 4 numbers given; write PLBEAM e n1 n2 n3 n4",
    "PLBEAM 1 3 5 6 7": r"line 8: PLBEAM: element 1 already exists \(line 1\); give another number",
    "PLBEAM 2 3 1 6 7": r"line 8: PLBEAM: node 1 is already a planar_point, and is used here as a planar_angle",
    "X 9 0 0": r"line 8: X: no element has the node 9",
    "X 1 0 0 0": r"line 8: X: 3 coordinates given, but node 1 is a planar_point with 2 \(x, y\)",
    "X 3 0 0": r"line 8: X: already given in line 2; keep one of them",
    "MASS 3 1.0": r"line 8: MASS: already given in line 4",
    "MASS 4 1 0 0 1 0 1": r"line 8: MASS: 6 numbers given; node 4 is a planar_angle and takes 1",
    "FORCE 3 1": r"line 8: FORCE: 1 numbers given; node 3 is a planar_point and takes 2",
    "FORCE 1 0 1": r"line 8: FORCE: coordinate 2 of node 1 is fixed by FIX in line 3, and a force cannot move it",
    "FORCE 1 0 0": r"line 8: FORCE: load on 'p1': this node is fixed and cannot move",
    "FIX 2 1": r"line 8: FIX: coordinate 1 of node 2 is fixed here and an input by INPUTX in line 5",
    "FIX 2": r"line 8: FIX: coordinate 1 of node 2 is fixed here and an input by INPUTX in line 5",
    "INPUTX 1 2": r"line 8: INPUTX: coordinate 2 of node 1 is an input here and fixed by FIX in line 3",
    "INPUTX 2 2": r"line 8: INPUTX: node 2, a planar_angle, has coordinates 1 to 1",
    "DYNX 1 1": r"line 8: DYNX: coordinate 1 of node 1 is a dynamic coordinate here and fixed by FIX in line 3",
    "DYNX 2 1": r"line 8: DYNX: coordinate 1 of node 2 is a dynamic coordinate here and an input by INPUTX in line 5",
    "XD 1 1 0.5": r"line 8: XD: the coordinate is fixed by FIX in line 3, and cannot have a given rate",
    "E 1 1 0.5": r"line 8: E: mode 1 of element 1 is rigid and cannot have an initial value; release it",
    "FIX 3 3": r"line 8: FIX: node 3, a planar_point, has coordinates 1 to 2",
    "FIX 3 1.5": r"line 8: FIX: coordinate 1.5 is not a positive whole number",
    "RLSE 7 1": r"line 8: RLSE: element 7 does not exist; elements are 1",
    "RLSE 1 4": r"line 8: RLSE: a PLBEAM has modes 1 to 3",
    "ENHC 1 1 1 2": r"line 8: ENHC: mode 1 of PLBEAM 1 is not a slip \(none\) and cannot be non-holonomic",
    "ESTIFF 1 1 2 3": r"line 8: ESTIFF: 3 values given; a PLBEAM has EA, EI",
    "ESTIFF 1 -1": r"line 8: ESTIFF: a value is negative",
    "LENGTH0 1 0.4": r"line 8: LENGTH0: a PLBEAM takes EMASS, ESTIFF, EDAMPP",
    "DIR 1 0 1 0": r"line 8: DIR: a PLBEAM has no direction",
    "EDD 1 2 3.0": r"line 8: EDD: an acceleration can only be given to an input",
    "TORQUEL 4 1 0 0": r"line 8: TORQUEL: it takes an orientation node and three moments",
    "RESTART": r"line 8: RESTART: is not supported; in Python, motion\[-1\] is a state to start from",
    "SCREW 2 2 4 0.1": r"line 8: SCREW: is not supported; relate rotation and travel in Python",
    "FIX 1 one": r"line 8: FIX: 'one' is not a number",
    "FIX 1 nan": r"line 8: FIX: 'nan' is not finite",
    "FIX 1 infinity": r"line 8: FIX: 'infinity' is not finite",
    "X 5 1e300 0": r"line 8: X: '1e300' is too large to calculate with; give at most 1e\+150",
    "X 5 1,5 0": r"line 8: X: '1,5' is not a number; correct it \(numbers are separated by blanks, decimals by",
    "FIX 3 0_1": r"line 8: FIX: '0_1' is not a number",
    "FIX 3 \u0661": r"line 8: FIX: '\u0661' is not a number",
}


@pytest.mark.parametrize("line", WRONG)
def test_a_line_that_cannot_be_taken_is_reported_with_its_number(line: str, tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match=r"model\.dat, " + WRONG[line]):
        file(tmp_path, *CRANK, line)


WITHOUT_LENGTH = [
    ["PLBEAM 1 1 2 3 4"],
    ["PLBEAMNL 1 1 2 3 4", "ESTIFF 1 1 1"],
    ["BEAM 1 1 2 3 4 0 1 0", "EMASS 1 1"],
    ["TRUSS 1 1 3", "ESTIFF 1 1"],
    ["PLTRUSS 1 1 3", "ESTIFF 1 1", "EMASS 1 1"],
    ["PLTRUSS 1 1 3", "LENGTH0 1 0.5"],
    ["PLBELT 1 1 2 3 4 0.1 0.1", "ESTIFF 1 1"],
]


@pytest.mark.parametrize("lines", WITHOUT_LENGTH, ids=" ".join)
def test_an_element_without_length_is_reported_with_its_line(lines: list[str], tmp_path: Path) -> None:
    written = lines[0].split()[0]
    with pytest.raises(
        fx.ModelError, match=rf"model\.dat, line 1: {written}: the nodes 1 and 3 coincide as drawn"
    ):
        file(tmp_path, *lines, "FIX 1", dialect="delft")


def test_gears_whose_centres_coincide_are_reported_with_their_line(tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match=r"line 1: GEAR: the radii are opposite"):
        file(tmp_path, "GEAR 1 1 2 3 4 0.1 -0.1", "INPUTE 1 1")


def test_a_deformation_has_one_role(tmp_path: Path) -> None:
    with pytest.raises(
        fx.ModelError,
        match=r"line 9: INPUTE: mode 3 of element 1 is an input here and a dynamic coordinate by DYNE in line 8",
    ):
        file(tmp_path, *CRANK, "DYNE 1 2 3", "INPUTE 1 3")
    with pytest.raises(
        fx.ModelError,
        match=r"line 9: LINE: mode 2 of element 1 is a dynamic coordinate here and a kinematic coordinate by KINE",
    ):
        file(tmp_path, *CRANK, "KINE 1 1 2", "LINE 1 2", dialect="delft")


def test_what_building_refuses_is_reported_with_the_file(tmp_path: Path) -> None:
    found = file(tmp_path, "PLWHEEL 1 1 2 3 0.3 1 0", "ED 1 1 0.2", "MASS 1 1")
    with pytest.raises(fx.ModelError, match=r"model\.dat: initial rate of 'plwheel1.longitudinal'"):
        _ = found.system


def test_a_second_run_in_one_file_is_not_passed_over(tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match="line 9: MASS: comes after END in line 8, .* a separate file"):
        file(tmp_path, *CRANK, "END", "MASS 3 4.0", "END", "EOF")


def test_settings_without_effect_are_reported(tmp_path: Path) -> None:
    found = file(tmp_path, *CRANK, "EPSKIN 1e-6", "JOBID a crank", "MAXITERA 20", "HMAX 0.1", "FORCEMODE 1")
    assert [note.split(":")[0] for note in found.notes] == ["line 8", "line 9", "line 10", "line 12"]
    assert found.max_step == 0.1


def test_assumptions_are_reported_where_they_matter(tmp_path: Path) -> None:
    found = file(
        tmp_path,
        "SURFACE 1 1  1 1 1 0 0 0 0 0 0 -1",
        "X 1 0.6 0 -0.8",
        "MASS 1 1",
        "FORCE 1 0 0 -9.81",
        "XD 1 2 1.0",
    )
    assert found.notes == (
        "line 1: SURFACE 1: c1 ... c10 are read as the factors of x², y², z², xy, yz, xz, x, y, z and 1",
    )
    state = found.system.initial
    assert abs(found.deformation(state, 1, 1)) < 1e-15
    assert state.rate("p1.y") == 1.0


def test_no_keyword_is_both_known_and_refused() -> None:
    assert not KEYWORDS.keys() & UNSUPPORTED.keys()


def test_bearing_and_hinge_modes_have_their_own_order(tmp_path: Path) -> None:
    found = file(
        tmp_path,
        "BEARING 1 1 2 3 4  0 0 1",
        "FIX 1",
        "FIX 2",
        "RLSE 1 4",
        "MASS 4 1 0 0 1 0 2",
        "DYNE 1 1",
        "DYNE 1 4",
        "MASS 3 3.0",
        "ESTIFF 1 12 0 0 8",
        dialect="delft",
    )
    assert found.deformations[1, 1] == ("bearing1.axial", 1.0)
    assert found.deformations[1, 4] == ("bearing1.angle", 1.0)
    assert np.allclose([mode.omega for mode in found.frequencies()], [2.0, 2.0])
    assert "modes 1 to 3 are read as the displacements" in found.notes[0]


def test_missing_dofs_are_reported_in_the_words_of_the_file(tmp_path: Path) -> None:
    found = file(tmp_path, *CRANK[:4], "RLSE 1 1", "DYNE 1 1")
    with pytest.raises(
        fx.ConstraintError, match="model.dat: under-constrained.*in the file: .* DYNE or DYNX"
    ):
        _ = found.system


def test_truss_may_be_drawn_strained(tmp_path: Path) -> None:
    found = file(tmp_path, "TRUSS 1 1 2", "X 2 0 0 -1.2", "FIX 1", "FIX 2 1 2", "LENGTH0 1 1.0", "RLSE 1 1",
                 "ESTIFF 1 50", "MASS 2 1", dialect="delft")  # fmt: skip
    state = found.system.initial
    assert abs(found.deformation(state, 1, 1) - 0.2) < 1e-15
    assert abs(found.stress(state, 1, 1) - 10.0) < 1e-12


def test_released_coupled_bending_takes_its_part_of_the_stiffness(tmp_path: Path) -> None:
    """One bending mode free, the other rigid: 4 EI/l³ alone, not that of a free end."""
    found = file(
        tmp_path, "PLBEAM 1 1 2 3 4", "X 3 2 0", "FIX 1", "FIX 2", "RLSE 1 2", "ESTIFF 1 0 5", "MASS 3 1"
    )
    law = found.model.laws[0]
    assert law.deformations == ("plbeam1.bend1",)
    assert abs(law.p[1] - 4 * 5 / 8) < 1e-15


def test_command_line_reports_file_and_line(tmp_path: Path) -> None:
    path = tmp_path / "model.dat"
    path.write_text("\n".join([*CRANK, "GEARBOX 1 2"]))
    for arguments in (["run", str(path)], ["convert", str(path), str(tmp_path / "model.py")]):
        result = CliRunner().invoke(main, arguments)
        assert result.exit_code == 1
        assert "model.dat, line 8: GEARBOX: unknown keyword" in result.output
        assert "Traceback" not in result.output
    assert not (tmp_path / "model.py").exists()
    path.write_bytes(b"\xff\xfe\x00PLBEAM")
    assert "is not text" in CliRunner().invoke(main, ["run", str(path)]).output
    path.write_text("* nothing\n")
    assert "it has no elements" in CliRunner().invoke(main, ["run", str(path)]).output
    path.write_text("\n".join(CRANK))
    output = CliRunner().invoke(main, ["run", str(path), "--mode", "5"]).output
    assert "mode 5 does not exist" in output
