"""The header of a file of results, as JSON: everything but the arrays."""

from __future__ import annotations

import json
from typing import Any

from flexel.results.saved.record import Record

FORMAT = "flexel result 2"
HEADER = "header"


def header_of(record: Record) -> str:
    """Everything but the arrays, as JSON; numbers are written with full precision."""
    variables = {
        n: {"dims": z.dims, "shape": z.values.shape, "unit": z.unit, "doc": z.doc}
        for n, z in record.variables.items()
    }
    return json.dumps(
        {
            "format": FORMAT,
            "kind": record.kind,
            "variables": variables,
            "labels": record.labels,
            "units": record.units,
            "header": record.header,
        }
    )


def parsed(text: str) -> dict[str, Any]:
    """The header in a text; a ValueError if it is not one of this format."""
    found = json.loads(text)
    if not isinstance(found, dict) or found.get("format") != FORMAT:
        raise ValueError(f"its header is not of the format '{FORMAT}'")
    return found
