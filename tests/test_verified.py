"""The tables of docs/verification.md from the findings of the property campaign."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
import verified
from campaign.families import FAMILIES
from campaign.properties import PROPERTIES

DOCS = Path(__file__).resolve().parents[1] / "docs"
FOUND = {
    "campaign": "property",
    "seed": 7,
    "models": 12,
    "seconds": 1.5,
    "families": {"wheel": 12},
    "properties": [
        {"name": "accelerations", "models": 11, "largest": 1.234e-12, "median": 0.0, "tolerance": 1e-8}
    ],
    "skipped": [
        {"reason": "energy: damped", "models": 3},
        {"reason": "time reversed: damped", "models": 4},
    ],
    "failures": [],
}


@pytest.mark.parametrize(
    ("table", "line"),
    [
        ("run", "12 models with the seed 7; none failed."),
        ("properties", "| accelerations | 11 | 1.2e-12 | 0 | 1.0e-8 |"),
        ("families", "| wheel | 12 |"),
        ("skipped", "| damped | energy, time reversed | 4 |"),
    ],
)
def test_a_table_is_written_from_the_findings(table: str, line: str) -> None:
    """What stands there before is replaced, and a second time changes nothing."""
    text = verified.filled(f"a\n<!--campaign: {table}-->\nold\n<!--end-->\nb", FOUND)
    assert line in text.splitlines() and "old" not in text
    assert text.startswith("a\n<!--") and text.endswith("<!--end-->\nb")
    assert verified.filled(text, FOUND) == text


def test_new_findings_are_kept_and_fill_the_page(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """With --check nothing is written, and the exit status says so whether the page differs."""
    monkeypatch.setattr(verified, "PAGE", tmp_path / "page.md")
    monkeypatch.setattr(verified, "KEPT", tmp_path / "kept.json")
    verified.PAGE.write_text("<!--campaign: run-->\n<!--end-->\n")
    new = tmp_path / "new.json"
    new.write_text(json.dumps(FOUND))
    assert verified.main([str(new), "--check"]) == 1 and not verified.KEPT.exists()
    assert "page.md differs" in capsys.readouterr().out
    assert verified.main([str(new)]) == 0 and verified.main(["--check"]) == 0
    assert "12 models" in verified.PAGE.read_text()


def test_the_page_is_filled_from_the_kept_findings() -> None:
    """Which are of all families and properties, and without failures."""
    assert verified.main(["--check"]) == 0
    found = json.loads((DOCS / "verification.json").read_text(encoding="utf-8"))
    assert not found["failures"]
    assert {z["name"] for z in found["properties"]} <= {z.name for z in PROPERTIES}
    assert set(found["families"]) <= set(FAMILIES)
