"""Rules of controllers: outputs and state from time, inputs and state; linear rules and Python functions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from flexel.base.arguments import LARGEST
from flexel.base.arrays import Array
from flexel.base.copies import Constant, check_travels
from flexel.base.errors import FlexelError, LinearizationError, ModelError

DIFFERENCE_STEP = 6e-6  # of central differences, relative: the cube root of the rounding error
KINK_TOLERANCE = 1e-3  # relative difference of slopes from which a function counts as not smooth


class Rule(Protocol):
    """Outputs u (nu,) of a controller, and its state after the instant or its rate (nx,)."""

    @property
    def nx(self) -> int:
        """Number of states."""
        ...

    def __call__(self, t: float, y: Array, x: Array) -> tuple[Array, Array]:
        """Return u and the state (sampled) or its rate (continuous) from inputs y (ny,) and state x (nx,)."""
        ...

    def slopes(self, t: float, y: Array, x: Array) -> Array:
        """Return the derivatives (nu + nx, ny + nx) by (y, x)."""
        ...

    def smooth_slopes(self, t: float, y: Array, x: Array) -> Array:
        """Return the same derivatives; raise a LinearizationError where there are none."""
        ...


@dataclass(frozen=True)
class LinearRule(Constant):
    """u = C x + D (r - y) with the state A x + B (r - y)."""

    A: Array
    B: Array
    C: Array
    D: Array
    r: Array

    @property
    def nx(self) -> int:
        """Number of states."""
        return len(self.A)

    def __call__(self, t: float, y: Array, x: Array) -> tuple[Array, Array]:
        """See `Rule`."""
        w = self.r - y
        return self.C @ x + self.D @ w, self.A @ x + self.B @ w

    def slopes(self, t: float, y: Array, x: Array) -> Array:
        """See `Rule`."""
        return np.block([[-self.D, self.C], [-self.B, self.A]])

    smooth_slopes = slopes


@dataclass(frozen=True)
class FunctionRule(Constant):
    """A Python function: u = function(t, y), or (u, state or its rate) = function(t, y, x)."""

    owner: str
    function: Callable[..., Any]
    nu: int
    nx: int
    with_state: bool

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields; raise a ModelError that names the controller if the function cannot be pickled."""
        check_travels(self.owner, self.function)
        return super().__getstate__()

    def __call__(self, t: float, y: Array, x: Array) -> tuple[Array, Array]:
        """See `Rule`; a ModelError names the controller and the time if the function fails."""
        given = (t, y.copy(), x.copy()) if self.with_state else (t, y.copy())
        at = f"{self.owner} at t = {t:g} s"
        try:
            found = self.function(*given)
        except FlexelError:
            raise
        except Exception as error:  # a user's function may raise anything
            raise ModelError(
                f"{at}: the function failed ({type(error).__name__}: {error}); it is called with "
                f"{'(t, y, x)' if self.with_state else '(t, y)'}"
            ) from error
        if not self.with_state:
            return self._vector(found, self.nu, f"{at}: the function returned"), np.zeros(0)
        if not isinstance(found, tuple | list) or len(found) != 2:
            raise ModelError(
                f"{at}: the function returned {found!r:.80}; with a state it must return two values, "
                "(outputs, state)"
            )
        u = self._vector(found[0], self.nu, f"{at}: the function returned outputs")
        return u, self._vector(found[1], self.nx, f"{at}: the function returned the state")

    @staticmethod
    def _vector(value: Any, size: int, what: str) -> Array:
        try:
            found = np.asarray(value, dtype=float).reshape(-1)
        except (TypeError, ValueError, OverflowError):
            found = np.zeros(0)
        if found.size != size or not np.all(np.abs(found) <= LARGEST):
            numbers = "1 finite number" if size == 1 else f"{size} finite numbers"
            raise ModelError(f"{what} {value!r:.80}; it must return {numbers}")
        return found

    def _both(self, t: float, yx: Array) -> Array:
        ny = yx.size - self.nx
        return np.concatenate(self(t, yx[:ny], yx[ny:]))

    def _differences(self, t: float, yx: Array, j: int, h: float) -> tuple[Array, Array]:
        """Return function values ahead of and behind a point, h apart from it."""
        ahead, behind = yx.copy(), yx.copy()
        ahead[j] += h
        behind[j] -= h
        return self._both(t, ahead), self._both(t, behind)

    def slopes(self, t: float, y: Array, x: Array) -> Array:
        """See `Rule`; by central differences."""
        yx = np.concatenate([y, x])
        found = np.zeros((self.nu + self.nx, yx.size))
        for j, value in enumerate(yx):
            h = DIFFERENCE_STEP * max(1.0, abs(value))
            ahead, behind = self._differences(t, yx, j, h)
            found[:, j] = (ahead - behind) / (2 * h)
        return found

    def smooth_slopes(self, t: float, y: Array, x: Array) -> Array:
        """See `Rule`: slopes on both sides, and over a longer distance, must agree."""
        yx, found = np.concatenate([y, x]), self.slopes(t, y, x)
        middle = self._both(t, yx)
        scale = np.abs(found).max(axis=1, initial=0.0) + 1e-6 * (1 + np.abs(middle))
        for j, value in enumerate(yx):
            h = 10 * DIFFERENCE_STEP * max(1.0, abs(value))
            ahead, behind = self._differences(t, yx, j, h)
            sides = np.abs(ahead - 2 * middle + behind) / h
            longer = np.abs((ahead - behind) / (2 * h) - found[:, j])
            if np.any(np.maximum(sides, longer) > KINK_TOLERANCE * scale):
                what = f"input {j}" if j < y.size else f"state {j - y.size}"
                raise LinearizationError(
                    f"{self.owner}: the function is not smooth at t = {t:g} s (it has a kink or a jump over {what}), "
                    "so it has no linearization there; linearize about another state, or use a smooth function"
                )
        return found
