"""Declarations of a model that are undone as a whole when a part of them is refused.

A refused call must not leave some of its elements behind: the corrected call would find their names taken.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar, cast

Declaration = TypeVar("Declaration", bound=Callable[..., Any])


def whole_or_nothing(declare: Declaration) -> Declaration:
    """A method of `Model` that adds names and laws, or raises and leaves the model unchanged."""

    @wraps(declare)
    def guarded(model: Any, *args: Any, **options: Any) -> Any:
        before = {name: len(z) for name, z in vars(model).items() if isinstance(z, (dict, list))}
        try:
            return declare(model, *args, **options)
        except Exception:
            for name, count in before.items():
                _shorten(getattr(model, name), count)
            raise

    return cast(Declaration, guarded)


def _shorten(kept: dict[str, Any] | list[Any], count: int) -> None:
    """Remove the latest entries until `count` remain."""
    while len(kept) > count:
        if isinstance(kept, dict):
            kept.popitem()
        else:
            kept.pop()
