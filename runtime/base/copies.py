"""Contents of pickles: the fields of a record without its caches, and functions that the receiver can import."""

from __future__ import annotations

import io
import pickle
import sys
from dataclasses import fields
from typing import Any, Self

from flexel.base.errors import FlexelError, ModelError

REMEDY = "use a function defined in a module"
OF_TIME = f"{REMEDY}, or one of flexel's functions of time (fx.Polynomial, fx.Ramp, fx.Harmonic, fx.Table)"


class Portable:
    """Base of dataclasses that are pickled and copied as their fields: cached values are computed again."""

    def __getstate__(self) -> dict[str, Any]:
        """The fields alone."""
        return {z.name: getattr(self, z.name) for z in fields(self)}  # type: ignore[arg-type]


class Constant(Portable):
    """Base of records that never change: a copy, deep or not, is the record itself."""

    def __copy__(self) -> Self:
        """The record itself."""
        return self

    def __deepcopy__(self, _: object) -> Self:
        """The record itself."""
        return self


class _Trial(pickle.Pickler):
    """Tries a function alone: objects of flexel to which it refers may refer back to it, and are tried themselves."""

    def persistent_id(self, obj: Any) -> str | None:
        """A name instead of an object of flexel."""
        return "flexel" if type(obj).__module__.startswith("flexel.") else None


def check_travels(owner: str, function: object, remedy: str = REMEDY) -> None:
    """Check that a user's function can be pickled; a ModelError that names its owner otherwise.

    A pickler that writes functions by value instead of by name, such as that of joblib, is not checked.
    """
    try:
        _Trial(io.BytesIO()).dump(function)
    except FlexelError:
        raise
    except Exception as error:  # objects of the user may raise anything
        if _by_value():
            return
        raise ModelError(
            f"{owner}: {function!r} cannot be pickled, and so not sent to another process ({error}); {remedy}"
        ) from error


def _by_value() -> bool:
    """Whether the pickler at work is one that writes functions by value: seen from the modules that are calling."""
    frame = sys._getframe().f_back
    while frame is not None:
        if str(frame.f_globals.get("__name__")).rpartition(".")[2] == "cloudpickle":
            return True
        frame = frame.f_back
    return False
