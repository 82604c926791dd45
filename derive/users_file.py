"""Runs a user's Python file, and reports any error with the line of the file; without SymPy."""

import runpy
import sys
import traceback
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from flexel.derive.definition_errors import FlexelError


@contextmanager
def reported_by_line(path: Path) -> Iterator[None]:
    """End the command with a message that names the line of the user's file, whatever the file raises."""
    try:
        yield
    except click.ClickException:
        raise
    except SyntaxError as error:
        place = f"{error.filename or path}" + (f", line {error.lineno}" if error.lineno else "")
        raise click.ClickException(f"{place}: {error.msg}") from error
    except Exception as error:  # a user's file may raise anything
        own = [
            frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)
        ]
        place = f"{path}, line {own[-1]}" if own else str(path)
        kind = "" if isinstance(error, FlexelError) else f"{type(error).__name__}: "
        raise click.ClickException(f"{place}: {kind}{error}") from error


def names_of(path: Path) -> Mapping[str, Any]:
    """Run a Python file as Python does, with its folder first on the path; return the names it defines."""
    with folder_first(path), reported_by_line(path):
        return runpy.run_path(str(path), run_name=path.stem)


@contextmanager
def folder_first(path: Path) -> Iterator[None]:
    """Put the folder of a file first on Python's path."""
    before = list(sys.path)
    sys.path.insert(0, str(path.parent.resolve()))
    try:
        yield
    finally:
        sys.path[:] = before
