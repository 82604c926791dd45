"""The command line says what it does, fails when a number is off, and writes its numbers as JSON."""

import json
import subprocess
import sys
import types
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner, Result

import flexel
from flexel.apps.cli import main as cli
from flexel.apps.cli import reproduce as published
from flexel.base.errors import FlexelError
from flexel.results.reproduction import Quantity, Report


def run(*arguments: str) -> Result:
    """Run `flexel` with these arguments in this process."""
    return CliRunner().invoke(cli.main, list(arguments))


@pytest.fixture
def pendulum(monkeypatch: pytest.MonkeyPatch) -> list[Path | None]:
    """Put a published system `pendulum` in the table; return the list of output folders it is called with."""
    calls: list[Path | None] = []

    def reproduce(out: Path | None) -> Report:
        calls.append(out)
        omega = Quantity(
            "omega", np.sqrt(9.81), 3.1320919526731650, 1e-12, "rad/s", "Huygens (1673)", kind="published"
        )
        poles = Quantity("poles", np.array([-1j, 1j]), [-1j, 1j], 1e-14, kind="closed form")
        return Report("pendulum", [omega, poles, Quantity("lean", np.float64(0.1))])

    module = types.ModuleType("pendulum_example")
    module.reproduce = reproduce  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "pendulum_example", module)
    monkeypatch.setattr(published, "CASES", {"pendulum": "pendulum_example"})
    return calls


def fails_with(monkeypatch: pytest.MonkeyPatch, outcome: Report | Exception) -> None:
    """Let the pendulum's reproduction return a report, or raise."""

    def reproduce(out: Path | None) -> Report:
        if isinstance(outcome, Exception):
            raise outcome
        return outcome

    monkeypatch.setattr(sys.modules["pendulum_example"], "reproduce", reproduce)


@pytest.mark.parametrize(
    "command", ["derive", "verify", "reproduce", "run", "check", "sweep", "convert", "view", "info"]
)
@pytest.mark.parametrize("switch", ["--help", "-h"])
def test_every_command_has_help(command: str, switch: str) -> None:
    """`flexel COMMAND --help` explains, and `flexel --help` lists it."""
    assert command in run("--help").output
    result = run(command, switch)
    assert result.exit_code == 0, result.output
    assert f"flexel {command}" in result.output or f"main {command}" in result.output


@pytest.mark.parametrize("switch", ["--help", "-h"])
def test_the_bench_of_a_checkout_has_its_help(
    switch: str, checkout: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All arguments are those of the command of the sources."""
    monkeypatch.setattr(flexel, "__file__", str(checkout / "runtime" / "__init__.py"))
    result = run("bench", switch)
    assert result.exit_code == 0, result.output
    assert "bench [OPTIONS] [NAME...]" in result.output
    assert "--json FILE" in result.output and "--plot FILE" in result.output
    wrong = run("bench", "--jsn", "-")
    assert wrong.exit_code == 2 and "--jsn" in wrong.stderr


@pytest.mark.parametrize("arguments", [(), ("--help",), ("hoist", "--json", "-")])
def test_a_bench_without_the_sources_says_where_it_is(
    arguments: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As an installed wheel, which has no tools/ beside it; it is listed all the same."""
    monkeypatch.setattr(flexel, "__file__", str(tmp_path / "flexel" / "__init__.py"))
    assert "\n  bench " in run("--help").stdout
    result = run("bench", *arguments)
    assert (result.exit_code, result.stdout) == (1, "")
    assert result.stderr.startswith("Error: the benchmarks come with the sources")
    assert "make bench" in result.stderr and len(result.stderr.splitlines()) == 1


def test_module_is_the_command() -> None:
    """`python -m flexel --version` prints the version."""
    result = subprocess.run([sys.executable, "-m", "flexel", "--version"], capture_output=True, text=True)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.startswith("flexel, version ")


def test_info_names_compiler_cache_and_kernels() -> None:
    """`flexel info` lists versions, compiler, cache and kernels."""
    result = run("info")
    assert f"in {Path(flexel.__file__).parent}\n" in result.output
    assert result.exit_code == 0, result.output
    names = {line.split()[0] for line in result.output.splitlines()}
    assert {"flexel", "python", "sympy", "numpy", "scipy", "compiler", "cache", "kernels"} <= names
    assert "not loaded" not in result.output


def test_reproduce_prints_a_table(pendulum: list[Path | None], tmp_path: Path) -> None:
    """The table shows published and computed numbers; the output folder is made and handed on."""
    result = run("reproduce", "pendulum", "--out", str(tmp_path / "a" / "b"))
    assert result.exit_code == 0, result.output
    assert "Huygens (1673)" in result.stdout and "3.13209195267" in result.stdout
    assert pendulum == [tmp_path / "a" / "b"] and pendulum[0].is_dir()


def test_json_without_file_goes_to_stdout(pendulum: list[Path | None]) -> None:
    """Standard output holds the JSON and nothing else; complex numbers are pairs."""
    result = run("reproduce", "pendulum", "--json")
    case = json.loads(result.stdout)
    assert (result.exit_code, case["case"], case["files"], pendulum) == (0, "pendulum", [], [None])
    omega, poles, lean = case["quantities"]
    keys = {"name", "computed", "reference", "kind", "error", "tolerance", "tolerance_kind", "reason", "unit",
            "source", "ok"}  # fmt: skip
    assert set(omega) == set(lean) == keys and set(poles) == keys | {"complex"} and poles["complex"] is True
    assert omega["computed"] == pytest.approx(omega["reference"], rel=1e-12)
    assert poles["computed"] == [[0.0, -1.0], [0.0, 1.0]]
    assert (lean["reference"], lean["kind"], lean["ok"]) == (None, "none", None)
    assert (omega["kind"], omega["tolerance_kind"], omega["ok"]) == ("published", "relative", True)
    assert case["seconds"] > 0


@pytest.mark.parametrize(
    ("names", "kind"), [(["pendulum"], dict), (["pendulum", "pendulum"], list), (["all"], list)]
)
def test_json_file(pendulum: list[Path | None], tmp_path: Path, names: list[str], kind: type) -> None:
    """One name writes an object, several names (and `all`) a list; each system runs once."""
    file = tmp_path / "numbers.json"
    result = run("reproduce", *names, "--json", str(file))
    assert result.exit_code == 0 and "Huygens" in result.stdout
    assert isinstance(json.loads(file.read_text()), kind)
    assert len(pendulum) == 1


def test_a_number_that_is_off_fails(pendulum: list[Path | None], monkeypatch: pytest.MonkeyPatch) -> None:
    """The JSON is still written, the exit status is not 0, and the message names the quantity."""
    fails_with(monkeypatch, Report("pendulum", [Quantity("g", 9.80, 9.81, 1e-6, kind="published")]))
    result = run("reproduce", "pendulum", "--json")
    assert result.exit_code == 1
    assert json.loads(result.stdout)["quantities"][0]["ok"] is False
    assert "not reproduced: pendulum: g" in result.stderr


def test_an_error_of_flexel_is_reported_without_traceback(
    pendulum: list[Path | None], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A system that cannot be computed ends in one line and exit status 1."""
    fails_with(monkeypatch, FlexelError("rod 'a': length is 0; give it one"))
    result = run("reproduce", "pendulum")
    assert result.exit_code == 1 and "pendulum: rod 'a': length is 0" in result.stderr


def test_an_interrupt_keeps_the_systems_that_are_finished(
    pendulum: list[Path | None], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Ctrl-C in the second system: the JSON has the first, the exit status is that of an interrupt."""

    def interrupted(out: Path | None) -> Report:
        raise KeyboardInterrupt

    module = types.ModuleType("second_example")
    module.reproduce = interrupted  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "second_example", module)
    monkeypatch.setitem(published.CASES, "second", "second_example")
    result = run("reproduce", "all", "--json", str(tmp_path / "numbers.json"))
    assert result.exit_code == 130
    assert "second: interrupted; 1 of 2 systems are kept" in result.stderr
    assert [case["case"] for case in json.loads((tmp_path / "numbers.json").read_text())] == ["pendulum"]


def test_an_interrupted_verification_shows_what_was_verified(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ctrl-C in the second element: the first one's rows are printed, the exit status is not 0."""
    from flexel.derive import verify as module

    one = module.verify

    def second_is_interrupted(spec: Any, address: int, definition: Any) -> Any:
        if spec.name == "norm":
            raise KeyboardInterrupt
        return one(spec, address, definition)

    monkeypatch.setattr(module, "verify", second_is_interrupted)
    result = run("verify", "planar_hinge", "norm", "truss")
    assert result.exit_code == 1
    assert "planar_hinge  stiffness" in result.stdout and "NOT OK interrupted" in result.stdout
    assert "truss" not in result.stdout


def test_unknown_system_lists_the_known_ones(pendulum: list[Path | None]) -> None:
    """A misspelt name is answered with the names that exist."""
    result = run("reproduce", "pendulun")
    assert result.exit_code == 2
    assert "'pendulun'" in result.stderr and "pendulum, all" in result.stderr


def test_a_system_is_not_taken_for_a_file(pendulum: list[Path | None]) -> None:
    """`--json pendulum` is a slip of order, not a file name."""
    assert run("reproduce", "all", "--json", "pendulum").exit_code == 2
    assert pendulum == []


@pytest.mark.parametrize(
    ("computed", "reference", "tolerance", "error", "ok"),
    [
        (1.0 + 1e-9, 1.0, 1e-8, 1e-9, True),
        (1e-9, 0.0, 1e-8, 1e-9, True),  # absolute where the reference is 0
        ([100.0, 1.1], [100.0, 1.0], 0.05, 0.1, False),  # relative to each entry itself
        ([[1.0, 2.0], [3.0, 4.4]], [[1, 2], [3, 4]], 0.05, 0.1, False),
        (3, 3, 0.0, 0.0, True),
        (1 + 1e-3j, 1.0, 1e-4, 1e-3, False),
        ([1.0, 2.0], [1.0, 2.0, 3.0], 1.0, np.inf, False),
        (np.nan, 1.0, 1.0, np.inf, False),
        (np.inf, None, 0.0, None, False),
        (5.0, None, 0.0, None, True),
    ],
)
def test_a_quantity_judges_itself(
    computed: object, reference: object, tolerance: float, error: float | None, ok: bool
) -> None:
    """Errors are relative to each entry of the reference, absolute where all are 0; NaN is never ok."""
    quantity = Quantity("q", computed, reference, tolerance, kind="none" if reference is None else "own")
    assert quantity.error == (error if error is None else pytest.approx(error, rel=1e-6))
    assert (quantity.ok, quantity.verdict) == (ok, None if ok and reference is None else ok)
    json.dumps(quantity.to_dict(), allow_nan=False)
    assert ("NO" in Report("case", [quantity]).table()) is not ok


def test_a_long_array_shows_its_worst_entry() -> None:
    """Eleven by four eigenvalues are one line of the table, the worst of them."""
    reference = 1 + np.arange(44.0).reshape(11, 4)
    computed = reference.copy()
    computed[7, 2] += 0.31
    row = Quantity("eigenvalues", computed, reference, 0.0015, source="a book", kind="own", reason="rough")
    line = Report("case", [row]).table().splitlines()[-1]
    assert "own" in line and "0.0015 relative" in line and line.endswith("a book; tolerance: rough")
    assert line.startswith("eigenvalues[7,2] (worst of 44)") and "1.0e-02" in line and "NO" in line


def test_a_path_that_cannot_be_written_is_reported_in_one_line(
    pendulum: list[Path | None], tmp_path: Path
) -> None:
    """JSON in a folder that is not there is refused before anything is computed; a folder cannot be in a file."""
    nowhere = str(tmp_path / "nowhere" / "numbers.json")
    for command in (("reproduce", "pendulum"), ("verify", "truss")):
        result = run(*command, "--json", nowhere)
        assert result.exit_code == 2 and "the folder does not exist; create it" in result.stderr
    assert pendulum == []
    (tmp_path / "file").write_text("")
    result = run("reproduce", "pendulum", "--out", str(tmp_path / "file" / "out"))
    assert result.exit_code == 1 and isinstance(result.exception, SystemExit)
    assert "Not a directory; give another path" in result.stderr
