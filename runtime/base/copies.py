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
    """Base of dataclasses that are pickled and copied as their fields; cached values are computed again."""

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields alone."""
        return {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]


class Constant(Portable):
    """Base of records that never change: a copy, deep or not, is the record itself."""

    def __copy__(self) -> Self:
        """Return the record itself."""
        return self

    def __deepcopy__(self, _: object) -> Self:
        """Return the record itself."""
        return self


class _Trial(pickle.Pickler):
    """Tests a function alone: the flexel objects it refers to may refer back to it, and are tested separately."""

    def persistent_id(self, obj: Any) -> str | None:
        """Return a name in place of a flexel object."""
        return "flexel" if type(obj).__module__.startswith("flexel.") else None


def can_travel(value: object) -> bool:
    """Whether a value can be pickled by the pickler at work."""
    plain = value is None or isinstance(value, (bool, int, float, str))
    return plain or _obstacle(value) is None or _by_value()


def check_travels(owner: str, function: object, remedy: str = REMEDY) -> None:
    """Check that a user's function can be pickled; a ModelError that names its owner otherwise.

    A pickler that writes functions by value instead of by name, such as that of joblib, is not checked.
    """
    error = _obstacle(function)
    if isinstance(error, FlexelError):
        raise error
    if error is not None and not _by_value():
        raise ModelError(
            f"{owner}: {function!r} cannot be pickled and sent to another process ({error}); {remedy}"
        ) from error


def _obstacle(value: object) -> Exception | None:
    """Return what pickling a value alone raises; None if it can be pickled."""
    try:
        _Trial(io.BytesIO()).dump(value)
    except Exception as error:  # objects of the user may raise anything
        return error
    return None


def _by_value() -> bool:
    """Whether the current pickler writes functions by value, judged by the modules on the call stack."""
    frame = sys._getframe().f_back
    while frame is not None:
        if str(frame.f_globals.get("__name__")).rpartition(".")[2] == "cloudpickle":
            return True
        frame = frame.f_back
    return False
