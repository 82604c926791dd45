"""Tables of the pages from the figures of `flexel bench`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import measured
import pytest
from bench.table import ROWS


def row(name: str, value: float, **more: Any) -> dict[str, Any]:
    plain = {"value": value, "unit": "ms", "error": 2.6e-11, "target": None, "goal": None, "peers": {}}
    return {"name": name, **plain, **more}


FIGURES = [
    row("ride", 8.4849, target=6, goal=3.5, peers={"kane": {"value": 60.17, "error": None}, "other": None}),
    row("walk", 0.0123456, error=None),
    row(
        "grow", 4.0, sizes=[1, 2], values=[1.0, 4.0], exponent=2.0,
        peers={"kane": {"value": None, "error": 1e-3, "values": [12.345, None], "exponent": None}},
    ),
]  # fmt: skip


def test_a_table_between_marks_is_written_from_the_figures() -> None:
    """What stands there before is replaced, and a second time changes nothing."""
    text = measured.filled("a\n<!--measured: ride w*-->\nold\n<!--end-->\nb", FIGURES)
    assert "| `ride` | 8.48 ms | 6, 3.5 | 2.6e-11 | kane: 60.2 (**7.09**); other: not installed |" in text
    assert "| `walk` | 0.0123 ms | – | – | – |" in text
    assert "old" not in text and text.startswith("a\n<!--") and text.endswith("<!--end-->\nb")
    assert measured.filled(text, FIGURES) == text


def test_faster_is_said_of_the_best_way_of_a_program() -> None:
    """All ways are shown; the ratio is that of the fastest one, and each program has its own."""
    peers = {
        "kane": {"value": 80.0, "error": 1e-9},
        "kane, in C": {"value": 2.0, "error": 1e-9},
        "euler": {"value": 40.0, "error": None},
    }
    text = measured.filled("<!--measured: run-->\n<!--end-->", [row("run", 8.0, peers=peers)])
    shown = "kane: 80.0 (error 1.0e-9); kane, in C: 2.00 (**0.250**, error 1.0e-9); euler: 40.0 (**5.00**) |"
    assert shown in text


def test_times_over_the_size_have_a_table_for_each_row() -> None:
    text = measured.filled("<!--scaling: grow-->\n<!--end-->", FIGURES)
    assert "| `grow` [ms] | N = 1 | N = 2 | power of N | error |" in text
    assert "| flexel | 1.00 | 4.00 | 2.00 | 2.6e-11 |" in text
    assert "| kane | 12.3 | – | – | 1.0e-3 |" in text


@pytest.mark.parametrize(
    ("value", "written"),
    [
        (1234.5, "1234"),
        (123.4, "123"),
        (99.96, "100.0"),
        (1.0, "1.00"),
        (0.25, "0.250"),
        (0.0009996, "0.0010"),
        (0.0, "0.000"),
    ],
)
def test_times_have_three_digits(value: float, written: str) -> None:
    assert float(measured.time(value)) == pytest.approx(value, rel=5e-3)
    assert float(measured.time(value)) == float(written)


def test_a_row_that_was_not_measured_is_refused() -> None:
    with pytest.raises(ValueError, match=r"'sail'; there are: ride, walk, grow"):
        measured.filled("<!--measured: sail-->\n<!--end-->", FIGURES)


def test_new_figures_replace_those_of_their_rows(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """With --check nothing is written, and the exit status says so what differs."""
    page, new = tmp_path / "page.md", tmp_path / "new.json"
    page.write_text("<!--measured: ride walk-->\n<!--end-->\n")
    monkeypatch.setattr(measured, "KEPT", tmp_path / "measured.json")
    monkeypatch.setattr(measured, "pages", lambda: [page])
    measured.KEPT.write_text(json.dumps(FIGURES))
    new.write_text(json.dumps([row("walk", 5.0)]))
    assert measured.main(["--check"]) == 1 and "page.md differs" in capsys.readouterr().out
    assert measured.main([str(new)]) == 0
    assert "| `walk` | 5.00 ms" in page.read_text() and "`ride` | 8.48 ms" in page.read_text()
    assert [row["name"] for row in measured.kept()] == ["ride", "walk", "grow"]
    assert measured.main(["--check"]) == 0


def test_the_pages_are_filled_from_the_kept_figures() -> None:
    """Which are of rows that there are."""
    assert measured.main(["--check"]) == 0
    assert {row["name"] for row in measured.kept()} <= set(ROWS)
