"""The programs of the documentation's pages, run once in each process of the tests: test_docs.py runs all."""

from __future__ import annotations

from functools import cache

import page_output
from filling import DOCS, pages

PAGES = [page.name for page in pages()]
WITHOUT = {  # pages without a program, and why
    "architecture.md": "about the code itself",
    "words.md": "a table of words",
    "report.md": "about commands",
    "speed.md": "about a command",
    "theory.md": "mathematics",
    "verification.md": "about how flexel is checked",
}


@cache
def ran(page: str) -> page_output.Ran:
    """What the program of a page leaves: ``names``, ``printed`` and ``drawn``."""
    return page_output.run(DOCS.parent / page if page == "README.md" else DOCS / page)
