"""Runs the commands that write the files of the report, each in a process of its own."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from pathlib import Path

import flexel
from flexel.base.errors import FlexelError
from flexel.base.files import replacing
from flexel.report.parts import FACTS, Made, files_in, read_parts

PYTHON = (sys.executable, "-m")
NEEDS_CHECKOUT = {"campaign": "tests", "sanitize": "Makefile"}  # and what of it


@dataclass(frozen=True)
class Request:
    """What is to be made: rows of `flexel bench`; number of models and seed of the campaign."""

    rows: Sequence[str]
    models: int
    seed: int


def checkout() -> Path | None:
    """The source tree that this package is in, or None if it is installed without one."""
    root = Path(flexel.__file__).resolve().parents[1]
    whole = all((root / name).exists() for name in ("Makefile", "tests", "pyproject.toml"))
    return root if whole else None


def commit() -> str:
    """The commit of the source tree, marked where files differ from it; empty without git or a checkout."""
    root = checkout()
    if root is None or not (root / ".git").exists():
        return ""
    command = ["git", "-C", str(root), "describe", "--always", "--dirty", "--exclude=*"]
    try:
        answer = subprocess.run(command, capture_output=True, text=True, check=False)
    except FileNotFoundError:  # no git
        return ""
    return answer.stdout.strip()


def version() -> str:
    """Version of flexel, with the commit of a checkout."""
    source = commit()
    return f"{flexel.__version__} ({source})" if source else flexel.__version__


def check_possible(parts: Sequence[str]) -> None:
    """Refuse parts that need a checkout where there is none, before anything runs.

    Raises
    ------
    FlexelError
        With the name of the part and the remedy.
    """
    lacking = [z for z in parts if z in NEEDS_CHECKOUT] if checkout() is None else []
    if lacking:
        raise FlexelError(
            f"report: {lacking[0]} needs a checkout of flexel ({NEEDS_CHECKOUT[lacking[0]]}), and "
            f"{Path(flexel.__file__).parent} is not in one; run `make report` in a clone of the sources, or leave "
            f"{' and '.join(lacking)} out"
        )


def make(part: str, folder: Path, request: Request, facts: Mapping[str, str]) -> str:
    """Run the command of a part, and note when and where.

    Parameters
    ----------
    part : str
        One of `parts.NAMES`.
    folder : Path
        Where the files are written.  An older file of the part is removed first.
    facts : mapping of str to str
        About this machine.

    Returns
    -------
    str
        What went wrong; empty if nothing.
    """
    words, place = _command(part, (folder / f"{part}.json").resolve(), request)
    for old in files_in(folder)[part]:
        old.unlink()
    begin = time.perf_counter()
    status = subprocess.run(words, cwd=place, check=False, stdout=subprocess.DEVNULL).returncode
    seconds = time.perf_counter() - begin
    if not files_in(folder)[part]:
        return f"{part}: no file was written, exit status {status} of {' '.join(words)}"
    _note(part, folder, Made(f"{datetime.now(UTC):%Y-%m-%d %H:%M} UTC", commit(), seconds, dict(facts)))
    return f"{part}: exit status {status}" if status else ""


def _command(part: str, file: Path, request: Request) -> tuple[list[str], Path | None]:
    """The command of a part, and the folder that it runs in."""
    root = checkout()
    campaign = ["campaign", "--models", str(request.models), "--seed", str(request.seed)]
    own = {"verify": [], "reproduce": ["all"], "bench": list(request.rows)}
    if part in own:
        return [*PYTHON, "flexel", part, *own[part], "--json", str(file)], None
    if part == "campaign":
        return [*PYTHON, *campaign, "--json", str(file)], root and root / "tests"
    return ["make", "--no-print-directory", "sanitize", f"SANITIZE_JSON={file}"], root


def _note(part: str, folder: Path, made: Made) -> None:
    """Write when and where a part was made, beside what is known of the others."""
    file = folder / FACTS
    known = read_parts({"facts": [file]}).made if file.exists() else {}
    notes = {name: asdict(z) for name, z in known.items()} | {part: asdict(made)}
    with replacing(file, "report") as new:
        new.write_text(json.dumps(notes, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
