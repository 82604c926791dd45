"""Rows of the tables of `flexel reproduce`: references of a named kind, tolerances that say something."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tables import objections

from flexel.apps.cli.reproduce import CASES
from flexel.results.reproduction import Quantity

KEPT = Path(__file__).resolve().parents[1] / "docs" / "quoted"


def kept(case: str) -> list[dict[str, Any]]:
    """The rows of a system that the documentation quotes; `make docs` compares them with the program."""
    rows: list[dict[str, Any]] = json.loads((KEPT / f"{case}.json").read_text(encoding="utf-8"))["quantities"]
    return rows


@pytest.mark.parametrize("case", CASES)
def test_every_row_says_what_it_is_compared_with_and_how_closely(case: str) -> None:
    rows = kept(case)
    assert len({row["name"] for row in rows}) == len(rows)
    assert {row["name"]: objection for row in rows if (objection := objections(row))} == {}


@pytest.mark.parametrize(
    "row",
    [
        Quantity("wide", 1.001, 1.0, 0.01, source="a book", kind="published"),
        Quantity("missed", 1.1, 1.0, 0.01, source="a book", kind="published"),
        Quantity("no source", 1.0, 1.0, 0.0, kind="published"),
        Quantity("wide for zero", 1e-10, 0.0, 1e-9, source="conserved", kind="closed form"),
        Quantity("small entry", [1.0, 0.5], [1.0, 0.4], 0.1, source="a run", kind="other program"),
    ],
    ids=lambda row: row.name,
)
def test_such_a_row_is_objected_to(row: Quantity) -> None:
    assert len(objections(row.to_dict())) == 1


@pytest.mark.parametrize(
    "row",
    [
        Quantity("near", 1.001, 1.0, 0.002, source="a book", kind="published"),
        Quantity("exact", 3, 3, 0, source="the talk", kind="published"),
        Quantity("rounding", 1.0 + 1e-15, 1.0, 1e-12, source="a book", kind="published"),
        Quantity("large", 1e6 + 1e-9, 1e6, 1e-6, source="", kind="own", tolerance_kind="absolute"),
        Quantity("steps", 1e-10, 0.0, 1e-8, source="conserved", kind="closed form", reason="1e6 steps"),
        Quantity("reported", np.array([1.0, 0.0])),
    ],
    ids=lambda row: row.name,
)
def test_such_a_row_is_fine(row: Quantity) -> None:
    assert objections({**row.to_dict(), "source": "somewhere"}) == []


@pytest.mark.parametrize(
    "given",
    [
        {"reference": 1.0},
        {"kind": "own"},
        {"reference": [1.0, 0.0], "kind": "own", "computed": [1.0, 0.0]},
    ],
)
def test_a_row_that_hides_its_reference_is_refused(given: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match="quantity 'q'"):
        Quantity(**{"name": "q", "computed": 1.0, **given})
