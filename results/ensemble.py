"""The motions of many variants of a system as a result."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from flexel.base.arguments import unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.outside import Dataset
from flexel.base.shown import prints
from flexel.results.motion import Motion
from flexel.results.saved.record import require


class Ensemble:
    """Time histories of selected quantities in many variants; ``ensemble["tip.y"]`` is an array (variants, times).

    Values are NaN for variants that failed; for variants that ended early, after their end.

    Attributes
    ----------
    t : ndarray (nt,)
        Times [s].
    parameters : dict of str to ndarray (variants, …)
        The varied parameters, by name; also the initial values and rates.
    failed : dict of int to str
        Messages of variants that failed, by their number.
    statistics : list of dict of str to int
        Steps and evaluations of each variant; empty if it failed.
    """

    def __init__(
        self,
        t: Array,
        values: Mapping[str, tuple[Array, str]],
        parameters: Mapping[str, Array],
        failed: Mapping[int, str],
        statistics: list[dict[str, int]],
        recompute: Callable[[int], Motion],
    ) -> None:
        self.t, self._values, self.parameters = t, dict(values), dict(parameters)
        self.failed, self.statistics, self._recompute = dict(failed), statistics, recompute

    def __len__(self) -> int:
        """Number of variants."""
        return len(self.statistics)

    @prints
    def __repr__(self) -> str:
        return f"Ensemble({len(self)} variants, {len(self.failed)} failed, {self.t.size} times, {self.names})"

    @property
    def names(self) -> tuple[str, ...]:
        """The stored quantities."""
        return tuple(self._values)

    def __getitem__(self, name: str) -> Array:
        """Return values (variants, times) of a stored quantity."""
        if name not in self._values:
            raise ModelError(
                f"ensemble: {unknown(str(name), self._values, 'quantity that was kept')}; name it in `outputs`"
            )
        return self._values[name][0]

    def motion(self, i: int) -> Motion:
        """Compute the whole motion of a variant again, with identical results.

        Raises
        ------
        ModelError
            A variant that does not exist.
        FlexelError
            The error of the variant.
        """
        if isinstance(i, bool) or not isinstance(i, (int, np.integer)) or not -len(self) <= i < len(self):
            raise ModelError(f"ensemble: variant {i!r}; give a number from 0 to {len(self) - 1}")
        return self._recompute(int(i) % len(self))

    def to_xarray(self) -> Dataset:
        """Return an xarray.Dataset over (variant, time), with parameters as coordinates and failure messages."""
        xarray = require("xarray", "xarray")
        data: dict[str, Any] = {
            name: (("variant", "time"), values, {"units": unit})
            for name, (values, unit) in self._values.items()
        }
        data["failed"] = ("variant", [self.failed.get(i, "") for i in range(len(self))])
        coordinates: dict[str, Any] = {
            "time": ("time", self.t, {"units": "s"}),
            "variant": np.arange(len(self)),
        }
        for name, values in self.parameters.items():
            coordinates[name] = (("variant", f"{name}: entry") if values.ndim > 1 else "variant", values)
        return xarray.Dataset(data, coordinates)
