"""Lines of SPACAR files, for tests."""

from pathlib import Path

import flexel as fx

CRANK = [
    "PLBEAM 1 1 2 3 4",
    "X 3 0.5 0",
    "FIX 1",
    "MASS 3 2.0",
    "INPUTX 2 1",
    "XD 2 1 1.5",
    "TIMESTEP 100 2.0",
]


def file(tmp_path: Path, *lines: str, dialect: str | None = None) -> fx.Spacar:
    path = tmp_path / "model.dat"
    path.write_text("\n".join(lines) + "\n")
    return fx.read_spacar(path, dialect)
