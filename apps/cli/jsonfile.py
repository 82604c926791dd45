"""Checks the options that name a file to write."""

from collections.abc import Container
from pathlib import Path

import click


def check_json_file(file: str | None, names: Container[str], kind: str, option: str = "--json") -> None:
    """Reject a file that could not be written at the end, or that is one of the names to work on.

    Raises
    ------
    click.UsageError
        With the remedy.
    """
    if file is None:
        return
    if file in names:
        raise click.UsageError(f"{option} {file}: that is a {kind}, not a file; write names before {option}.")
    if not Path(file).absolute().parent.is_dir():
        raise click.UsageError(
            f"{option} {file}: the folder does not exist; create it, or give another path."
        )
