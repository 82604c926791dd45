"""A branch of periodic motions with varying speed as a result: amplitudes, folds, stability, pictures, tables."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from flexel.base.arguments import quantities
from flexel.base.arrays import Array, ComplexArray
from flexel.base.outside import DataFrame, Figure
from flexel.linear.harmonics import refined
from flexel.results.periodic_motion import PeriodicSolution
from flexel.results.saved.record import require


class PeriodicBranch:
    """Periodic motions in order along a branch; ``branch[i]`` is a `PeriodicSolution`.

    Attributes
    ----------
    solutions : list of PeriodicSolution
    multipliers : ndarray of complex (n, 2 nd)
        Floquet multipliers of each motion, largest modulus first.
    kinds : list of str
        Per motion "", "end", "fold" where the speed reverses, or "peak" where the largest multiplier has a maximum.
    message : str
        Where and why the branch stopped early; empty if it is complete.
    """

    def __init__(
        self, solutions: list[PeriodicSolution], multipliers: ComplexArray, kinds: list[str], message: str
    ) -> None:
        self.solutions, self.multipliers, self.kinds, self.message = solutions, multipliers, kinds, message

    def __len__(self) -> int:
        """Number of motions."""
        return len(self.solutions)

    def __getitem__(self, i: int) -> PeriodicSolution:
        """Return the motion of that number."""
        return self.solutions[i]

    def __iter__(self) -> Iterator[PeriodicSolution]:
        """Iterate over the motions in order."""
        return iter(self.solutions)

    @property
    def omega(self) -> Array:
        """Angular frequencies (n,) [rad/s]."""
        return np.array([solution.omega for solution in self.solutions])

    @property
    def folds(self) -> list[int]:
        """Numbers of the motions at folds."""
        return [i for i, kind in enumerate(self.kinds) if kind == "fold"]

    @property
    def peaks(self) -> list[int]:
        """Numbers of the motions where the largest multiplier has a maximum."""
        return [i for i, kind in enumerate(self.kinds) if kind == "peak"]

    @property
    def modulus(self) -> Array:
        """Modulus (n,) of the largest Floquet multiplier."""
        return np.asarray(np.abs(self.multipliers[:, 0]))

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Whether small disturbances of each motion decay (n,); not at a fold."""
        return np.array(
            [modulus < 1 and kind != "fold" for modulus, kind in zip(self.modulus, self.kinds, strict=True)]
        )

    @property
    def stretches(self) -> list[tuple[slice, bool]]:
        """Return parts of the branch that are entirely stable or unstable; adjacent parts share a motion."""
        inner = self.stable | np.array([kind == "fold" for kind in self.kinds])
        steps = (inner[:-1] & inner[1:]).tolist()
        ends = [0, *(i for i in range(1, len(steps)) if steps[i] != steps[i - 1]), len(steps)]
        return [(slice(i, j + 1), steps[i]) for i, j in zip(ends, ends[1:], strict=False) if j > i]

    def largest(self, name: str) -> Array:
        """Return the largest magnitude (n,) of a quantity over the period, for each motion; names as in `Motion`."""
        return np.array([np.abs(refined(solution[name])).max() for solution in self.solutions])

    def harmonics(self, name: str) -> ComplexArray:
        """Return complex amplitudes (n, k + 1) of a degree of freedom, as in `PeriodicSolution.harmonics`."""
        return np.array([solution.harmonics(name) for solution in self.solutions])

    def plot(self, *names: str, path: str | Path | None = None) -> Figure:
        """Plot largest magnitudes and multipliers against the speed, unstable motions dashed (needs matplotlib).

        Parameters
        ----------
        *names : str
            Quantities; the degrees of freedom by default.
        path : path, optional
            Where to write the figure.
        """
        from flexel.apps.view.graphs import plot_branch

        return plot_branch(self, names or self.solutions[0].dofs, path)

    def to_pandas(self, *names: str) -> DataFrame:
        """Return a pandas.DataFrame: speed, kind, stability, largest multiplier, share of neglected harmonics, and the
        largest magnitude of each name (the degrees of freedom by default).
        """
        pandas = require("pandas", "xarray")
        shown = quantities(names, "to_pandas") or self.solutions[0].dofs
        own = {
            "omega": self.omega,
            "kind": self.kinds,
            "stable": self.stable,
            "modulus": self.modulus,
            "neglected": [solution.vibration.error for solution in self.solutions],
        }
        return pandas.DataFrame(own | {name: self.largest(name) for name in shown})
