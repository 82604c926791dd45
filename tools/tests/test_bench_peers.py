"""`flexel bench` beside other programs: a program made up for the test, and those that are installed."""

import json
import sys
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
import sympy
from bench import compare, peers, table, timing
from bench.compare import Figure, nothing
from bench.peers import PEERS, Peer
from bench.peers.printed import printed
from bench.speed_figure import ratios
from bench.table import ROWS, Row
from bench.timing import Series, Timing, Work, measure
from click.testing import CliRunner, Result

from flexel.apps.cli import main as cli

Prepare = Callable[..., Work]


def run(*arguments: str) -> Result:
    """Run `flexel bench` with these arguments in this process."""
    return CliRunner().invoke(cli.main, ["bench", *arguments])


def ticking(seconds: float, error: float = 0.0) -> Work:
    """Work that its own clock says to take some seconds a run."""
    time = [0.0]

    def work() -> float:
        time[0] += seconds
        return error

    return Work(work, error=float, clock=lambda: time[0])


@pytest.fixture(autouse=True)
def few_readings(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the yardstick, which all rows are printed with."""
    monkeypatch.setattr(timing, "MOST", 20)


@pytest.fixture
def programs(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """A function that puts one row, of 2 s a run, beside the peers of these names."""

    def put(beside: Mapping[str, Prepare], sizes: tuple[int, ...] = (), largest: int = 10**6) -> None:
        def prepare(size: int = 1) -> Work:
            return ticking(2.0 * size, 1e-9)

        row = Row("row", "s", 3.0, 1.0, prepare, "a difference", 1e-6, sizes)
        monkeypatch.setattr(table, "ROWS", {"row": row})
        made = tuple(
            Peer(name, name, {"row": preparation}, {"row": largest}) for name, preparation in beside.items()
        )
        monkeypatch.setattr(peers, "PEERS", made)
        monkeypatch.setattr(Peer, "installed", property(lambda peer: peer.name != "absent"))
        monkeypatch.setattr(Peer, "version", property(lambda peer: "1.0" if peer.installed else None))

    return put


def test_a_row_has_its_peers_in_json_and_in_the_table(programs: Callable[..., None], tmp_path: Path) -> None:
    """Null is not installed; the ratio is the peer's time over flexel's; a peer does not take the goal."""
    programs(
        {"slow": lambda: ticking(5.0, 2e-9), "quick": lambda: ticking(0.5), "absent": lambda: ticking(1.0)}
    )
    file = tmp_path / "figures.json"
    result = run("--json", str(file))
    assert result.exit_code == 0, result.output
    assert json.loads(file.read_text()) == [
        {
            "name": "row", "value": 2.0, "unit": "s", "error": 1e-9, "target": 3.0, "goal": 1.0,
            "accuracy": "a difference", "within": 1e-6,
            "peers": {"slow": {"value": 5.0, "error": 2e-9}, "quick": {"value": 0.5, "error": 0.0}, "absent": None},
        }
    ]  # fmt: skip
    lines = {line.split()[0]: line for line in result.stdout.splitlines()}
    assert "slow 1.0, quick 1.0, absent not installed" in lines["peers:"]
    assert " target " in lines["row"] and "2.5" in lines["slow"].split() and "0.25" in lines["quick"].split()
    assert "goal" not in lines["quick"] and lines["absent"].split(maxsplit=1)[1] == "not installed"


def test_a_peer_that_fails_or_is_inaccurate_is_reported_and_the_row_goes_on(
    programs: Callable[..., None],
) -> None:
    def broken() -> Work:
        raise OSError("no licence")

    programs({"broken": broken, "coarse": lambda: ticking(1.0, 1e-3), "good": lambda: ticking(4.0)})
    result = run("--json", "-")
    assert result.exit_code == 1
    assert "row with broken: OSError: no licence" in result.stderr
    assert "row with coarse: a difference: 1.0e-03; at most 1e-06 is allowed" in result.stderr
    assert "failed: row with broken, row with coarse" in result.stderr
    (figure,) = json.loads(result.stdout)
    assert figure["value"] == 2.0 and figure["peers"]["good"] == {"value": 4.0, "error": 0.0}
    assert figure["peers"]["broken"] == {"value": None, "error": None}
    marks = {line.split()[0]: line for line in result.stderr.splitlines() if line.startswith("  ")}
    assert "inaccurate" in marks["coarse"] and "no figure" in marks["broken"]


def test_a_row_that_scales_has_times_over_the_size_and_powers(programs: Callable[..., None]) -> None:
    """Linear beside quadratic; a size too large for a peer has no time; nor has what failed once."""

    def fragile(size: int) -> Work:
        if size > 10:
            raise MemoryError("too large")
        return ticking(1.0)

    programs(
        {"square": lambda size: ticking(0.1 * size**2), "fragile": fragile}, (10, 20, 40, 80), largest=40
    )
    result = run("--json", "-")
    (figure,) = json.loads(result.stdout)
    assert figure["sizes"] == [10, 20, 40, 80] and figure["values"] == [20.0, 40.0, 80.0, 160.0]
    assert (figure["value"], figure["exponent"]) == (160.0, pytest.approx(1.0))
    square = figure["peers"]["square"]
    assert square["value"] is None and square["values"] == pytest.approx([10.0, 40.0, 160.0, None])
    assert square["exponent"] == pytest.approx(2.0)
    assert figure["peers"]["fragile"] == {
        "value": None,
        "error": 0.0,
        "values": [1.0, None, None, None],
        "exponent": None,
    }
    assert result.stderr.count("MemoryError: too large") == 1
    assert "N = 40" in result.stderr and "flexel 160, square -" in result.stderr


def test_readings_are_taken_in_turn(monkeypatch: pytest.MonkeyPatch) -> None:
    """Slow work with fewer readings lies evenly between those of quick work."""
    monkeypatch.setattr(timing, "BUDGET", 12.0)
    order: list[str] = []

    def noted(name: str, seconds: float) -> Work:
        work = ticking(seconds)
        return Work(lambda: (order.append(name), work.run())[1], clock=work.clock)

    series = [Series(noted("quick", 1.0)), Series(noted("slow", 2.0))]
    order.clear()
    found = measure(series)
    assert [result.readings for result in found] == [12, 6]
    assert "".join(name[0] for name in order) == "qqs" * 6


def test_works_over_the_budget_run_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever stands beside them."""
    monkeypatch.setattr(timing, "BUDGET", 3.0)
    found = measure([Series(ticking(4.0)), Series(ticking(1.0))])
    assert [(result.shortest, result.readings) for result in found] == [(4.0, 2), (1.0, 5)]


def test_no_exponent_from_a_single_time() -> None:
    one = Timing(1.0, 1.0, 2, 0.0)
    assert Figure("s", (5, 10), [one, None]).exponent is None
    assert Figure("s", (5, 10), [one, Timing(4.0, 4.0, 2, float("nan"))]).exponent == pytest.approx(2.0)
    assert Figure("s", (5, 10), [one, Timing(4.0, 4.0, 2, float("nan"))]).error is None


def test_a_picture_shows_ratios_and_sizes(programs: Callable[..., None], tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="pictures need matplotlib: pip install 'flexel[plot]'")
    programs({"square": lambda size: ticking(0.1 * size**2)}, (10, 20, 40), largest=20)
    result = run("--plot", str(tmp_path / "figures.png"))
    assert result.exit_code == 0, result.output
    assert (tmp_path / "figures.png").stat().st_size > 5_000
    found = compare.compare(table.ROWS["row"], pytest.fail)
    assert ratios(found) == {"square": pytest.approx(1.0)}  # at 20, the largest size of both
    assert ratios(nothing(table.ROWS["row"])) == {}


@pytest.mark.parametrize(
    ("file", "why"), [("row", "that is a row"), ("/nowhere/x.png", "does not exist"), ("x.pdq", "png")]
)
def test_a_picture_that_cannot_be_drawn_is_refused_first(
    programs: Callable[..., None], monkeypatch: pytest.MonkeyPatch, file: str, why: str
) -> None:
    pytest.importorskip("matplotlib", reason="pictures need matplotlib: pip install 'flexel[plot]'")
    programs({})
    monkeypatch.setattr(compare, "compare", pytest.fail)
    result = run("--plot", file)
    assert result.exit_code != 0 and "--plot" in result.stderr and why in result.stderr


def test_a_picture_without_matplotlib_names_the_remedy(
    programs: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    programs({})
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    result = run("--plot", "x.png")
    assert result.exit_code == 1 and "flexel[plot]" in result.stderr


def test_the_rows_of_the_peers_are_rows_and_need_no_peer() -> None:
    """The table can be read without any of them: their modules import them when a row is prepared."""
    for peer in PEERS:
        assert peer.rows and set(peer.rows) <= set(ROWS) and set(peer.largest) <= set(peer.rows)
    for name, size in ((name, size) for peer in PEERS for name, size in peer.largest.items()):
        assert min(ROWS[name].sizes) <= size


def test_what_is_not_installed_is_found_to_be_so(monkeypatch: pytest.MonkeyPatch) -> None:
    peer = Peer("no_such_program", "no-such-program", {})
    assert not peer.installed and peer.version is None
    assert (
        Peer("numpy", "numpy", {}).installed
        and Peer("numpy", "numpy", {}).version == sys.modules["numpy"].__version__
    )
    assert isinstance(sys.modules["numpy"], ModuleType)


def test_a_way_of_a_program_needs_the_program() -> None:
    way = Peer("numpy, in C", "numpy", {})
    assert way.program == "numpy" and way.installed and way.version == sys.modules["numpy"].__version__


def test_equations_printed_as_c_have_the_rates_of_the_formulas() -> None:
    """A mass matrix whose first pivot is zero, against LAPACK."""
    a, b, u, v = names = sympy.symbols("a b u v")
    M, f = sympy.Matrix([[0, 2 + a**2], [sympy.sin(b) ** 2 + 1, a * b]]), sympy.Matrix([u**3 - b, v * a])
    rates, y = printed(names, [*M, *f]), np.array([0.3, -0.7, 1.1, 0.4])
    given = dict(zip(names, y, strict=True))
    expected = np.linalg.solve(*(np.array(matrix.subs(given), dtype=float) for matrix in (M, f)))
    np.testing.assert_allclose(rates(y), [*y[2:], *expected[:, 0]], rtol=1e-14)


SMALL = {"scaling_chain": 60, "scaling_rope": 125, "scaling_ladder": 60}  # sizes that a test can afford
PAIRS = [(peer, row) for peer in PEERS for row in peer.rows if row != "build_bicycle"]


@pytest.mark.parametrize(("peer", "row"), PAIRS, ids=[f"{row}-{peer.name}" for peer, row in PAIRS])
@pytest.mark.filterwarnings("ignore")  # of the other program
def test_a_peer_that_is_installed_is_accurate(peer: Peer, row: str) -> None:
    """The same error against the same reference as flexel's row is allowed."""
    if not peer.installed:
        pytest.skip(f"{peer.name} is not installed: pip install 'flexel[peers]'")
    prepare = partial(peer.rows[row], SMALL[row]) if row in SMALL else peer.rows[row]
    work = prepare()
    assert work.error is not None and ROWS[row].accurate(work.error(work.run()))
