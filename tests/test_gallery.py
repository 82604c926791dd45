"""Every program of the gallery runs, draws in flexel's style, and finds its known number."""

import ast
import inspect
import re
import runpy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from flexel.apps.view.figures import COLOURS
from flexel.examples import gallery

FOLDER = Path(inspect.getfile(gallery)).parent
NAMES = sorted(file.stem for file in FOLDER.glob("[a-z]*.py"))
TIGHT = 1e-7
LOOSE = {  # relative differences that are due to the model, where they are more than rounding and integration
    "bicycle": 2e-5,  # speeds are interpolated between those computed
    "buckling": 3e-3,  # eight elements
    "flexure_stage": 1e-5,  # the leaves stretch
    "four_bar": 1e-6,  # extremes of stored instants
    "hanging_chain": 1e-3,  # forty links
    "own_element": 1e-7,
}
LONGEST = 40  # lines of code


@pytest.mark.parametrize("name", NAMES)
def test_a_program_finds_what_is_known(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot", reason="the gallery draws: pip install 'flexel[plot]'")
    shown: list[int] = []
    monkeypatch.setattr(pyplot, "show", lambda: shown.extend(pyplot.get_fignums()))
    try:
        with pyplot.rc_context():
            names = runpy.run_path(str(FOLDER / f"{name}.py"))
            assert pyplot.rcParams["axes.prop_cycle"].by_key()["color"] == list(COLOURS)
        assert len(shown) == 1
        check_figure(pyplot.figure(shown[0]))
    finally:
        pyplot.close("all")
    known = np.asarray(names["known"])
    scale = abs(known).max()
    np.testing.assert_allclose(names["found"], known, rtol=0, atol=LOOSE.get(name, TIGHT) * scale)


@pytest.mark.parametrize("name", NAMES)
def test_a_program_ends_with_a_page_of_the_viewer_and_its_picture_is_in_the_list(
    name: str, checkout: Path
) -> None:
    """`tools/gallery_pictures.py` draws the picture."""
    text = (FOLDER / f"{name}.py").read_text(encoding="utf-8")
    last = ast.parse(text).body[-1]
    assert isinstance(last, ast.Expr) and isinstance(last.value, ast.Call)
    assert ast.unparse(last.value.func).endswith((".view", "view_modes"))
    path = f"images/gallery/{name}.png"
    assert f"# sphinx_gallery_thumbnail_path = '{path}'\n" in text
    assert (checkout / "docs" / path).read_bytes()[16:24] == (400).to_bytes(4) + (280).to_bytes(4)


def check_figure(figure: Any) -> None:
    """Something is drawn; the figure has a title, and plain axes have quantities with units."""
    assert figure.axes[0].has_data()
    assert figure.get_suptitle() or any(axes.get_title() for axes in figure.axes)
    for axes in figure.axes:
        if axes.name == "rectilinear":
            bar = axes.get_label() == "<colorbar>"
            for label in (axes.get_ylabel(),) if bar else (axes.get_xlabel(), axes.get_ylabel()):
                assert re.fullmatch(r"[^\[]+ \[.+\]", label), label


def test_there_are_enough_and_they_are_short() -> None:
    """Code is counted without the text at the head, empty lines, comments, and what shows the motion at the end."""
    lengths = {}
    for name in NAMES:
        text = (FOLDER / f"{name}.py").read_text(encoding="utf-8").split("# %%")[0]
        code = text.split("\n")[ast.parse(text).body[0].end_lineno :]
        lengths[name] = sum(1 for line in code if line.strip() and not line.lstrip().startswith("#"))
    assert len(NAMES) >= 24
    assert {name: n for name, n in lengths.items() if n >= LONGEST} == {}
