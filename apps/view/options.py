"""Options of pictures: their names and types, and checks of what is given for them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields
from inspect import Parameter, signature
from typing import TYPE_CHECKING, Any, TypedDict

from flexel.apps.view.scene import View
from flexel.base.arguments import unknown, vector
from flexel.base.errors import ModelError

if TYPE_CHECKING:
    from flexel.integration.trajectory import Trajectory


class MotionOptions(TypedDict, total=False):
    """Options of a page that shows a motion; see `flexel.apps.view.page.scene_data`."""

    frames: int
    between: tuple[float, float] | None
    view: View | None
    title: str
    caption: str
    plots: Sequence[str] | None
    slower: float | None
    progress: bool | None


class ModeOptions(TypedDict, total=False):
    """Options of a page that shows modes; see `flexel.apps.view.page.mode_data`."""

    modes: Sequence[Any] | None
    view: View | None
    title: str
    caption: str


METHOD_PARAMETERS = ("path", "modes")  # parameters that belong to the methods


def checked(owner: str, picture: Callable[..., Any], options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options, all of which the function that makes the picture accepts.

    Raises
    ------
    ModelError
        An option of `View` given alongside `view`, or an unknown one, with the nearest names.
    """
    known = [
        option.name
        for option in signature(picture).parameters.values()
        if option.default is not Parameter.empty and option.name not in METHOD_PARAMETERS
    ]
    for wrong in (option for option in options if option not in known):
        if "view" in known and wrong in {field.name for field in fields(View)}:
            raise ModelError(f"{owner}: '{wrong}' is an option of View; write view=fx.View({wrong}=…)")
        raise ModelError(f"{owner}: {unknown(wrong, known, 'option')}")
    return dict(options)


def span_of(motion: Trajectory, between: Sequence[float] | None, owner: str) -> tuple[float, float]:
    """Return the times of the part of a motion to show [s], all of it by default.

    Raises
    ------
    ModelError
        Not two numbers, or the end before the start.
    """
    if between is None:
        return float(motion.t[0]), float(motion.t[-1])
    start, end = vector(between, owner, "between", 2).tolist()
    if start > end:
        raise ModelError(f"{owner}: between ends at {end:g} s before its start at {start:g} s; exchange them")
    return start, end
