"""Run the programs of pages, and check or fill what they print.

A block ``python`` is a part of its page's program: the parts run in order, with common names, in an empty folder, and a
warning is an error. A block ``text`` straight after a part is what this part prints, all of it. ``python
docs/programs.py PAGE…`` runs pages (all without a name) and writes such blocks anew; ``--check`` only says which pages
differ, ``--pictures`` keeps the pictures that a program draws under names that its page shows. The check of all pages is
`tests/test_page_programs.py`.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import re
import shutil
import sys
import tempfile
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from filling import fill

DOCS = Path(__file__).resolve().parent
BLOCK = re.compile(r"^```(?P<language>[^\n`]*)\n(?P<text>.*?)^```$", re.DOTALL | re.MULTILINE)
PICTURE = re.compile(r"\]\(images/([\w-]+\.png)\)")
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?|(?<![\w.])[-+]?\.\d+")

# Parts that are not run here: the page, the first line of the part (or * for all), and why.
LEFT_OUT = {
    ("README.md", "let = Let()"): "a part of derive/elements/truss.py, shown as an example",
    ("adding-an-element.md", "*"): "needs its element to be compiled: tests/test_adding_an_element.py follows the page",
    ("start.md", "from concurrent.futures import ProcessPoolExecutor"): "other processes import the function from a file",
    ("sweeps.md", "from distributed import Client, LocalCluster"): "tests/sweeps start such a cluster",
    ("sweeps.md", "from dask_jobqueue import SLURMCluster"): "needs a cluster with a queue",
    ("stability-map.md", "def build(wheelbase, trail):"): "some minutes; `flexel reproduce` runs it",
}


@dataclass(frozen=True)
class Part:
    """One block of a program: its code, where it ends in the page, and what it prints according to the page."""

    code: str
    end: int
    shown: re.Match[str] | None

    @property
    def head(self) -> str:
        """The first line."""
        return self.code.split("\n", 1)[0]


def pages() -> list[Path]:
    """README.md and the pages."""
    return [DOCS.parent / "README.md", *sorted(DOCS.glob("*.md"))]


def parts(text: str) -> Iterator[Part]:
    """The parts of the program of a page."""
    blocks = list(BLOCK.finditer(text))
    for block, after in zip(blocks, [*blocks[1:], None], strict=True):
        if block["language"] == "python":
            follows = after is not None and after["language"] == "text"
            follows = follows and not text[block.end() : after.start()].strip()  # type: ignore[union-attr]
            yield Part(block["text"], block.end(), after if follows else None)


def run(page: Path, images: Path | None = None) -> tuple[dict[str, Any], list[tuple[Part, str]]]:
    """Run a page in a folder of its own: the names that it leaves, and what each part printed.

    Pictures that the page shows from ``images/`` and that its program has drawn are copied to `images`.
    """
    names: dict[str, Any] = {"__name__": page.stem}
    printed: list[tuple[Part, str]] = []
    before, text = Path.cwd(), page.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", ResourceWarning)
        os.chdir(folder)
        try:
            for number, part in enumerate(parts(text)):
                if LEFT_OUT.keys() & {(page.name, part.head), (page.name, "*")}:
                    continue
                out = io.StringIO()
                with contextlib.redirect_stdout(out):
                    exec(compile(part.code, f"{page.name}, part {number}", "exec"), names)  # noqa: S102
                printed.append((part, out.getvalue()))
            for name in PICTURE.findall(text) if images else ():
                if Path(name).is_file():
                    shutil.copy(name, images / name)
        finally:
            os.chdir(before)
    return names, printed


def agree(shown: str, printed: str) -> bool:
    """Whether both have the same words, and numbers that differ by at most one unit of the last digit shown."""
    if NUMBER.sub("#", shown).split() != NUMBER.sub("#", printed).split():
        return False
    pairs = zip(NUMBER.findall(shown), NUMBER.findall(printed), strict=True)
    return all(abs(float(a) - float(b)) <= 1.01 * _unit(a) for a, b in pairs)


def _unit(number: str) -> float:
    """The weight of the last digit; numbers without a point are counts, and exact."""
    mantissa, _, exponent = number.partition("e")
    if "." not in mantissa and not exponent:
        return 0.0
    return float(10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2])))


def renewed(page: Path, images: Path | None = None) -> str:
    """The text of a page with what its program prints now, where that differs from what it shows."""
    text = page.read_text(encoding="utf-8")
    for part, out in reversed(run(page, images)[1]):
        if part.shown is not None and not agree(part.shown["text"], out):
            start, end = part.shown.span("text")
            text = text[:start] + "".join(f"{line.rstrip()}\n" for line in out.splitlines()) + text[end:]
    return text


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Run the programs of pages and fill what they print.")
    parser.add_argument("pages", nargs="*", help="names such as start.md; all without one")
    parser.add_argument("--check", action="store_true", help="change nothing, fail where a page differs")
    parser.add_argument("--pictures", action="store_true", help="keep the pictures that programs draw")
    given = parser.parse_args()
    os.environ.setdefault("MPLBACKEND", "Agg")
    chosen = [z for z in pages() if z.name in given.pages or not given.pages]
    images = DOCS / "images" if given.pictures else None
    new = {page.read_text(encoding="utf-8"): renewed(page, images) for page in chosen}
    sys.exit(fill(chosen, new.__getitem__, check=given.check))
