"""All that is wrong in a file is reported together, each with its line, and nothing that only follows from it."""

from pathlib import Path

import pytest
from spacar_lines import CRANK, file

import flexel as fx

HALT = ["END", "HALT"]


def errors(tmp_path: Path, *lines: str, dialect: str | None = None) -> list[str]:
    """The lines of the one error, without the name of the file."""
    with pytest.raises(fx.ModelError) as caught:
        file(tmp_path, *lines, dialect=dialect)
    found = str(caught.value).splitlines()
    assert all(line.startswith("model.dat, line") for line in found), found
    return [line.removeprefix("model.dat, ") for line in found]


def test_mistakes_of_every_kind_come_together_in_the_order_of_the_lines(tmp_path: Path) -> None:
    """Of words, of counts, of references, of contradictions, and of what the model itself refuses."""
    found = errors(
        tmp_path,
        "PLBEAM 1 1 2 3 4",
        "X 3 0.5 zero",
        "X 1 0 0",
        "FIX 1",
        "SPRING 1 2",
        "INPUTX 2 1",
        "FIX 2 1",
        "RLSE 7 1",
        "PLBEAM 2 5 6 7 8",
        "X 7 1 0",
        "TUBE 3 1 2 3 4 5 6 0 1 0",
        *HALT,
        "XM 3 -2.0",
        "EM 2 1 2 3",
        "ESTIFF 2 1 2 3",
        "XF 1 0 0",
        "ITERSTEP 4",
        "TIMESTEP 1.0 0.5",
        "GRAVITY 0 -9.81",
        "OUTX 1 9 1",
    )
    assert [line.split(":")[0] for line in found] == [
        f"line {i}" for i in (2, 5, 7, 8, 11, 14, 15, 16, 17, 18, 19, 21)
    ]
    assert "'zero' is not a number" in found[0]
    assert "unknown keyword" in found[1]
    assert "coordinate 1 of node 2 is an input here" in found[2] or "is fixed here and" in found[2]
    assert "element 7 does not exist; elements are 1, 2" in found[3]
    assert "TUBE: is not supported" in found[4]
    assert "point mass 'mass3'" in found[5] and "XM" in found[5]
    assert "node is fixed and cannot move" in found[8]
    assert "no element has the node 9" in found[11]


def test_what_the_model_refuses_about_a_node_is_reported_with_its_line(tmp_path: Path) -> None:
    found = errors(tmp_path, "BEAM 1 1 2 3 4 0 1 0", "X 3 1 0 0", "X 2 2 0 0 1", "XM 3 1.0", "FIX 1")
    assert len(found) == 1 and "line 3: X: frame 'o2': Euler parameters" in found[0]


def test_the_same_mistake_is_one_message(tmp_path: Path) -> None:
    beams = [f"TUBE {i} 1 2 3 4 5 6 0 1 0" for i in range(1, 5)]
    found = errors(tmp_path, *CRANK[:3], *beams, "TUBE 9 1 2 3 4 5 6 0 1 0", *HALT, "TUBE 7 1 2")
    assert len(found) == 1 and found[0].startswith("lines 4 to 8, 11: TUBE: is not supported")


def test_what_only_follows_from_a_mistake_is_not_reported(tmp_path: Path) -> None:
    """Nothing about nodes, coordinates, roles and laws of an element whose own line is wrong."""
    found = errors(
        tmp_path,
        "BEAN 1 1 2 3 4 0 1 0",
        "X 3 1 0 0",
        "FIX 1",
        "FIX 2",
        "DYNE 1",
        "INPUTX 3 2",
        *HALT,
        "EM 1 1.0",
        "ESTIFF 1 1 1 1 1",
        "XF 3 0 0 1",
        "STARTDE 1 3 0.5",
        "DELINPX 3 2 1.0",
        *HALT,
        "OUTE 1 1 3",
    )
    assert len(found) == 1 and found[0].startswith("line 1: BEAN: unknown keyword; did you mean ")


@pytest.mark.parametrize(
    ("wrong", "lines"),
    [
        ("X 3 1 0 x", []),
        ("INPUTX 3 0.5", ["DELINPX 3 2 1.0", "INPUTX 3 2 1 1"]),
        ("RLSE 1 x", ["STARTDE 1 3 0.5"]),
        ("RLSE 1 9", ["STARTDE 1 3 0.5"]),
        ("BEAM 2 3 4 5 6 0 1", ["EM 2 1", "XM 5 1", "X 5 2 0 0"]),
        ("BEAM 2 3 4 5 5 0 1 0", ["EM 2 1", "XM 5 1", "X 5 2 0 0", "ESTIFF 2 1 1 1 1"]),
    ],
)
def test_one_wrong_line_is_one_message(wrong: str, lines: list[str], tmp_path: Path) -> None:
    own = [] if wrong.startswith("X ") else ["X 3 1 0 0"]
    found = errors(tmp_path, "BEAM 1 1 2 3 4 0 1 0", *own, wrong, "FIX 1", "FIX 2", *HALT, "EM 1 1", *lines)
    assert len(found) == 1 and found[0].startswith(f"line {2 + len(own)}: {wrong.split()[0]}: ")


def test_values_of_one_quantity_are_given_once(tmp_path: Path) -> None:
    lines = [*CRANK[:3], "INPUTE 1 2", *HALT, "INPUTE 1 2 0.1 0.2", "EDD 1 2 0.3"]
    assert file(tmp_path, *lines).model.parts[-1].motion.coefficients == (-0.1, -0.2, -0.15)
    assert errors(tmp_path, *lines, "STARTDE 1 2 0.1", "ED 1 2 0.5", dialect="twente") == [
        "line 9: STARTDE: the value is already given by INPUTE in line 7; keep one of them",
        "line 10: ED: the rate is already given by INPUTE in line 7; keep one of them",
    ]


def test_an_early_end_is_reported_alone(tmp_path: Path) -> None:
    """What stands behind it is not read, so nothing is said about what seems to be missing."""
    found = errors(tmp_path, CRANK[0], "END", *CRANK[1:], "EOF")
    assert [line.split(":")[0] for line in found] == ["line 3"] and "comes after END in line 2" in found[0]


def test_many_mistakes_are_counted(tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError) as caught:
        file(tmp_path, *(f"A{i}B" for i in range(100)))
    found = str(caught.value).splitlines()
    assert len(found) == 61 and found[-1] == "… and 40 more errors"


def test_errors_can_be_sent_to_another_process(tmp_path: Path) -> None:
    import pickle

    with pytest.raises(fx.ModelError) as caught:
        file(tmp_path, "BEAN 1", "BEEM 2")
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)
