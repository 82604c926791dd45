"""The command line: the table of the commands of `flexel`, each in a room of `flexel.commands`.

A command imports what it needs when it runs, so that ``flexel --help`` is quick and ``flexel derive`` works without
compiled kernels.
"""

import sys

import click

import flexel
from flexel.commands.convert import convert
from flexel.commands.derive import derive
from flexel.commands.info import info
from flexel.commands.reproduce import reproduce
from flexel.commands.run import run
from flexel.commands.verify import verify
from flexel.commands.view import view


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(flexel.__version__, prog_name="flexel")
def main() -> None:
    """A compiler for mechanisms: derive, compile, run."""


for command in (derive, verify, reproduce, run, convert, view, info):
    main.add_command(command)


if __name__ == "__main__":
    sys.exit(main())
