"""`tools/write_report.py`: one page from small files; what fails stands at the top, what is missing is named."""

import json
import sys
from collections.abc import Callable
from html.parser import HTMLParser
from math import inf
from pathlib import Path
from typing import Any

import pytest
import write_report
from click.testing import CliRunner, Result
from report import plots
from report.markup import Html, size, table, tag
from report_files import ALL, BENCH, CAMPAIGN, FACTS, REPRODUCE, SANITIZE, VERIFY

import flexel
from flexel.apps.cli.reproduce import CASES
from flexel.generated.table import ELEMENTS, LAWS


def report(*arguments: str) -> Result:
    """Run the script in this process."""
    return CliRunner().invoke(write_report.report, arguments)


def changed(data: Any, *path: str | int, to: Any) -> Any:
    """A copy with another value at a place."""
    copy = json.loads(json.dumps(data))
    inner = copy
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = to
    return copy


Page = Callable[..., tuple[Result, str]]


@pytest.fixture
def page(tmp_path: Path) -> Page:
    """A function that writes these files and then the page, and returns the result and the page."""

    def write(**files: Any) -> tuple[Result, str]:
        folder = tmp_path / "data"
        folder.mkdir(exist_ok=True)
        for name, data in files.items():
            text = data if isinstance(data, str) else json.dumps(data)
            (folder / f"{name}.json").write_text(text, encoding="utf-8")
        result = report("--from", str(folder))
        target = tmp_path / "data.html"
        return result, target.read_text(encoding="utf-8") if target.exists() else ""

    return write


class Reader(HTMLParser):
    """Whether elements are closed in order; the identifiers, and what is referred to."""

    EMPTY = {"meta"}

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: list[str] = []
        self.references: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in self.EMPTY:
            self.open.append(tag)
        given = dict(attrs)
        assert tag not in ("script", "link", "iframe", "img", "object")
        self.ids += [given["id"] or ""] if "id" in given else []
        self.references += [given[key] or "" for key in ("href", "src", "xlink:href") if key in given]

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        self.handle_endtag(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_the_page_has_the_numbers_of_all_files(page: Page) -> None:
    result, text = page(**ALL, facts=FACTS)
    assert result.exit_code == 0, result.output
    assert "No failure in what was run" in text  # not all kernels, not all systems
    for shown in ("3.4e-11", "2.2e-16", "0.30172", "0.30174", "2.0e-5", "tolerance 1.0e-7", "8.4 µs", "<b>5</b>",
                  "symbrim 42 µs", "exudyn not installed", "seed 71", "3.3e-10", "no independent equations",
                  "planar chains", "python -m flexel verify", "0 findings", "Z80", "abc123", "2026-11-22 10:00 UTC",
                  f"flexel {flexel.__version__}"):  # fmt: skip
        assert shown in text, shown
    for kind in ("Published numbers", "Closed forms", "another program", "independently", "only reported"):
        assert kind in text
    assert "-1+2.5i" in text  # pairs are complex numbers where the row says so
    assert "[4], worst of 5" in text and "5.4999" in text


def test_the_page_is_whole_and_refers_to_nothing_outside(page: Page) -> None:
    _, text = page(**ALL, facts=FACTS)
    read = Reader(text)
    assert read.open == [] and text.startswith("<!DOCTYPE html>")
    assert len(set(read.ids)) == len(read.ids)
    assert {reference.removeprefix("#") for reference in read.references} <= set(read.ids)
    assert "//" not in text.replace("https://", "//") or "http" not in text
    assert "Euler &amp; &lt;Bernoulli&gt;" in text and "<Bernoulli>" not in text


def test_what_is_missing_is_named_with_the_command_that_makes_it(page: Page) -> None:
    result, text = page(verify=VERIFY)
    assert result.exit_code == 0
    for part in ("reproduce", "bench", "campaign", "sanitize"):
        assert f"<code>make report PARTS={part}</code>" in text
        assert f"make report PARTS={part}" in result.stderr
    other = [name for name in [*ELEMENTS, *(f"law {law}" for law in LAWS)] if name != "truss"]
    assert f"The kernels of {', '.join(other)}: not in this report" in text


def test_systems_that_are_not_in_the_file_are_named(page: Page) -> None:
    _, text = page(reproduce=[REPRODUCE])
    assert f"The systems {', '.join(name for name in CASES if name != 'beams')}: not in this report" in text


def test_an_empty_folder_says_that_nothing_was_run(page: Page) -> None:
    result, text = page()
    assert result.exit_code == 0 and "Nothing was run" in text and "No failure" not in text


def test_several_files_of_systems_are_one_table(page: Page) -> None:
    one, other = {**REPRODUCE, "case": "rope"}, {**REPRODUCE, "case": "hoist"}
    _, text = page(**{"reproduce": REPRODUCE, "reproduce-rope": one, "reproduce-hoist": [other]})
    assert "3 systems, 15 quantities, 12 with a reference" in text


BROKEN = changed(CAMPAIGN, "failures", to=[{"program": "m = <fx>", "property": "energy", "error": 0.25}])


@pytest.mark.parametrize(
    ("files", "reported"),
    [
        ({"verify": changed(changed(VERIFY, "ok", to=False), "rows", 0, "ok", to=False)}, "truss.position.De: 3.4e-11"),
        ({"verify": changed(changed(VERIFY, "ok", to=False), "rows", to=[])}, "nothing was verified"),
        ({"reproduce": changed(REPRODUCE, "quantities", 0, "ok", to=False)}, "beams: tip: error 2.0e-5"),
        ({"reproduce": changed(REPRODUCE, "quantities", 3, "ok", to=False)}, "beams: mass: not finite"),
        ({"reproduce": changed(REPRODUCE, "quantities", to=[])}, "beams: no quantity"),
        ({"bench": changed(BENCH, 0, "error", to=1e-3)}, "bicycle_rhs: error 1.0e-3, allowed 1.0e-8"),
        ({"bench": changed(BENCH, 0, "value", to=None)}, "bicycle_rhs: no time"),
        ({"campaign": BROKEN}, "energy: error 2.5e-1"),
        ({"campaign": changed(BROKEN, "failures", 0, "message", to="DynamicsError: x")}, "energy: DynamicsError: x"),
        ({"campaign": changed(CAMPAIGN, "properties", 0, "largest", to=1.0)}, "energy: largest error 1.0e0"),
        ({"campaign": changed(CAMPAIGN, "models", to=0)}, "no model"),
        ({"sanitize": changed(SANITIZE, "steps", 0, "ok", to=False)}, "python -m flexel verify: failed"),
        ({"sanitize": changed(SANITIZE, "found", to=["==\n==1==ERROR: Address: x"])}, "a sanitizer: ==1==ERROR"),
    ],
)  # fmt: skip
def test_a_failure_stands_at_the_top_and_in_the_exit_status(
    page: Page, files: dict[str, Any], reported: str
) -> None:
    result, text = page(**files)
    assert result.exit_code == 1 and reported in result.stderr
    top = text[: text.index("<nav>")]
    assert "No failure" not in top and "1 failure</strong>" in top
    assert reported in top and 'class="bad"' in text[text.index("<nav>") :]


def test_the_program_of_a_failed_property_is_printed(page: Page) -> None:
    _, text = page(campaign=BROKEN)
    assert "<pre>m = &lt;fx&gt;</pre>" in text
    assert '<tr class="bad"><td>energy</td>' in text  # though its largest error is small


@pytest.mark.parametrize(
    ("name", "content", "reported"),
    [
        ("verify", '{"ok": tr', "not JSON"),
        ("verify", "[" * 100_000, "not JSON"),
        ("verify", '{"ok": true, "seconds": NaN}', "NaN is not a finite number"),
        ("verify", '{"ok": true, "seconds": 1' + 400 * "0" + "}", "is not a finite number"),
        ("verify", "[]", "the file is [], not an object"),
        ("verify", json.dumps(changed(VERIFY, "rows", 1, "ok", to="yes")), "the file.rows[1].ok is \"yes\", not true"),
        ("reproduce", json.dumps(changed(REPRODUCE, "quantities", 0, "error", to=True)), "quantities[0].error is true"),
        ("reproduce", '{"case": "beams"}', "the file has no 'quantities'"),
        ("reproduce", json.dumps(changed(REPRODUCE, "quantities", 0, "computed", to=["x"])), "'tip' is damaged"),
        ("bench", json.dumps(changed(BENCH, 0, "peers", "symbrim", to=[1])), "the file[0].peers.symbrim is [1], not"),
        ("campaign", "null", "the file is null, not an object"),
        ("sanitize", json.dumps(changed(SANITIZE, "found", to=[1])), "the file.found[0] is 1, not a string"),
        ("facts", "{", "not JSON"),
    ],
)  # fmt: skip
def test_a_damaged_file_is_named_with_the_remedy(page: Page, name: str, content: str, reported: str) -> None:
    result, text = page(**{name: content})
    assert result.exit_code == 1 and isinstance(result.exception, SystemExit)
    assert reported in result.stderr and "again: make report PARTS=" in result.stderr
    assert f"{name}.json" in result.stderr or "beams" in result.stderr
    assert text == ""


def test_without_matplotlib_the_page_has_the_tables(page: Page, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    result, text = page(**ALL)
    assert result.exit_code == 0, result.output
    assert "<svg" not in text and "flexel[plot]" in text and "2.4e-4" in text


def test_with_matplotlib_the_plots_are_in_the_page(page: Page) -> None:
    pytest.importorskip("matplotlib", reason="plots need matplotlib: pip install 'flexel[plot]'")
    _, text = page(**ALL)
    assert text.count("<svg") == 3  # errors over tolerances, one quantity that converges, ratios
    for colour in plots.VARIABLES:
        assert colour not in text.split("</style>", 1)[1]


def test_plots_have_no_style_that_reaches_the_page() -> None:
    pytest.importorskip("matplotlib", reason="plots need matplotlib: pip install 'flexel[plot]'")
    drawn = plots.Plots().draw(plots.log_log, [2, 4], [0.0, 1e-3], 1.0, "steps")
    assert drawn.startswith("<svg viewBox") and "<style" not in drawn and "http" not in drawn


def test_text_is_escaped_wherever_it_stands() -> None:
    assert tag("p", "<b>", Html("<i></i>"), title='"') == '<p title="&quot;">&lt;b&gt;<i></i></p>'
    assert "&lt;td&gt;" in table(["<th>"], [("", ["<td>"])])


@pytest.mark.parametrize(
    ("error", "written"), [(None, "–"), (0.0, "0"), (1.26e-10, "1.3e-10"), (inf, "inf"), (3e-5, "3.0e-5")]
)
def test_errors_have_two_digits(error: float | None, written: str) -> None:
    assert size(error) == written
