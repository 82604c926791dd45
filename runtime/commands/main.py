"""The command line: the table of the commands of `flexel`, each in a module of `flexel.commands`.

A command imports its modules when it runs, so that ``flexel --help`` is quick and ``flexel derive`` works without
compiled kernels.
"""

import sys
from typing import Any

import click

import flexel
from flexel.commands.bench import bench
from flexel.commands.check import check
from flexel.commands.convert import convert
from flexel.commands.derive import derive
from flexel.commands.info import info
from flexel.commands.report import report
from flexel.commands.reproduce import reproduce
from flexel.commands.run import run
from flexel.commands.sweep import sweep
from flexel.commands.verify import verify
from flexel.commands.view import view


class Commands(click.Group):
    """Reports a path that cannot be read or written in one line."""

    def invoke(self, ctx: click.Context) -> Any:
        """Run the requested command."""
        try:
            return super().invoke(ctx)
        except OSError as error:
            if error.filename is None:  # such as a closed pipe, which click handles
                raise
            raise click.ClickException(f"{error.filename}: {error.strerror}; give another path") from error


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(flexel.__version__, prog_name="flexel")
def main() -> None:
    """A compiler for mechanisms: derive, compile, run."""


for command in (derive, verify, reproduce, bench, report, run, check, sweep, convert, view, info):
    main.add_command(command)


if __name__ == "__main__":
    sys.exit(main())
