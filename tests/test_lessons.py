"""Every lesson of the documentation runs, and finds the known number of its exercise; one of them as a notebook."""

import os
import runpy
from pathlib import Path

import numpy as np
import pytest

FOLDER = Path(__file__).parents[1] / "docs" / "lessons"
LESSONS = sorted(file.stem for file in FOLDER.glob("lesson_*.py"))
LOOSE = {  # relative differences that are due to the model, where they are more than rounding and integration
    "lesson_02_mechanism": 1e-4,  # extremes of stored instants
    "lesson_05_statics": 5e-5,  # four elements
    "lesson_06_flexure": 3e-4,  # the leaves stretch, and shear
    "lesson_08_rope": 5e-3,  # the rope stretches and has a mass
}
TIGHT = 1e-9


@pytest.mark.parametrize("name", LESSONS)
def test_a_lesson_finds_what_is_known(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot", reason="lessons draw: pip install 'flexel[plot]'")
    monkeypatch.setattr(pyplot, "show", lambda: None)
    try:
        with pyplot.rc_context():
            names = runpy.run_path(str(FOLDER / f"{name}.py"))
    finally:
        pyplot.close("all")
    scale = np.max(np.abs(names["known"]))
    assert np.max(np.abs(np.subtract(names["found"], names["known"]))) <= LOOSE.get(name, TIGHT) * scale


def test_there_are_ten_and_each_has_an_exercise_with_a_solution() -> None:
    assert [int(name.split("_")[1]) for name in LESSONS] == list(range(1, 11))
    for name in LESSONS:
        text = (FOLDER / f"{name}.py").read_text(encoding="utf-8")
        assert text.count("\n# Exercise\n# --------\n") == text.count("\n# Solution\n# --------\n") == 1, name


def test_a_lesson_is_a_notebook_that_shows_its_motion_and_its_figures() -> None:
    """The file that the built documentation offers, in a kernel; its last lines of cells are pictures."""
    nbclient = pytest.importorskip("nbclient", reason="pip install 'flexel[test]'")
    nbformat = pytest.importorskip("nbformat", reason="pip install 'flexel[test]'")
    built = Path(os.environ.get("FLEXEL_DOCS", FOLDER.parent / "_build"))
    if not built.is_dir():
        pytest.skip("the documentation is not built: make pages")
    (file,) = sorted(built.rglob("lesson_01_names.ipynb"))
    book = nbformat.read(file, as_version=4)
    nbclient.NotebookClient(book, timeout=300, kernel_name="python3").execute()
    shown = [set(output.get("data", {})) for cell in book.cells for output in cell.get("outputs", [])]
    assert any("text/html" in kinds for kinds in shown) and any("image/png" in kinds for kinds in shown)
