"""`flexel view`: a saved result as a page for the browser."""

from __future__ import annotations

from pathlib import Path

import click


@click.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path), metavar="RESULT")
@click.option(
    "--out",
    type=click.Path(dir_okay=False, writable=True, path_type=Path),
    metavar="FILE.html",
    help="File of the page; beside the result by default.",
)
@click.option("--title", default="", help="Written above the picture; the name of the result by default.")
@click.option("--open", "open_it", is_flag=True, help="Open the page in a browser.")
def view(file: Path, out: Path | None, title: str, open_it: bool) -> None:
    """Write a page that shows a saved RESULT (.npz, .nc, .mat, .csv, or SPACAR's .sbd) in any browser, offline.

    A motion or periodic motion is played; for a linearization the modes are shown. Nothing in the file is executed.
    """
    from flexel.base.errors import FlexelError
    from flexel.results.saved.loading import load
    from flexel.results.saved.spacar_records import SpacarRecords

    try:
        result = load(file)
        if isinstance(result, SpacarRecords):
            raise click.UsageError(f"{file} holds matrices, without nodes to draw; give the .sbd file.")
        path = result.view(out or file.with_suffix(".html"), title=title or file.stem)
    except FlexelError as error:
        raise click.ClickException(str(error)) from error
    click.echo(f"wrote {path}")
    if open_it:
        click.launch(path.resolve().as_uri())
