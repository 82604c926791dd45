"""The C text of elements and laws: the printed kernels in their templates."""

import hashlib
import math
import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from flexel.derive.declare import Element, Law, Parameter
from flexel.derive.emit.fold import folded
from flexel.derive.emit.printer import BLOCK, print_kernel
from flexel.derive.program.kernel_outputs import Derived, Kernel

_DIGEST = "@digest@"

NOTICE = "Written by `flexel derive`; do not edit."


@cache
def _environment() -> Environment:
    folder = Path(__file__).with_name("templates")
    return Environment(loader=FileSystemLoader(folder), undefined=StrictUndefined, keep_trailing_newline=True)


def render(template: str, **context: Any) -> str:
    """Fill in a template, without trailing blanks; lines of C are folded."""
    text = _environment().get_template(template).render(notice=NOTICE, block=BLOCK, **context)
    clean = "\n".join(line.rstrip() for line in text.splitlines()).rstrip("\n") + "\n"
    return clean if template.endswith(".py.jinja") else folded(clean)


def _stamped(text: str) -> str:
    """Insert the text's digest in the places kept for it."""
    return text.replace(_DIGEST, hashlib.sha256(text.encode()).hexdigest()[:16])


def digest_of(source: str) -> str:
    """Return the digest that a source carries."""
    found = re.search(r'^    \.digest = "(\w+)",$', source, re.MULTILINE)
    assert found is not None
    return found[1]


def _kernel_context(derived: Derived, kernel: Kernel) -> dict[str, Any]:
    body = print_kernel(derived, kernel)
    text = "\n".join(line for loop in body.loops for line in loop.lines)

    def used(arrays: Sequence[tuple[str, int]]) -> list[dict[str, Any]]:
        return [
            {"name": name, "index": i, "rows": rows}
            for i, (name, rows) in enumerate(arrays)
            if re.search(rf"\b{name}\[\d+ \* ", text)
        ]

    return {
        "name": kernel.name,
        "operations": kernel.operations,
        "inputs": [f"{name} ({len(derived.inputs[name])})" for name in kernel.inputs],
        "outputs": [{**vars(output), "size": math.prod(output.shape)} for output in kernel.outputs],
        "used_inputs": used([(name, len(derived.inputs[name])) for name in kernel.inputs]),
        "used_outputs": used([(output.name, len(output.rows)) for output in kernel.outputs]),
        "arrays": body.arrays,
        "loops": body.loops,
    }


def _comment(text: str) -> str:
    return text.replace("*/", "* /")


def _parameters(parameters: Sequence[Parameter]) -> list[str]:
    return [_comment(f"{p.name} ({p.size}) [{p.unit}]: {p.doc}") for p in parameters]


def _context(declared: Element | Law, derived: Derived, symbol: str) -> dict[str, Any]:
    return {
        "name": declared.name,
        "symbol": symbol,
        "doc": _comment(declared.doc).splitlines(),
        "source": _comment(declared.source),
        "np": len(declared.parameter_symbols),
        "parameters": _parameters(declared.parameters),
        "kernels": [_kernel_context(derived, kernel) for kernel in derived.kernels.values()],
    }


def _states(law: Law) -> list[str]:
    return [_comment(f"{state.name} [{state.unit}]") for state in law.states]


def element_source(element: Element, derived: Derived, symbol: str = "") -> str:
    """Write the C of an element; the table of its kernels is the global ``flexel_<symbol>``, by default its name."""
    modes = [
        ", ".join(f"{mode.name} [{mode.unit}]" for mode in group) or "none"
        for group in (element.deformations, element.slips)
    ]
    text = render(
        "element.c.jinja",
        **_context(element, derived, symbol or element.name),
        n=len(element.x),
        m=len(element.deformations),
        k=len(element.slips),
        x=", ".join(symbol.name for symbol in element.x),
        e=_comment(modes[0]),
        s=_comment(modes[1]),
        digest=_DIGEST,
    )
    return _stamped(text)


def laws_source(laws: Sequence[Law], derived: Sequence[Derived], symbol: str = "") -> str:
    """Write the C of laws; their tables are ``flexel_law_<name>``, or ``flexel_<symbol>`` for a single one."""
    contexts = [
        {**_context(law, d, symbol or f"law_{law.name}"), "m": len(law.e), "k": len(law.s), "z": _states(law)}
        for law, d in zip(laws, derived, strict=True)
    ]
    return _stamped(render("laws.c.jinja", laws=contexts, digest=_DIGEST))
