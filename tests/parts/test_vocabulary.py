"""The runtime reads what an element is from its declaration; it has no list of names of elements, laws or families."""

import ast
from dataclasses import replace
from pathlib import Path

import pytest

import flexel as fx
from flexel.apps.view.painters import PAINTERS
from flexel.derive.declare.words import PICTURES, SIGNS
from flexel.generated.table import ELEMENTS
from flexel.model.signs import CHECKS

ROOT = Path(fx.__file__).parent.parent
RUNTIME = sorted(
    path for folder in ("runtime", "parts", "results", "apps") for path in (ROOT / folder).rglob("*.py")
)


def test_every_picture_has_a_painter_and_every_sign_a_check() -> None:
    assert sorted(PAINTERS) == sorted(PICTURES)
    assert list(CHECKS) == list(SIGNS)


def asks_for_a_name(node: ast.AST) -> bool:
    """Whether code compares the name of an element's or law's specification with text, or looks into it."""
    if isinstance(node, ast.Compare):
        sides = [node.left, *node.comparators]
        texts = any(isinstance(side, ast.Constant | ast.Tuple | ast.Set | ast.List) for side in sides)
        named = any(
            isinstance(side, ast.Name) and side.id.isupper() and side.id != "ELEMENTS" for side in sides
        )
        return any(ast.unparse(side).endswith("spec.name") for side in sides) and (texts or named)
    return isinstance(node, ast.Call) and "spec.name." in ast.unparse(node.func)


@pytest.mark.parametrize("path", RUNTIME, ids=lambda path: path.name)
def test_nothing_depends_on_the_name_of_an_element(path: Path) -> None:
    assert [
        ast.unparse(node) for node in ast.walk(ast.parse(path.read_text())) if asks_for_a_name(node)
    ] == []


def asks_for_a_family(node: ast.AST) -> bool:
    """Whether code compares a family or looks it up; to print one is no question."""
    if isinstance(node, ast.Compare):
        return any("spec.family" in ast.unparse(side) for side in (node.left, *node.comparators))
    return isinstance(node, ast.Subscript) and "spec.family" in ast.unparse(node.slice)


def looks_up_a_name(node: ast.AST) -> bool:
    """Whether code takes what belongs to an element or law from a table that has its name as a key."""
    if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "get"):
        return False
    table = ast.unparse(node.func.value)
    return table.isupper() and any(ast.unparse(key).endswith("spec.name") for key in node.args)


@pytest.mark.parametrize("path", sorted((ROOT / "runtime").rglob("*.py")), ids=lambda path: path.name)
def test_the_core_asks_for_no_family(path: Path) -> None:
    """It reads facts of the pages: gaps, what is reported, the arms of bodies, where a law begins to act."""
    nodes = ast.walk(ast.parse(path.read_text()))
    assert [ast.unparse(node) for node in nodes if asks_for_a_family(node) or looks_up_a_name(node)] == []


@pytest.mark.parametrize("kinked", [False, True])
def test_a_deformation_with_a_kink_is_no_degree_of_freedom(kinked: bool) -> None:
    m = fx.Model()
    m.point("A", (0, 0, 0), fixed=True)
    m.point("B", (0.6, 0.8, 0))
    m.fix("B.y", "B.z")
    m.truss("bar", "A", "B")
    m.spring("bar.elongation", stiffness=100.0)
    m.point_mass("load", "B", 1.0)
    bar = m.instances["bar"]
    (elongation,) = bar.spec.deformations
    m.instances["bar"] = replace(
        bar, spec=replace(bar.spec, deformations=(replace(elongation, kinked=kinked),))
    )
    structure = m.build().structure
    assert structure.kinked == ((structure.index["bar.elongation"],) if kinked else ())
    assert m.build().dynamic == (("B.x",) if kinked else ("bar.elongation",))


def test_the_gaps_of_round_and_helical_grooves_say_that_they_have_kinks() -> None:
    kinked = {element.name for element in ELEMENTS.values() if any(d.kinked for d in element.deformations)}
    assert kinked == {f"{name}_round_groove" for name in ("cable", "point", "sphere")} | {
        "cable_helical_groove"
    }


def test_a_matrix_with_a_negative_eigenvalue_is_refused() -> None:
    m = fx.Model(gravity=(0, 0, 0))
    m.point("A", (0, 0, 0), fixed=True)
    m.point("B", (1, 0, 0))
    m.truss("bar", "A", "B")
    with pytest.raises(fx.ModelError, match="parameter S .* has a negative eigenvalue"):
        m.attach("linear_1", ["bar.elongation"], preload=0, S=-1.0, D=0)
