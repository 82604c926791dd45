"""A user's page: a Python file that declares elements and laws.

It is run as a program whose ``__name__`` is that of the file.  Its elements and laws are those that its statements
assign to names, one by one or in lists and tuples; what it imports does not count.  If it assigns a dict ``ranges``,
such as ``{"l0": (0.1, 0.2), "p_x": (0, 1)}``, these are the ranges in which its definitions are verified.
"""

import ast
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import click

from flexel.derive.compiled import CompiledElement, CompiledLaw
from flexel.derive.declare import Element, Law
from flexel.derive.users_file import names_of

Ranges = Mapping[str, tuple[float, float]]


@dataclass(frozen=True)
class UsersPage:
    """The elements and laws of a file, by name in its order, the lines that declare them, and its ranges."""

    path: Path
    declared: Mapping[str, Element | Law]
    lines: Mapping[str, int]
    ranges: Ranges

    @property
    def elements(self) -> list[Element]:
        """The elements."""
        return [value for value in self.declared.values() if isinstance(value, Element)]

    @property
    def laws(self) -> list[Law]:
        """The laws."""
        return [value for value in self.declared.values() if isinstance(value, Law)]

    def place(self, name: str) -> str:
        """Return file and line of an element or a law."""
        return f"{self.path}, line {self.lines[name]}"

    @contextmanager
    def reported(self, name: str) -> Iterator[None]:
        """End the command with one message that names file, line and element, where its definition is refused."""
        try:
            yield
        except (ValueError, NotImplementedError, RuntimeError) as error:
            owner = self.declared[name].owner
            text = str(error)
            raise click.ClickException(
                f"{self.place(name)}: {text if owner in text else f'{owner}: {text}'}"
            ) from error

    def chosen(self, names: Sequence[str]) -> "UsersPage":
        """Return the page with those that are named only; with all of them if no name is given."""
        for name in names:
            if name not in self.declared:
                raise click.UsageError(
                    f"{self.path} has no element or law '{name}'; there are {', '.join(self.declared)}"
                )
        kept = names or list(self.declared)
        return replace(self, declared={name: self.declared[name] for name in kept})

    def ranges_of(self, name: str) -> Ranges:
        """Return the ranges of what an element or a law has."""
        return {key: limits for key, limits in self.ranges.items() if key in _names_in(self.declared[name])}


def is_page(argument: str) -> bool:
    """Whether an argument of a command is a file of Python, not the name of an element."""
    return argument.endswith(".py")


def read_page(path: Path) -> UsersPage:
    """Run a user's file and collect its elements and laws.

    Raises
    ------
    ClickException
        The file raises an error, declares nothing, or two things of one name; something in it is compiled already.
    """
    if not path.is_file():
        raise click.ClickException(f"{path}: there is no such file; give another path")
    names = names_of(path)
    declared: dict[str, Element | Law] = {}
    lines: dict[str, int] = {}
    compiled: list[tuple[str, int, str]] = []
    for name, line in _assigned(path):
        for value in _values(names.get(name)):
            if isinstance(value, CompiledElement | CompiledLaw):
                compiled.append((name, line, value.spec.name))
            if not isinstance(value, Element | Law) or declared.get(value.name) is value:
                continue
            if value.name in declared:
                raise click.ClickException(
                    f"{path}, line {line}: {value.owner}: line {lines[value.name]} already declares "
                    f"{declared[value.name].owner}; give it another name"
                )
            declared[value.name], lines[value.name] = value, line
    for name, line, what in compiled:
        if what not in declared:
            raise click.ClickException(
                f"{path}, line {line}: {name} is the compiled '{what}', whose definition no longer has a name; "
                "give the result of fx.compile_element or fx.compile_law another name than the definition"
            )
    if not declared:
        raise click.ClickException(
            f"{path}: it declares no element or law; assign a flexel.derive.Element or Law to a name"
        )
    return UsersPage(path, declared, lines, _ranges(path, names, list(declared.values())))


def line_of(path: Path, names: Mapping[str, Any], declared: Element | Law) -> int | None:
    """Return the line of a file that assigns an element or a law to a name; None if none does."""
    for name, line in _assigned(path):
        if any(value is declared for value in _values(names.get(name))):
            return line
    return None


def _assigned(path: Path) -> Iterator[tuple[str, int]]:
    """Return the names to which the statements of a file assign, each with the line of the first assignment."""
    found: dict[str, int] = {}

    def look(nodes: Sequence[ast.AST]) -> None:
        for node in nodes:
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef | ast.Lambda):
                continue
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                found[node.id] = min(found.get(node.id, node.lineno), node.lineno)
            look(list(ast.iter_child_nodes(node)))

    look(ast.parse(path.read_text(encoding="utf-8")).body)
    yield from sorted(found.items(), key=lambda entry: entry[1])


def _values(value: Any) -> list[Any]:
    """Return the value itself, or those in a list, a tuple or a dict."""
    if isinstance(value, list | tuple):
        return list(value)
    return list(value.values()) if isinstance(value, dict) else [value]


def _names_in(declared: Element | Law) -> set[str]:
    """Return the names of what may have a range."""
    return {symbol.name for symbol in declared.arguments} | {
        parameter.name for parameter in declared.parameters
    }


def _ranges(path: Path, names: Mapping[str, Any], declared: Sequence[Element | Law]) -> Ranges:
    ranges = names.get("ranges", {})
    if not isinstance(ranges, Mapping):
        raise click.ClickException(
            f"{path}: ranges is {ranges!r}; make it a dict such as {{'l0': (lowest, highest)}}"
        )
    known = set().union(*map(_names_in, declared))
    for name in ranges:
        if name not in known:
            raise click.ClickException(
                f"{path}: ranges has '{name}', which no element or law of the file has; there are "
                f"{', '.join(sorted(known))}"
            )
    return dict(ranges)
