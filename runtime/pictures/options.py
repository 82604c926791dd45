"""Options that a method passes on to a picture, checked by name where the user gives them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from inspect import Parameter, signature
from typing import Any

from flexel.base.arguments import unknown
from flexel.base.errors import ModelError
from flexel.pictures.scene import View

OWN = ("path", "modes")  # parameters that the methods have themselves


def checked(owner: str, picture: Callable[..., Any], options: Mapping[str, Any]) -> dict[str, Any]:
    """The options, all of which the function that makes the picture takes.

    Raises
    ------
    ModelError
        An option of `View` beside `view`, or an unknown one, with the nearest names.
    """
    known = [
        z.name
        for z in signature(picture).parameters.values()
        if z.default is not Parameter.empty and z.name not in OWN
    ]
    for wrong in (z for z in options if z not in known):
        if "view" in known and wrong in {z.name for z in fields(View)}:
            raise ModelError(f"{owner}: '{wrong}' is an option of View; write view=fx.View({wrong}=…)")
        raise ModelError(f"{owner}: {unknown(wrong, known, 'option')}")
    return dict(options)
