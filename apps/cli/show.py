"""Implements `flexel show`: prints definitions and what is derived from them."""

import click

from flexel.apps.cli.derive import PASSED_ON


@click.command(
    context_settings=PASSED_ON, short_help="Print a definition, its symbols, C code, and formulas in LaTeX."
)
@click.argument("arguments", nargs=-1, type=click.UNPROCESSED)
def show(arguments: tuple[str, ...]) -> None:
    """Pass all arguments to flexel.derive.show_command, whose help is shown by `flexel show --help`."""
    from flexel.derive.show_command import main as command

    command.main(args=list(arguments), prog_name="flexel show")
