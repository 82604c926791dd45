"""Docstrings as Sphinx is given them."""

import ast
import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

import flexel


@pytest.fixture(scope="module")
def docstrings(checkout: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location("docstrings", checkout / "docs" / "docstrings.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_attributes_that_share_a_line_have_one_each(docstrings: ModuleType) -> None:
    given = [
        "Text.",
        "",
        "Attributes",
        "----------",
        "M, C : ndarray (nd, nd)",
        "    |M| is large.",
        "t : float",
        "",
    ]
    given += ["A, B : ndarray (nk, nd), tuple of str", "    Both.", "p, q : str, optional"]
    lines = list(given)
    docstrings.process(None, "class", "name", None, None, lines)
    assert lines == [
        *given[:4],
        *("M : ndarray (nd, nd)", "    \\|M\\| is large.", "C : ndarray (nd, nd)", "    \\|M\\| is large."),
        *("t : float", "", "A : ndarray (nk, nd)", "    Both.", "B : tuple of str", "    Both."),
        *("p : str, optional", "q : str, optional"),
    ]


def test_parameters_are_left_as_they_are(docstrings: ModuleType) -> None:
    given = ["Parameters", "----------", "p, q : str", "    Bodies."]
    assert docstrings.separated(given) == given


def test_a_colon_in_a_property_does_not_make_a_type(docstrings: ModuleType) -> None:
    lines = ["Torsion constant: the polar moment.", ""]
    docstrings.process(None, "property", "J", None, None, lines)
    assert lines == ["Torsion constant – the polar moment.", ""]


def test_every_public_name_has_a_topic(checkout: Path) -> None:
    """A module that the page of public names does not list stops the build of the documentation."""
    tree = ast.parse((checkout / "docs" / "pages.py").read_text(encoding="utf-8"))
    [topics] = [
        n.value for n in tree.body if isinstance(n, ast.Assign) and ast.unparse(n.targets[0]) == "HOMES"
    ]
    listed = {module for modules in ast.literal_eval(topics).values() for module in modules}
    assert set(flexel._HOMES.values()) - listed == set()
