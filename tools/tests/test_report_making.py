"""`tools/write_report.py --run`: the commands that write the files, when and where they ran."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
import write_report
from click.testing import CliRunner, Result
from report import making
from report.json_data import read_json
from report.parts import NAMES, Sanitized
from report_files import BENCH, VERIFY


def report(*arguments: str) -> Result:
    """Run the script in this process."""
    return CliRunner().invoke(write_report.report, arguments)


def test_the_parts_are_made_and_the_page_says_when(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An older file is removed; the file of a command that fails counts, and so does its exit status."""
    folder = tmp_path / "data"
    folder.mkdir()
    (folder / "bench.json").write_text("old")
    programs = {"verify": VERIFY, "bench": BENCH}

    def command(part: str, file: Path, request: making.ReportOptions) -> tuple[list[str], None]:
        assert (request.rows, request.models, request.seed) == (["chain_40"], 7, 3)
        code = f"open({str(file)!r}, 'w').write({json.dumps(programs[part])!r})"
        return [sys.executable, "-c", code if part == "verify" else "raise SystemExit(3)"], None

    monkeypatch.setattr(making, "_command", command)
    options = "--from", str(folder), "--rows", "chain_40", "--models", "7", "--seed", "3"
    result = report("--run", "bench", "verify", *options)
    assert result.exit_code == 1
    assert (
        "bench: no file was written, exit status 3" in result.stderr and "missing: The times" in result.stderr
    )
    made = json.loads((folder / "facts.json").read_text())
    assert set(made) == {"verify"} and made["verify"]["seconds"] > 0
    assert {"machine", "python", "numpy", "scipy", "compiler"} <= set(made["verify"]["facts"])
    text = (tmp_path / "data.html").read_text(encoding="utf-8")
    assert made["verify"]["date"] in text and "3.4e-11" in text


QUICK = f"""
import runpy, sys
sys.path.insert(0, {str(Path(__file__).parents[1])!r})
from bench import timing
timing.BUDGET, timing.MOST = 1e-3, 20
runpy.run_module(sys.argv.pop(1), run_name="__main__", alter_sys=True)
"""


def test_a_real_row_of_the_benchmarks_is_measured(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By the command itself, which spends next to no time on it."""
    monkeypatch.setattr(making, "PYTHON", (sys.executable, "-c", QUICK))
    result = report("--run", "bench", "--rows", "kernels_beam", "--from", str(tmp_path / "made"))
    assert result.exit_code == 0, result.output
    assert "kernels_beam" in (tmp_path / "made.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("arguments", "reported"),
    [
        (["--run", "verfy"], "no part named 'verfy'; there are: verify, reproduce"),
        (["--run"], "write --run and the parts"),
        (["verify"], "write --run and the parts"),
    ],
)
def test_arguments_that_cannot_be_meant_are_refused(
    arguments: list[str], reported: str, tmp_path: Path
) -> None:
    result = report(*arguments, "--from", str(tmp_path))
    assert result.exit_code == 2 and reported in result.stderr


def test_all_parts_have_a_command(tmp_path: Path) -> None:
    request = making.ReportOptions(["chain_40"], 5, 2)
    commands = {part: making._command(part, tmp_path / "x.json", request)[0] for part in NAMES}
    assert commands["bench"][1:] == ["-m", "flexel", "bench", "chain_40", "--json", str(tmp_path / "x.json")]
    assert commands["campaign"][1:7] == ["-m", "campaign", "--models", "5", "--seed", "2"]
    assert (
        commands["sanitize"][0] == "make"
        and commands["sanitize"][-1] == f"SANITIZE_JSON={tmp_path / 'x.json'}"
    )


def test_commands_under_sanitizers_leave_what_ran_and_what_was_found(tmp_path: Path) -> None:
    """The environment is that of the marked lines alone; after a failure the rest is listed, not run."""
    file, logs = tmp_path / "out" / "sanitize.json", tmp_path / "found"
    (tmp_path / "found.1").write_text("of an earlier run")
    lines = ['test -z "$MARK"', f'+test "$MARK" = "a b" && echo ERROR: x > {logs}.7', "false", "+true"]
    script = [
        sys.executable,
        str(Path(__file__).parents[2] / ".ci" / "sanitized.py"),
        str(file),
        str(logs),
        "MARK=a b",
    ]
    answer = subprocess.run(script, input="\n".join(lines), capture_output=True, text=True, check=False)
    assert answer.returncode == 1, answer.stderr
    found = read_json(Sanitized, file, "make sanitize")
    assert [step.ok for step in found.steps] == [True, True, False, None]
    assert found.found == ["ERROR: x\n"] and "ERROR: x" in answer.stdout
    assert found.steps[3].command == "true"
