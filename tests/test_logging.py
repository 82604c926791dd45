"""What the library does is told to the loggers under `flexel`, and to nobody else: it prints nothing."""

import ast
import logging
from pathlib import Path

import pytest
from click.testing import CliRunner
from mistakes import pendulum

import flexel as fx
from flexel.apps.cli.main import main


def told(caplog: pytest.LogCaptureFixture, topic: str, level: int = logging.INFO) -> str:
    """Everything that was recorded on a topic at a level."""
    found = (
        record for record in caplog.records if record.name == f"flexel.{topic}" and record.levelno == level
    )
    return "\n".join(record.getMessage() for record in found)


@pytest.fixture(autouse=True)
def _all_levels(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.DEBUG, logger="flexel")


def chain(links: int = 1) -> fx.Model:
    """Rods in the plane, one after another, drawn horizontal."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("P0", (0, 0), fixed=True)
    for i in range(links):
        m.point(f"P{i + 1}", (i + 1.0, 0))
        m.truss(f"rod{i}", f"P{i}", f"P{i + 1}", mass_per_length=1.0)
    return m


def test_building_tells_counts_and_degrees_of_freedom(caplog: pytest.LogCaptureFixture) -> None:
    chain().build()
    m = chain()
    m.independent("P1.y")
    m.build()
    chosen, named = told(caplog, "build").splitlines()
    assert "1 degree of freedom (P1.y)" in chosen and chosen.endswith("chosen")
    assert named.endswith("as named")


def test_building_tells_redundant_constraints(caplog: pytest.LogCaptureFixture) -> None:
    m = chain()
    m.truss("twin", "P0", "P1", mass_per_length=1.0)
    with pytest.raises(fx.ConstraintError):
        m.build()
    assert "not independent: " in told(caplog, "build") and "'twin.elongation'" in told(caplog, "build")


def test_a_motion_tells_its_method_steps_and_events(caplog: pytest.LogCaptureFixture) -> None:
    low = fx.Event("low", lambda state: state["P1.y"] + 0.5, terminal=False)
    motion = chain().build().simulate(0.4, events=[low])
    first, event, last = told(caplog, "simulate").splitlines()
    assert (
        first
        == "t = 0 to 0.4 s by DOP853, chosen because max|eigenvalue|*duration = 0 at t = 0 s, at most 3e+04"
    )
    assert event.startswith("t = 0.268") and event.endswith("event 'low'")
    assert last.startswith("t = 0.4 s: reached the end; {'steps': ")
    steps = told(caplog, "simulate", logging.DEBUG).splitlines()
    assert len(steps) == motion.statistics["steps"] and steps[-1] == "step to t = 0.4 s"


def test_a_motion_tells_changes_of_its_degrees_of_freedom(caplog: pytest.LogCaptureFixture) -> None:
    m = chain()
    m.independent("P1.y")
    motion = m.build().simulate(1.0)
    told_of = [line for line in told(caplog, "simulate").splitlines() if "instead of" in line]
    assert len(told_of) == len(motion.rechoices) > 0
    assert told_of[0].endswith("s: degrees of freedom ('P1.x',) instead of ('P1.y',)")


def test_an_equilibrium_tells_its_iterations(caplog: pytest.LogCaptureFixture) -> None:
    m = chain()
    m.spring("P1.y", 100.0)
    m.build().equilibrium()
    assert "Newton iterations, error" in told(caplog, "statics")
    assert told(caplog, "statics").endswith("equilibrium at t = 0 s")
    assert "evaluation 1: error" in told(caplog, "newton", logging.DEBUG)


def test_a_load_path_tells_its_arcs(caplog: pytest.LogCaptureFixture) -> None:
    m = chain()
    m.spring("P1.y", 100.0)
    m.load("P1.y", lambda t: 10.0 * t)
    states = m.build().static_path(t_end=1.0)
    assert f"path to t = 1 s: {len(states)} equilibria" in told(caplog, "statics")
    assert "after an arc of 0.1" in told(caplog, "continuation", logging.DEBUG)


def test_compiling_tells_whether_the_cache_had_it(
    caplog: pytest.LogCaptureFixture, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    for _ in range(2):
        chain().law("rod0.elongation", lambda e, ed: 1e4 * e + 777 * e**3)
    *made, derivation, shared = told(caplog, "compile").splitlines()
    for line, said in zip(made, (" derived in ", " compiled in ", "agrees with its definition"), strict=True):
        assert said in line
    assert "the derivation of " in derivation and f" is in the cache: {tmp_path}" in derivation
    assert f" is in the cache: {tmp_path}" in shared


def test_variants_and_sweeps_tell_their_numbers(caplog: pytest.LogCaptureFixture) -> None:
    pytest.importorskip("xarray")
    chain().build().simulate_many(0.1, parameters={"rod0.rhoA": [1.0, 2.0, 3.0]}, threads=1)
    assert told(caplog, "variants").splitlines() == [
        "3 variants in 1 threads",
        "3 variants computed, 0 failed",
    ]
    fx.sweep(lambda a: a, {"a": [1.0, 2.0]}, lambda a: {"b": 2 * a}, executor="serial")
    first, last = told(caplog, "sweep").splitlines()
    assert first.startswith("2 points, 0 done before") and last == "2 points done, 0 failed"


MODEL = """
import flexel as fx
m = fx.Model(gravity=(0, -9.81))
m.point("O", (0, 0), fixed=True)
m.point("A", (1, 0))
m.truss("rod", "O", "A", mass_per_length=1)
"""


@pytest.mark.parametrize(("option", "steps"), [([], None), (["-v"], False), (["-vv"], True)])
def test_the_command_line_shows_it_on_request(tmp_path: Path, option: list[str], steps: bool | None) -> None:
    file = tmp_path / "model.py"
    file.write_text(MODEL)
    log = logging.getLogger("flexel")
    before = log.level, list(log.handlers)
    result = CliRunner().invoke(main, [*option, "run", str(file), "--time", "0.1", "--out", str(tmp_path)])
    assert result.exit_code == 0, result.output
    assert ("flexel.build: System(1 degree of freedom" in result.stderr) is (steps is not None)
    assert ("flexel.simulate: step to t = " in result.stderr) is bool(steps)
    assert (log.level, log.handlers) == before


def test_without_a_handler_nothing_is_written(capfd: pytest.CaptureFixture[str]) -> None:
    assert any(isinstance(handler, logging.NullHandler) for handler in logging.getLogger("flexel").handlers)
    pendulum().build().simulate(0.1, progress=False)
    assert capfd.readouterr() == ("", "")


def test_the_library_does_not_print() -> None:
    """Only commands print, and the derivation as a program of its own."""
    root = Path(fx.__file__).parent.parent
    folders = [root / name for name in ("runtime", "parts", "results", "apps", "derive")]
    places = [path for folder in folders for path in folder.rglob("*.py")]
    places = [
        path for path in places if path.name != "__main__.py" and root / "apps" / "cli" not in path.parents
    ]
    assert len(places) > 300
    for path in places:
        calls = (node.func for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.Call))
        names = {function.id for function in calls if isinstance(function, ast.Name)}
        assert "print" not in names, path
