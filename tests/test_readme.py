"""The README's program runs as it stands and prints what the README says of it."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

README = Path(__file__).parents[1] / "README.md"


def program() -> str:
    found = re.search(r"```python\n(import numpy.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    assert found is not None
    return found[1]


def test_the_bicycle_takes_less_than_thirty_lines() -> None:
    assert len(program().strip().splitlines()) < 30


def test_the_bicycle_of_the_readme_rides(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="the README's program draws with matplotlib")
    environment = os.environ | {"MPLBACKEND": "Agg"}
    answer = subprocess.run(
        [sys.executable, "-c", program()],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        env=environment,
        check=False,
    )
    assert answer.returncode == 0, answer.stderr
    assert (tmp_path / "kick.png").stat().st_size > 10_000
    for digits in ("-13.1", "-0.72", "-0.26", "3.72"):
        assert digits in answer.stdout


PAGES = [README, *sorted((README.parent / "docs").glob("*.md"))]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_pictures_and_links_of_a_page_exist(page: Path) -> None:
    names = re.findall(r"\]\(([^):#]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
    assert names
    assert [name for name in names if not _exists(page.parent, name)] == []


def _exists(folder: Path, name: str) -> bool:
    """Whether a link leads somewhere: to a file, or to what is written when the documentation is built."""
    gallery = name.removeprefix("_generated/gallery/")
    if gallery == name:
        return (folder / name).is_file()
    return gallery == "index" or (folder.parent / "examples" / "gallery" / f"{gallery}.py").is_file()


@pytest.mark.parametrize("page", ["flexures.md", "warping.md"])
def test_the_leaf_spring_of_the_documentation_runs(page: str, capsys: pytest.CaptureFixture[str]) -> None:
    text = (README.parent / "docs" / page).read_text(encoding="utf-8")
    found = re.search(r"```python\n(.*?)```", text, re.DOTALL)
    assert found is not None
    exec(found[1], {})
    assert capsys.readouterr().out.strip()
