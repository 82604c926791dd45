"""`flexel convert MODEL.dat MODEL.py`."""

from __future__ import annotations

from pathlib import Path

import click

FILE = click.Path(exists=True, dir_okay=False, path_type=Path)
DIALECT = click.option(
    "--dialect",
    type=click.Choice(["delft", "twente"]),
    help="Dialect of the file; recognized by its keywords if not given.",
)


@click.command()
@click.argument("file", type=FILE, metavar="MODEL.dat")
@click.argument("target", type=click.Path(dir_okay=False, path_type=Path), metavar="MODEL.py")
@DIALECT
def convert(file: Path, target: Path, dialect: str | None) -> None:
    """Write the SPACAR input file MODEL.dat as a readable Python program, which gives the same results.

    An existing MODEL.py is not overwritten.
    """
    from flexel.base.errors import FlexelError
    from flexel.spacar.convert import convert_spacar

    try:
        click.echo(f"wrote {convert_spacar(file, target, dialect)}")
    except FlexelError as error:
        raise click.ClickException(str(error)) from error
