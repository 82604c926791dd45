"""Numbers that pages quote: filled from the tables of `flexel reproduce`, and still those of the program."""

from __future__ import annotations

from typing import Any

import pytest
import quoted

from flexel.apps.cli.reproduce import CASES

TABLES: dict[str, list[dict[str, Any]]] = {
    "road": [
        {"name": "speed", "computed": 12.3456, "error": 3.21e-6, "kind": "own", "ok": True},
        {"name": "speed 2", "computed": [-1.5, 23456.78], "error": 6.5e-9, "kind": "own", "ok": True},
        {"name": "only", "computed": 1.0, "error": None, "kind": "none", "ok": None},
    ]
}


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("0.00<!--= speed-->", "12.35"),
        ("1e-1<!--= speed:error-->", "3e-6"),
        ("1.0e-1<!--= speed*:error-->", "3.2e-6"),
        ("0<!--= speed 2[1]-->", "23\u00a0457"),
        ("−9.0<!--= road/speed 2[0]-->", "−1.5"),
        ("0.0<!--= road/speed 2[0] ×-1e3-->", "1500.0"),
        ("1e-5<!--≤ speed:error-->", "1e-5"),
    ],
)
def test_a_number_before_a_mark_is_filled_in_its_own_style(before: str, after: str) -> None:
    text = quoted.filled(f"<!--quoted: road--> at {before} m/s", TABLES)
    assert f"at {after}<!--" in text and text.endswith("--> m/s")
    assert quoted.filled(text, TABLES) == text
    assert quoted.wrong(text, TABLES) == []


@pytest.mark.parametrize(
    ("mark", "said"),
    [("12.33<!--= speed-->", "12.33 (= speed) is 12.3456"), ("1e-6<!--≤ speed:error-->", "is 3.21e-06")],
)
def test_a_number_that_the_program_does_not_give_is_reported(mark: str, said: str) -> None:
    (found,) = quoted.wrong(f"<!--quoted: road-->{mark}", TABLES)
    assert said in found


@pytest.mark.parametrize("path", ["sped", "speed:size", "sea/speed", "only:error"])
def test_a_mark_that_names_nothing_is_refused(path: str) -> None:
    with pytest.raises(ValueError, match="row"):
        quoted.filled(f"<!--quoted: road-->1.0<!--= {path}-->", TABLES)


def test_the_last_digit_may_round_differently_on_another_machine() -> None:
    assert quoted.wrong("12.34<!--= road/speed-->", TABLES) == []


def test_the_pages_are_filled_from_the_kept_tables() -> None:
    assert quoted.check({}) == []
    assert set(quoted.kept()) == set(CASES)


def test_rows_of_another_kind_or_that_fail_are_reported() -> None:
    files = {"road": [dict(row) for row in TABLES["road"]]}
    assert quoted.differences(TABLES, files) == []
    files["road"][0]["kind"] = "published"
    assert "road: the rows" in quoted.differences(TABLES, files)[0]
    assert (
        quoted.differences({"road": [{**TABLES["road"][0], "ok": False}]}, {})[0]
        == "road: speed is not reproduced"
    )


def test_every_page_of_a_system_quotes_it() -> None:
    for page in quoted.pages():
        if page.stem in CASES:
            marks = list(quoted.marks(page.read_text(encoding="utf-8")))
            assert len(marks) >= 5 and {case for _, case in marks} >= {page.stem}
