"""Functions of time with exact first and second rates.

A function of time is one of the classes below, a triple of functions, or a callable that takes a second-order
jet (value, rate, acceleration); operators and NumPy functions work on jets.  A callable that takes numbers only is
enough where no rates are needed, as for a load.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Protocol, TypeVar, runtime_checkable

import numpy as np

from flexel.base.arguments import MIN_POSITIVE, array, number
from flexel.base.arrays import Array
from flexel.base.copies import OF_TIME, Constant, check_travels
from flexel.base.errors import FlexelError, ModelError
from flexel.base.jets import Jet, as_jet
from flexel.base.meaning import described, in_unit
from flexel.base.nested import WITHIN
from flexel.base.switching import next_switch, on_switch
from flexel.base.time_tables import Table

Found = TypeVar("Found")
AFTER = 1e-14  # distance from a start at which a function is evaluated, relative to the time, or to a second
DIFFERENCE = 1e-6  # times between which a rate is a difference, relative to the time, or to a second


@runtime_checkable
class TimeFunction(Protocol):
    """Interface of anything that maps a time [s] to value, rate and acceleration."""

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t."""
        ...


@dataclass(frozen=True)
class TimeFormula(Constant):
    """A Python function of time, differentiated by second-order jets."""

    function: Callable[[Any], Any]
    owner: str = "function of time"

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields; raise a ModelError that names the owner if the function cannot be pickled."""
        check_travels(self.owner, self.function, OF_TIME)
        return super().__getstate__()

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t [s]."""
        y = self._called(
            Jet(t, 1.0, 0.0), t, ", using operators and NumPy functions; or give the triple (u, u', u'')"
        )
        return _finite((y.value, y.rate, y.acceleration), self.owner, t)

    def value(self, t: float) -> float:
        """Return the value at time t [s], for which the function may use anything that takes a number."""
        return _finite((self._called(t, t).value, 0.0, 0.0), self.owner, t)[0]

    def _called(self, argument: Any, t: float, remedy: str = "") -> Jet:
        """Call the function with a jet, or with a number, at time t [s]."""
        try:
            with WITHIN:
                return as_jet(self.function(argument))
        except FlexelError:
            raise
        except Exception as error:  # a user's function may raise anything
            raise ModelError(
                f"{self.owner}: the function failed at t = {t:g} s ({error}); it is called with one argument t and "
                f"must return one number{remedy}"
            ) from error

    def next_knot(self, t: float) -> float:
        """Return the first time after t [s] at which a comparison in the function is expected to change."""
        return self._watched(t, partial(next_switch, self.function, t), math.inf)

    def on_knot(self, t: float, within: float) -> bool:
        """Whether a comparison in the function changes within a given time [s] of t."""
        return self._watched(t, partial(on_switch, self.function, t, within), False)

    def _watched(self, t: float, look: Callable[[], Found], otherwise: Found) -> Found:
        """Look at the comparisons of the function at a time; a function that takes numbers only does not show them."""
        try:
            return look()
        except Exception:  # a user's function may raise anything, as `math.exp` does for a jet
            self.value(t)  # if it fails for a number, too, it is wrong
            return otherwise


@dataclass(frozen=True)
class Triple(Constant):
    """Value, first and second rate as three functions of time."""

    functions: tuple[Callable[[float], float], Callable[[float], float], Callable[[float], float]]
    owner: str = "function of time"

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields; raise a ModelError that names the owner if a function cannot be pickled."""
        for function in self.functions:
            check_travels(self.owner, function, OF_TIME)
        return super().__getstate__()

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t [s]."""
        u, ud, udd = self.functions
        try:
            with WITHIN:
                values = float(u(t)), float(ud(t)), float(udd(t))
        except FlexelError:
            raise
        except Exception as error:  # a user's function may raise anything
            raise self._failed(t, error) from error
        return _finite(values, self.owner, t)

    def value(self, t: float) -> float:
        """Return the value at time t [s], without its rates."""
        try:
            with WITHIN:
                value = float(self.functions[0](t))
        except FlexelError:
            raise
        except Exception as error:  # as above
            raise self._failed(t, error) from error
        return _finite((value, 0.0, 0.0), self.owner, t)[0]

    def _failed(self, t: float, error: Exception) -> ModelError:
        """Return the error of a function that has raised one."""
        return ModelError(
            f"{self.owner}: one of the functions (u, u', u'') failed at t = {t:g} s ({error}); each is called "
            "with one number t and must return one number"
        )


@dataclass(frozen=True)
class Foreign(Constant):
    """A function of time given as a user's object with a method `rates`."""

    function: TimeFunction
    owner: str

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields; raise a ModelError that names the owner if the object cannot be pickled."""
        check_travels(self.owner, self.function, OF_TIME)
        return super().__getstate__()

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t [s]."""
        with WITHIN:
            return self.function.rates(t)

    def next_knot(self, t: float) -> float:
        """Return the first knot after t reported by the object, if it has such a method."""
        return next_knot(self.function, t)

    def on_knot(self, t: float, within: float) -> bool:
        """Whether the object reports a knot within a given time [s] of t."""
        return next_knot(self.function, t - within) <= t + within


def _finite(values: tuple[float, float, float], owner: str, t: float) -> tuple[float, float, float]:
    if math.isfinite(values[0]) and math.isfinite(values[1]) and math.isfinite(values[2]):
        return values
    raise ModelError(
        f"{owner}: value, rate and acceleration at t = {t:g} s are {values}, but must be finite; correct the function"
    )


@dataclass
class Held:
    """A value that is set from outside, and is constant between settings."""

    value: float = 0.0

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t [s]."""
        return self.value, 0.0, 0.0


def next_knot(function: object, t: float) -> float:
    """Return the first time after t [s] at which a function is known not to be smooth; infinite if there is none."""
    following: Callable[[float], float] | None = getattr(function, "next_knot", None)
    return math.inf if following is None else following(t)


def on_knot(function: object, t: float, within: float) -> bool:
    """Whether a function of time is known not to be smooth within a given time [s] of t."""
    there: Callable[[float, float], bool] | None = getattr(function, "on_knot", None)
    return there is not None and there(t, within)


def just_after(functions: Iterable[object], t: float) -> float:
    """Return a time [s], or one just after it if a function is not smooth there: what a motion from there sees."""
    after = t + AFTER * max(abs(t), 1.0)
    return after if any(on_knot(f, t, after - t) for f in functions) else t


def value_of(function: TimeFunction, t: float) -> float:
    """Return the value of a function of time at time t [s]: of a Python function, without its rates."""
    if isinstance(function, TimeFormula | Triple | TimeScaled):
        return function.value(t)
    return function.rates(t)[0]


def rate_of(function: TimeFunction, t: float) -> float:
    """Return the rate of a function of time at time t [s]: by a difference where a Python function has none."""
    try:
        return function.rates(t)[1]
    except ModelError:
        h = DIFFERENCE * max(abs(t), 1.0)
        return (value_of(function, t + h) - value_of(function, t - h)) / (2 * h)


def sampled(function: TimeFunction, begin: float, end: float, many: int, few: int) -> Array:
    """Return the values of a function of time at many + 1 times [s], or few + 1 if it takes one time only.

    They are NaN where the function fails at one of them: it says so where a motion gets there.
    """
    plain = _plain(function)
    with WITHIN, np.errstate(all="ignore"):
        values = _of_all(plain, np.linspace(begin, end, many + 1))
        return _of_each(plain, np.linspace(begin, end, few + 1)) if values is None else values


def values_at(function: TimeFunction, times: Array) -> Array:
    """Return the values of a function of time at some times [s]; NaN where it fails at one of them."""
    plain = _plain(function)
    with WITHIN, np.errstate(all="ignore"):
        values = _of_all(plain, times)
        return _of_each(plain, times) if values is None else values


def rates_at(function: TimeFunction, times: Array) -> Array:
    """Return value, first and second rate of a function of time at some times [s] (nt, 3).

    A triple of Python functions is called with all times at once if each takes them.
    """
    if isinstance(function, Triple):
        with WITHIN, np.errstate(all="ignore"):
            columns = [_of_all(own, times) for own in function.functions]
        if all(column is not None and np.all(np.isfinite(column)) for column in columns):
            return np.column_stack(columns)  # type: ignore[arg-type]
    return np.array([function.rates(t) for t in times.tolist()]).reshape(-1, 3)


def _of_all(plain: Callable[[Any], Any], times: Array) -> Array | None:
    """Call a user's function with many times at once; None if it takes one only.

    A single time is no proof: float() takes an array of one number, with a warning of older versions of NumPy.
    """
    if times.size < 2:
        return None
    try:
        values = np.asarray(plain(times), dtype=float)
    except Exception:  # a user's function may raise anything for an array
        return None
    return values if values.shape == times.shape else None


def _of_each(plain: Callable[[Any], Any], times: Array) -> Array:
    """Call a user's function with one time after another; NaN if it fails at one of them."""
    try:
        return np.array([float(plain(t)) for t in times.tolist()])
    except Exception:  # a user's function may raise anything, and says so where a motion gets there
        return np.full(times.size, np.nan)


def _plain(function: TimeFunction) -> Callable[[Any], Any]:
    """Return the user's function for the value alone, of one time or, if it takes them, of many."""
    if isinstance(function, TimeScaled):
        inner, factor = _plain(function.function), function.factor
        return lambda t: inner(factor * t)
    if isinstance(function, TimeFormula):
        return function.function
    return function.functions[0] if isinstance(function, Triple) else lambda t: function.rates(t)[0]


def steady(function: TimeFunction) -> bool:
    """Whether a function of time is known to be constant."""
    return isinstance(function, Held) or (
        isinstance(function, Polynomial) and len(function.coefficients) == 1
    )


@dataclass(frozen=True)
class TimeScaled(Constant):
    """u(factor t): a function of time that runs `factor` times as fast."""

    function: TimeFunction
    factor: float

    @property
    def knots(self) -> Array:
        """Times [s] at which it is not smooth, as of a `Table`."""
        return np.asarray(getattr(self.function, "knots", ())) / self.factor

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t [s]."""
        u, v, a = self.function.rates(self.factor * t)
        return u, self.factor * v, self.factor**2 * a

    def value(self, t: float) -> float:
        """Return the value at time t [s]."""
        return value_of(self.function, self.factor * t)

    def next_knot(self, t: float) -> float:
        """Return the first knot after time t [s]."""
        return next_knot(self.function, self.factor * t) / self.factor

    def on_knot(self, t: float, within: float) -> bool:
        """Whether there is a knot within a given time [s] of t."""
        return on_knot(self.function, self.factor * t, self.factor * within)


def calls_user(function: TimeFunction) -> bool:
    """Whether a function of time calls user code, which may return other values later."""
    inner = function.function if isinstance(function, TimeScaled) else function
    return isinstance(inner, (TimeFormula, Triple, Foreign))


def time_scaled(function: TimeFunction, factor: float) -> TimeFunction:
    """Return the function run `factor` times as fast; a constant is returned as it is."""
    return function if steady(function) else TimeScaled(function, factor)


@described
class Polynomial(Constant):
    """u(t) = c0 + c1 t + c2 t^2 + …"""

    coefficients: Sequence[float] = in_unit("")

    def __post_init__(self) -> None:
        c = array(self.coefficients, "Polynomial", "coefficients")
        if c.ndim != 1 or not c.size:
            raise ModelError(
                f"Polynomial: coefficients {self.coefficients!r}; give a list of one or more numbers"
            )

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t [s]."""
        t = number(t, "Polynomial", "time")
        u = v = a = 0.0
        for c in reversed(self.coefficients):  # Horner's scheme for the value and its derivatives together
            u, v, a = u * t + c, v * t + u, a * t + 2 * v
        return float(u), float(v), float(a)


@described
class Ramp(Constant):
    """A step from one value to another: the quintic with continuous acceleration.

    Parameters
    ----------
    t0, t1 : float
        Start and end of the step [s].
    u0, u1 : float
        Values before and after it.
    """

    t0: float = in_unit("s")
    t1: float = in_unit("s")
    u0: float = in_unit("")
    u1: float = in_unit("")

    def __post_init__(self) -> None:
        for name in ("t0", "t1", "u0", "u1"):
            number(getattr(self, name), "Ramp", name)
        if not self.t1 - self.t0 > MIN_POSITIVE:
            raise ModelError(f"Ramp: t1 = {self.t1} is not after t0 = {self.t0}; give t0 < t1")

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t [s]."""
        t = number(t, "Ramp", "time")
        T, d = self.t1 - self.t0, self.u1 - self.u0
        fraction = min(max((t - self.t0) / T, 0.0), 1.0)
        u = fraction**3 * (10 - 15 * fraction + 6 * fraction**2)
        return (
            self.u0 + d * u,
            d / T * 30 * fraction**2 * (1 - fraction) ** 2,
            d / T**2 * 60 * fraction * (1 - fraction) * (1 - 2 * fraction),
        )

    def next_knot(self, t: float) -> float:
        """Return the start or the end of the step, whichever comes next after t [s]; infinite after its end."""
        return self.t0 if t < self.t0 else self.t1 if t < self.t1 else math.inf

    def on_knot(self, t: float, within: float) -> bool:
        """Whether its start or its end is within a given time [s] of t."""
        return self.next_knot(t - within) <= t + within


@described
class Harmonic(Constant):
    """u(t) = offset + amplitude sin(omega t + phase).

    Parameters
    ----------
    amplitude : float
    omega : float
        Angular frequency [rad/s].
    phase : float
        [rad]
    offset : float
        Mean value.
    """

    amplitude: float = in_unit("")
    omega: float = in_unit("rad/s")
    phase: float = in_unit("rad", default=0.0)
    offset: float = in_unit("", default=0.0)

    def __post_init__(self) -> None:
        for name in ("amplitude", "omega", "phase", "offset"):
            number(getattr(self, name), "Harmonic", name)

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t [s]."""
        t = number(t, "Harmonic", "time")
        w, p = self.omega, self.omega * t + self.phase
        s, c = self.amplitude * np.sin(p), self.amplitude * np.cos(p)
        return float(self.offset + s), float(w * c), float(-w * w * s)


FUNCTION_CLASSES = (Polynomial, Ramp, Harmonic, TimeFormula, Triple, Foreign)


def as_function(value: Any, owner: str) -> TimeFunction:
    """Convert a number, a function of time or a triple of functions to a TimeFunction; keep one as it is."""
    if isinstance(value, Table):
        return value.of(owner)
    if isinstance(value, FUNCTION_CLASSES):
        return value
    if isinstance(value, TimeFunction) and not isinstance(value, type):
        return Foreign(value, owner)
    if isinstance(value, type):
        raise ModelError(f"{owner}: {value.__name__} is a class; give an instance, {value.__name__}(…)")
    if isinstance(value, tuple):
        if len(value) != 3 or not all(callable(function) for function in value):
            raise ModelError(f"{owner}: {value!r} given; a tuple must hold the three functions (u, u', u'')")
        return Triple(value, owner)
    if callable(value):
        return TimeFormula(value, owner)
    if isinstance(value, (str, list, type(None))):
        raise ModelError(f"{owner}: {value!r} is neither a number nor a function of time; give one of these")
    return Polynomial((number(value, owner, "value"),))
