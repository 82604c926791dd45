"""Docstrings of the methods of `Model`, composed of the docstring of a part and the meaning of its fields."""

from __future__ import annotations

import ast
import inspect
from collections.abc import Iterator
from dataclasses import Field, fields
from functools import cache
from itertools import pairwise
from textwrap import indent, wrap
from typing import Any

from flexel.base.meaning import meaning_of
from flexel.model.part import Part

WIDTH = 104  # of the lines of text
SECTIONS = ("Parameters", "Returns", "Raises", "Warns", "See Also", "Notes", "References", "Examples")

# Readable names of annotations whose names would not help a reader.
WORDS = {
    "Any": "object",
    "Array": "array_like",
    "Given": "str, RigidBody or pair of nodes",
    "Numbers": "sequence of float",
    "Outline": "callable or sequence of float",
    "Path": "sequence of points, or callable",
    "Vector": "sequence of float",
}
CONTAINERS = {"Sequence": "sequence", "list": "list", "Mapping": "mapping"}


def documentation(kind: type[Part[Any]]) -> str:
    """Write the docstring of the method that declares a part: numpydoc, with its fields and what it returns."""
    head, sections = _sections(inspect.cleandoc(kind.__doc__ or ""))
    made = str(kind.lower.__annotations__["return"])
    composed = {"Parameters": "\n".join(line for item in fields(kind) for line in _entry(item))}
    if made != "None":
        composed["Returns"] = in_words(made)
    sections = composed | sections
    shown = (f"{title}\n{'-' * len(title)}\n{sections[title]}" for title in SECTIONS if sections.get(title))
    return "\n\n".join([head, *shown])


@cache
def in_words(annotation: str) -> str:
    """Write the type of an annotation as numpydoc writes types: "float, optional", "sequence of float", "node"."""
    return _union(ast.parse(annotation, mode="eval").body)


def _sections(text: str) -> tuple[str, dict[str, str]]:
    """Return the text before the first section, and the text of each section by title."""
    lines = text.splitlines()
    starts = [
        i for i, line in enumerate(lines) if line in SECTIONS and lines[i + 1 : i + 2] == ["-" * len(line)]
    ]
    bounds = [*starts, len(lines)]
    return "\n".join(lines[: bounds[0]]).rstrip(), {
        lines[start]: "\n".join(lines[start + 2 : end]).rstrip() for start, end in pairwise(bounds)
    }


def _entry(item: Field[Any]) -> Iterator[str]:
    """Write the lines of a field in the section of parameters."""
    meaning, annotation = meaning_of(item), str(item.type)
    if not meaning.spread:
        yield f"{item.name} : {meaning.form or in_words(annotation)}"
    elif annotation.startswith("tuple"):
        yield f"*{item.name} : {meaning.form or in_words(annotation).removeprefix('tuple of ')}"
    else:
        yield f"**{item.name}"
    yield from indent("\n".join(wrap(meaning.sentence, WIDTH)), "    ").splitlines()


def _union(node: ast.expr) -> str:
    """Write a type, or its alternatives, in words."""
    alternatives = list(_alternatives(node))
    shown = [option for option in alternatives if option != "None"]
    if "Node" in shown and "str" in shown:  # names are accepted wherever nodes are
        shown[shown.index("Node")] = "node"
        shown.remove("str")
    given = dict.fromkeys(shown)
    if any(option.startswith("Sequence[") for option in given):
        given.pop("Array", None)
    words = [_words(option) for option in given]
    joined = f"{', '.join(words[:-1])} or {words[-1]}" if len(words) > 1 else words[0]
    return f"{joined}, optional" if "None" in alternatives else joined


def _alternatives(node: ast.expr) -> Iterator[str]:
    """Return the the alternatives of a union, as they are written."""
    if isinstance(node, ast.BinOp):
        yield from _alternatives(node.left)
        yield from _alternatives(node.right)
    else:
        yield ast.unparse(node)


def _words(option: str) -> str:
    """Write one alternative in words."""
    node = ast.parse(option, mode="eval").body
    if not isinstance(node, ast.Subscript):
        return WORDS.get(option, option)
    container = ast.unparse(node.value)
    inner = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
    if container == "Callable":
        return "callable"
    if option.startswith("Sequence[Sequence["):
        return "matrix"
    members = [_plural(_union(item)) for item in inner if ast.unparse(item) != "..."]
    if container == "tuple":
        return f"{'tuple' if len(members) < len(inner) else 'pair'} of {members[0]}"
    return f"{CONTAINERS.get(container, container)} of {' to '.join(members)}"


def _plural(words: str) -> str:
    return "nodes" if words == "node" else words
