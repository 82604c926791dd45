"""The runtime reads what an element is from its declaration; it has no list of names of elements."""

import ast
from pathlib import Path

import pytest

import flexel as fx
from flexel.declare.signs import CHECKS
from flexel.derive.declare.words import PICTURES, SIGNS
from flexel.pictures.painters import PAINTERS

RUNTIME = sorted((Path(fx.__file__).parent).rglob("*.py"))


def test_every_picture_has_a_painter_and_every_sign_a_check() -> None:
    assert sorted(PAINTERS) == sorted(PICTURES)
    assert list(CHECKS) == list(SIGNS)


def asks_for_a_name(node: ast.AST) -> bool:
    """Whether code compares the name of an element's or law's specification with text, or looks into it."""
    if isinstance(node, ast.Compare):
        sides = [node.left, *node.comparators]
        texts = any(isinstance(z, ast.Constant | ast.Tuple | ast.Set | ast.List) for z in sides)
        named = any(isinstance(z, ast.Name) and z.id.isupper() and z.id != "ELEMENTS" for z in sides)
        return any(ast.unparse(z).endswith("spec.name") for z in sides) and (texts or named)
    return isinstance(node, ast.Call) and "spec.name." in ast.unparse(node.func)


@pytest.mark.parametrize("path", RUNTIME, ids=lambda path: path.name)
def test_nothing_depends_on_the_name_of_an_element(path: Path) -> None:
    assert [ast.unparse(z) for z in ast.walk(ast.parse(path.read_text())) if asks_for_a_name(z)] == []


def test_a_matrix_with_a_negative_eigenvalue_is_refused() -> None:
    m = fx.Model(gravity=(0, 0, 0))
    m.point("A", (0, 0, 0), fixed=True)
    m.point("B", (1, 0, 0))
    m.truss("bar", "A", "B")
    with pytest.raises(fx.ModelError, match="parameter S .* has a negative eigenvalue"):
        m.attach("linear_1", ["bar.elongation"], preload=0, S=-1.0, D=0)
