"""Shared by the scripts that fill pages: filled pages, tables between two marks, lists as lines of JSON."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

DOCS = Path(__file__).resolve().parent.parent / "docs"
Lines = Callable[[re.Match[str]], Iterable[str]]


def pages() -> list[Path]:
    """Return README.md and the pages."""
    return [DOCS.parent / "README.md", *sorted(DOCS.glob("*.md"))]


def entries(items: Iterable[Any]) -> str:
    """Write the entries of a JSON list, a line each."""
    return ",\n".join(json.dumps(item, ensure_ascii=False, allow_nan=False) for item in items)


def marked(words: str) -> re.Pattern[str]:
    """Return the pattern of a table between marks: group 1 the first mark, 2 its word, 3 its names, 4 the last mark."""
    return re.compile(rf"(<!--({words}): ([^>]+?)-->\n).*?(<!--end-->)", re.DOTALL)


def filled(text: str, pattern: re.Pattern[str], lines: Lines) -> str:
    """Return the page with the lines of its tables written anew."""
    return pattern.sub(
        lambda match: match[1] + "\n" + "\n".join(lines(match)).rstrip() + "\n\n" + match[4], text
    )


def differing(pages: Sequence[Path], new: Callable[[str], str]) -> dict[Path, str]:
    """Return the pages whose text changes, with their new text."""
    wanted = {page: (text := page.read_text(encoding="utf-8"), new(text)) for page in pages}
    return {page: found for page, (text, found) in wanted.items() if found != text}


def fill(pages: Sequence[Path], new: Callable[[str], str], *, check: bool) -> int:
    """Write the pages that change, or only report them; the exit status is 1 if there are any."""
    found = differing(pages, new)
    if not check:
        for page, text in found.items():
            page.write_text(text, encoding="utf-8")
    print(f"{', '.join(page.name for page in found) or 'no page'} {'differs' if check else 'written'}")
    return int(check and bool(found))
