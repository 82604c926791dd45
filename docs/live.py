"""Writes the pages of the viewer that the documentation shows in place: that of its first program, and the bicycle."""

import os
import re
import tempfile
from pathlib import Path

from flexel.examples.bicycle import bicycle, kick

PROGRAM = re.compile(r"```python\n(.*?)```", re.DOTALL)  # the first one of a page


def write(folder: Path, out: Path) -> None:
    """Write ``pendulum.html`` and ``bicycle.html`` into a folder.

    Parameters
    ----------
    folder : Path
        Of the documentation.
    out : Path
        Where the pages are written.
    """
    out.mkdir(parents=True, exist_ok=True)
    _run((folder / "index.md").read_text(encoding="utf-8"), out)
    system = bicycle()
    motion = system.simulate(5, start=kick(system, 4.5, 0.05)[0], progress=False)
    motion.view(out / "bicycle.html", title="The bicycle at 4.5 m/s after a kick", frames=151, progress=False)


def _run(page: str, out: Path) -> None:
    """Run the first program of a page, which writes ``pendulum.html`` where it is."""
    program = PROGRAM.search(page)
    assert program is not None
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as place:
        os.chdir(place)
        try:
            exec(program[1], {"print": lambda *_: None})
        finally:
            os.chdir(before)
        (out / "pendulum.html").write_bytes((Path(place) / "pendulum.html").read_bytes())
