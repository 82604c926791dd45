"""Programs of users, run by tests: here, which saves the start of an interpreter and the imports."""

import runpy
from contextlib import chdir, redirect_stdout
from io import StringIO
from pathlib import Path


def printed(program: Path) -> str:
    """What a program prints that runs as ``__main__`` in its folder."""
    with chdir(program.parent), redirect_stdout(StringIO()) as out:
        runpy.run_path(str(program), run_name="__main__")
    return out.getvalue()
