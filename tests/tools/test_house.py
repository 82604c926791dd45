"""The figures of tools/house.py are the kept ones, which only fall; what is new is named."""

import house
import pytest
from house import Figure


@pytest.fixture(scope="module")
def found() -> dict[str, Figure]:
    return house.figures()


def test_no_figure_has_grown(found: dict[str, Figure]) -> None:
    assert house.faults(found, house.kept()) == ([], [])


def test_what_is_new_is_named(found: dict[str, Figure]) -> None:
    name = "names of modules given again"
    now = {name: Figure.of({"models": 1, "steps": 2}), "lines of C": Figure(1004)}
    kept = {name: Figure.of({"steps": 1}), "lines of C": Figure(1000)}
    above, below = house.faults(now, kept)
    assert below == [] and above[0].startswith(f"{name}: 3 for 1 (models +1, steps +1); make it smaller, or ")
    assert len(above) == 1  # of lines, a few are allowed
    assert house.faults(kept, now) == ([], [f"{name}: only 1 for 3: python tools/house.py --write"])
    assert house.faults({"lines of C": Figure(1006)}, kept)[0][0].startswith("lines of C: 1006 for 1000; ")


def test_what_is_counted() -> None:
    tree = house.ast.parse(
        "A = 1\nB: float = 2.0\nC, D = 1, 2\nE = 'text'\nf = 3\nG = {'a': 0.5}\nclass H: ...\n"
    )
    assert [*house.constants(tree)] == ["A", "B", "C", "D", "G"]
