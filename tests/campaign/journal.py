"""Verdicts of the campaign of default settings on disk: a run may be stopped, continued and shared by processes.

A line of the journal is a verdict. It counts for the same ride by the same program only: a line has a digest of the
sources and of the ride. Processes may write to one journal at the same time, each its own seeds.
"""

import hashlib
import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from campaign.drive import SILENT, Verdict
from campaign.ride import Ride

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ("runtime", "parts", "generated", "derive", "tests/campaign")
KINDS = {".py", ".c", ".h"}
Row = dict[str, Any]


@cache
def version() -> str:
    """A digest of the program and of the campaign."""
    found = hashlib.sha256()
    for folder in SOURCES:
        for path in sorted(file for file in (ROOT / folder).rglob("*") if file.suffix in KINDS):
            found.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes())
    return found.hexdigest()[:16]


def row_of(name: str, verdict: Verdict) -> Row:
    """What is kept of a verdict; the program of the motion where its error is silent."""
    ride = verdict.ride
    row = {
        "name": name,
        "family": ride.case.family,
        "traits": list(ride.traits),
        "outcome": verdict.outcome,
        "why": verdict.why,
        "method": verdict.method,
        "seconds": round(verdict.seconds, 1),
    }
    return row | ({"program": ride.program()} if verdict.outcome == SILENT else {})


class Journal:
    """Verdicts by ride, in a file if there is one.

    Parameters
    ----------
    path : Path, optional
        The file; it is continued if it exists.
    """

    def __init__(self, path: Path | None = None) -> None:
        self.path = path
        self._rows = dict(self._read())

    def _read(self) -> Iterator[tuple[str, Row]]:
        if self.path is None or not self.path.exists():
            return
        for line in self.path.read_text(encoding="utf-8").splitlines():
            kept = json.loads(line)
            if kept["version"] == version():
                yield kept["ride"], kept["row"]

    def row(self, name: str, ride: Ride) -> Row | None:
        """The verdict on a ride that this program has judged."""
        return self._rows.get(_digest(name, ride))

    def keep(self, name: str, verdict: Verdict) -> Row:
        """Keep a verdict, at the end of the file."""
        key, row = _digest(name, verdict.ride), row_of(name, verdict)
        self._rows[key] = row
        if self.path is not None:
            with self.path.open("a", encoding="utf-8") as file:
                file.write(json.dumps({"version": version(), "ride": key, "row": row}) + "\n")
        return row


def _digest(name: str, ride: Ride) -> str:
    text = f"{name}\n{ride.traits}\n{ride.program()}"
    return hashlib.sha256(text.encode()).hexdigest()[:16]
