"""The documentation builds without a warning, and its programs run."""

import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

DOCS = Path(__file__).resolve().parents[1] / "docs"


def programs(page: str) -> list[str]:
    return re.findall(r"```python\n(.*?)```", (DOCS / page).read_text(encoding="utf-8"), re.DOTALL)


def test_the_programs_of_the_first_five_minutes_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("matplotlib", reason="the page draws with matplotlib: pip install 'flexel[plot]'")
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    blocks = programs("start.md")
    for block in blocks:
        exec(block, names)
    assert len(blocks) == 4
    assert (tmp_path / "fourbar.png").stat().st_size > 5_000
    printed = capsys.readouterr().out
    shown = re.search(r"```text\n(.*?)```", (DOCS / "start.md").read_text(encoding="utf-8"), re.DOTALL)
    assert shown is not None and shown[1].strip() in printed


def test_the_program_of_the_page_on_control_steadies_the_rod() -> None:
    """Upright and falling at first, then at rest and upright with a controller; sampled too, unless too late."""
    names: dict[str, Any] = {}
    for block in programs("control.md"):
        exec(block, names)
    assert names["lin"].eigenvalues().real.max() == pytest.approx((1.5 * 9.81 / 0.5) ** 0.5, rel=1e-9)
    assert names["regulated"].linearize().eigenvalues().real.max() < -1
    assert abs(names["motion"]["motor.angle"][-1]) < 1e-4
    assert names["sampled"]["motor.angle"][-1] == pytest.approx(0.2, abs=1e-6)
    assert names["delay"] == 0.03 and not names["loop"].stable
    assert abs(names["angle"]) < 1e-3


def test_the_program_of_the_page_on_concepts_runs(capsys: pytest.CaptureFixture[str]) -> None:
    """A spring on a deformation that was rigid frees a degree of freedom."""
    for block in programs("concepts.md"):
        exec(block, {})
    first, second = (line.count("'") // 2 for line in capsys.readouterr().out.splitlines())
    assert (first, second) == (1, 2)


def test_the_programs_of_the_page_on_variants_run(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, Any] = {}
    for block in programs("many.md"):
        exec(block, names)
    assert names["found"]["pivot.angle"].shape == (200, 201) and not names["found"].failed
    assert names["many"].M.shape == (50, 1, 1) and names["loci"].stable.all()
    assert "(50, 2) True" in capsys.readouterr().out


def test_the_programs_of_the_pages_on_flexures_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The mechanisms behave as the page says, and its table and its pictures are those of its programs."""
    pytest.importorskip("matplotlib", reason="the page draws with matplotlib: pip install 'flexel[plot]'")
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    for block in programs("flexure-design.md"):
        exec(block, names)
    page = (DOCS / "flexure-design.md").read_text(encoding="utf-8")
    shown = re.search(r"```text\n(.*?)```", page, re.DOTALL)
    assert shown is not None and shown[1].strip() in capsys.readouterr().out
    drawn = re.findall(r"\]\(images/(\w+\.png)\)", page)
    assert len(drawn) == 5 and all((tmp_path / z).stat().st_size > 5_000 for z in drawn)
    guide, hinge, stage = (names[z] for z in ("guide", "hinge", "stage"))
    stiffness = 2 * 206e9 * 25e-3 * 0.4e-3**3 / 0.1**3
    assert 8 / guide.displacements[-1, 4, 0] == pytest.approx(stiffness * (1 - 5 / 54.2), rel=0.02)
    assert guide.displacements[-1, 4, 1] == pytest.approx(
        -0.6 * guide.displacements[-1, 4, 0] ** 2 / 0.1, rel=0.02
    )
    assert hinge.moments[-1, 4, 2] == pytest.approx(2 * 206e9 * 25e-3 * 0.4e-3**3 / 12 / 0.1 * 0.4, rel=0.05)
    assert stage.released == () and len(guide.released) == len(hinge.released) == 1
    static = (names["D"] - names["C"] @ np.linalg.solve(names["A"], names["B"]))[0, 0]
    assert static == pytest.approx(guide.compliance(5)[-1, 0, 0], rel=1e-6)
    for block in programs("coming-from-spacar-light.md"):
        exec(block, names)
    assert names["A"].shape == (36, 36) and names["C"].shape == (2, 36)


@pytest.mark.slow
def test_the_pages_build_without_a_warning(tmp_path: Path) -> None:
    for package in ("sphinx", "myst_parser", "furo", "sphinx_gallery"):
        pytest.importorskip(package, reason="the documentation needs pip install 'flexel[docs]'")
    command = [sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-d", str(tmp_path / "trees")]
    answer = subprocess.run(
        [*command, str(DOCS), str(tmp_path / "html")], capture_output=True, text=True, check=False
    )
    assert answer.returncode == 0, answer.stderr
    page = (tmp_path / "html" / "_generated" / "elements" / "wheel.html").read_text(encoding="utf-8")
    assert "longitudinal" in page and "against the definition" in page
    report = (tmp_path / "html" / "report-latest.html").read_text(encoding="utf-8")
    assert "Published numbers" in report and "<td>wheel</td>" in report
    formulas = (tmp_path / "html" / "theory.html").read_text(encoding="utf-8")
    assert formulas.count("<math") > 50 and 'class="accented">q\u0308' in formulas
    assert not re.search(r"<(script|link)[^>]*(src|href)=.https?://", formulas)  # nothing from a network
    classic = (tmp_path / "html" / "_generated" / "gallery" / "four_bar.html").read_text(encoding="utf-8")
    assert "sphx_glr_four_bar_001.png" in classic and "the rocker swings between" in classic
    assert 'href="report-latest.html"' in (tmp_path / "html" / "report.html").read_text(encoding="utf-8")
