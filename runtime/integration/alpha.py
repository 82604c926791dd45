"""Single steps of the generalized-alpha method on coordinates and multipliers.

Newton's method runs in C (implicit.c in the engine), with the analytic tangent as its matrix; loads and prescribed
motions at the end of a step are evaluated before.  Source: see implicit.c; Zienkiewicz and Xie (1991) for the step
control.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.engine.contact_selection import ALARM, ContactSelection
from flexel.engine.stepping import Stepping
from flexel.engine.workspace import Workspace
from flexel.integration.balance import TINY_FORCE, Balance, Saddle
from flexel.integration.extent import extent
from flexel.integration.scheme import Scheme
from flexel.mechanics.free_motion import check_inertia
from flexel.mechanics.saddle import SaddlePattern
from flexel.model.state import State
from flexel.system import CoreSystem

FORCES = 1e-2  # weight of the forces' relative residual against the violation of conditions
ROUNDING = 1e-13  # local error, in natural scales, below which coordinates are noise
LOOSE = 1e-4  # local error beyond which the forces are weighted less, down to a tenth: such steps are coarse anyway


class AlphaStepper(Saddle):
    """Single steps of the generalized-alpha method, in a separate workspace that holds the last trial point.

    Attributes
    ----------
    t : float
        Current time [s].
    stepping : Stepping
        The current point, and the end of a step that was found.
    arguments : tuple
        With which another one is made.
    """

    t = 0.0

    def __init__(self, system: CoreSystem, radius: float, newton: str, tolerance: float = 0.0) -> None:
        super().__init__(system, work=Workspace(system.evaluation.tables))
        self.arguments = system, radius, newton, tolerance
        if newton not in ("full", "modified"):
            raise ModelError(f"simulate: newton {newton!r} is unknown; choose full or modified")
        self.scheme = Scheme.with_radius(radius, bool(self.force_rows.size))
        self._matrix = pattern = self._pattern(None)
        scales = {"hold_scale": self.scales[self.roles.holonomic], "x_scale": self.x_scale}
        self.stepping = Stepping(self.balancing, pattern.elimination, pattern.source, scales)
        self.numbers = c = self.stepping.struct
        for name, value in asdict(self.scheme).items():
            setattr(c, name, value)
        c.full, c.length, c.tiny = newton == "full", self.length, TINY_FORCE
        coarse = 0 < tolerance < np.inf
        c.forces = FORCES * max(min(LOOSE / tolerance, 1.0), 0.1) if coarse else FORCES
        self._selection = ContactSelection(self.work)
        self._chosen = not self._selection.worthwhile

    def expect(self, start: State, duration: float, tolerance: float, absolute: float) -> None:
        """Scale the tolerance by how far a motion may go, at least; it stays above `absolute`, and above noise.

        Parameters
        ----------
        start : State
        duration : float
            [s]
        tolerance, absolute : float
            Over the size of the motion, and in natural scales.
        """
        least = max(ROUNDING, absolute) / max(tolerance, ROUNDING)
        self.numbers.ranges.least = max(least, extent(self, start, duration))

    def begin(self, start: State) -> None:
        """Continue from a state, with its accelerations."""
        self.t = start.t
        old = self.stepping.old
        for name in ("x", "v", "a", "e", "z", "zd"):
            old[name][:] = getattr(start, name)
        old["w"][:], old["zw"][:], old["mu"][:] = start.a, start.zd, self.multipliers(start)
        self.stepping.begin()

    def follow(self, other: AlphaStepper) -> None:
        """Continue from the current point of another stepper."""
        self.take(other.t, other.stepping.old)

    def take(self, t: float, values: Mapping[str, Array]) -> None:
        """Continue from the vectors of `Stepping.old` at a time [s]."""
        self.t = t
        for name, array in values.items():
            self.stepping.old[name][:] = array
        self.stepping.begin()

    def step(self, h: float) -> bool:
        """Try a step by Newton's method; return whether it was found."""
        if not self._chosen:
            self._choose(self.stepping.old["x"])
            self._chosen = True
        found = self._run(h)
        if not (found and self._selection.worthwhile):
            return found
        gap = self._selection.smallest()
        if gap <= ALARM:
            self._choose(self.stepping.now["x"])
        return gap > 0 or self._run(h)  # again if an omitted contact has closed within the step

    def local_errors(self, h: float) -> Array:
        """Return the local errors (n,) of the coordinates in the step of length h [s] that was found."""
        p, q = self.stepping.old, self.stepping.now
        return np.asarray((self.scheme.beta - 1 / 6) * h * h * (q["w"] - p["w"]))

    def check_inertia(self) -> None:
        """Raise if the matrix of the step that was not found is singular for a motion without mass; names it.

        Raises
        ------
        InertiaError
        """
        if self.stepping.singular:
            check_inertia(self._matrix.matrix(self.work), self.work.tables.M.matrix(self.work.M))

    def _pattern(self, used: NDArray[np.bool_] | None) -> SaddlePattern:
        return SaddlePattern(self.work, self.force_rows, self.force_rows, rolling=True, used=used)

    def _choose(self, x: Array) -> None:
        """Omit the contacts that are far apart at coordinates x, in the matrix too."""
        self._selection.choose(x)
        self._matrix = pattern = self._pattern(self._selection.used)
        self.stepping.use(pattern.elimination, pattern.source)

    def _run(self, h: float) -> bool:
        self.numbers.t = self.t
        self.given(self.t + h)
        try:
            return self.stepping.run(h)
        except FloatingPointError:
            self.check_slopes()
            raise

    def accept(self, t: float) -> None:
        """Continue from the end of the step that was found, at time t."""
        self.stepping.accept()
        self.t = t

    def current(self) -> Balance:
        """Return the balance at the current time."""
        return self.balance_at(self.t, self.stepping.old)

    def found(self, t: float) -> Balance:
        """Return the balance at the end of the step that was found, at time t [s]."""
        return self.balance_at(t, self.stepping.now)

    def balance_at(self, t: float, p: Mapping[str, Array]) -> Balance:
        """Return the balance at a time [s], for vectors such as those of `Stepping.old`."""
        self.z, self.balancing.struct.implicit = p["z"], 0
        return self.balance(t, p["x"], p["v"], p["a"], p["mu"], p["e"])
