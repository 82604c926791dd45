"""Tables of published and independently computed numbers, in `examples/data`, with their origin."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any


def published(name: str) -> dict[str, Any]:
    """Return the table of that name; numbers with many digits may be text.

    Parameters
    ----------
    name : str
        Of the file in `examples/data`, without its suffix.
    """
    file = resources.files("flexel.examples") / "data" / f"{name}.json"
    found: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
    return found
