"""Entries of ``generated/table.py``: specifications, written as Python.

Fields that have their default value are left out, so an entry contains only its particular values.
"""

from dataclasses import MISSING, Field, fields, is_dataclass
from typing import Any

from flexel.derive.spec import ElementSpec, LawSpec

_STEP = "    "


def table_entry(spec: ElementSpec | LawSpec) -> str:
    """Write the entry of an element or a law in ``table.py``."""
    lines = [f"{_STEP}{_literal(spec.name)}: {type(spec).__name__}("]
    for field in fields(spec):
        value = getattr(spec, field.name)
        if _said(field, value):
            lines += _field(field.name, value)
    return "\n".join([*lines, f"{_STEP}),"])


def _said(field: Field[Any], value: Any) -> bool:
    return bool(value != field.default)


def _field(name: str, value: Any) -> list[str]:
    """Write the lines of one field: tuples of specifications and kernels over several."""
    indent = 2 * _STEP
    if isinstance(value, dict):
        lines = [f"{indent}{name}={{"]
        for key, kernel in value.items():
            lines += _kernel(key, kernel)
        return [*lines, f"{indent}}},"]
    if isinstance(value, tuple) and value:
        return [
            f"{indent}{name}=(",
            *(f"{indent}{_STEP}{_literal(entry)}," for entry in value),
            f"{indent}),",
        ]
    return [f"{indent}{name}={_literal(value)},"]


def _kernel(name: str, kernel: Any) -> list[str]:
    indent = 3 * _STEP
    return [
        f"{indent}{_literal(name)}: {type(kernel).__name__}(",
        f"{indent}{_STEP}{_literal(kernel.inputs)},",
        f"{indent}{_STEP}(",
        *(f"{indent}{2 * _STEP}{_literal(output)}," for output in kernel.outputs),
        f"{indent}{_STEP}),",
        f"{indent}{_STEP}{kernel.operations},",
        f"{indent}),",
    ]


def _literal(value: Any) -> str:
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'
    if isinstance(value, tuple):
        if len(value) > 4 and value == tuple(range(len(value))):
            return f"tuple(range({len(value)}))"
        return f"({', '.join(map(_literal, value))}{',' if len(value) == 1 else ''})"
    return _call(value) if is_dataclass(value) else repr(value)


def _call(spec: Any) -> str:
    """Write a small specification as the call that makes it; what has a default is named."""
    arguments = []
    for field in fields(spec):
        value = getattr(spec, field.name)
        if _said(field, value):
            named = f"{field.name}=" if field.default is not MISSING else ""
            arguments.append(named + _literal(value))
    return f"{type(spec).__name__}({', '.join(arguments)})"
