"""Numbers that pages quote: filled from the tables of `flexel reproduce`, and still those of the program."""

from __future__ import annotations

import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from flexel.commands.reproduce import CASES
from flexel.examples import beams_dynamic, beams_static

DOCS = Path(__file__).resolve().parents[1] / "docs"


@pytest.fixture(scope="module")
def quoted() -> ModuleType:
    spec = spec_from_file_location("quoted", DOCS / "quoted.py")
    assert spec is not None and spec.loader is not None
    module = module_from_spec(spec)
    sys.modules["quoted"] = module
    spec.loader.exec_module(module)
    return module


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
def test_a_number_before_a_mark_is_filled_in_its_own_style(
    quoted: ModuleType, before: str, after: str
) -> None:
    text = quoted.filled(f"<!--quoted: road--> at {before} m/s", TABLES)
    assert f"at {after}<!--" in text and text.endswith("--> m/s")
    assert quoted.filled(text, TABLES) == text
    assert quoted.wrong(text, TABLES) == []


@pytest.mark.parametrize(
    ("mark", "said"),
    [("12.33<!--= speed-->", "12.33 (= speed) is 12.3456"), ("1e-6<!--≤ speed:error-->", "is 3.21e-06")],
)
def test_a_number_that_the_program_does_not_give_is_told(quoted: ModuleType, mark: str, said: str) -> None:
    (found,) = quoted.wrong(f"<!--quoted: road-->{mark}", TABLES)
    assert said in found


@pytest.mark.parametrize("path", ["sped", "speed:size", "sea/speed", "only:error"])
def test_a_mark_that_names_nothing_is_refused(quoted: ModuleType, path: str) -> None:
    with pytest.raises(ValueError, match="row"):
        quoted.filled(f"<!--quoted: road-->1.0<!--= {path}-->", TABLES)


def test_the_last_digit_may_round_differently_on_another_machine(quoted: ModuleType) -> None:
    assert quoted.wrong("12.34<!--= road/speed-->", TABLES) == []


def test_the_pages_are_filled_from_the_kept_tables(quoted: ModuleType) -> None:
    assert quoted.check({}) == []
    assert set(quoted.kept()) == set(CASES)


def test_rows_of_another_kind_or_that_fail_are_told(quoted: ModuleType) -> None:
    files = {"road": [dict(z) for z in TABLES["road"]]}
    assert quoted.differences(TABLES, files) == []
    files["road"][0]["kind"] = "published"
    assert "road: the rows" in quoted.differences(TABLES, files)[0]
    assert (
        quoted.differences({"road": [{**TABLES["road"][0], "ok": False}]}, {})[0]
        == "road: speed is not reproduced"
    )


def test_every_page_of_a_system_quotes_it(quoted: ModuleType) -> None:
    for page in quoted.pages():
        if page.stem in CASES:
            marks = list(quoted.marks(page.read_text(encoding="utf-8")))
            assert len(marks) >= 5 and {case for _, case in marks} >= {page.stem}


@pytest.mark.slow
def test_the_kept_tables_are_those_of_the_program_where_the_documentation_does_not_run_it(
    quoted: ModuleType,
) -> None:
    """`make docs` computes all systems anew except the beams, whose search for meshes takes a minute."""
    rows = [*beams_static.large_deflections(), *beams_static.buckling(), *beams_dynamic.vibrations()]
    found = {z.name: quoted.rounded(z.to_dict()) for z in [*rows, *beams_dynamic.spin_up()]}
    kept = [z for z in quoted.kept()["beams"] if z["name"] in found]
    assert len(kept) == len(found)
    tables = {"beams": [found.get(z["name"], z) for z in quoted.kept()["beams"]]}
    assert quoted.differences(tables, quoted.kept()) == []
    assert quoted.wrong((DOCS / "beams.md").read_text(encoding="utf-8"), tables) == []
