"""Prescribed functions of time with their first and second rates, derived and never differenced.

A function of time is called with a second-order jet (value, rate, acceleration), on which operators and
NumPy functions work; or it is one of the ready-made classes here; or a triple of functions.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from flexel.base.arguments import array, number
from flexel.base.errors import FlexelError, ModelError

ROUNDING = 1e-13  # of sums of durations, relative to the times of a table


@runtime_checkable
class TimeFunction(Protocol):
    """Anything that maps a time [s] to value, rate and acceleration."""

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value, first and second rate at time t."""
        ...


def _power(u: float, n: float) -> tuple[float, float, float]:
    return u**n, n * u ** (n - 1) if n else 0.0, n * (n - 1) * u ** (n - 2) if n not in (0, 1) else 0.0


def _tan(u: float) -> tuple[float, float, float]:
    y = np.tan(u)
    return y, 1 + y * y, 2 * y * (1 + y * y)


def _tanh(u: float) -> tuple[float, float, float]:
    y = np.tanh(u)
    return y, 1 - y * y, -2 * y * (1 - y * y)


def _arcsin(u: float) -> tuple[float, float, float]:
    w = 1 - u * u
    return np.arcsin(u), w**-0.5, u * w**-1.5


def _arccos(u: float) -> tuple[float, float, float]:
    y, d, dd = _arcsin(u)
    return np.pi / 2 - y, -d, -dd


# value, first and second derivative of each NumPy function that a jet understands
_UNARY: dict[Any, Callable[[float], tuple[float, float, float]]] = {
    np.sin: lambda u: (np.sin(u), np.cos(u), -np.sin(u)),
    np.cos: lambda u: (np.cos(u), -np.sin(u), -np.cos(u)),
    np.tan: _tan,
    np.exp: lambda u: (np.exp(u), np.exp(u), np.exp(u)),
    np.expm1: lambda u: (np.expm1(u), np.exp(u), np.exp(u)),
    np.log: lambda u: (np.log(u), 1 / u, -1 / u**2),
    np.log1p: lambda u: (np.log1p(u), 1 / (1 + u), -1 / (1 + u) ** 2),
    np.sqrt: lambda u: _power(u, 0.5),
    np.square: lambda u: (u * u, 2 * u, 2.0),
    np.reciprocal: lambda u: (1 / u, -1 / u**2, 2 / u**3),
    np.sinh: lambda u: (np.sinh(u), np.cosh(u), np.sinh(u)),
    np.cosh: lambda u: (np.cosh(u), np.sinh(u), np.cosh(u)),
    np.tanh: _tanh,
    np.arcsin: _arcsin,
    np.arccos: _arccos,
    np.arctan: lambda u: (np.arctan(u), 1 / (1 + u * u), -2 * u / (1 + u * u) ** 2),
    np.absolute: lambda u: (abs(u), float(np.sign(u)), 0.0),
    np.negative: lambda u: (-u, -1.0, 0.0),
    np.positive: lambda u: (u, 1.0, 0.0),
}


class Jet:
    """A number with its first and second rate; arithmetic follows the chain rule.

    Parameters
    ----------
    value, rate, acceleration : float
    """

    __slots__ = ("acceleration", "rate", "value")

    def __init__(self, value: float, rate: float = 0.0, acceleration: float = 0.0) -> None:
        self.value, self.rate, self.acceleration = float(value), float(rate), float(acceleration)

    def chain(self, y: float, d: float, dd: float) -> Jet:
        """The jet of f(self) from f, f' and f'' at the value."""
        return Jet(y, d * self.rate, dd * self.rate**2 + d * self.acceleration)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **kwargs: Any) -> Any:
        if method != "__call__" or kwargs:
            return NotImplemented
        if ufunc in _UNARY:
            return self.chain(*_UNARY[ufunc](self.value))
        operator = _BINARY.get(ufunc)
        if operator is None:
            raise TypeError(f"numpy.{ufunc.__name__} has no rates here; give the triple (u, u', u'') instead")
        return operator(*(z if isinstance(z, Jet) else Jet(z) for z in inputs))

    def __float__(self) -> float:
        raise TypeError(
            "a function of time was given to math.* or float(); use numpy functions (np.sin, not math.sin), "
            "so that its rates can be derived"
        )

    def __add__(self, o: Any) -> Jet:
        o = _jet(o)
        return Jet(self.value + o.value, self.rate + o.rate, self.acceleration + o.acceleration)

    def __mul__(self, o: Any) -> Jet:
        o = _jet(o)
        return Jet(
            self.value * o.value,
            self.rate * o.value + self.value * o.rate,
            self.acceleration * o.value + 2 * self.rate * o.rate + self.value * o.acceleration,
        )

    def __pow__(self, n: Any) -> Jet:
        if isinstance(n, Jet):
            if n.rate == 0 and n.acceleration == 0:
                return self.chain(*_power(self.value, n.value))
            return np.exp(n * np.log(self))  # type: ignore[no-any-return]
        return self.chain(*_power(self.value, float(n)))

    def __rpow__(self, base: float) -> Jet:
        return np.exp(self * float(np.log(base)))  # type: ignore[no-any-return]

    def __neg__(self) -> Jet:
        return Jet(-self.value, -self.rate, -self.acceleration)

    def __pos__(self) -> Jet:
        return self

    def __sub__(self, o: Any) -> Jet:
        return self + (-_jet(o))

    def __rsub__(self, o: Any) -> Jet:
        return _jet(o) + (-self)

    def __truediv__(self, o: Any) -> Jet:
        return self * _jet(o) ** -1

    def __rtruediv__(self, o: Any) -> Jet:
        return _jet(o) * self**-1

    def __abs__(self) -> Jet:
        return self.chain(*_UNARY[np.absolute](self.value))

    def __lt__(self, o: Any) -> bool:
        return self.value < _jet(o).value

    def __le__(self, o: Any) -> bool:
        return self.value <= _jet(o).value

    def __gt__(self, o: Any) -> bool:
        return self.value > _jet(o).value

    def __ge__(self, o: Any) -> bool:
        return self.value >= _jet(o).value

    __radd__ = __add__
    __rmul__ = __mul__


def _jet(value: Any) -> Jet:
    if isinstance(value, np.ndarray) and value.shape == ():  # from np.where
        value = value.item()
    return value if isinstance(value, Jet) else Jet(value)


_BINARY: dict[Any, Callable[[Jet, Jet], Any]] = {
    np.add: lambda a, b: a + b,
    np.subtract: lambda a, b: a - b,
    np.multiply: lambda a, b: a * b,
    np.true_divide: lambda a, b: a / b,
    np.power: lambda a, b: a**b,
    np.less: lambda a, b: a < b,
    np.less_equal: lambda a, b: a <= b,
    np.greater: lambda a, b: a > b,
    np.greater_equal: lambda a, b: a >= b,
    np.maximum: lambda a, b: a if a >= b else b,
    np.minimum: lambda a, b: a if a <= b else b,
}


@dataclass(frozen=True)
class Formula:
    """A Python function of time, differentiated by second-order jets."""

    function: Callable[[Any], Any]
    owner: str = "function of time"

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value, first and second rate at time t [s]."""
        try:
            y = _jet(self.function(Jet(t, 1.0, 0.0)))
        except FlexelError:
            raise
        except Exception as error:  # whatever a user's function does
            raise ModelError(
                f"{self.owner}: the function failed at t = {t:g} s ({error}); it is called with one argument t and "
                "must give one number, by operators and NumPy functions, or give the triple (u, u', u'')"
            ) from error
        return _finite((y.value, y.rate, y.acceleration), self.owner, t)


@dataclass(frozen=True)
class Triple:
    """Value, first and second rate as three functions of time."""

    functions: tuple[Callable[[float], float], Callable[[float], float], Callable[[float], float]]
    owner: str = "function of time"

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value, first and second rate at time t [s]."""
        u, ud, udd = self.functions
        try:
            values = float(u(t)), float(ud(t)), float(udd(t))
        except FlexelError:
            raise
        except Exception as error:  # whatever a user's function does
            raise ModelError(
                f"{self.owner}: one of the functions (u, u', u'') failed at t = {t:g} s ({error}); each is called "
                "with one number t and must give one number"
            ) from error
        return _finite(values, self.owner, t)


def _finite(values: tuple[float, float, float], owner: str, t: float) -> tuple[float, float, float]:
    if math.isfinite(values[0]) and math.isfinite(values[1]) and math.isfinite(values[2]):
        return values
    raise ModelError(
        f"{owner}: value, rate and acceleration at t = {t:g} s are {values}; they must be finite, correct the function"
    )


@dataclass(frozen=True)
class Polynomial:
    """u(t) = c0 + c1 t + c2 t^2 + …"""

    coefficients: Sequence[float]

    def __post_init__(self) -> None:
        c = array(self.coefficients, "Polynomial", "coefficients")
        if c.ndim != 1 or not c.size:
            raise ModelError(
                f"Polynomial: coefficients {self.coefficients!r}; give a list of one number or more"
            )

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value, first and second rate at time t [s]."""
        u = v = a = 0.0
        for c in reversed(self.coefficients):  # Horner's scheme for the value and its derivatives together
            u, v, a = u * t + c, v * t + u, a * t + 2 * v
        return float(u), float(v), float(a)


@dataclass(frozen=True)
class Ramp:
    """A step from `u0` to `u1` between `t0` and `t1`, the quintic with continuous acceleration."""

    t0: float
    t1: float
    u0: float
    u1: float

    def __post_init__(self) -> None:
        for name in ("t0", "t1", "u0", "u1"):
            number(getattr(self, name), "Ramp", name)
        if not self.t1 > self.t0:
            raise ModelError(f"Ramp: t1 = {self.t1} is not after t0 = {self.t0}; give t0 < t1")

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value, first and second rate at time t [s]."""
        T, d = self.t1 - self.t0, self.u1 - self.u0
        z = min(max((t - self.t0) / T, 0.0), 1.0)
        u = z**3 * (10 - 15 * z + 6 * z**2)
        return self.u0 + d * u, d / T * 30 * z**2 * (1 - z) ** 2, d / T**2 * 60 * z * (1 - z) * (1 - 2 * z)


@dataclass(frozen=True)
class Harmonic:
    """u(t) = offset + amplitude sin(omega t + phase)."""

    amplitude: float
    omega: float
    phase: float = 0.0
    offset: float = 0.0

    def __post_init__(self) -> None:
        for name in ("amplitude", "omega", "phase", "offset"):
            number(getattr(self, name), "Harmonic", name)

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value, first and second rate at time t [s]."""
        w, p = self.omega, self.omega * t + self.phase
        s, c = self.amplitude * np.sin(p), self.amplitude * np.cos(p)
        return float(self.offset + s), float(w * c), float(-w * w * s)


class Table:
    """Values at given times, joined by a cubic spline (C2).

    Parameters
    ----------
    t, u : array_like (n,)
        Increasing times [s] and values, n >= 4.
    """

    def __init__(self, t: ArrayLike, u: ArrayLike) -> None:
        from scipy.interpolate import CubicSpline

        times, values = array(t, "Table", "times"), array(u, "Table", "values")
        if values.shape != times.shape:
            raise ModelError(
                f"Table: {times.size} times and values of shape {values.shape}; give one value for each"
            )
        if times.ndim != 1 or times.size < 4 or np.any(np.diff(times) <= 0):
            raise ModelError("Table: times must be at least four, strictly increasing; sort them")
        self._spline = CubicSpline(times, values)
        self._range = float(times[0]), float(times[-1])
        self._owner = ""

    def of(self, owner: str) -> Table:
        """The same table, whose errors name what it moves."""
        found = copy.copy(self)
        found._owner = f"{owner}: "
        return found

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value, first and second rate at time t [s]; a ModelError outside the table."""
        first, last = self._range
        slack = ROUNDING * max(abs(first), abs(last))
        if not first - slack <= t <= last + slack:
            raise ModelError(
                f"{self._owner}Table: time {t} s lies outside {first}…{last} s; extend the table"
            )
        t = min(max(t, first), last)
        return float(self._spline(t)), float(self._spline(t, 1)), float(self._spline(t, 2))


def as_function(value: Any, owner: str) -> TimeFunction:
    """A TimeFunction from a number, a function of time, a triple of functions, or a ready-made one."""
    if isinstance(value, Table):
        return value.of(owner)
    if isinstance(value, TimeFunction) and not isinstance(value, type):
        return value
    if isinstance(value, type):
        raise ModelError(
            f"{owner}: {value.__name__} is a class; give one made with its numbers, {value.__name__}(…)"
        )
    if isinstance(value, tuple):
        if len(value) != 3 or not all(callable(z) for z in value):
            raise ModelError(f"{owner}: {value!r} given; a tuple must hold the three functions (u, u', u'')")
        return Triple(value, owner)
    if callable(value):
        return Formula(value, owner)
    if isinstance(value, (str, list, type(None))):
        raise ModelError(f"{owner}: {value!r} is neither a number nor a function of time; give one of these")
    return Polynomial((number(value, owner, "value"),))
