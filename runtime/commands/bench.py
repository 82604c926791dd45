"""`flexel bench`: what flexel costs; the rows are found by name when it runs."""

import json
import sys
import time
from collections.abc import Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

import click

from flexel.base.stopping import StoppedError, stopping
from flexel.commands.jsonfile import check_json_file
from flexel.commands.stop import INTERRUPTED

if TYPE_CHECKING:
    from flexel.benchmarks.table import Figure, Row
    from flexel.benchmarks.timing import Timing

# Modules that are imported when the command runs: `flexel --help` is quick, and the table brings NumPy.
MACHINE, TABLE, TIMING = (f"flexel.benchmarks.{name}" for name in ("machine", "table", "timing"))


@click.command()
@click.argument("names", nargs=-1, metavar="[NAME...]")
@click.option(
    "--json",
    "json_file",
    type=click.Path(dir_okay=False, writable=True, allow_dash=True),
    metavar="FILE",
    help="Write the figures as a JSON list; with - to stdout, the table to stderr.",
)
def bench(names: tuple[str, ...], json_file: str | None) -> None:
    """Measure what flexel costs, and print it beside the figures to reach and to aim at.

    Without NAME all rows, which takes minutes; each figure is the shortest CPU time of many runs in one thread.
    Exit status 1 if a row fails or is not accurate enough. Ctrl-C stops; what is measured is kept.
    """
    if not import_module(MACHINE).one_thread():
        click.echo(
            "NumPy was imported before: set OPENBLAS_NUM_THREADS=1, or the times may be wrong", err=True
        )
    rows = import_module(TABLE).ROWS
    chosen = _chosen(names, rows)
    check_json_file(json_file, rows, "row")
    begin, table = time.perf_counter(), sys.stderr if json_file == "-" else sys.stdout
    _head(table)
    figures, failed, interrupted = _measured(chosen, table)
    click.echo(f"{len(figures)} of {len(chosen)} rows in {time.perf_counter() - begin:.0f} s", err=True)
    if json_file is not None:
        with click.open_file(json_file, "w", encoding="utf-8") as stream:
            stream.write(
                json.dumps([figure.to_dict() for figure in figures], indent=1, ensure_ascii=False) + "\n"
            )
    if interrupted:
        raise SystemExit(INTERRUPTED)
    if failed:
        raise click.ClickException("failed: " + ", ".join(failed))


def _chosen(names: Sequence[str], rows: "dict[str, Row]") -> "list[Row]":
    """Return the rows named on the command line, without duplicates; all without names."""
    unknown = [name for name in names if name not in rows]
    if unknown:
        raise click.UsageError(f"no row named {', '.join(map(repr, unknown))}; there are: {', '.join(rows)}.")
    return [rows[name] for name in dict.fromkeys(names or rows)]


def _head(table: Any) -> None:
    """Print the machine, the yardstick and the titles of the columns."""
    unit = import_module(TIMING).yardstick()
    click.echo(import_module(MACHINE).machine(), file=table)
    click.echo(
        f"yardstick, numpy.linalg.solve of a 40 x 40 system: {unit.shortest * 1e6:.3g} µs "
        f"(median {unit.median * 1e6:.3g})",
        file=table,
    )
    titles = (
        f"{'shortest':>9} {'median':>9} {'':<2} {'reach':>6} {'aim':>6} {'met':<10} {'runs':>5} {'error':>8}"
    )
    click.echo(f"{'':<18}{titles}", file=table)


def _measured(rows: "list[Row]", table: Any) -> "tuple[list[Figure], list[str], bool]":
    """Measure and print one row after another.

    Returns
    -------
    tuple
        Figures; names of rows that failed or are not accurate enough; whether Ctrl-C ended it.
    """
    figures: list[Figure] = []
    failed: list[str] = []
    for row in rows:
        try:
            with stopping():
                figure, timing = row.measured()
        except StoppedError:
            click.echo(f"\n{row.name}: interrupted", err=True)
            return figures, failed, True
        except Exception as error:  # whatever it is: the other rows are measured, and the exit status tells
            click.echo(f"{row.name}: {type(error).__name__}: {error}", err=True)
            failed.append(row.name)
            figures.append(row.figure())
            continue
        click.echo(_line(row, figure, timing), file=table)
        if not row.accurate(figure):
            found = "no number" if figure.error is None else f"{figure.error:.1e}"
            click.echo(f"{row.name}: {row.accuracy}: {found}; at most {row.within:g} is allowed", err=True)
            failed.append(row.name)
        figures.append(figure)
    return figures, failed, False


def _line(row: "Row", figure: "Figure", timing: "Timing") -> str:
    """Return the line of the table of a measured row."""
    median = timing.median / timing.shortest * figure.value if figure.value else 0.0
    reach, aim, error = (
        "" if z is None else f"{z:{form}}"
        for z, form in ((row.reach, "g"), (row.aim, "g"), (figure.error, ".1e"))
    )
    times = f"{figure.value:>9.4g} {median:>9.4g} {row.unit:<2} {reach:>6} {aim:>6}"
    return f"{row.name:<18}{times} {row.mark(figure):<10} {timing.readings:>5} {error:>8}"
