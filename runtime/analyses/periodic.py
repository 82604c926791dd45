"""The nonlinear periodic motion of a system."""

from __future__ import annotations

import numpy as np

from flexel.base.arguments import positive
from flexel.base.errors import ModelError
from flexel.integration.outcome import Integration, States
from flexel.linear.periodic import periodic_motion
from flexel.mechanics.core import Core
from flexel.results.motion import Motion
from flexel.results.periodic import PeriodicSolution


class PeriodicMotions(Core):
    """Periodic motions of a system."""

    def periodic(
        self,
        start: PeriodicSolution | None = None,
        *,
        period: float,
        harmonics: int,
        samples: int | None = None,
        accuracy: float | None = None,
    ) -> PeriodicSolution:
        """Nonlinear periodic motion under periodic prescribed motions and loads, by harmonic balance.

        Parameters
        ----------
        start : PeriodicSolution, optional
            A neighbouring solution with as many harmonics to start from; the linearized one by default.
        period : float
            [s]
        harmonics : int
            Number of harmonics of the Fourier series.
        samples : int, optional
            Times in the period; 4 per harmonic and 4 more by default.
        accuracy : float, optional
            Largest permitted amplitude of the neglected harmonics, relative to the largest amplitude.

        Raises
        ------
        ModelError, PositionError, LinearizationError
            A period or a number of harmonics that is not positive; or as `flexel.linear.periodic.periodic_motion`.
        """
        period = positive(period, "periodic", "period")
        if not isinstance(harmonics, (int, np.integer)) or harmonics < 1:
            raise ModelError(f"periodic: {harmonics!r} harmonics requested; give a whole number, 1 or more")
        X = None if start is None else start.vibration.X
        orbit, vibration = periodic_motion(self, period, harmonics, X, samples, accuracy)
        counts = {"samples": len(orbit.states), "harmonics": harmonics}
        motion = Motion(self, Integration(States(orbit.states), [], [], counts, "periodic"))
        return PeriodicSolution(motion, vibration)
