"""The command line: `flexel derive`, `verify`, `reproduce` and `info`.

Each command imports what it needs when it runs, so that ``flexel --help`` is quick and ``flexel derive``
works without compiled kernels. It may see `flexel.derive`, but only lazily.
"""

import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import click

import flexel

if TYPE_CHECKING:
    from flexel.report import Report

# The published systems: name -> module with a function reproduce(out: Path | None) -> Report.
CASES = {
    "bicycle": "flexel.examples.bicycle",
    "beams": "flexel.examples.beams",
    "cardan": "flexel.examples.cardan",
    "slider-crank": "flexel.examples.slider_crank",
    "flexures": "flexel.examples.flexures",
    "vehicle": "flexel.examples.vehicle",
    "motorcycle": "flexel.examples.motorcycle",
}

PASSED_ON = {"ignore_unknown_options": True, "help_option_names": []}


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(flexel.__version__, prog_name="flexel")
def main() -> None:
    """A compiler for mechanisms: derive, compile, run."""


@main.command(context_settings=PASSED_ON, short_help="Regenerate the C kernels, or check them (--check).")
@click.argument("arguments", nargs=-1, type=click.UNPROCESSED)
def derive(arguments: tuple[str, ...]) -> None:
    """Pass everything on to flexel.derive, whose own help is shown by `flexel derive --help`."""
    from flexel.derive.__main__ import main as command

    command.main(args=list(arguments), prog_name="flexel derive")


@main.command(context_settings=PASSED_ON, short_help="Check every compiled kernel's derivatives.")
@click.argument("arguments", nargs=-1, type=click.UNPROCESSED)
def verify(arguments: tuple[str, ...]) -> None:
    """Pass everything on to flexel.derive.verify, whose own help is shown by `flexel verify --help`."""
    from flexel.derive.verify import main as command

    command.main(args=list(arguments), prog_name="flexel verify")


@main.command()
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
    help="Write figures and animations here (made if missing); without it none are drawn.",
)
def reproduce(names: tuple[str, ...], json_file: str | None, out: Path | None) -> None:
    """Run published systems and compare with the printed numbers.

    Exit status 0 only if every quantity is within its tolerance. NAME `all` runs every system there is.
    """
    cases = _chosen(names)
    if json_file in CASES or json_file == "all":
        raise click.UsageError(
            f"--json {json_file}: that is a system, not a file; write names before --json."
        )
    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
    to_stdout = json_file == "-"
    reports = [_run(name, out, to_stdout) for name in cases]
    if json_file is not None:
        from flexel.report import to_json

        text = to_json(reports, as_list=len(names) > 1 or names == ("all",))
        with click.open_file(json_file, "w", encoding="utf-8") as stream:
            stream.write(text)
    failed = [
        f"{report.case}: {entry.name}" for report in reports for entry in report.quantities if not entry.ok
    ]
    if failed:
        raise click.ClickException("not reproduced: " + ", ".join(failed))


@main.command()
def info() -> None:
    """Print versions, compiler, cache directory and whether the kernels load."""
    from flexel.info import facts

    rows = facts()
    width = max(len(name) for name, _ in rows)
    for name, fact in rows:
        click.echo(f"{name:<{width}}  {fact}")


def _chosen(names: Sequence[str]) -> list[str]:
    """Return the cases that the names on the command line ask for, each once."""
    unknown = [name for name in names if name not in CASES and name != "all"]
    if unknown:
        known = ", ".join([*CASES, "all"])
        raise click.UsageError(
            f"no published system named {', '.join(map(repr, unknown))}; there are: {known}."
        )
    return list(CASES) if "all" in names else list(dict.fromkeys(names))


def _run(name: str, out: Path | None, table_on_stderr: bool) -> "Report":
    """Run one system, time it and print its table."""
    from flexel.errors import FlexelError

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


if __name__ == "__main__":
    sys.exit(main())
