"""Whether the rates of a prescribed motion that the user gives are those of its values."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.time_functions import Foreign, TimeFunction, Triple
from flexel.mechanics.core import Core

# Parts of a motion, evenly spread, on no round number.
PLACES: Array = np.asarray((np.arange(7) + 0.5) * 0.6180339887498949 % 1)
STEP = 1e-5  # of the differences, relative to the duration
ERROR = 0.1  # of a rate, relative to the largest, that is accepted: values may be interpolated in a table
ROUNDING = 1e-14
FEWEST = 2  # times at which a rate is wrong: it may jump near one
RATES = ("rate u'", "second rate u''")


def check_rates(system: Core, begin: float, end: float) -> None:
    """Compare the rates of prescribed motions with differences of their values at some times of a motion [s].

    Raises
    ------
    ModelError
        If a rate differs from the differences at two times or more; names the quantity.
    """
    roles, names = system.roles, system.structure.names
    for place, function in zip(roles.prescribed, roles.motions, strict=True):
        if isinstance(function, Triple | Foreign) and end > begin:
            _check(names[place], function, begin, end - begin)


def _check(name: str, function: TimeFunction, begin: float, duration: float) -> None:
    """Check one function; differences that do not settle say nothing."""
    times, h = begin + duration * PLACES, STEP * duration
    there, near, far = _values(function, times), _slopes(function, times, h / 2), _slopes(function, times, h)
    for i, rate in enumerate(RATES):
        given, found = there[:, i + 1], near[:, i]
        size = max(np.abs(given).max(), np.abs(found).max())
        unsure = 10 * np.abs(found - far[:, i]) + ROUNDING * np.abs(there[:, i]).max() / h
        off = np.abs(given - found) - unsure
        if np.count_nonzero(off > ERROR * size) >= FEWEST:
            k = int(np.argmax(off))
            raise ModelError(
                f"'{name}': the {rate} of its prescribed motion is {given[k]:.6g} at t = {times[k]:.6g} s, but "
                f"differences give {found[k]:.6g}; correct the triple (u, u', u''), or give u alone"
            )


def _values(function: TimeFunction, times: Array) -> Array:
    """Value, first and second rate at each time (nt, 3)."""
    return np.array([function.rates(float(t)) for t in times])


def _slopes(function: TimeFunction, times: Array, h: float) -> Array:
    """Central differences of them."""
    return (_values(function, times + h) - _values(function, times - h)) / (2 * h)
