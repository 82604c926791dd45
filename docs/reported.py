"""Write the latest report beside the pages: kernels verified now, the rest from the files that this folder keeps.

The systems are those of ``quoted/``, the times those of ``measured.json``, the campaign that of ``verification.json``;
the sanitizers those of ``report/``, which `make report` and a copy renew (see report.md).
"""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

from flexel.commands.reproduce import CASES
from flexel.generated.table import ELEMENTS, LAWS
from flexel.report.making import version
from flexel.report.page import page, sections, write
from flexel.report.parts import files_in, read_parts

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
        What `flexel verify` found, as JSON.
    """
    files = {part: files for part, files in files_in(docs / "report").items() if part in KEPT}
    files |= {
        "verify": [verified],
        "reproduce": sorted((docs / "quoted").glob("*.json")),
        "bench": [docs / "measured.json"],
        "campaign": [docs / "verification.json"],
    }
    parts = read_parts(files)
    made = {part: z for part, z in parts.made.items() if part in KEPT}
    names = [*ELEMENTS, *(f"law {z}" for z in LAWS)]
    found = sections(parts, names, list(CASES))
    target.parent.mkdir(parents=True, exist_ok=True)
    write(target, page(found, version(), f"{datetime.now(UTC):%Y-%m-%d}", made, NOTES))
