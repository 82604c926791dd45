"""`flexel run MODEL.dat` and `flexel convert MODEL.dat MODEL.py`.

Imports click; the reading of files only when a command runs.
"""

from __future__ import annotations

from pathlib import Path

import click

FILE = click.Path(exists=True, dir_okay=False, path_type=Path)
DIALECT = click.option(
    "--dialect",
    type=click.Choice(["delft", "twente"]),
    help="Of the file; recognized by its keywords if not given.",
)


@click.command()
@click.argument("file", type=FILE, metavar="MODEL.dat")
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="DIR",
    help="Folder for results (.npz, time histories as .csv), made if missing; without it none are written.",
)
@click.option(
    "--mode",
    type=int,
    metavar="N",
    help="SPACAR's mode of analysis: 1 motion, 2 its forces, 4 linearization along it, 7 equilibrium, frequencies "
    "and buckling, 8 and 9 state space in equilibrium and along the motion, 10 load steps.",
)
@DIALECT
def run(file: Path, out: Path | None, mode: int | None, dialect: str | None) -> None:
    """Run the SPACAR input file MODEL.dat and print its results in SPACAR's numbering and signs.

    The file is read as data and never executed. Without --mode a file with TIMESTEP is simulated, one with load steps
    takes these on, and for any other the equilibrium, its frequencies and its buckling loads are found.
    """
    if file.suffix.lower() != ".dat":
        raise click.UsageError(
            f"{file}: suffix '{file.suffix}' is unknown; give MODEL.dat, a SPACAR input file."
        )
    from flexel.errors import FlexelError
    from flexel.spacar.run import run_spacar

    try:
        click.echo(run_spacar(file, out, mode=mode, dialect=dialect))
    except FlexelError as error:
        raise click.ClickException(str(error)) from error


@click.command()
@click.argument("file", type=FILE, metavar="MODEL.dat")
@click.argument("target", type=click.Path(dir_okay=False, path_type=Path), metavar="MODEL.py")
@DIALECT
def convert(file: Path, target: Path, dialect: str | None) -> None:
    """Write the SPACAR input file MODEL.dat as a readable Python program, which gives the same results.

    An existing MODEL.py is not overwritten.
    """
    from flexel.errors import FlexelError
    from flexel.spacar.convert import convert_spacar

    try:
        click.echo(f"wrote {convert_spacar(file, target, dialect)}")
    except FlexelError as error:
        raise click.ClickException(str(error)) from error
