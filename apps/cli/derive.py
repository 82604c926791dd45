"""Implements `flexel derive`: writes or checks the C of elements and laws. `flexel.derive` is imported when it runs."""

import click

PASSED_ON = {"ignore_unknown_options": True, "help_option_names": []}


@click.command(context_settings=PASSED_ON, short_help="Write the C code of elements, or of your own page.")
@click.argument("arguments", nargs=-1, type=click.UNPROCESSED)
def derive(arguments: tuple[str, ...]) -> None:
    """Pass all arguments to flexel.derive, whose help is shown by `flexel derive --help`."""
    from flexel.derive.__main__ import main as command

    command.main(args=list(arguments), prog_name="flexel derive")
