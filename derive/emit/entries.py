"""Entries of ``generated/table.py``, as text.

The classes that the entries name are in ``flexel.derive.spec``.
"""

from collections.abc import Collection, Sequence
from typing import Any

from flexel.derive.declare import Element, Law
from flexel.derive.program.kernels import Derived, Kernel


def _tuple(values: Collection[Any]) -> str:
    items = list(values)
    if len(items) > 4 and items == list(range(len(items))):
        return f"tuple(range({len(items)}))"
    return f"({', '.join(map(_literal, items))}{',' if len(items) == 1 else ''})"


def _literal(value: Any) -> str:
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'
    return repr(value)


def _call(kind: str, *values: Any) -> str:
    return f"{kind}({', '.join(_literal(value) for value in values)})"


def _group(name: str, entries: Sequence[str]) -> list[str]:
    if not entries:
        return [f"        {name}=(),"]
    return [f"        {name}=(", *(f"            {entry}," for entry in entries), "        ),"]


def _kernels(kernels: Collection[Kernel]) -> list[str]:
    lines = ["        kernels={"]
    for kernel in kernels:
        lines += [f'            "{kernel.name}": KernelSpec(', f"                {_tuple(kernel.inputs)},"]
        lines.append("                (")
        for o in kernel.outputs:
            arguments = f"{_literal(o.name)}, {_tuple(o.shape)}, {_tuple(o.nonzeros)}"
            lines.append(f"                    OutputSpec({arguments}),")
        lines += ["                ),", f"                {kernel.operations},", "            ),"]
    return [*lines, "        },"]


def table_entry(declared: Element | Law, derived: Derived, digest: str) -> str:
    """Entry of an element or a law in ``table.py``, with the digest of its C."""
    d = declared
    parameters = [_call("ParameterSpec", p.name, p.size, p.unit, p.doc) for p in d.parameters]
    head = [f"        name={_literal(d.name)},", f"        digest={_literal(digest)},"]
    head += [f"        doc={_literal(d.doc)},"]
    if isinstance(d, Element):
        kind = "ElementSpec"
        head.append(f"        source={_literal(d.source)},")
        head += _group("nodes", [_call("NodeSpec", node.name, node.kind) for node in d.nodes])
        head += _group("parameters", parameters)
        modes = [_call("DeformationSpec", e.name, e.unit, e.angle, e.free) for e in d.deformations]
        head += _group("deformations", modes)
        head += _group("slips", [_call("SlipSpec", s.name, s.unit, s.free) for s in d.slips])
    else:
        kind = "LawSpec"
        head += [
            f"        deformations={len(d.e)},",
            f"        slips={len(d.s)},",
            *_group("states", [_call("InternalSpec", z.name, z.unit) for z in d.states]),
            *_group("parameters", parameters),
        ]
    lines = [f"    {_literal(d.name)}: {kind}(", *head, *_kernels(derived.kernels.values()), "    ),"]
    return "\n".join(lines)
