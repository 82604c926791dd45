"""Rows of `flexel reproduce`, computed once: those that `make docs` has computed with this very program, or anew."""

from __future__ import annotations

from functools import cache
from typing import Any

import quoted


@cache
def rows_of(case: str) -> dict[str, dict[str, Any]]:
    """The rows of a system by name, as `Quantity.to_dict` gives them, rounded to 15 digits."""
    return {row["name"]: row for row in quoted.computed().get(case) or quoted.run(case)}


def not_reproduced(case: str) -> dict[str, Any]:
    """The errors of the rows that are not within their tolerances; a row without a reference has no verdict."""
    return {name: row["error"] for name, row in rows_of(case).items() if row["ok"] is False}
