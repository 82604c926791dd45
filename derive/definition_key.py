"""The key of a definition: equal for equal definitions in every process, different where anything differs.

What is derived also depends on the program that derives it, so its files and the version of SymPy are part of the key.
"""

import hashlib
from collections.abc import Iterable
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any

import sympy as sp

from flexel.derive.declare import Element, Law

FOLDER = Path(__file__).resolve().parent


def definition_key(declared: Element | Law) -> str:
    """Return the key of an element or a law: twenty hexadecimal digits."""
    return _hashed([_program(), sp.__version__, _Digests().of(declared)])[:20]


@cache
def _program() -> str:
    """Return the hash of the files of `flexel.derive`."""
    files = sorted(path for path in FOLDER.rglob("*") if path.suffix in (".py", ".jinja"))
    return _hashed(
        text for path in files for text in (path.relative_to(FOLDER).as_posix(), path.read_text("utf-8"))
    )


class _Digests:
    """Hashes of declarations and expressions; a part that is shared by several expressions is hashed once."""

    def __init__(self) -> None:
        # by identity, since SymPy may count 2 and 2.0 as equal; an object that is kept keeps its identity
        self._known: dict[int, tuple[sp.Basic, str]] = {}

    def of(self, value: Any) -> str:
        """Return the hash of a declaration, an expression, or a tuple of such."""
        if isinstance(value, sp.Basic):
            if id(value) not in self._known:
                self._known[id(value)] = value, self._expression(value)
            return self._known[id(value)][1]
        if is_dataclass(value):
            parts = [self.of(getattr(value, field.name)) for field in fields(value)]
        elif isinstance(value, (tuple, list)):
            parts = [self.of(part) for part in value]
        else:  # a text, a number, a flag, None
            return _hashed([type(value).__name__, repr(value)])
        return _hashed([type(value).__name__, *parts])

    def _expression(self, expr: sp.Basic) -> str:
        if not expr.args:
            return _hashed([sp.srepr(expr)])
        return _hashed([type(expr).__name__, *map(self.of, expr.args)])


def _hashed(parts: Iterable[str]) -> str:
    """Return the hash of texts, which are told apart by their lengths."""
    found = hashlib.sha256()
    for part in parts:
        content = part.encode()
        found.update(b"%d:" % len(content))
        found.update(content)
    return found.hexdigest()
