"""SUNDIALS' CVODE on the equations of flexel in minimal coordinates, with their analytic Jacobian."""

from __future__ import annotations

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.integration.jacobian import jacobian
from flexel.integration.minimal import natural_scales_of_y
from flexel.model.snapshot import Snapshot

LARGE = 100  # variables from which LAPACK factorizes


def integrate(system: fx.System, start: fx.State, times: Array, rtol: float) -> tuple[Array, dict[str, int]]:
    """Integrate by the backward differentiation formulas of order 1 to 5, in the degrees of freedom of the start.

    Parameters
    ----------
    times : ndarray (k,)
        The first one is that of the start.
    rtol : float
        The absolute tolerance is a hundredth of it, in natural scales.

    Returns
    -------
    x : ndarray (k, n)
        Coordinates at the times.
    counts : dict
        Numbers of steps and evaluations.

    Raises
    ------
    FlexelError
        If scikit-sundae is not installed, or the integration fails.
    """
    try:
        from sksundae.cvode import CVODE
    except ImportError as error:
        raise FlexelError("CVODE needs scikit-sundae; pip install 'flexel[sundials]'") from error
    kinematics = system.kinematics_of(start.roles)
    choice, nz = kinematics.choice, kinematics.structure.nz
    system.warm(start)

    def rates(t: float, y: Array, dy: Array) -> None:
        dy[:] = system.rhs(t, np.array(y))

    def at(t: float, y: Array) -> Snapshot:
        system.rhs(t, np.array(y))
        work = choice.work
        work.rates()
        return Snapshot(t, work.x.copy(), work.v.copy(), work.e.copy(), work.w[: work.e.size].copy())

    def slope(t: float, y: Array, dy: Array, J: Array) -> None:
        now = at(t, y)
        J[:] = jacobian(kinematics, now, np.array(y[y.size - nz :]))
        system.warm(now)

    scales = natural_scales_of_y(kinematics)
    solver = CVODE(
        rates,
        jacfn=slope,
        rtol=rtol,
        atol=rtol / 100 * scales,
        linsolver="lapackdense" if scales.size > LARGE else "dense",
    )
    known, steps, x = float(times[0]), 0, [start.x]
    solver.init_step(known, np.concatenate([start.q, start.qd, start.z]))
    for time in times[1:]:
        while known < time:
            found = solver.step(times[-1], method="onestep", tstop=times[-1])
            if not found.success:
                raise FlexelError(f"CVODE: {found.message}")
            steps += float(found.t) > known  # after a time within a step its end is returned again
            known = float(found.t)
        found = solver.step(time)
        x.append(at(float(time), found.y).x)
    return np.array(x), {"steps": steps, "evaluations": int(found.nfev)}
