"""Writes pages about elements and laws, from their specifications and their verification."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

from flexel.derive.spec import DeformationSpec, ElementSpec, KernelSpec, LawSpec, ParameterSpec
from flexel.generated.table import ELEMENTS, LAWS

Rows = list[dict[str, Any]]


def table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """Return a table in Markdown, or "None." if there are no rows."""
    lines = [[str(cell).replace("|", r"\|") for cell in row] for row in rows]
    if not lines:
        return "None.\n"
    return "\n".join(f"| {' | '.join(row)} |" for row in [head, ["---"] * len(head), *lines]) + "\n"


def parameters(specs: Sequence[ParameterSpec]) -> str:
    """Return the table of the parameters of an element or a law."""
    counts = ("" if spec.size == 1 else f" ({spec.size} numbers)" for spec in specs)
    units = ("-" if spec.unit == "1" else spec.unit for spec in specs)
    rows = zip(specs, counts, units, strict=True)
    return table(
        ("name", "meaning"), [(f"`{spec.name}`", f"{spec.doc}{n} [{unit}]") for spec, n, unit in rows]
    )


def kernels(specs: dict[str, KernelSpec]) -> str:
    """Return the table of kernels: inputs, outputs and number of operations."""
    rows = []
    for name, kernel in specs.items():
        written = [
            f"{output.name} {'×'.join(map(str, output.shape))} ({len(output.nonzeros)})"
            for output in kernel.outputs
        ]
        rows.append((name, ", ".join(kernel.inputs), ", ".join(written), kernel.operations))
    return table(("kernel", "inputs", "outputs (stored entries)", "operations"), rows)


def errors(rows: Rows) -> str:
    """Return the table of the verification."""
    return table(
        ("kernel", "output", "against finite differences", "against the definition"),
        [
            (row["kernel"], row["output"], number(row["differences"]), number(row["reference"]))
            for row in rows
        ],
    )


def number(value: float | None) -> str:
    """Format an error; a dash if there is none."""
    return "–" if value is None else f"{value:.0e}"


def element_page(spec: ElementSpec, rows: Rows, picture: str = "") -> str:
    """Return definition, source, kernels, counts and verification of one element, and the picture of its modes."""
    modes = [
        (f"`{mode.name}`", mode.unit, "free" if mode.free else "rigid", period(mode))
        for mode in spec.deformations
    ]
    slips = [(f"`{slip.name}`", slip.unit, "free" if slip.free else "zero") for slip in spec.slips]
    shown = f"\n![As drawn, and moved along each deformation and slip]({picture})\n" if picture else ""
    return f"""# {spec.name}

```text
{spec.doc}
```
{shown}
Source: {spec.source}.

## Nodes

{table(("node", "kind"), [(f"`{node.name}`", node.kind.replace("_", " ")) for node in spec.nodes])}
## Parameters

{parameters(spec.parameters)}
## Deformations

{table(("name", "unit", "default", "period"), modes)}
## Slips

{table(("name", "unit", "default"), slips)}
## Kernels

{kernels(spec.kernels)}
## Verification

Largest relative errors at random configurations, printed by `flexel verify {spec.name}`: against finite differences of
the kernel one order below, and against the definition in 60 digits.

{errors(rows)}"""


def period(spec: DeformationSpec) -> str:
    """Write the period of a deformation as a formula."""
    terms = []
    for term in spec.period:
        turns = f"{term.factor / (2 * math.pi):g}·2π".removeprefix("1·").replace("-1·", "-")
        terms.append(" ".join([turns, *(name if n == 1 else f"{name}^{n}" for name, _, n in term.powers)]))
    return " + ".join(terms)


def laws_page(rows: dict[str, Rows]) -> str:
    """Return the page with all laws."""
    parts = [
        "# Laws\n\nA law gives the stress of free deformations and slips. It does not depend on geometry.\n"
        "`m.spring` and `m.stop` attach the common ones, `m.attach` any of them by name.\n"
    ]
    for spec in LAWS.values():
        parts += [
            f"## {spec.name}\n\n```text\n{spec.doc}\n```\n",
            law_facts(spec),
            parameters(spec.parameters),
        ]
        parts += [kernels(spec.kernels), f"Verification:\n\n{errors(rows.get(f'law {spec.name}', []))}"]
    return "\n".join(parts)


def law_facts(spec: LawSpec) -> str:
    """Return the numbers of deformations and slips of a law, and its internal states."""
    states = ", ".join(f"`{state.name}` [{state.unit}]" for state in spec.states) or "none"
    return f"Deformations: {spec.deformations}; slips: {spec.slips}; internal states: {states}.\n"


def elements_page() -> str:
    """Return the list of element pages."""
    costs = [
        (f"[{spec.name}](elements/{spec.name}.md)", spec.source, count(spec)) for spec in ELEMENTS.values()
    ]
    pages = "\n".join(f"elements/{name}" for name in ELEMENTS)
    return (
        "# Elements\n\nEach element is declared in `derive/elements` and added to a model by a method of `Model`:\n"
        "its own, or `Model.element`.\n\n"
        + table(("element", "source", "operations, all kernels"), costs)
        + f"\n```{{toctree}}\n:hidden:\n\n{pages}\n```\n"
    )


def count(spec: ElementSpec) -> int:
    """Count the operations of all kernels together."""
    return sum(kernel.operations for kernel in spec.kernels.values())
