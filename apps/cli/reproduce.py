"""Implements `flexel reproduce`: systems of the literature compared with references."""

import time
from collections.abc import Sequence
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import click

from flexel.apps.cli.jsonfile import check_json_file
from flexel.apps.cli.stop import INTERRUPTED

if TYPE_CHECKING:
    from flexel.results.reproduction import Report

# The systems: name -> module with a function reproduce(out: Path | None) -> Report.
CASES = {
    "bicycle": "flexel.examples.bicycle",
    "beams": "flexel.examples.beams",
    "warping": "flexel.examples.warping",
    "cardan": "flexel.examples.cardan",
    "cylinder": "flexel.examples.cylinder",
    "slider-crank": "flexel.examples.slider_crank",
    "flexures": "flexel.examples.flexures",
    "rope": "flexel.examples.rope",
    "contact": "flexel.examples.contact",
    "hoist": "flexel.examples.hoist",
    "vehicle": "flexel.examples.vehicle",
    "motorcycle": "flexel.examples.motorcycle",
    "tolerances": "flexel.examples.tolerances",
    "stability-map": "flexel.examples.stability_map",
}


@click.command()
@click.argument("names", nargs=-1, required=True, metavar="NAME...")
@click.option(
    "--json",
    "json_file",
    is_flag=False,
    flag_value="-",
    type=click.Path(dir_okay=False, writable=True, allow_dash=True),
    metavar="[FILE]",
    help="Write the numbers as JSON; without FILE (or with -) to stdout, the table to stderr",
)
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="DIR",
    help="Write figures and animations here (created if missing); without it none are drawn.",
)
def reproduce(names: tuple[str, ...], json_file: str | None, out: Path | None) -> None:
    """Run systems of the literature and print every number next to its reference, with the kind of reference.

    Exit status 0 only if every quantity that has a reference is within its tolerance of it, and all are
    finite. NAME `all` runs every system.
    Ctrl-C stops; finished systems keep their tables, files and JSON.
    """
    cases = _chosen(names)
    check_json_file(json_file, (*CASES, "all"), "system")
    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
    to_stdout = json_file == "-"
    reports: list[Report] = []
    for name in cases:
        try:
            reports.append(_run(name, out, to_stdout))
        except KeyboardInterrupt:
            click.echo(f"\n{name}: interrupted; {len(reports)} of {len(cases)} systems are kept", err=True)
            break
    if json_file is not None:
        _write_json(reports, json_file, as_list=len(names) > 1 or names == ("all",))
    _conclude(reports, len(cases))


def _write_json(reports: Sequence["Report"], file: str, as_list: bool) -> None:
    from flexel.results.reproduction import to_json

    with click.open_file(file, "w", encoding="utf-8") as stream:
        stream.write(to_json(reports, as_list=as_list or not reports))


def _conclude(reports: Sequence["Report"], asked: int) -> None:
    """Exit status 0 only if all requested quantities exist and are within tolerance."""
    failed = [
        f"{report.case}: {entry.name}" for report in reports for entry in report.quantities if not entry.ok
    ]
    if failed:
        raise click.ClickException("not reproduced: " + ", ".join(failed))
    if len(reports) < asked:
        raise SystemExit(INTERRUPTED)


def _chosen(names: Sequence[str]) -> list[str]:
    """Return the cases named on the command line, without duplicates."""
    unknown = [name for name in names if name not in CASES and name != "all"]
    if unknown:
        known = ", ".join([*CASES, "all"])
        raise click.UsageError(
            f"no published system named {', '.join(map(repr, unknown))}; there are: {known}."
        )
    return list(CASES) if "all" in names else list(dict.fromkeys(names))


def _run(name: str, out: Path | None, table_on_stderr: bool) -> "Report":
    """Run one system, time it and print its table."""
    from flexel.base.errors import FlexelError

    click.echo(f"{name} ...", err=True)
    start = time.perf_counter()
    try:
        report: Report = import_module(CASES[name]).reproduce(out)
    except FlexelError as error:
        raise click.ClickException(f"{name}: {error}") from error
    except ModuleNotFoundError as error:
        if error.name is None or not error.name.startswith("matplotlib"):
            raise
        raise click.ClickException(
            f"{name}: figures need matplotlib; `pip install 'flexel[plot]'` or leave out --out."
        ) from error
    report = replace(report, seconds=report.seconds or time.perf_counter() - start)
    click.echo(report.table(), err=table_on_stderr)
    for file in report.files:
        click.echo(f"wrote {file}", err=table_on_stderr)
    click.echo(
        f"{name}: {'all reproduced' if report.ok else 'NOT reproduced'} in {report.seconds:.1f} s", err=True
    )
    return report
