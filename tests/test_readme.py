"""The README's program is short, and links and pictures of all pages exist; test_docs.py runs the program."""

import re
from pathlib import Path

import pytest

README = Path(__file__).parents[1] / "README.md"


def program() -> str:
    found = re.search(r"```python\n(import numpy.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    assert found is not None
    return found[1]


def test_the_bicycle_takes_less_than_thirty_lines() -> None:
    assert len(program().strip().splitlines()) < 30


PAGES = [README, *sorted((README.parent / "docs").glob("*.md"))]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_pictures_and_links_of_a_page_exist(page: Path) -> None:
    names = re.findall(r"\]\(([^):#]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
    assert names
    assert [name for name in names if not _exists(page.parent, name)] == []


def _exists(folder: Path, name: str) -> bool:
    """Whether a link leads somewhere: to a file, or to what is written when the documentation is built."""
    gallery = name.removeprefix("_generated/gallery/")
    if name in ("_generated/laws", "_generated/elements", "_generated/api", "_generated/lessons/index"):
        return True
    if gallery == name:
        return (folder / name).is_file()
    return gallery == "index" or (folder.parent / "examples" / "gallery" / f"{gallery}.py").is_file()
