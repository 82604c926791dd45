"""Write one HTML page about all checks, with the errors found; ``make report`` runs this script.

``python tools/write_report.py`` writes the page from the JSON files of the parts in a folder, and shows for a missing
part the command that makes it; ``--run PART...`` makes parts first.
"""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path

import click
from bench.machine import processor
from report.making import ReportOptions, make, version
from report.page import page, sections, write
from report.parts import NAMES, files_in, read_parts
from report.section import PageSection

from flexel.apps.cli.facts import facts
from flexel.apps.cli.reproduce import CASES
from flexel.apps.cli.stop import INTERRUPTED
from flexel.base.errors import FlexelError
from flexel.generated.table import ELEMENTS, LAWS

# Rows of `flexel bench` that take a few seconds each.
QUICK = (
    "bicycle_rhs bicycle_M1 bicycle_loci chain_40 linearize_vehicle build_bicycle build_vehicle kernels_beam"
)
PACKAGES_SHOWN = (
    "python",
    "numpy",
    "scipy",
    "sympy",
    "matplotlib",
    "compiler",
    "kernels",
)  # of `flexel info`
PEERS = ("exudyn", "symbrim", "pin", "mujoco", "bicycleparameters")
FOLDER = Path("out/report")


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
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
    """Write one HTML page about all checks, with the errors found.

    The page is written from the JSON files of the PARTs verify, reproduce, bench, campaign and sanitize in a folder;
    for a missing part it shows the command that makes it. `--run PART...` makes parts first.

    Exit status 1 if the page shows a failure, or a part could not be made; 130 after Ctrl-C.
    """
    chosen = _chosen(parts, run_them)
    problems: list[str] = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for part in chosen:
            problems += _make(part, folder, ReportOptions(rows.split(), models, seed))
        target, found = _write(folder, out)
    except FlexelError as error:
        raise click.ClickException(str(error)) from error
    except KeyboardInterrupt:
        click.echo(f"\ninterrupted; what was made before is in {folder}", err=True)
        raise SystemExit(INTERRUPTED) from None
    _conclude(target, found, problems)


def _chosen(parts: Sequence[str], run_them: bool) -> list[str]:
    """Return the parts to make, in the order of the page."""
    unknown = [part for part in parts if part not in NAMES and part != "all"]
    if unknown:
        raise click.UsageError(f"no part named '{unknown[0]}'; there are: {', '.join(NAMES)}, all.")
    if bool(parts) != run_them:
        raise click.UsageError("write --run and the parts to make, as in: --run verify reproduce")
    return [name for name in NAMES if name in parts or "all" in parts]


def _make(part: str, folder: Path, request: ReportOptions) -> list[str]:
    """Make one part; return its problems."""
    click.echo(f"{part} ...", err=True)
    problem = make(part, folder, request, _facts())
    return [problem] if problem else []


def _write(folder: Path, out: Path | None) -> tuple[Path, list[PageSection]]:
    """Write the page; return its path and its sections."""
    parts = read_parts(files_in(folder))
    names = [*ELEMENTS, *(f"law {law}" for law in LAWS)]
    found = sections(parts, names, list(CASES))
    target = out or folder.with_suffix(".html")
    write(target, page(found, version(), f"{datetime.now(UTC):%Y-%m-%d %H:%M} UTC", parts.made))
    return target, found


def _facts() -> dict[str, str]:
    """Return facts about the machine and its software, without paths of the user's."""
    known = dict(facts())
    shown = {
        name: known[name]
        for name in (*PACKAGES_SHOWN, *PEERS)
        if known.get(name, "not installed") != "not installed"
    }
    return {"machine": processor(), **shown}


def _conclude(target: Path, found: Sequence[PageSection], problems: Sequence[str]) -> None:
    """Summarize the page; exit with status 1 if it shows a failure."""
    for section in found:
        for sentence in section.missing:
            click.echo(f"missing: {sentence}", err=True)
    click.echo(f"wrote {target}")
    failures = [f"{section.title}: {one}" for section in found for one in section.failures] + list(problems)
    if failures:
        raise click.ClickException("failed: " + "; ".join(failures))


if __name__ == "__main__":
    report()
