"""What the scripts of this folder share: pages that are filled, tables between two marks, entries as lines of JSON."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

DOCS = Path(__file__).resolve().parent
Lines = Callable[[re.Match[str]], Iterable[str]]


def pages() -> list[Path]:
    """README.md and the pages."""
    return [DOCS.parent / "README.md", *sorted(DOCS.glob("*.md"))]


def entries(items: Iterable[Any]) -> str:
    """The entries of a JSON list, a line each."""
    return ",\n".join(json.dumps(z, ensure_ascii=False, allow_nan=False) for z in items)


def marked(words: str) -> re.Pattern[str]:
    """The pattern of a table between marks: group 1 is the first mark, 2 its word, 3 what it names, 4 the last mark."""
    return re.compile(rf"(<!--({words}): ([^>]+?)-->\n).*?(<!--end-->)", re.DOTALL)


def filled(text: str, pattern: re.Pattern[str], lines: Lines) -> str:
    """The page with the lines of its tables written anew."""
    return pattern.sub(lambda z: z[1] + "\n" + "\n".join(lines(z)).rstrip() + "\n\n" + z[4], text)


def differing(pages: Sequence[Path], new: Callable[[str], str]) -> dict[Path, str]:
    """The pages that differ from what they should be, with that."""
    wanted = {page: (text := page.read_text(encoding="utf-8"), new(text)) for page in pages}
    return {page: found for page, (text, found) in wanted.items() if found != text}


def fill(pages: Sequence[Path], new: Callable[[str], str], *, check: bool) -> int:
    """Write the pages that differ from what they should be, or only say which; the exit status is 1 if some differ."""
    found = differing(pages, new)
    if not check:
        for page, text in found.items():
            page.write_text(text, encoding="utf-8")
    print(f"{', '.join(z.name for z in found) or 'no page'} {'differs' if check else 'written'}")
    return int(check and bool(found))
