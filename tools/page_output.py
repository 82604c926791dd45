"""Run the programs of pages, and check or fill the output shown.

A block ``python`` is a part of its page's program: the parts run in order, with common names, in an empty folder, and a
warning is an error. A part that begins with a comment such as ``# cam.py`` is also a file of that name in the folder. A
block ``text`` or ``c`` straight after a part is what this part prints, all of it. A block ``sh`` with such a block
after it is a part, too: its commands are those of flexel.

``python tools/page_output.py PAGE…`` runs pages (all without a name) and writes what they print anew; ``--check`` only
reports pages that differ, ``--pictures`` keeps the pictures that a program draws under names that its page shows.
`tests/tools/test_page_output.py` checks all pages.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import re
import shlex
import sys
import tempfile
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

from click.testing import CliRunner
from filling import DOCS, fill, pages

from flexel.apps.cli.main import main as flexel_command

BLOCK = re.compile(r"^```(?P<language>[^\n`]*)\n(?P<text>.*?)^```$", re.DOTALL | re.MULTILINE)
PICTURE = re.compile(r"\]\(images/([\w-]+\.png)\)")
FILE = re.compile(r"# (\w+\.py)")
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?|(?<![\w.])[-+]?\.\d+")

# Parts that are not run here: the page, the first line of the part (or * for all), and why.
LEFT_OUT = {
    ("README.md", "let = Let()"): "a part of derive/elements/truss.py, shown as an example",
    (
        "adding-an-element.md",
        "*",
    ): "needs its element to be compiled: tests/test_adding_an_element.py follows the page",
    (
        "coming-from-exudyn.md",
        "import exudyn as exu",
    ): "needs Exudyn; tests/tools/test_page_output.py runs it where it is",
    ("start.md", "import logging"): "sets up the log of the whole process",
    (
        "start.md",
        "from concurrent.futures import ProcessPoolExecutor",
    ): "other processes import the function from a file",
    ("sweeps.md", "from distributed import Client, LocalCluster"): "tests/sweeps start such a cluster",
    ("sweeps.md", "from dask_jobqueue import SLURMCluster"): "needs a cluster with a queue",
}


@dataclass(frozen=True)
class Part:
    """One block of a program: its code, what it prints according to the page, and whether it is of commands."""

    code: str
    shown: re.Match[str] | None
    commands: bool = False

    @property
    def head(self) -> str:
        """The first line."""
        return self.code.split("\n", 1)[0]


@dataclass(frozen=True)
class Ran:
    """The results of a program: its names, the output of each part, and the pictures that it drew."""

    names: dict[str, Any]
    printed: list[tuple[Part, str]] = field(default_factory=list)
    drawn: dict[str, bytes] = field(default_factory=dict)


def parts(text: str) -> Iterator[Part]:
    """Return the parts of the program of a page."""
    blocks = list(BLOCK.finditer(text))
    for block, after in pairwise([*blocks, None]):
        if block is None or block["language"] not in ("python", "sh"):
            continue
        if after is not None and (
            after["language"] not in ("text", "c") or text[block.end() : after.start()].strip()
        ):
            after = None
        if block["language"] == "python" or after is not None:
            yield Part(block["text"], after, block["language"] == "sh")


def run(page: Path) -> Ran:
    """Run the program of a page in a separate folder."""
    ran, text, before = Ran({"__name__": page.stem}), page.read_text(encoding="utf-8"), Path.cwd()
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("error", UserWarning)
        os.chdir(folder)
        try:
            for part in parts(text):
                if not LEFT_OUT.keys() & {(page.name, part.head), (page.name, "*")}:
                    ran.printed.append((part, execute(part, page.name, ran.names)))
            ran.drawn.update({file.name: file.read_bytes() for file in Path().glob("*.png")})
        finally:
            os.chdir(before)
    return ran


def execute(part: Part, page: str, names: dict[str, Any]) -> str:
    """Run one part; return its output."""
    if part.commands:
        return "".join(_of_command(line) for line in part.code.splitlines())
    if file := FILE.fullmatch(part.head):
        Path(file[1]).write_text(part.code, encoding="utf-8")
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(part.code, f"{page}: {part.head}", "exec", dont_inherit=True), names)  # noqa: S102
    return out.getvalue()


def _of_command(line: str) -> str:
    """Return what a command of flexel prints; a comment may follow it."""
    program, *arguments = shlex.split(line, comments=True)
    if program != "flexel":
        raise ValueError(f"{line}: only commands of flexel are run")
    result = CliRunner().invoke(flexel_command, arguments, catch_exceptions=False)
    if result.exit_code:
        raise ValueError(f"{line}: {result.output}")
    return result.stdout


def agrees(part: Part, printed: str) -> bool:
    """Whether a part prints what its page shows; the errors of `flexel verify` depend on the machine."""
    if part.shown is None:
        return True
    measured = part.commands and part.code.startswith("flexel verify")
    return agree(part.shown["text"], printed, counts_only=measured)


def agree(shown: str, printed: str, counts_only: bool = False) -> bool:
    """Whether both have the same words, and numbers that differ by at most one unit of the last digit shown.

    Numbers after the word "about" depend on rounding, and so on the processor: they may differ by a quarter, errors
    such as 2e-05 by a factor of three. With `counts_only`, only whole numbers are compared.
    """
    if NUMBER.sub("#", shown).split() != NUMBER.sub("#", printed).split():
        return False
    pairs = zip(NUMBER.finditer(shown), NUMBER.findall(printed), strict=True)
    return all(
        _near(a[0], b, shown[: a.start()].endswith("about "))
        for a, b in pairs
        if not (counts_only and _unit(a[0]))
    )


def _near(shown: str, printed: str, about: bool) -> bool:
    """Whether two numbers agree, one of which a page shows."""
    a, b = float(shown), float(printed)
    if about and "e" in shown:
        return a / 3.001 <= b <= 3.001 * a
    return abs(a - b) <= max(1.01 * _unit(shown), 0.25 * abs(a) if about else 0.0)


def _unit(number: str) -> float:
    """Return the weight of the last digit; numbers without a point are counts, and exact."""
    mantissa, _, exponent = number.partition("e")
    if "." not in mantissa and not exponent:
        return 0.0
    return float(10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2])))


def renewed(page: Path, images: Path | None) -> str:
    """Return the text of a page with the current output of its program, where that differs from the output shown.

    Pictures that the program draws and the page shows from ``images/`` are written to `images`.
    """
    text, ran = page.read_text(encoding="utf-8"), run(page)
    for part, out in reversed(ran.printed):
        if part.shown is not None and not agrees(part, out):
            start, end = part.shown.span("text")
            text = text[:start] + "".join(f"{line.rstrip()}\n" for line in out.splitlines()) + text[end:]
    if images is not None:
        for name in ran.drawn.keys() & set(PICTURE.findall(text)):
            (images / name).write_bytes(ran.drawn[name])
    return text


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Run the programs of pages and fill what they print.")
    parser.add_argument("pages", nargs="*", help="names such as start.md; all without one")
    parser.add_argument("--check", action="store_true", help="change nothing, fail where a page differs")
    parser.add_argument("--pictures", action="store_true", help="keep the pictures that programs draw")
    given = parser.parse_args()
    os.environ.setdefault("MPLBACKEND", "Agg")
    unknown = sorted(set(given.pages) - {page.name for page in pages()})
    if unknown:
        parser.error(f"no page is called {', '.join(unknown)}; give names such as start.md")
    chosen = [page for page in pages() if page.name in given.pages or not given.pages]
    images = DOCS / "images" if given.pictures else None
    new = {page.read_text(encoding="utf-8"): renewed(page, images) for page in chosen}
    sys.exit(fill(chosen, new.__getitem__, check=given.check))
