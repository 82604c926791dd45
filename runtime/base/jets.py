"""Second-order jets: numbers with their first and second rates; operators and NumPy functions accept them.

The comparisons in a function can be watched: the differences of their two sides show when it will not be smooth.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

_WATCHING = threading.local()


@contextmanager
def watched() -> Iterator[list[Jet]]:
    """Collect the differences of all jets compared in this thread within the block."""
    before = getattr(_WATCHING, "differences", None)
    found: list[Jet] = []
    _WATCHING.differences = found
    try:
        yield found
    finally:
        _WATCHING.differences = before


def _note(difference: Jet) -> None:
    """Add the difference of two compared jets, if comparisons are being watched."""
    differences: list[Jet] | None = getattr(_WATCHING, "differences", None)
    if differences is not None:
        differences.append(difference)


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
    np.sign: lambda u: (float(np.sign(u)), 0.0, 0.0),
    np.floor: lambda u: (np.floor(u), 0.0, 0.0),
    np.rint: lambda u: (np.rint(u), 0.0, 0.0),
    np.trunc: lambda u: (np.trunc(u), 0.0, 0.0),
    np.ceil: lambda u: (np.ceil(u), 0.0, 0.0),
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
        """Return the jet of f(self) from f, f' and f'' at the value."""
        return Jet(y, d * self.rate, dd * self.rate**2 + d * self.acceleration)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **kwargs: Any) -> Any:
        if method != "__call__" or kwargs:
            return NotImplemented
        if ufunc in _KINKED:
            _note(_KINKED[ufunc](self))
        if ufunc in _UNARY:
            return self.chain(*_UNARY[ufunc](self.value))
        operator = _BINARY.get(ufunc)
        if operator is None:
            raise TypeError(f"numpy.{ufunc.__name__} has no rates here; give the triple (u, u', u'') instead")
        return operator(*(value if isinstance(value, Jet) else Jet(value) for value in inputs))

    def __array_function__(self, function: Any, types: Any, args: Any, kwargs: Any) -> Any:
        found = _FUNCTIONS.get(function, function._implementation)
        return found(*args, **kwargs)

    def __float__(self) -> float:
        raise TypeError(
            "the time was passed to math.*, float() or a function such as np.interp, which have no rates; use "
            "operators and elementary functions of NumPy (np.sin, not math.sin), and for values at given times "
            "fx.Table(times, values, kind='linear')"
        )

    def __add__(self, o: Any) -> Jet:
        o = as_jet(o)
        return Jet(self.value + o.value, self.rate + o.rate, self.acceleration + o.acceleration)

    def __mul__(self, o: Any) -> Jet:
        o = as_jet(o)
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
        return self + (-as_jet(o))

    def __rsub__(self, o: Any) -> Jet:
        return as_jet(o) + (-self)

    def __truediv__(self, o: Any) -> Jet:
        return self * as_jet(o) ** -1

    def __rtruediv__(self, o: Any) -> Jet:
        return as_jet(o) * self**-1

    def __floor__(self) -> Jet:
        return np.floor(self)  # type: ignore[no-any-return]

    def __ceil__(self) -> Jet:
        return np.ceil(self)  # type: ignore[no-any-return]

    def __int__(self) -> int:
        _note(_to_whole(self))
        return int(self.value)

    __trunc__ = __int__

    def __round__(self, digits: int | None = None) -> Jet:
        size = 10.0 ** (digits or 0)
        _note(_to_whole(self * size + 0.5))
        return Jet(float(round(self.value, digits or 0)))

    def __floordiv__(self, o: Any) -> Jet:
        return np.floor(self / o)  # type: ignore[no-any-return]

    def __rfloordiv__(self, o: Any) -> Jet:
        return np.floor(o / self)  # type: ignore[no-any-return]

    def __mod__(self, o: Any) -> Jet:
        found: Jet = self - as_jet(o) * (self // o)
        return found

    def __rmod__(self, o: Any) -> Jet:
        return as_jet(o) % self

    def __abs__(self) -> Jet:
        _note(self)
        return self.chain(*_UNARY[np.absolute](self.value))

    def _compared(self, o: Any) -> float:
        """Return the difference from another number, and note it."""
        difference = self + (-as_jet(o))
        _note(difference)
        return difference.value

    def __lt__(self, o: Any) -> bool:
        return self._compared(o) < 0

    def __le__(self, o: Any) -> bool:
        return self._compared(o) <= 0

    def __gt__(self, o: Any) -> bool:
        return self._compared(o) > 0

    def __ge__(self, o: Any) -> bool:
        return self._compared(o) >= 0

    __radd__ = __add__
    __rmul__ = __mul__


def as_jet(value: Any) -> Jet:
    """Return the jet of a number or a jet; a number has no rates."""
    if isinstance(value, np.ndarray) and value.shape == ():  # from np.where
        value = value.item()
    return value if isinstance(value, Jet) else Jet(value)


def _to_whole(u: Jet) -> Jet:
    """Return the difference between a jet and the next whole number it will reach."""
    whole = np.floor(u.value) + 1 if u.rate > 0 else np.ceil(u.value) - 1
    return u + Jet(-whole)


def _applied(function: Any, *arguments: Any) -> Any:
    """Apply a NumPy function to jets, which NumPy's types do not accept."""
    return function(*arguments)


def _interpolated(
    x: Jet, times: Any, values: Any, left: float | None = None, right: float | None = None
) -> Jet:
    """Evaluate `np.interp`: straight lines between given points, constant outside."""
    t, u = np.asarray(times, dtype=float), np.asarray(values, dtype=float)
    i = int(np.searchsorted(t, x.value, side="right" if x.rate > 0 else "left"))
    ahead = i if x.rate > 0 else i - 1
    if 0 <= ahead < t.size:
        _note(x - float(t[ahead]))
    slope = (u[i] - u[i - 1]) / (t[i] - t[i - 1]) if 0 < i < t.size else 0.0
    return x.chain(float(np.interp(x.value, t, u, left, right)), float(slope), 0.0)


def _clipped(x: Jet, least: Any = None, most: Any = None) -> Any:
    """Evaluate `np.clip`."""
    above = x if least is None else _applied(np.maximum, x, least)
    return above if most is None else _applied(np.minimum, above, most)


# NumPy functions that are not universal functions and are implemented separately for jets
_FUNCTIONS: dict[Any, Callable[..., Any]] = {
    np.interp: _interpolated,
    np.clip: _clipped,
    np.round: lambda x, decimals=0: round(x, decimals),
}

# quantities that are zero where a NumPy function of one argument is not smooth
_KINKED: dict[Any, Callable[[Jet], Jet]] = {
    np.absolute: lambda u: u,
    np.sign: lambda u: u,
    np.floor: _to_whole,
    np.trunc: _to_whole,
    np.rint: lambda u: _to_whole(u + 0.5),
    np.ceil: _to_whole,
}

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
    np.heaviside: lambda a, b: Jet(0.0) if a < 0.0 else Jet(1.0) if a > 0.0 else b,
    np.mod: lambda a, b: a % b,
    np.floor_divide: lambda a, b: a // b,
}
