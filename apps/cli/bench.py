"""Implements `flexel bench`: the command, its options and all that it measures are in tools/bench of the sources."""

import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import click

import flexel


class OfTheSources(click.Command):
    """Stands for the command of the sources, which reads the arguments and runs."""

    def make_context(
        self, info_name: str | None, args: list[str], parent: click.Context | None = None, **extra: Any
    ) -> click.Context:
        """Return the context of that command: click runs the command that a context belongs to."""
        return _command().make_context(info_name, args, parent, **extra)


def _command() -> click.Command:
    """Import the command from the checkout in which flexel is installed."""
    tools = Path(flexel.__file__).parents[1] / "tools"
    if not (tools / "bench" / "command.py").is_file():
        raise click.ClickException(
            "the benchmarks come with the sources of flexel, not with this installation; run `make bench` in a checkout"
        )
    if str(tools) not in sys.path:
        sys.path.insert(0, str(tools))
    command: click.Command = import_module("bench.command").bench
    return command


bench = OfTheSources("bench", help="Measure computing times next to those of other programs (in a checkout).")
