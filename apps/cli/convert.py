"""Implements `flexel convert MODEL.dat MODEL.py`."""

from __future__ import annotations

from pathlib import Path

import click

from flexel.apps.spacar.keywords import DIALECTS

FILE = click.Path(exists=True, dir_okay=False, path_type=Path)
DIALECT = click.option(
    "--dialect",
    type=click.Choice(DIALECTS),
    help="Dialect of the file; recognized by its keywords if not given.",
)


@click.command()
@click.argument("file", type=FILE, metavar="MODEL.dat")
@click.argument("target", type=click.Path(dir_okay=False, path_type=Path), metavar="MODEL.py")
@DIALECT
def convert(file: Path, target: Path, dialect: str | None) -> None:
    """Write the SPACAR input file MODEL.dat as a readable Python program that gives the same results.

    An existing MODEL.py is not overwritten.
    """
    from flexel.apps.spacar.python_program import convert_spacar
    from flexel.base.errors import FlexelError

    try:
        click.echo(f"wrote {convert_spacar(file, target, dialect)}")
    except FlexelError as error:
        raise click.ClickException(str(error)) from error
