"""Declarations of a model that are taken back as a whole when a part of them is refused.

What lays a hundred elements must not leave fifty behind: the corrected call would find their names taken.
Imports nothing of flexel.
"""

from __future__ import annotations

from collections.abc import Callable
from copy import copy
from functools import wraps
from typing import Any, TypeVar, cast

Declaration = TypeVar("Declaration", bound=Callable[..., Any])


def whole_or_nothing(declare: Declaration) -> Declaration:
    """A method of `Model` that leaves the model as it was if it raises."""

    @wraps(declare)
    def guarded(model: Any, *args: Any, **options: Any) -> Any:
        before = {name: copy(z) for name, z in vars(model).items() if isinstance(z, (dict, list))}
        try:
            return declare(model, *args, **options)
        except Exception:
            vars(model).update(before)
            raise

    return cast(Declaration, guarded)
