"""Implements `flexel sweep`: builds and analyses the model in a user's file at many points."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from flexel.apps.cli.stop import INTERRUPTED
from flexel.derive.users_file import names_of, reported_by_line

if TYPE_CHECKING:
    from xarray import Dataset

NEEDED_NAMES = ("build", "analyse", "points")


@click.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path), metavar="FILE")
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="DIR",
    help="Folder for the results, created if missing; out/FILE by default.",
)
@click.option(
    "--workers", type=click.IntRange(min=1), metavar="N", help="Number of processes; all by default."
)
@click.option("--scheduler", metavar="ADDRESS", help="Compute on the dask cluster with this address.")
@click.option("--retry", is_flag=True, help="Recompute points that failed before.")
def sweep(file: Path, out: Path | None, workers: int | None, scheduler: str | None, retry: bool) -> None:
    """Build and analyse a model at many points, and keep the results in a folder.

    FILE is a Python program that defines build(**point), which returns a fx.Model; analyse(system), which returns a
    dict of numbers and arrays; and points: {"parameter": [values]} for all combinations, a list of points, or a sample.

    The same command continues a sweep that was interrupted in any way. fx.open_sweep(DIR) reads the folder.
    Exit status 1 if points failed, 130 after Ctrl-C.
    """
    names = names_of(file)
    missing = [name for name in NEEDED_NAMES if name not in names]
    if missing:
        raise click.ClickException(f"{file}: defines no {missing[0]}; define {', '.join(NEEDED_NAMES)}")
    place = out or Path("out") / file.stem
    with reported_by_line(file), _importing_from(file.parent), _executor(scheduler) as executor:
        data = _swept(names, place, executor, workers, retry)
    _report(data)
    click.echo(f"{data.attrs['message']}; results are in {place}")
    if data.attrs["message"].startswith("interrupted"):
        click.echo("the same command continues", err=True)
        raise SystemExit(INTERRUPTED)
    if (data["failed"] != "").any():
        raise SystemExit(1)


def _swept(names: Mapping[str, Any], place: Path, executor: Any, workers: int | None, retry: bool) -> Dataset:
    """Run the sweep and return the dataset, with failures in its message."""
    import flexel as fx

    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="sweep: ", category=fx.IncompleteWarning)
        return fx.sweep(
            names["build"],
            names["points"],
            names["analyse"],
            executor=executor,
            workers=workers,
            folder=place,
            retry_failed=retry,
        )


@contextmanager
def _importing_from(folder: Path) -> Iterator[None]:
    """Let workers start with the path of this process, so that they import modules next to the file as it did."""
    before = list(sys.path)
    sys.path.insert(0, str(folder.resolve()))
    try:
        yield
    finally:
        sys.path[:] = before


@contextmanager
def _executor(scheduler: str | None) -> Iterator[Any]:
    """Return a client of the cluster at that address; None without one."""
    if scheduler is None:
        yield None
        return
    from flexel.results.saved.record import require

    with require("distributed", "cluster").Client(scheduler) as client:
        yield client


def _report(data: Dataset) -> None:
    """Print the range of each result that is one real number at each point."""
    import numpy as np

    dims = data["failed"].dims
    for name, variable in data.data_vars.items():
        if variable.dims != dims or variable.dtype.kind != "f" or not np.isfinite(variable.values).any():
            continue
        low, middle, high = np.nanpercentile(variable.values, (0, 50, 100))
        click.echo(
            f"  {name:<24} {low: .6g} to {high:.6g}, median {middle:.6g} {variable.attrs.get('units', '')}".rstrip()
        )
