"""The command line: the table of the commands of `flexel`, each in a module of `flexel.commands`.

A command imports its modules when it runs, so that ``flexel --help`` is quick and ``flexel derive`` works without
compiled kernels.
"""

import logging
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
@click.option("-v", "--verbose", count=True, help="Show what is done, on stderr; -vv in every step.")
@click.pass_context
def main(ctx: click.Context, verbose: int) -> None:
    """A compiler for mechanisms: derive, compile, run."""
    if verbose:
        _show_records(ctx, logging.DEBUG if verbose > 1 else logging.INFO)


def _show_records(ctx: click.Context, level: int) -> None:
    """Write the records of the library to stderr until the command ends."""
    handler, log = logging.StreamHandler(), logging.getLogger("flexel")
    handler.setFormatter(logging.Formatter("%(name)s: %(message)s"))
    before = log.level
    log.addHandler(handler)
    log.setLevel(level)

    def end() -> None:
        log.removeHandler(handler)
        log.setLevel(before)

    ctx.call_on_close(end)


for command in (derive, verify, reproduce, bench, report, run, check, sweep, convert, view, info):
    main.add_command(command)


if __name__ == "__main__":
    sys.exit(main())
