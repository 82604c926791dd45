"""In a real kernel: figures, pages and animations show by themselves as the last line of a cell."""

from __future__ import annotations

import base64
from pathlib import Path
from typing import Any

import pytest
from browser import Browser

CELLS = {
    "model": """
import sys

sys.path.insert(0, {tests!r})
from mechanisms import pendulum_model

import flexel as fx

m = pendulum_model()
m
""",
    "system": "system = m.build()\nsystem",
    "motion": "motion = system.simulate(1.0, samples=21)\nmotion",
    "state": "motion[-1]",
    "linearization": "hanging = system.equilibrium(stable=True)\nlin = system.linearize(hanging)\nlin",
    "modes": "lin.modes()",
    "plot": 'motion.plot("A.x")',
    "phase": 'motion.plot_phase("pivot.angle")',
    "spectrum": 'motion.spectrum_plot("pivot.angle")',
    "shapes": "motion.plot_shapes(0.0, 0.5)",
    "loci": 'system.root_loci(parameters={{"rod.rhoA": [1.0, 2.0]}}).plot()',
    "view": "motion.view(frames=5)",
    "again": 'motion.view(frames=5, title="Once more")',
    "vibration": "lin.view()",
    "animate": "motion.animate(fps=4.0)",
    "energy": "motion.energy",
    "node": "system.structure.nodes[0]",
    "element": 'm.instances["rod"]',
    "bar": "_ = system.simulate(1.0, progress=True)",
}
FIGURES = ("plot", "phase", "spectrum", "shapes", "loci")
TABLES = (
    "model",
    "system",
    "motion",
    "state",
    "linearization",
    "modes",
    "view",
    "again",
    "vibration",
    "animate",
)


@pytest.fixture(scope="module")
def outputs() -> dict[str, list[Any]]:
    """What each cell shows."""
    pytest.importorskip("ipykernel", reason="notebooks need a kernel: pip install 'flexel[test]'")
    nbclient = pytest.importorskip(
        "nbclient", reason="notebooks are run by nbclient: pip install 'flexel[test]'"
    )
    from nbformat.v4 import new_code_cell, new_notebook

    tests = str(Path(__file__).parent.parent)
    notebook = new_notebook(cells=[new_code_cell(text.format(tests=tests)) for text in CELLS.values()])
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    return dict(zip(CELLS, (cell.outputs for cell in notebook.cells), strict=True))


def shown(outputs: dict[str, list[Any]], name: str) -> Any:
    """The result of a cell, by kinds of content; beside it there may be a progress bar, which was taken away."""
    *others, output = outputs[name]
    assert output.output_type == "execute_result", output
    assert not "".join(other.text for other in others).rpartition("\r")[2].strip(), others
    return output.data


@pytest.mark.parametrize("name", FIGURES)
def test_a_figure_shows_by_itself(outputs: dict[str, list[Any]], name: str) -> None:
    assert base64.b64decode(shown(outputs, name)["image/png"]).startswith(b"\x89PNG")


@pytest.mark.parametrize("name", TABLES)
def test_results_have_tables_and_pages(outputs: dict[str, list[Any]], name: str) -> None:
    assert shown(outputs, name)["text/html"]


def test_what_is_small_is_shown_in_one_line(outputs: dict[str, list[Any]]) -> None:
    energy, node, element = (shown(outputs, name)["text/plain"] for name in ("energy", "node", "element"))
    assert energy.startswith("Histories(kinetic 0 … ") and energy.endswith(" J)") and len(energy) < 120
    assert node == "Node(O: planar point at (0, 0) m, fixed)"
    assert element.startswith("Instance(rod: planar_beam3 on O, turn, A; ") and "l0 = 1 m" in element


def test_a_bar_of_work_that_is_soon_done_leaves_nothing(outputs: dict[str, list[Any]]) -> None:
    assert all(not output.text.strip() for output in outputs["bar"])


def test_an_animation_carries_its_picture(outputs: dict[str, list[Any]]) -> None:
    data = shown(outputs, "animate")["text/html"].split("base64,")[1].split('"')[0]
    assert base64.b64decode(data).startswith(b"GIF8")


def test_several_pages_of_a_saved_notebook_draw_offline(
    outputs: dict[str, list[Any]], tmp_path: Path, fresh: Browser
) -> None:
    """Each in a frame of its own; the fixture sees to it that nothing is fetched."""
    names = ("motion", "view", "again", "vibration")
    body = "".join(shown(outputs, name)["text/html"] for name in names)
    path = tmp_path / "saved.html"
    path.write_text(f"<!DOCTYPE html><html><body>{body}</body></html>")
    fresh.go(path.as_uri())
    drawn = "[...document.querySelectorAll('iframe')].filter(frame => {} !== undefined).length"
    picture = "frame.contentDocument?.querySelector('#picture')?.dataset.frame"
    fresh.wait(f"{drawn.format(picture)} === {len(names)}")
    titles = fresh.value("[...document.querySelectorAll('iframe')].map(frame => frame.title)")
    assert titles.count("Once more") == 1 and len(titles) == len(names)
