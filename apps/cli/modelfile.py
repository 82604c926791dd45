"""Reads a user's model: a saved one, or a Python program that declares it or does everything itself in ``main(out)``.

A Python file is run as a program whose ``__name__`` is that of the file, so code under
``if __name__ == "__main__":`` runs only with ``python MODEL.py``.  Of the names it defines, these are used:

- ``main(out)``, if there is one: called with the folder for results. A Motion that it returns is saved.
- otherwise the `flexel.Model` called ``model`` or ``m``, or the only one there is,
- with ``simulate``, a dict of the options of `System.simulate`, such as ``{"duration": 2.0, "samples": 401}``.
"""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from flexel.derive.users_file import folder_first

if TYPE_CHECKING:
    from flexel.parts.model import Model


def saved_model(path: Path) -> Model:
    """Load a model saved as JSON; the modules that it names may be in the folder of the file."""
    from flexel.base.errors import FlexelError
    from flexel.parts.model import Model
    from flexel.parts.model_file import read_parts

    try:
        with folder_first(path):
            return Model.of(*read_parts(path))
    except FlexelError as error:
        raise click.ClickException(str(error)) from error


def model_in(names: Mapping[str, Any], path: Path) -> Model:
    """Return the model defined by a file."""
    from flexel.parts.model import Model

    models = {name: value for name, value in names.items() if isinstance(value, Model)}
    for name in ("model", "m"):
        if name in models:
            return models[name]
    different = {id(value): value for value in models.values()}
    if len(different) == 1:
        return next(iter(different.values()))
    if models:
        raise click.ClickException(f"{path}: several models, {', '.join(models)}; name one of them model")
    raise click.ClickException(f"{path}: neither a fx.Model nor a function main(out); define one of them")


def options_in(names: Mapping[str, Any], path: Path) -> dict[str, Any]:
    """Return the options of `System.simulate` given in a file."""
    options = names.get("simulate", {})
    if not isinstance(options, Mapping) or not all(isinstance(name, str) for name in options):
        raise click.ClickException(
            f"{path}: simulate is {options!r}; make it a dict of options such as {{'duration': 2.0}}"
        )
    from flexel.base.arguments import unknown
    from flexel.results.analyses.motions import simulate

    known = [name for name in inspect.signature(simulate).parameters if name != "system"]
    if wrong := [name for name in options if name not in known]:
        raise click.ClickException(f"{path}: simulate: {unknown(wrong[0], known, 'option')}")
    return dict(options)
