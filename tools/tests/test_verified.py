"""The tables of docs/verification.md from the findings of the campaigns."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
import verified
from campaign.families import FAMILIES
from campaign.properties import PROPERTIES
from filling import DOCS

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
MOVED = {
    "campaign": "defaults",
    "seed": 0,
    "part": 100,
    "models": 200,
    "outcomes": {"agree": 199, "silent error": 1},
    "families": [{"name": "wheel", "agree": 199, "silent error": 1}],
    "traits": [{"name": "stop", "agree": 199, "silent error": 1}],
    "silent": [{"name": "1/wheel/3", "method": "DOP853", "why": "P.x: 3 times the bound"}],
}
BOTH = {"property": FOUND, "defaults": MOVED}


@pytest.mark.parametrize(
    ("table", "line"),
    [
        ("campaign: run", "12 models with the seed 7; none failed."),
        ("campaign: properties", "| accelerations | 11 | 1.2e-12 | 0 | 1.0e-8 |"),
        ("campaign: families", "| wheel | 12 |"),
        ("campaign: skipped", "| damped | energy, time reversed | 4 |"),
        ("defaults: run", "200 motions with the seeds 0 to 1; 1 of them has a silent error."),
        ("defaults: outcomes", "| all | 199 | 1 |"),
        ("defaults: traits", "| stop | 199 | 1 |"),
        ("defaults: silent", "| 1/wheel/3 | DOP853 | P.x: 3 times the bound |"),
    ],
)
def test_a_table_is_written_from_the_findings(table: str, line: str) -> None:
    """What stands there before is replaced, and a second time changes nothing."""
    text = verified.filled(f"a\n<!--{table}-->\nold\n<!--end-->\nb", BOTH)
    assert line in text.splitlines() and "old" not in text
    assert text.startswith("a\n<!--") and text.endswith("<!--end-->\nb")
    assert verified.filled(text, BOTH) == text


def test_new_findings_are_kept_and_fill_the_page(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """With --check nothing is written, and the exit status says so whether the page differs."""
    monkeypatch.setattr(verified, "PAGE", tmp_path / "page.md")
    kept = tmp_path / "kept.json"
    monkeypatch.setattr(verified, "KEPT", {"property": kept})
    verified.PAGE.write_text("<!--campaign: run-->\n<!--end-->\n")
    new = tmp_path / "new.json"
    new.write_text(json.dumps(FOUND))
    assert verified.main([str(new), "--check"]) == 1 and not kept.exists()
    assert "page.md differs" in capsys.readouterr().out
    assert verified.main([str(new)]) == 0 and verified.main(["--check"]) == 0
    assert "12 models" in verified.PAGE.read_text()


def test_the_page_is_filled_from_the_kept_findings() -> None:
    """Which are of all families and properties, and without failures."""
    assert verified.main(["--check"]) == 0
    found = json.loads((DOCS / "verification.json").read_text(encoding="utf-8"))
    assert not found["failures"]
    assert {entry["name"] for entry in found["properties"]} <= {check.name for check in PROPERTIES}
    assert set(found["families"]) <= set(FAMILIES)
