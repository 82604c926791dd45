"""`flexel bench` measures, writes JSON, and reports what fails. Nothing here depends on how long anything takes."""

import json
import os
import signal
import time
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bench import table, timing
from bench.chains import right_hand_side
from bench.machine import machine
from bench.table import ROWS, UNITS, Row
from bench.timing import Series, Work, measure
from click.testing import CliRunner, Result

import flexel as fx
from flexel.apps.cli import main as cli

KEYS = {"name", "value", "unit", "error", "target", "goal", "accuracy", "within", "peers"}
QUICK = ("bicycle_rhs", "bicycle_M1", "linearize_vehicle", "build_bicycle", "kernels_beam", "import_flexel")


def run(*arguments: str) -> Result:
    """Run `flexel bench` with these arguments in this process."""
    return CliRunner().invoke(cli.main, ["bench", *arguments])


@pytest.fixture(autouse=True)
def few_readings(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the yardstick, which all rows are printed with."""
    monkeypatch.setattr(timing, "MOST", 20)


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Spend next to no time on a row."""
    monkeypatch.setattr(timing, "BUDGET", 1e-3)
    monkeypatch.setattr(timing, "FEWEST", 1)


def rows(monkeypatch: pytest.MonkeyPatch, **works: Work | Exception) -> None:
    """Put rows with these works in place of all, each with an error of at most 1."""

    def prepare(work: Work | Exception) -> Work:
        if isinstance(work, Work):
            return work
        raise work

    found = {
        name: Row(name, "ms", 1e6, 1e5, partial(prepare, work), "a difference", 1.0)
        for name, work in works.items()
    }
    monkeypatch.setattr(table, "ROWS", found)


def test_the_rows_have_units_figures_and_references() -> None:
    """The goal is beyond the target; what has a largest error says what the error is."""
    assert {"bicycle_rhs", "hoist", "chain_100_closed", "kernels_beam"} <= set(ROWS)
    for name, row in ROWS.items():
        assert row.name == name and row.unit in UNITS
        assert (row.target is None) == (row.goal is None)
        assert row.target is None or row.goal is None or row.goal < row.target
        assert bool(row.accuracy) == (row.within is not None)


@pytest.mark.usefixtures("quick")
def test_the_cheapest_rows_are_measured_and_accurate(tmp_path: Path) -> None:
    """The table has a line for each, the JSON the entries; errors are finite where there is a reference."""
    file = tmp_path / "figures.json"
    result = run(*QUICK, "--json", str(file))
    assert result.exit_code == 0, result.output
    assert "yardstick" in result.stdout and machine() in result.stdout
    figures = json.loads(file.read_text(encoding="utf-8"))
    assert [figure["name"] for figure in figures] == list(QUICK)
    for figure in figures:
        row = ROWS[figure["name"]]
        assert set(figure) == KEYS and figure["name"] in result.stdout
        assert figure["value"] > 0
        assert (figure["unit"], figure["target"], figure["goal"]) == (row.unit, row.target, row.goal)
        assert (figure["error"] is None) == (row.within is None)


@pytest.mark.parametrize("closed", [False, True])
def test_a_chain_moves_as_its_closed_form_says(closed: bool) -> None:
    work = right_hand_side(6, closed)
    assert work.error is not None and work.error(work.run()) < 1e-11


def test_json_with_a_dash_goes_to_stdout_and_the_table_to_stderr(monkeypatch: pytest.MonkeyPatch) -> None:
    """A row that is named twice is measured once; the shortest time is in the unit of the row."""
    clock = iter(np.arange(0.0, 1e6, 3.0))  # every reading 3 s after the last one
    rows(monkeypatch, one=Work(lambda: 0, error=lambda _: 0.5, clock=lambda: float(next(clock)), count=2))
    result = run("one", "one", "--json", "-")
    assert json.loads(result.stdout) == [
        {
            "name": "one", "value": 1500.0, "unit": "ms", "error": 0.5, "target": 1e6, "goal": 1e5,
            "accuracy": "a difference", "within": 1.0, "peers": {},
        }
    ]  # fmt: skip
    assert "yardstick" in result.stderr and "1 of 1 rows in" in result.stderr


def test_an_unknown_row_lists_the_known_ones() -> None:
    result = run("bicycle_rsh")
    assert result.exit_code == 2
    assert "'bicycle_rsh'" in result.stderr and "bicycle_rhs, bicycle_M1" in result.stderr


@pytest.mark.parametrize(("file", "why"), [("hoist", "that is a row"), ("/nowhere/x.json", "does not exist")])
def test_a_file_that_cannot_be_meant_is_refused_before_anything_is_measured(file: str, why: str) -> None:
    result = run("--json", file)
    assert result.exit_code == 2 and why in result.stderr


@pytest.mark.usefixtures("quick")
def test_a_row_that_fails_or_is_inaccurate_is_reported_after_the_others(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Exit status 1; a row that failed has no value, an inaccurate one keeps its own and is marked."""
    file = tmp_path / "figures.json"
    good, coarse, lost = (
        Work(lambda: 0, error=lambda _, number=number: number) for number in (0.5, 1.5, np.nan)
    )
    rows(monkeypatch, broken=ValueError("no such rope"), coarse=coarse, lost=lost, good=good)
    result = run("--json", str(file))
    assert result.exit_code == 1
    assert "broken: ValueError: no such rope" in result.stderr
    assert "coarse: a difference: 1.5e+00; at most 1 is allowed" in result.stderr
    assert "failed: broken, coarse, lost" in result.stderr
    marks = {line.split()[0]: line for line in result.stdout.splitlines()}
    assert "inaccurate" in marks["coarse"] and "goal" in marks["good"]
    figures = {figure["name"]: figure for figure in strictly(file.read_text(encoding="utf-8"))}
    assert figures["broken"]["value"] is None and figures["coarse"]["error"] == 1.5
    assert figures["lost"]["error"] is None


def strictly(text: str) -> Any:
    """JSON that every program reads: without NaN."""

    def refuse(constant: str) -> None:
        raise AssertionError(constant)

    return json.loads(text, parse_constant=refuse)


@pytest.mark.usefixtures("quick")
def test_an_interrupt_keeps_what_was_measured(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Ctrl-C in the second row: the JSON has the first, the exit status is that of an interrupt.

    A simulation would end with a part of its motion, and its time would be taken for that of the whole.
    """
    m = fx.Model()
    m.point("p", (0, 0, 0))
    m.point_mass("mass", "p", 1.0)

    def press(t: float) -> float:
        if t > 0:  # in the motion, not when the model is built
            os.kill(os.getpid(), signal.SIGINT)
        return 0.0

    m.load("p.x", (press, lambda t: 0.0, lambda t: 0.0))
    system = m.build()
    rows(
        monkeypatch,
        first=Work(lambda: 0, error=lambda _: 0.0),
        second=Work(lambda: system.simulate(1.0), error=lambda _: 0.0),
    )
    result = run("--json", str(tmp_path / "figures.json"))
    assert result.exit_code == 130
    assert "second: interrupted" in result.stderr and "1 of 2 rows" in result.stderr
    assert [row["name"] for row in json.loads((tmp_path / "figures.json").read_text())] == ["first"]


def test_work_that_needs_longer_than_the_budget_runs_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(timing, "BUDGET", 0.0)
    runs: list[float] = []
    (found,) = measure([Series(Work(lambda: runs.append(time.perf_counter()), error=lambda _: 0.25))])
    assert (len(runs), found.readings, found.error) == (2, 2, 0.25)
    assert found.shortest <= found.median
