"""SPACAR files as text: ends, dialects, encodings."""

from pathlib import Path

import pytest
from spacar_declarations import declared
from spacar_lines import CRANK, file

import flexel as fx


@pytest.mark.parametrize("mark", ["END HALT", "end halt", "END END"])
def test_an_end_of_one_dialect_does_not_override_keywords_of_the_other(mark: str, tmp_path: Path) -> None:
    """MASS and TIMESTEP n T of Delft under an END of Twente: 5 s would be read as 100 s."""
    lines = [*CRANK[:-1], "TIMESTEP 100 5.0", mark]
    with pytest.raises(
        fx.ModelError,
        match=rf"model\.dat, line 8: {mark.upper()} is a keyword of the Twente .* MASS in line 4",
    ):
        file(tmp_path, *lines)
    assert file(tmp_path, *lines, dialect="delft").duration == 5.0


@pytest.mark.parametrize(
    "data",
    [
        pytest.param("\ufeff".encode() + "\n".join(CRANK).encode(), id="mark at the beginning"),
        pytest.param("\n".join(["* Kurbel mit Öl", *CRANK]).encode("latin-1"), id="latin-1"),
        pytest.param("\r\n".join(["* wait \x85 for it", *CRANK]).encode("latin-1"), id="ellipsis of Windows"),
        pytest.param("\r".join(["* Öl", *CRANK]).encode(), id="returns alone"),
        pytest.param("\n".join(["% Öl", *CRANK]).encode("utf-16"), id="utf-16 with a mark"),
        pytest.param("\r\n".join([*CRANK, "END"]).encode() + b"\x1a", id="end of DOS"),
        pytest.param(
            "\n\n".join(["  * indented", *CRANK]).replace(" ", "\t  ").encode(), id="tabs, empty lines"
        ),
    ],
)
def test_text_is_read_in_the_usual_encodings(data: bytes, tmp_path: Path) -> None:
    path = tmp_path / "model.dat"
    path.write_bytes(data)
    assert declared(fx.read_spacar(path)) == declared(file(tmp_path, *CRANK))


@pytest.mark.parametrize(
    "data",
    ["\n".join(CRANK).encode("utf-16-le"), b"\x89PNG\r\n" + bytes(range(1, 256))],
    ids=["utf-16", "picture"],
)
def test_what_is_not_text_is_refused(data: bytes, tmp_path: Path) -> None:
    path = tmp_path / "model.dat"
    path.write_bytes(data)
    with pytest.raises(fx.ModelError, match=r"model\.dat: is not text .* give a SPACAR input file"):
        fx.read_spacar(path)
