"""The command line: the commands of `flexel`, each in a module of `flexel.apps.cli`.

A command imports its modules when it runs, so that ``flexel --help`` is quick and ``flexel derive`` works without
compiled kernels.
"""

import logging
import sys
from typing import Any

import click

import flexel
from flexel.apps.cli.bench import bench
from flexel.apps.cli.check import check
from flexel.apps.cli.convert import convert
from flexel.apps.cli.derive import derive
from flexel.apps.cli.info import info
from flexel.apps.cli.reproduce import reproduce
from flexel.apps.cli.run import run
from flexel.apps.cli.show import show
from flexel.apps.cli.sweep import sweep
from flexel.apps.cli.verify import verify
from flexel.apps.cli.view import view


class Commands(click.Group):
    """Reports an unreadable or unwritable path in one line."""

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
@click.option("-v", "--verbose", count=True, help="Show what is being done, on stderr; with -vv, every step.")
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


for command in (derive, verify, show, reproduce, bench, run, check, sweep, convert, view, info):
    main.add_command(command)


if __name__ == "__main__":
    sys.exit(main())
