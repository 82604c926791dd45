"""The command ``python -m flexel.derive.show_command``, also reached as ``flexel show``."""

import math
import re
import sys
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

import click
import sympy as sp

from flexel.derive.acceptance import check_definition
from flexel.derive.declare import Element, Law
from flexel.derive.derived_code import element_code, law_code
from flexel.derive.formulas_text import as_latex, as_text
from flexel.derive.spec import ElementSpec, LawSpec
from flexel.derive.users_page import is_page, line_of, read_page
from flexel.derive.verify import definitions

LISTED = 4  # components of a parameter that are listed one by one
Text = Callable[[Element | Law, str], str]
Table = tuple[str, Sequence[tuple[str, ...]]]


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("names", nargs=-1, required=True, metavar="NAME|PAGE.py [NAME]...")
@click.option("--kernel", metavar="NAME", help="Print only the C code of this kernel.")
@click.option("--latex", is_flag=True, help="Print only the formulas, as LaTeX.")
def main(names: tuple[str, ...], kernel: str | None, latex: bool) -> None:
    """Print elements and laws: where they are declared, symbols, formulas, operations, the C of a kernel.

    They are built in, or declared in your Python file: `flexel show PAGE.py`, all or those named.
    """
    if kernel is not None and latex:
        raise click.UsageError("--kernel and --latex exclude each other; leave one out")

    def text(declared: Element | Law, place: str) -> str:
        if latex:
            return as_latex(declared)
        return shown(declared, place) if kernel is None else c_of(declared, kernel)

    click.echo("\n\n".join(_of_page(names, text) if is_page(names[0]) else _built_in(names, text)))


def _of_page(names: Sequence[str], text: Text) -> list[str]:
    page = read_page(Path(names[0])).chosen(names[1:])
    found = []
    for name, declared in page.declared.items():
        with page.reported(name):
            check_definition(declared)
            found.append(text(declared, page.place(name)))
    return found


def _built_in(names: Sequence[str], text: Text) -> list[str]:
    known = definitions()
    by_name = {name.removeprefix("law_"): value for name, value in known.items()} | known
    for name in names:
        if name not in by_name:
            raise click.UsageError(
                f"no element or law '{name}'; there are: {', '.join(known)}. Names of your own files end in .py."
            )
    return [text(by_name[name], _place(by_name[name])) for name in names]


def _place(declared: Element | Law) -> str:
    """Return file and line of a built-in definition."""
    for name in sorted(sys.modules):
        if name.startswith(("flexel.derive.elements.", "flexel.derive.laws.")):
            module = sys.modules[name]
            path = Path(str(module.__file__))
            if (line := line_of(path, vars(module), declared)) is not None:
                return f"{path}, line {line}"
    raise AssertionError(f"'{declared.name}' is declared in a module")


def shown(declared: Element | Law, place: str) -> str:
    """Describe an element or a law that is declared at a place, with the C of its first kernel."""
    source, spec = _code(declared)
    first = next(iter(spec.kernels))
    parts = [
        f"{declared.owner}: {place}\n" + "\n".join(f"  {line}" for line in declared.doc.splitlines()),
        *([f"source\n  {declared.source}"] if declared.source else []),
        *_symbols(declared),
        f"formulas\n{as_text(declared)}",
        "operations for one element\n" + _columns(_operations(spec)),
        f"C of {first}\n\n{_function(source, first)}",
    ]
    return "\n\n".join(parts)


def c_of(declared: Element | Law, kernel: str) -> str:
    """Return the C of a kernel, or a ClickException if there is no such kernel."""
    source, spec = _code(declared)
    if kernel not in spec.kernels:
        raise click.ClickException(
            f"'{declared.name}' has no kernel '{kernel}'; there are {', '.join(spec.kernels)}"
        )
    return _function(source, kernel)


def _code(declared: Element | Law) -> tuple[str, ElementSpec | LawSpec]:
    return element_code(declared) if isinstance(declared, Element) else law_code(declared)


def _symbols(declared: Element | Law) -> list[str]:
    """Return tables of what the formulas are made of, and of what they give."""
    first, *others = _of_law(declared) if isinstance(declared, Law) else _of_element(declared)
    parameters = [(_listed(p.symbols), f"[{p.unit}]", p.doc) for p in declared.parameters]
    tables: list[Table] = [first, ("parameters", parameters), *others]
    return [f"{title}\n{_columns(rows)}" for title, rows in tables if rows]


def _listed(symbols: Sequence[sp.Symbol]) -> str:
    """Return the names of symbols; of many, the first and the last."""
    names = [symbol.name for symbol in symbols]
    return " ".join(names) if len(names) <= LISTED else f"{names[0]} … {names[-1]}"


def _of_element(element: Element) -> list[Table]:
    nodes = [(n.name, n.kind.replace("_", " "), " ".join(s.name for s in n.x)) for n in element.nodes]
    deformations = [(d.name, f"[{d.unit}]", "free" if d.free else "rigid") for d in element.deformations]
    slips = [(s.name, f"[{s.unit}]", "free" if s.free else "zero") for s in element.slips]
    outputs = [(o.name, f"[{o.unit}]", "×".join(map(str, o.shape))) for o in element.outputs]
    return [("nodes", nodes), ("deformations", deformations), ("slips", slips), ("outputs", outputs)]


def _of_law(law: Law) -> list[Table]:
    units = law.units or [""] * (len(law.e) + len(law.s))
    on = [
        (s.name, f"[{unit}]" if unit else "any unit") for s, unit in zip((*law.e, *law.s), units, strict=True)
    ]
    states = [(state.name, f"[{state.unit}]") for state in law.states]
    return [
        ("deformations and slips", on),
        ("rates", [(s.name,) for s in law.ed]),
        ("internal states", states),
    ]


def _operations(spec: ElementSpec | LawSpec) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = []
    for name, kernel in spec.kernels.items():
        written = []
        for output in kernel.outputs:
            if size := math.prod(output.shape):
                stored = len(output.nonzeros)
                of = "" if stored == size else f", {stored} of {size}"
                written.append(f"{output.name} ({'×'.join(map(str, output.shape))}{of})")
        rows.append((name, str(kernel.operations), ", ".join(written)))
    return rows


def _columns(rows: Iterable[Sequence[str]]) -> str:
    listed = list(rows)
    widths = [max(map(len, column)) for column in zip(*listed, strict=True)]
    return "\n".join(
        "  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in listed
    )


def _function(source: str, kernel: str) -> str:
    """Return the function of a kernel in the C of an element, with its head comment."""
    found = re.search(rf"^/\* {kernel}: .*?^}}$", source, re.MULTILINE | re.DOTALL)
    assert found is not None
    return found[0]


if __name__ == "__main__":
    main(prog_name="flexel show")
