"""How far a motion turns in the modes it excites: any integrator must follow these; resting modes may be stepped over.

A system is stiff for a motion if its fastest eigenvalues belong to modes that the motion does not excite.
"""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.mechanics.rigid import spectrum
from flexel.model.state import State
from flexel.system import CoreSystem

SEEN = 0.05  # amplitude of a mode, relative to the range of the motion, from which it is followed
DECAY = 15.0  # time constants after which a damped mode has vanished
GROWTH = 10.0  # time constants after which an unstable mode matters, whatever its amplitude at first


def followed(system: CoreSystem, state: State, A: Array, duration: float) -> float:
    """Return the angle [rad] through which the excited modes turn.

    The motion is that of the equations linearized at its start, y' = f + A (y - y0): mode i with eigenvalue λ_i and
    left and right eigenvectors l_i, r_i has the amplitude l_i·f / (l_i·r_i λ_i).

    Parameters
    ----------
    system : CoreSystem
    state : State
        The start, with its accelerations.
    A : ndarray (2 nd + nk + nz, 2 nd + nk + nz)
        Its state matrix.
    duration : float
        [s]
    """
    nd = system.roles.nd
    eigenvalues, left, right = spectrum(A, nd)
    f = _rates(system, state)
    moving = np.abs(eigenvalues) > 0
    w, r = eigenvalues[moving], right[:, moving]
    amplitudes = left[:, moving].conj().T @ f / (left[:, moving].conj() * r).sum(axis=0)
    rigid = f - (r @ amplitudes).real
    parts = np.abs(r * amplitudes / np.maximum(np.abs(w), 1 / duration))[nd:]
    parts = parts / _sizes(system, A, parts, rigid, duration)[:, None]
    lasting = np.where(w.real < 0, np.minimum(duration, DECAY / np.maximum(-w.real, 1e-300)), duration)
    seen = (parts.max(axis=0, initial=0.0) > SEEN) | (w.real * duration > GROWTH)
    turned = float((np.abs(w) * lasting)[seen].max(initial=0.0))
    return max(turned, _rotation(system, state) * duration)


def _rates(system: CoreSystem, state: State) -> Array:
    """Return the derivatives of (q_d', q_d, q_k, z)."""
    dynamic, dofs = system.roles.dynamic, system.roles.dofs
    return np.concatenate([state.Phi_v[dynamic], state.rates[dofs], state.zd])


def _sizes(system: CoreSystem, A: Array, parts: Array, rigid: Array, duration: float) -> Array:
    """Return the ranges of (q_d, q_k, z): the largest of the degrees of freedom, scaled, and each internal state's."""
    nd, nq = system.roles.nd, system.roles.nq
    ranges = parts.sum(axis=1) + np.abs(rigid[nd:]) * duration
    ranges[:nd] += np.abs(rigid[:nd]) * duration**2 / 2
    scales = system.kinematics.scales(system.roles.dofs)
    ranges[:nq] = scales * (ranges[:nq] / scales).max(initial=0.0)
    return np.asarray(np.maximum(ranges, 1e-300))


def _rotation(system: CoreSystem, state: State) -> float:
    """Return the fastest rate [rad/s] among angles and Euler parameters."""
    units = np.array(system.structure.units, dtype=object)
    return float(np.abs(state.rates[(units == "rad") | (units == "-")]).max(initial=0.0))


def knots(system: CoreSystem, begin: float, end: float) -> float:
    """Count the knots of tables within the motion: a step of every method ends at each."""
    tables = [np.asarray(getattr(function, "knots", ())) for function in system.kinematics.time_functions]
    return float(sum(np.count_nonzero((knots > begin) & (knots < end)) for knots in tables))
