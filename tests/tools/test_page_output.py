"""Programs of README.md and of the pages are found, marked and compared; they run in test_docs.py."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import page_output
import pytest
from filling import DOCS
from page_programs import PAGES, WITHOUT

PARTS = {
    page: list(page_output.parts((DOCS / page).read_text(encoding="utf-8")))
    for page in PAGES
    if page != "README.md"
}
SHOWN = sorted(page for page, parts in PARTS.items() if any(part.shown for part in parts))


def test_every_page_has_a_program_and_shows_what_it_prints() -> None:
    assert sorted(page for page, parts in PARTS.items() if not parts) == sorted(WITHOUT)
    assert set(PARTS) - {*SHOWN, *WITHOUT} <= {"adding-an-element.md"}


def test_what_is_not_run_is_still_there() -> None:
    """A reason whose program is gone, or has changed its first line, is no reason."""
    heads = {(page, part.head) for page, parts in PARTS.items() for part in parts}
    heads |= {(page, "*") for page in PARTS}
    left = {program for program in page_output.LEFT_OUT if program[0] != "README.md"}
    assert left <= heads


@pytest.mark.parametrize("page", PAGES)
def test_every_program_is_marked_as_one(page: str) -> None:
    """No Python hides in a block of another language, or of none."""
    text = (DOCS.parent / page if page == "README.md" else DOCS / page).read_text(encoding="utf-8")
    for block in page_output.BLOCK.finditer(text):
        if block["language"] in ("", "sh"):
            with pytest.raises(SyntaxError):
                ast.parse(block["text"])
    assert {block["language"] for block in page_output.BLOCK.finditer(text)} & {
        "py",
        "python3",
        "Python",
    } == set()


@pytest.mark.parametrize(
    ("shown", "printed", "same"),
    [
        ("1.234 N", "1.2344999 N", True),
        ("1.234 N", "1.236 N", False),
        ("1.234 N", "1.234 m", False),
        ("-1.5e-03", "-1.51e-03", True),
        ("-1.5e-03", "1.5e-03", False),
        ("5 parts", "6 parts", False),
        ("[1. 2.]", "[1.  2.]", True),
        ("1.0", "1.0 2.0", False),
        ("beam2", "beam3", False),
        ("-0.26-3.73j", "-0.26+3.73j", False),
        ("about 2.9 thousand, error about 2e-08", "about 3.2 thousand, error about 5e-08", True),
        ("about 2.9 thousand", "about 3.9 thousand", False),
        ("about 75 steps", "about 92 steps", True),
        ("about 75 steps", "about 95 steps", False),
        ("error about 2e-08", "error about 7e-08", False),
    ],
)
def test_what_is_shown_is_compared_to_its_last_digit(shown: str, printed: str, same: bool) -> None:
    assert page_output.agree(shown, printed) is same


def test_blocks_of_a_page_are_found_and_its_output_is_filled(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "# A\n```python\nx = 2\n```\ntext\n\n```text\nno output\n```\n\n```python\nprint(x + 1)\n```\n\n```text\n```\n"
    )
    first, second = page_output.parts(page.read_text())
    assert first.shown is None and first.code == "x = 2\n" and second.shown is not None
    assert page_output.renewed(page, None) == page.read_text().replace("```text\n```", "```text\n3\n```")
    assert re.search("no output", page_output.renewed(page, None))


def test_the_program_for_exudyn_prints_what_its_page_shows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("exudyn", reason="Exudyn is not installed: pip install 'flexel[peers]'")
    monkeypatch.chdir(tmp_path)  # it writes a folder
    part = PARTS["coming-from-exudyn.md"][0]
    shown = part.shown["text"].split()
    printed = page_output.execute(part, "coming-from-exudyn.md", {}).split()[-2:]
    assert [float(number) for number in printed] == pytest.approx(
        [float(number) for number in shown], abs=2e-6
    )
