"""Implements `flexel bench`: computing times compared with those of other programs."""

import json
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Any

import click

from flexel.apps.cli.jsonfile import check_json_file
from flexel.apps.cli.stop import INTERRUPTED
from flexel.base.stopping import StoppedError, stopping

if TYPE_CHECKING:
    from bench.compare import Comparison, Figure
    from bench.table import Row

# Modules imported when the command runs: NumPy, which most of them import, is limited to one thread before.
MACHINE, TABLE, TIMING, COMPARE, PEERS, PLOT = (
    f"bench.{name}" for name in ("machine", "table", "timing", "compare", "peers", "speed_figure")
)


@click.command()
@click.argument("names", nargs=-1, metavar="[NAME...]")
@click.option(
    "--json",
    "json_file",
    type=click.Path(dir_okay=False, writable=True, allow_dash=True),
    metavar="FILE",
    help="Write the figures as a JSON list; with - to stdout, the table to stderr.",
)
@click.option(
    "--plot",
    "plot_file",
    type=click.Path(dir_okay=False, writable=True),
    metavar="FILE",
    help="Plot the ratios to the peers, and times against size; the suffix determines the format.",
)
def bench(names: tuple[str, ...], json_file: str | None, plot_file: str | None) -> None:
    """Measure computing times, and print them next to those of other programs and the targets.

    Without NAME, all rows are measured (many minutes); each figure is the shortest CPU time of many runs in one thread.
    Other programs, if installed, run the same model alternately with flexel: pip install 'flexel[peers]'.
    Exit status 1 if a row or a peer fails or is not accurate enough. Ctrl-C stops; finished measurements are kept.
    """
    if not import_module(MACHINE).one_thread():
        click.echo(
            "NumPy was already imported: set OPENBLAS_NUM_THREADS=1, or the times may be wrong", err=True
        )
    rows = import_module(TABLE).ROWS
    chosen = _chosen(names, rows)
    check_json_file(json_file, rows, "row")
    check_json_file(plot_file, rows, "row", "--plot")
    if plot_file is not None:
        with _reported():
            import_module(PLOT).check_format(plot_file)
    begin, table = time.perf_counter(), sys.stderr if json_file == "-" else sys.stdout
    _head(table)
    found, failed, interrupted = _measured(chosen, table)
    click.echo(f"{len(found)} of {len(chosen)} rows in {time.perf_counter() - begin:.0f} s", err=True)
    if json_file is not None:
        with click.open_file(json_file, "w", encoding="utf-8") as stream:
            stream.write(
                json.dumps([comparison.to_dict() for comparison in found], indent=1, ensure_ascii=False)
                + "\n"
            )
    if plot_file is not None:
        with _reported():
            import_module(PLOT).plot(found, plot_file)
    if interrupted:
        raise SystemExit(INTERRUPTED)
    if failed:
        raise click.ClickException("failed: " + ", ".join(dict.fromkeys(failed)))


@contextmanager
def _reported() -> Iterator[None]:
    """Turn an error of flexel into one of the command line."""
    from flexel.base.errors import FlexelError

    try:
        yield
    except FlexelError as error:
        raise click.ClickException(f"--plot: {error}") from error


def _chosen(names: Sequence[str], rows: "dict[str, Row]") -> "list[Row]":
    """Return the rows named on the command line, without duplicates; all without names."""
    unknown = [name for name in names if name not in rows]
    if unknown:
        raise click.UsageError(f"no row named {', '.join(map(repr, unknown))}; there are: {', '.join(rows)}.")
    return [rows[name] for name in dict.fromkeys(names or rows)]


def _head(table: Any) -> None:
    """Print the machine, the peers, the yardstick and the titles of the columns."""
    unit = import_module(TIMING).yardstick()
    click.echo(import_module(MACHINE).machine(), file=table)
    peers = {peer.program: peer.version or "not installed" for peer in import_module(PEERS).PEERS}
    click.echo(f"peers: {', '.join(map(' '.join, peers.items()))}", file=table)
    click.echo(
        f"yardstick, numpy.linalg.solve of a 40 x 40 system: {unit.shortest * 1e6:.3g} µs "
        f"(median {unit.median * 1e6:.3g})",
        file=table,
    )
    titles = f"{'shortest':>9} {'median':>9} {'':<2} {'ratio':>6} {'target':>6} {'goal':>6} {'met':<10}"
    click.echo(f"{'':<26}{titles} {'runs':>5} {'error':>8} {'power':>6}", file=table)


def _measured(rows: "list[Row]", table: Any) -> "tuple[list[Comparison], list[str], bool]":
    """Measure and print one row after another.

    Returns
    -------
    tuple
        Figures; names of rows and peers that failed or are not accurate enough; whether Ctrl-C ended it.
    """
    compare = import_module(COMPARE)
    found: list[Comparison] = []
    failed: list[str] = []
    for row in rows:
        try:
            with stopping():
                result = compare.compare(row, partial(_peer_failed, failed, row.name))
        except StoppedError:
            click.echo(f"\n{row.name}: interrupted", err=True)
            return found, failed, True
        except Exception as error:  # any error: the other rows are measured, and the exit status reports it
            click.echo(f"{row.name}: {type(error).__name__}: {error}", err=True)
            failed.append(row.name)
            found.append(compare.nothing(row))
            continue
        found.append(result)
        _print(result, table)
        failed += _inaccurate(result)
    return found, failed, False


def _peer_failed(failed: list[str], row: str, peer: str, error: Exception) -> None:
    """Report a failure, and record the name."""
    click.echo(f"{row} with {peer}: {type(error).__name__}: {error}", err=True)
    failed.append(f"{row} with {peer}")


def _inaccurate(result: "Comparison") -> list[str]:
    """Report inaccurate rows and peers, and return their names."""
    row, failed = result.row, []
    for name, figure in {row.name: result.own, **result.by_row_and_name()}.items():
        if figure.measured and not row.accurate(figure.error):
            found = "no number" if figure.error is None else f"{figure.error:.1e}"
            click.echo(f"{name}: {row.accuracy}: {found}; at most {row.within:g} is allowed", err=True)
            failed.append(name)
    return failed


def _print(result: "Comparison", table: Any) -> None:
    """Print the line of a row, one for each peer, and for a row that scales one for each size."""
    row, own = result.row, result.own
    click.echo(f"{row.name:<26}{_line(row, own, own)}", file=table)
    for name, figure in result.peers.items():
        text = _line(row, figure, own) if figure is not None else "not installed"
        click.echo(f"  {name:<24}{text}", file=table)
    for i, size in enumerate(row.sizes):
        times = [
            f"{name} {'-' if figure.values[i] is None else format(figure.values[i], '.4g')}"
            for name, figure in {"flexel": own, **result.installed}.items()
        ]
        click.echo(f"  N = {size:<20}{row.unit:<3}{', '.join(times)}", file=table)


def _line(row: "Row", figure: "Figure", own: "Figure") -> str:
    """Return the figures of a program; target and goal are flexel's."""
    timing = figure.last
    if timing is None or figure.value is None:
        error = "" if figure.error is None else f", error {figure.error:.1e}"
        return f"no figure{' of the largest size' if row.sizes else ''}{error}"
    median = timing.median / timing.shortest * figure.value if figure.value else 0.0
    mine = figure is own
    ratio = "" if mine or not own.value else f"{figure.value / own.value:.3g}"
    met = row.mark(figure.value, figure.error) if mine else "" if row.accurate(figure.error) else "inaccurate"
    target, goal, error, power = (
        "" if number is None else f"{number:{form}}"
        for number, form in (
            (row.target if mine else None, "g"),
            (row.goal if mine else None, "g"),
            (figure.error, ".1e"),
            (figure.exponent, ".2f"),
        )
    )
    times = f"{figure.value:>9.4g} {median:>9.4g} {row.unit:<2} {ratio:>6} {target:>6} {goal:>6}"
    return f"{times} {met:<10} {timing.readings:>5} {error:>8} {power:>6}"
