"""The programs of the documentation's pages, run once in each process of the tests: test_docs.py runs all."""

from __future__ import annotations

import sys
from functools import cache
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import Any

DOCS = Path(__file__).resolve().parents[1] / "docs"


@cache
def programs() -> ModuleType:
    """``docs/programs.py``."""
    sys.path.insert(0, str(DOCS))
    try:
        spec = spec_from_file_location("docs_programs", DOCS / "programs.py")
        assert spec is not None and spec.loader is not None
        module = module_from_spec(spec)
        sys.modules["docs_programs"] = module
        spec.loader.exec_module(module)
    finally:
        sys.path.remove(str(DOCS))
    return module


PAGES = [page.name for page in programs().pages()]
WITHOUT = {  # pages without a program, and why
    "architecture.md": "about the code itself",
    "index.md": "the contents",
    "report.md": "about commands",
    "speed.md": "about a command",
    "theory.md": "mathematics",
    "verification.md": "about how flexel is checked",
}


@cache
def ran(page: str) -> Any:
    """What the program of a page leaves: ``names``, ``printed`` and ``drawn``."""
    return programs().run(DOCS.parent / page if page == "README.md" else DOCS / page)
