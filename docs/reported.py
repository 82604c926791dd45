"""Write the latest report next to the pages: kernels verified now, the rest from the files stored in this folder.

The systems are those of ``quoted/``, the times those of ``measured.json``, the campaign that of ``verification.json``;
the sanitizers those of ``report/``, which `make report` and a copy renew (see report.md).
"""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

from report.making import version
from report.page import page, sections, write
from report.parts import files_in, read_parts

from flexel.apps.cli.reproduce import CASES
from flexel.generated.table import ELEMENTS, LAWS

KEPT = ("sanitize", "facts")
NOTES = (
    "This is the page of the documentation. The kernels were verified when it was built. The systems are the "
    "kept tables that the pages quote; `make docs` computes most of them again and fails where they differ. The times "
    "are those of the page on speed, the campaign is that of the page on verification. The sanitizers ran where the "
    "table below says."
)


def write_report(docs: Path, verified: Path, target: Path) -> None:
    """Write the page.

    Parameters
    ----------
    docs : Path
        This folder.
    verified : Path
        The results of `flexel verify`, as JSON.
    """
    files = {part: files for part, files in files_in(docs / "report").items() if part in KEPT}
    files |= {
        "verify": [verified],
        "reproduce": sorted((docs / "quoted").glob("*.json")),
        "bench": [docs / "measured.json"],
        "campaign": [docs / "verification.json"],
    }
    parts = read_parts(files)
    made = {part: note for part, note in parts.made.items() if part in KEPT}
    names = [*ELEMENTS, *(f"law {law}" for law in LAWS)]
    found = sections(parts, names, list(CASES))
    target.parent.mkdir(parents=True, exist_ok=True)
    write(target, page(found, version(), f"{datetime.now(UTC):%Y-%m-%d}", made, NOTES))
