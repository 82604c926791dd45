"""Docstrings of the methods of `Model`: sections in numpydoc's order, types in words, units within the sentence."""

from __future__ import annotations

import inspect
import re
from dataclasses import fields
from typing import Any

import pytest

import flexel as fx
from flexel.base.meaning import Meaning, entry, meaning_of, quantity
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.parts.documentation import SECTIONS, documentation, in_words
from flexel.parts.method import METHOD_OF

assert fx.Model  # fills the table of methods
KINDS = [pytest.param(kind, id=name) for kind, name in METHOD_OF.items()]


@pytest.mark.parametrize(
    ("annotation", "words"),
    [
        ("float | None", "float, optional"),
        ("Node | str", "node"),
        ("Node | str | None", "node, optional"),
        ("bool | Sequence[Node | str]", "bool or sequence of nodes"),
        ("Sequence[float] | Array | None", "sequence of float, optional"),
        ("tuple[Node | str, Node | str]", "pair of nodes"),
        ("tuple[str, ...]", "tuple of str"),
        ("Mapping[str, tuple[float, float]] | None", "mapping of str to pair of float, optional"),
        ("float | Sequence[Sequence[float]] | Array | Curve | Callable[..., Any]", "float, matrix, Curve or callable"),
        ("list[ContactPoint]", "list of ContactPoint"),
    ],
)  # fmt: skip
def test_types_in_words(annotation: str, words: str) -> None:
    assert in_words(annotation) == words


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("Bending stiffness about z.", "Bending stiffness about z [N m²]."),
        ("Stiffness about z; planar beams need it.", "Stiffness about z [N m²]; planar beams need it."),
        ("Stiffness, by default that of steel.", "Stiffness [N m²], by default that of steel."),
        ("Stiffness k E I [] about z, 0.5 of it.", "Stiffness k E I [N m²] about z, 0.5 of it."),
    ],
)
def test_a_unit_is_within_the_sentence(text: str, sentence: str) -> None:
    assert Meaning(text, "N m²").sentence == sentence
    assert Meaning(text.replace("[] ", ""), "-").sentence == text.replace("[] ", "")


@part
class Post(Part[Node]):
    """Put up a post.

    Raises
    ------
    ModelError
        A height that is not positive.

    See Also
    --------
    beam : A flexible one.
    """

    name: str = entry("Name of the post.")
    height: float | None = quantity("m", "positive", "Height; none by default.", default=None)

    def lower(self, to: Lowering) -> Node:
        """Nothing here."""
        raise NotImplementedError


def test_a_docstring_is_composed_of_the_fields() -> None:
    assert documentation(Post).splitlines() == [
        *("Put up a post.", ""),
        *("Parameters", "----------", "name : str", "    Name of the post."),
        *("height : float, optional", "    Height [m]; none by default.", ""),
        *("Returns", "-------", "Node", ""),
        *("Raises", "------", "ModelError", "    A height that is not positive.", ""),
        *("See Also", "--------", "beam : A flexible one."),
    ]


@pytest.mark.parametrize("kind", KINDS)
def test_sections_come_in_the_order_of_numpydoc(kind: type[Part[Any]]) -> None:
    text = documentation(kind)
    found = [
        title
        for title, line in re.findall(r"^(\w[\w ]*)\n(-+)$", text, re.MULTILINE)
        if len(title) == len(line)
    ]
    assert found == [title for title in SECTIONS if title in found]
    assert len(found) == text.count("\n--")
    assert ("Returns" in found) == (inspect.signature(kind.lower).return_annotation != "None")


@pytest.mark.parametrize("kind", KINDS)
def test_every_field_has_sentences_with_its_unit_and_a_type_in_words(kind: type[Part[Any]]) -> None:
    wrong = []
    for item in fields(kind):
        meaning = meaning_of(item)
        ends = meaning.text.endswith((".", "…")) and meaning.text[0] in '"ABCDEFGHIJKLMNOPQRSTUVWXYZ'
        unit = meaning.unit in (None, "-", "") or meaning.sentence.count(f"[{meaning.unit}]") == 1
        words = meaning.form or in_words(str(item.type))
        plain = meaning.spread or not re.search(r"[|\[\]]|object|Any", words)
        if not (ends and unit and plain):
            wrong.append((item.name, words, meaning.sentence))
    assert wrong == []
