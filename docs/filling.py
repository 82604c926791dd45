"""Tables of pages that are written anew between two marks; for the scripts in this folder."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

Lines = Callable[[re.Match[str]], Iterable[str]]


def marked(words: str) -> re.Pattern[str]:
    """The pattern of a table between marks: group 1 is the first mark, 2 its word, 3 what it names, 4 the last mark."""
    return re.compile(rf"(<!--({words}): ([^>]+?)-->\n).*?(<!--end-->)", re.DOTALL)


def filled(text: str, pattern: re.Pattern[str], lines: Lines) -> str:
    """The page with the lines of its tables written anew."""
    return pattern.sub(lambda z: z[1] + "\n" + "\n".join(lines(z)).rstrip() + "\n\n" + z[4], text)


def fill(pages: Sequence[Path], new: Callable[[str], str], *, check: bool) -> int:
    """Write the pages that differ from what they should be, or only say which; the exit status is 1 if some differ."""
    differing = []
    for page in pages:
        text = page.read_text(encoding="utf-8")
        found = new(text)
        if found != text:
            differing.append(page.name)
            if not check:
                page.write_text(found, encoding="utf-8")
    print(f"{', '.join(differing) or 'no page'} {'differs' if check else 'written'}")
    return int(check and bool(differing))
