"""Implements `flexel verify`: checks the compiled kernels against independently computed derivatives."""

import click

from flexel.apps.cli.derive import PASSED_ON


@click.command(context_settings=PASSED_ON, short_help="Check every compiled kernel's derivatives.")
@click.argument("arguments", nargs=-1, type=click.UNPROCESSED)
def verify(arguments: tuple[str, ...]) -> None:
    """Pass all arguments to flexel.derive.verify_command, whose help is shown by `flexel verify --help`."""
    from flexel.derive.verify_command import main as command

    command.main(args=list(arguments), prog_name="flexel verify")
