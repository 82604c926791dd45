"""A user's model file: a Python program that declares a model, or does everything itself in ``main(out)``.

The file is run as a program whose ``__name__`` is the file's own, so code under
``if __name__ == "__main__":`` runs only with ``python MODEL.py``.  Of the names that it defines, these are used:

- ``main(out)``, if there is one: called with the folder for results. A Motion that it returns is saved.
- otherwise the `flexel.Model` called ``model`` or ``m``, or the only one there is,
- with ``simulate``, a dict of the options of `System.simulate`, such as ``{"duration": 2.0, "samples": 401}``.
"""

from __future__ import annotations

import runpy
import sys
import traceback
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from flexel.model import Model


@contextmanager
def reported_by_line(path: Path) -> Iterator[None]:
    """End the command with one line that names the line of the user's file, whatever it raises."""
    from flexel.base.errors import FlexelError

    try:
        yield
    except click.ClickException:
        raise
    except SyntaxError as error:
        place = f"{error.filename or path}" + (f", line {error.lineno}" if error.lineno else "")
        raise click.ClickException(f"{place}: {error.msg}") from error
    except Exception as error:  # a user's file may raise anything
        own = [z.lineno for z in traceback.extract_tb(error.__traceback__) if z.filename == str(path)]
        place = f"{path}, line {own[-1]}" if own else str(path)
        kind = "" if isinstance(error, FlexelError) else f"{type(error).__name__}: "
        raise click.ClickException(f"{place}: {kind}{error}") from error


def names_of(path: Path) -> Mapping[str, Any]:
    """Run a Python file, as Python does with its folder first on the path; returns the names that it defines."""
    before = list(sys.path)
    sys.path.insert(0, str(path.parent.resolve()))
    try:
        with reported_by_line(path):
            return runpy.run_path(str(path), run_name=path.stem)
    finally:
        sys.path[:] = before


def model_in(names: Mapping[str, Any], path: Path) -> Model:
    """The model defined by a file."""
    from flexel.model import Model

    models = {name: value for name, value in names.items() if isinstance(value, Model)}
    for name in ("model", "m"):
        if name in models:
            return models[name]
    different = {id(value): value for value in models.values()}
    if len(different) == 1:
        return next(iter(different.values()))
    if models:
        raise click.ClickException(f"{path}: several models, {', '.join(models)}; call one of them model")
    raise click.ClickException(f"{path}: neither a fx.Model nor a function main(out); define one of them")


def options_in(names: Mapping[str, Any], path: Path) -> dict[str, Any]:
    """Options of `System.simulate` given in a file."""
    options = names.get("simulate", {})
    if not isinstance(options, Mapping) or not all(isinstance(name, str) for name in options):
        raise click.ClickException(
            f"{path}: simulate is {options!r}; make it a dict of options such as {{'duration': 2.0}}"
        )
    return dict(options)
