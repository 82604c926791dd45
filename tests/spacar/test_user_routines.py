"""USERINP and USERSIG: programs of the user, which are never run; converted, they are functions to fill in."""

from pathlib import Path

import pytest
from click.testing import CliRunner
from programs import printed as printed_by
from spacar_declarations import declared
from spacar_lines import CRANK, file

import flexel as fx
from flexel.apps.cli.main import main

TWENTE = [
    "PLBEAM 1 1 2 3 4",
    "X 3 0.5 0",
    "FIX 1",
    "INPUTX 2",
    "END",
    "HALT",
    "XM 3 2.0",
    "INPUTX 2 1 0.1 0.2 0.4",
]
ROUTINES = ["USERINP crank_motion", "USERSIG leaf.m"]
END = ["TIMESTEP 1.0 10", "END", "END"]


def converted(tmp_path: Path) -> tuple[str, dict[str, float]]:
    """The program of the file, and what it prints."""
    target = tmp_path / "model.py"
    target.unlink(missing_ok=True)
    result = CliRunner().invoke(main, ["convert", str(tmp_path / "model.dat"), str(target)])
    assert result.exit_code == 0, result.output
    return target.read_text(), {a: float(b) for a, b in map(str.split, printed_by(target).splitlines())}


def test_files_with_routines_are_read_with_a_note(tmp_path: Path) -> None:
    without = file(tmp_path, *TWENTE, *END)
    found = file(tmp_path, *TWENTE, *ROUTINES, *END)
    assert declared(found) == declared(without)
    assert [note.split(", which")[0] for note in found.notes] == [
        "line 9: USERINP 'crank_motion' is a program",
        "line 10: USERSIG 'leaf.m' is a program",
    ]
    assert "its motions of inputs are missing" in found.notes[0]
    assert "its stresses and forces are missing" in found.notes[1]
    result = CliRunner().invoke(main, ["run", str(tmp_path / "model.dat")])
    assert result.exit_code == 0 and "USERSIG 'leaf.m' is a program, which is not run" in result.output


def test_a_routine_has_a_name(tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match="line 9: USERINP: 0 words given; write USERINP name"):
        file(tmp_path, *TWENTE, "USERINP", *END)


def test_converted_routines_change_nothing_until_they_are_filled_in(tmp_path: Path) -> None:
    file(tmp_path, *TWENTE, *END)
    _, plain = converted(tmp_path)
    file(tmp_path, *TWENTE, *ROUTINES, *END)
    text, printed = converted(tmp_path)
    assert printed == pytest.approx(plain, rel=1e-12, abs=1e-12)
    assert 'm.prescribe("o2.angle", userinp_o2_angle)' in text and "crank_motion" in text
    assert "usersig(m)" in text and "leaf.m" in text
    filled = text.replace("return 0.1 + 0.2 * t + 0.2 * t**2", "return 0.7 * t")
    assert filled != text
    (tmp_path / "filled.py").write_text(filled)
    filled_in = printed_by(tmp_path / "filled.py")
    assert float(dict(map(str.split, filled_in.splitlines()))["o2.angle"]) == pytest.approx(0.7)


def test_a_stress_that_is_filled_in_acts(tmp_path: Path) -> None:
    file(
        tmp_path,
        *TWENTE[:4],
        "RLSE 1 1",
        *TWENTE[4:],
        "ESTIFF 1 100",
        "USERSIG leaf",
        "XF 3 1 0",
        "END",
        "END",
    )
    text, printed = converted(tmp_path)
    law = 'model.law("plbeam1.elongation", lambda e, ed: 300.0 * e)'
    (tmp_path / "filled.py").write_text(text.replace("    return\n", f"    {law}\n"))
    stretched = dict(map(str.split, printed_by(tmp_path / "filled.py").splitlines()))
    stiffness = 100 / 0.5
    ratio = float(stretched["plbeam1.elongation"]) / printed["plbeam1.elongation"]
    assert ratio == pytest.approx(stiffness / (stiffness + 300.0), rel=1e-9)


def test_crank_of_delft_has_no_routines(tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match="USERINP is a keyword of the Twente dialect, but MASS in line 4"):
        file(tmp_path, *CRANK, "USERINP a")
