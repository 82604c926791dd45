"""A periodic motion as a result: one period by name, its harmonics, the stability, pictures, tables and files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack, overload

import numpy as np

from flexel.base.arguments import unknown
from flexel.base.arrays import Array, ComplexArray
from flexel.base.blas import in_one_thread
from flexel.base.errors import ModelError
from flexel.base.outside import DataFrame, Dataset, Figure
from flexel.base.shown import counted, listed, prints
from flexel.linear.harmonics import Coefficients, PeriodicVibration
from flexel.results.motion import Motion, with_options_of
from flexel.results.saved.archive import integration_of, record_of
from flexel.results.saved.exports import motion_frame
from flexel.results.saved.record import Record, Variable, require
from flexel.results.saved.record_files import write

if TYPE_CHECKING:
    from flexel.apps.view.options import MotionOptions
    from flexel.apps.view.page import Page

PARTS = ("real", "imaginary")


class PeriodicSolution:
    """A periodic motion: ``solution["rod.bend1"]`` over one period, and its Fourier series.

    Attributes
    ----------
    motion : Motion
        States at equidistant times of one period.
    vibration : PeriodicVibration
        Fourier coefficients of the degrees of freedom, and the linearized equations along the motion.
    """

    def __init__(self, motion: Motion, vibration: PeriodicVibration) -> None:
        self.motion = motion
        self.vibration = vibration

    @prints
    def __repr__(self) -> str:
        of = listed(self.motion.system.dynamic)
        return f"{type(self).__name__}(period {self.period:g} s, {counted(self.vibration.harmonics, 'harmonic')}; {of})"

    @property
    def t(self) -> Array:
        """Stored times (nt,) of one period [s]; the end of the period is not repeated."""
        return self.motion.t

    @property
    def omega(self) -> float:
        """Angular frequency [rad/s]."""
        return self.vibration.coefficients.omega

    @property
    def period(self) -> float:
        """Period [s]."""
        return 2 * np.pi / self.omega

    @property
    def dofs(self) -> tuple[str, ...]:
        """Names of the degrees of freedom."""
        return self.vibration.coefficients.names

    def __getitem__(self, name: str) -> Array:
        """Return the time history (nt,) of a quantity, its rates or force, over one period; names as in `Motion`."""
        return self.motion.series(name)[0]

    def unit(self, name: str) -> str:
        """Return the unit of a quantity, of its rates or its force."""
        return self.motion.unit(name)

    def harmonics(self, name: str) -> ComplexArray:
        """Return complex amplitudes (k + 1,) of a degree of freedom: harmonic j is Re(a_j exp(i j ω t)), a_0 the mean.

        Raises
        ------
        ModelError
            A name that is not a degree of freedom.
        """
        if not isinstance(name, str) or name not in self.dofs:
            raise ModelError(unknown(str(name), self.dofs, "degree of freedom"))
        a = 2 * self.vibration.X[self.vibration.harmonics :, self.dofs.index(name)]
        a[0] /= 2
        return np.asarray(a)

    @in_one_thread
    def multipliers(self) -> ComplexArray:
        """Floquet multipliers (2 nd,), largest modulus first; below one in modulus, small disturbances decay."""
        return self.vibration.coefficients.floquet_multipliers()

    # -- pictures --------------------------------------------------------------------------------

    def plot(self, *names: str | Sequence[str], path: str | Path | None = None, **options: Any) -> Figure:
        """Plot time histories over one period (needs matplotlib), with the options of `Motion.plot`."""
        return self.motion.plot(*names, path=path, **options)

    def plot_phase(self, x: str, y: str | None = None, *, path: str | Path | None = None) -> Figure:
        """Plot one quantity against another, by default the rate of `x` against `x`."""
        return self.motion.plot_phase(x, y, path=path)

    def spectrum_plot(self, path: str | Path | None = None) -> Figure:
        """Plot amplitudes of the harmonics of all degrees of freedom."""
        from flexel.apps.view.graphs import plot_harmonics

        return plot_harmonics(self.vibration, [self.unit(name) for name in self.dofs], path)

    def plot_shapes(self, *times: float, path: str | Path | None = None, **options: Any) -> Figure:
        """Draw the mechanism at the stored states nearest to the times."""
        return self.motion.plot_shapes(*times, path=path, **options)

    @overload
    def view(self, path: str | Path, **options: Unpack[MotionOptions]) -> Path: ...

    @overload
    def view(self, path: None = None, **options: Unpack[MotionOptions]) -> Page: ...

    @with_options_of(Motion.view)
    def view(self, path: str | Path | None = None, **options: Any) -> Path | Page:
        """Make an HTML page that shows one period in any browser, offline."""
        return self.motion.view(path, **options)

    # -- tables and files ------------------------------------------------------------------------

    def record(self) -> Record:
        """Return labelled arrays: one period, its Fourier series and linearized equations."""
        own, c = record_of(self.motion), self.vibration.coefficients
        k, X = self.vibration.harmonics, self.vibration.X
        variables = dict(own.variables)
        for name in ("M", "C", "K"):
            variables[name] = Variable(("time", "equation", "dof"), getattr(c, name))
        variables["F"] = Variable(("time", "equation"), c.F)
        parts = np.stack([X.real, X.imag], axis=-1)
        variables["fourier"] = Variable(
            ("order", "dof", "part"), parts, "", "coefficients of exp(i order ω t)"
        )
        labels = {**own.labels, "equation": c.names, "dof": c.names, "part": PARTS}
        labels["order"] = tuple(str(j) for j in range(-k, k + 1))
        header = {**own.header, "omega": c.omega, "neglected": self.vibration.neglected}
        return Record("periodic", variables, labels, own.units, header)

    def to_xarray(self) -> Dataset:
        """Return everything as an xarray.Dataset, labelled."""
        require("xarray", "xarray")
        return self.record().to_xarray()

    def to_pandas(self, *names: str) -> DataFrame:
        """Return a pandas.DataFrame over one period, a column for each name; all values if none is given."""
        return motion_frame(self.motion, names)

    def save(self, path: str | Path) -> Path:
        """Write the solution as .nc, .npz, .mat or .csv; `flexel.load` reads it back."""
        return write(self.record(), path)


def periodic_of(record: Record) -> PeriodicSolution:
    """Return the periodic solution in a record."""
    arrays = {name: variable.values for name, variable in record.variables.items()}
    names, header = record.labels["dof"], record.header
    M, C, K, F = (np.asarray(arrays[name], dtype=float) for name in ("M", "C", "K", "F"))
    c = Coefficients(float(header["omega"]), M, C, K, F, names)
    X = arrays["fourier"][..., 0] + 1j * arrays["fourier"][..., 1]
    return PeriodicSolution(
        Motion(None, integration_of(record)), PeriodicVibration(c, X, float(header["neglected"]))
    )
