"""`flexel report`: one page about what was checked; the benchmarks are found by name when they run."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import click

from flexel.commands.stop import INTERRUPTED

if TYPE_CHECKING:
    from flexel.report.section import Section

MACHINE = "flexel.benchmarks.machine"
# Rows of `flexel bench` that take a few seconds each.
QUICK = (
    "bicycle_rhs bicycle_M1 bicycle_loci chain_40 linearize_vehicle build_bicycle build_vehicle kernels_beam"
)
SHOWN = ("python", "numpy", "scipy", "sympy", "matplotlib", "compiler", "kernels")  # of `flexel info`
PEERS = ("exudyn", "symbrim", "pin", "mujoco", "bicycleparameters")
FOLDER = Path("out/report")


@click.command()
@click.argument("parts", nargs=-1, metavar="[PART]...")
@click.option("--run", "run_them", is_flag=True, help="Make the parts that follow first, or all: --run all.")
@click.option(
    "--from",
    "folder",
    type=click.Path(file_okay=False, path_type=Path),
    default=FOLDER,
    show_default=True,
    metavar="DIR",
    help="Folder of the JSON files, created if missing.",
)
@click.option(
    "--out",
    type=click.Path(dir_okay=False, writable=True, path_type=Path),
    metavar="FILE.html",
    help="File of the page; DIR.html by default.",
)
@click.option(
    "--rows", default=QUICK, metavar="NAMES", help="Rows of `flexel bench` that --run bench measures."
)
@click.option(
    "--models", type=click.IntRange(min=1), default=200, show_default=True, help="Of --run campaign."
)
@click.option("--seed", type=click.IntRange(min=0), default=1, show_default=True, help="Of --run campaign.")
def report(
    parts: tuple[str, ...], run_them: bool, folder: Path, out: Path | None, rows: str, models: int, seed: int
) -> None:
    """Write one page in HTML about what was checked, with the errors that were found.

    It is written from the JSON files of the PARTs verify, reproduce, bench, campaign and sanitize in a folder: what is
    missing is said in the page, with the command that makes it. `--run PART...` makes parts first; campaign and
    sanitize need a checkout. `make report` in a checkout makes all.

    Exit status 1 if the page shows a failure, or a part could not be made; 130 after Ctrl-C.
    """
    from flexel.base.errors import FlexelError
    from flexel.report.making import Request, check_possible

    chosen = _chosen(parts, run_them)
    problems: list[str] = []
    try:
        check_possible(chosen)
        folder.mkdir(parents=True, exist_ok=True)
        for part in chosen:
            problems += _make(part, folder, Request(rows.split(), models, seed))
        target, found = _write(folder, out)
    except FlexelError as error:
        raise click.ClickException(str(error)) from error
    except KeyboardInterrupt:
        click.echo(f"\ninterrupted; what was made before is in {folder}", err=True)
        raise SystemExit(INTERRUPTED) from None
    _conclude(target, found, problems)


def _chosen(parts: Sequence[str], run_them: bool) -> list[str]:
    """The parts to make, in the order of the page."""
    from flexel.report.parts import NAMES

    unknown = [z for z in parts if z not in NAMES and z != "all"]
    if unknown:
        raise click.UsageError(f"no part named '{unknown[0]}'; there are: {', '.join(NAMES)}, all.")
    if bool(parts) != run_them:
        raise click.UsageError(
            "write --run and the parts to make, as in: flexel report --run verify reproduce"
        )
    return [z for z in NAMES if z in parts or "all" in parts]


def _make(part: str, folder: Path, request: object) -> list[str]:
    """Make one part; what went wrong."""
    from flexel.report.making import make

    click.echo(f"{part} ...", err=True)
    problem = make(part, folder, request, _facts())  # type: ignore[arg-type]
    return [problem] if problem else []


def _write(folder: Path, out: Path | None) -> tuple[Path, list[Section]]:
    """Write the page; its place and its sections."""
    from datetime import UTC, datetime

    from flexel.commands.reproduce import CASES
    from flexel.generated.table import ELEMENTS, LAWS
    from flexel.report.making import version
    from flexel.report.page import page, sections, write
    from flexel.report.parts import files_in, read_parts

    parts = read_parts(files_in(folder))
    names = [*ELEMENTS, *(f"law {z}" for z in LAWS)]
    found = sections(parts, names, list(CASES))
    target = out or folder.with_suffix(".html")
    write(target, page(found, version(), f"{datetime.now(UTC):%Y-%m-%d %H:%M} UTC", parts.made))
    return target, found


def _facts() -> dict[str, str]:
    """Facts about the machine and what is installed on it, without paths of the user's."""
    from flexel.commands.facts import facts

    known = dict(facts())
    shown = {z: known[z] for z in (*SHOWN, *PEERS) if known.get(z, "not installed") != "not installed"}
    return {"machine": import_module(MACHINE).processor(), **shown}


def _conclude(target: Path, found: Sequence[Section], problems: Sequence[str]) -> None:
    """Say what is in the page; exit status 1 if something is wrong."""
    for section in found:
        for sentence in section.missing:
            click.echo(f"missing: {sentence}", err=True)
    click.echo(f"wrote {target}")
    failures = [f"{z.title}: {one}" for z in found for one in z.failures] + list(problems)
    if failures:
        raise click.ClickException("failed: " + "; ".join(failures))
