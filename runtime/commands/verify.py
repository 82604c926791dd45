"""`flexel verify`: the compiled kernels against independently computed derivatives. It imports `flexel.derive`."""

import click

from flexel.commands.derive import PASSED_ON


@click.command(context_settings=PASSED_ON, short_help="Check every compiled kernel's derivatives.")
@click.argument("arguments", nargs=-1, type=click.UNPROCESSED)
def verify(arguments: tuple[str, ...]) -> None:
    """Pass everything on to flexel.derive.verify, whose help is shown by `flexel verify --help`."""
    from flexel.derive.verify import main as command

    command.main(args=list(arguments), prog_name="flexel verify")
