"""Runs the commands that write the files of the report, each in its own process."""

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
from flexel.base.files import replacing
from report.parts import FACTS, Made, files_in, read_parts

PYTHON = (sys.executable, "-m")
ROOT = Path(__file__).resolve().parents[2]  # of the checkout


@dataclass(frozen=True)
class ReportOptions:
    """Options for making the parts: rows of `flexel bench`; number of models and seed of the campaign."""

    rows: Sequence[str]
    models: int
    seed: int


def commit() -> str:
    """Return the commit of the source tree, marked if files differ from it; empty without git."""
    if not (ROOT / ".git").exists():
        return ""
    command = ["git", "-C", str(ROOT), "describe", "--always", "--dirty", "--exclude=*"]
    try:
        answer = subprocess.run(command, capture_output=True, text=True, check=False)
    except FileNotFoundError:  # no git
        return ""
    return answer.stdout.strip()


def version() -> str:
    """Return the version of flexel, with the commit."""
    source = commit()
    return f"{flexel.__version__} ({source})" if source else flexel.__version__


def make(part: str, folder: Path, request: ReportOptions, facts: Mapping[str, str]) -> str:
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
        Description of the failure; empty if there is none.
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


def _command(part: str, file: Path, request: ReportOptions) -> tuple[list[str], Path | None]:
    """Return the command of a part, and the folder in which it runs."""
    campaign = ["campaign", "--models", str(request.models), "--seed", str(request.seed)]
    own = {"verify": [], "reproduce": ["all"], "bench": list(request.rows)}
    if part in own:
        return [*PYTHON, "flexel", part, *own[part], "--json", str(file)], None
    if part == "campaign":
        return [*PYTHON, *campaign, "--json", str(file)], ROOT / "tests"
    return ["make", "--no-print-directory", "sanitize", f"SANITIZE_JSON={file}"], ROOT


def _note(part: str, folder: Path, made: Made) -> None:
    """Record when and where a part was made, in addition to the records of other parts."""
    file = folder / FACTS
    known = read_parts({"facts": [file]}).made if file.exists() else {}
    notes = {name: asdict(note) for name, note in known.items()} | {part: asdict(made)}
    with replacing(file, "report") as new:
        new.write_text(json.dumps(notes, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
