"""The header of a file of results, as JSON: everything except the arrays."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from hashlib import sha256
from typing import Any

import numpy as np

from flexel.results.saved.record import Record

FORMAT = "flexel result 2"
HEADER = "header"


def header_of(record: Record) -> str:
    """Write everything except the arrays as JSON; numbers have full precision."""
    variables = {
        n: {"dims": variable.dims, "shape": variable.values.shape, "unit": variable.unit, "doc": variable.doc}
        for n, variable in record.variables.items()
    }
    found = {
        "format": FORMAT,
        "kind": record.kind,
        "variables": variables,
        "labels": record.labels,
        "units": record.units,
        "header": record.header,
    }
    return json.dumps(
        found | {"digest": digest(found, [variable.values for variable in record.variables.values()])}
    )


def digest(header: Mapping[str, Any], arrays: Iterable[Any]) -> str:
    """Return the digest of the header and of the arrays in its order, which the file must reproduce."""
    found = sha256(json.dumps({name: entry for name, entry in header.items() if name != "digest"}).encode())
    for values in arrays:
        found.update(np.ascontiguousarray(values, dtype="<f8").tobytes())
    return found.hexdigest()


def parsed(text: str) -> dict[str, Any]:
    """Parse the header in a text; raise a ValueError if it is not of this format."""
    found = json.loads(text)
    if not isinstance(found, dict) or found.get("format") != FORMAT:
        raise ValueError(f"its header is not of the format '{FORMAT}'")
    return found
