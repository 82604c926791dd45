"""Implements `flexel view`: shows a saved result as a page for the browser."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from flexel.results.motion import Motion


@click.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path), metavar="RESULT")
@click.option(
    "--out",
    type=click.Path(dir_okay=False, writable=True, path_type=Path),
    metavar="FILE.html",
    help="File of the page; next to the result by default.",
)
@click.option("--title", default="", help="Title above the picture; the name of the result by default.")
@click.option("--open", "open_it", is_flag=True, help="Open the page in a browser.")
def view(file: Path, out: Path | None, title: str, open_it: bool) -> None:
    """Write a page that shows a saved RESULT (.npz, .nc, .mat, .csv, or SPACAR's .sbd) in any browser, offline.

    A motion or periodic motion is played; a linearization is shown by its modes, a model (.json) by its initial state.
    Nothing in a result is executed; for a model, the modules of functions that it names are imported.
    """
    from flexel.base.errors import FlexelError
    from flexel.results.saved.loading import load_result
    from flexel.results.saved.spacar_records import SpacarRecords

    try:
        result = _start_of(file) if file.suffix.lower() == ".json" else load_result(file)
        if isinstance(result, SpacarRecords):
            raise click.UsageError(f"{file} contains matrices but no nodes to draw; give the .sbd file.")
        path = result.view(out or file.with_suffix(".html"), title=title or file.stem)
    except FlexelError as error:
        raise click.ClickException(str(error)) from error
    click.echo(f"wrote {path}")
    if open_it:
        click.launch(path.resolve().as_uri())


def _start_of(file: Path) -> Motion:
    """Build a saved model; return a motion of its initial state alone."""
    from flexel.apps.cli.modelfile import saved_model
    from flexel.integration.outcome import Integration, States
    from flexel.results.motion import Motion

    system = saved_model(file).build()
    return Motion(system, Integration(States([system.initial]), [], [], {}, "initial state"))
