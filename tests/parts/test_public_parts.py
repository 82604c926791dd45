"""`flexel.parts` has every kind of part, and what a part of one's own is written with."""

import ast
from importlib import import_module
from pathlib import Path

import pytest

import flexel as fx
import flexel.parts
from flexel.parts.method import METHOD_OF

AUTHORING = {"Lowering", "Part", "array_quantity", "entry", "part", "quantity"}


def test_every_kind_of_part_is_public() -> None:
    assert fx.Model  # fills the table of methods
    assert set(flexel.parts.__all__) == {kind.__name__ for kind in METHOD_OF} | AUTHORING


def test_names_are_those_of_their_modules_and_of_static_tools(checkout: Path) -> None:
    homes = flexel.parts._HOMES
    assert {
        n for n, home in homes.items() if getattr(import_module(home), n) is not getattr(flexel.parts, n)
    } == set()
    tree = ast.parse((checkout / "parts" / "__init__.py").read_text(encoding="utf-8"))
    block = next(n for n in tree.body if isinstance(n, ast.If) and "TYPE_CHECKING" in ast.unparse(n.test))
    typed = {a.name: n.module for n in block.body if isinstance(n, ast.ImportFrom) for a in n.names}
    assert typed == homes
    assert set(homes) <= set(dir(flexel.parts))


def test_an_unknown_name_is_refused() -> None:
    with pytest.raises(AttributeError, match="Beem"):
        flexel.parts.Beem  # noqa: B018
