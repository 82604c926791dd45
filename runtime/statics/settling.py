"""Judges the stability of an equilibrium, and descends to one if no stiffness resists.

Descent: Newton's step in the eigenvectors of the stiffness on the admissible motions, with the magnitude of each
eigenvalue, so that the potential decreases along every eigenvector; each part is limited.  A pendulum drawn
horizontally, which no stiffness resists, moves down until it hangs.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.linalg import eigh, ldl
from scipy.sparse import csc_array, diags_array
from scipy.sparse.linalg import splu as untyped_splu

from flexel.base.arrays import Array
from flexel.base.null_space import null_space
from flexel.mechanics.newton import newton
from flexel.statics.eigenproblem import FAR_BELOW, Pencil
from flexel.statics.equilibrium import MAX_STEP, STALLED_TOLERANCE, TOLERANCE, Equations, Rest

splu: Any = untyped_splu
MAX_SIZE = 1500  # most coordinates and multipliers for which stability is judged
MAX_DESCENT_SIZE = 600  # the same for a descent, which computes all eigenvectors at every step
NEUTRAL_TOLERANCE = 1e-11  # eigenvalue, relative to the stiffnesses of coordinates, that counts as zero
ROUNDED_STIFFNESS = 1e-5  # of a coordinate, over the largest, whose last digits are rounding errors
SYMMETRY_TOLERANCE = 1e-7  # relative difference below which a tangent counts as symmetric
SYMMETRY_ROUNDING = 1e-12  # the same relative to its largest entry
# Growth of entries in an elimination without exchanges, beside the largest, at which the signs of pivots still hold:
# rounding, 2e-16 times this, stays below the stiffness that counts as zero.
MOST_GROWTH = 1e4
SPRING_STIFFNESS = 100.0  # of springs on the conditions, relative to the largest entry of the stiffness
RIGID_STIFFNESS = 1e6  # the same at which springs count as rigid, in very large models
MOST_WAYS = 4  # soft motions of a very large model, among which the softest is looked for
MAX_STEPS = 200  # of a descent
FIRST_REACH = 0.02  # longest part of its first step, in natural scales
SINGULAR_STIFFNESS = 1e9  # that indicates a singular element, relative to that at the start of a descent


@dataclass(frozen=True)
class Tangent:
    """The tangent at one point, with coordinates in their natural scales.

    Attributes
    ----------
    K : ndarray (nf, nf)
        Symmetric part of the stiffness.
    C : ndarray (nf, nm)
        Forces of the multipliers.
    D : ndarray (nm, nf)
        Held conditions.
    """

    K: Array
    C: Array
    D: Array


def tangent(problem: Rest, q: Equations) -> Tangent:
    """Return the tangent of evaluated equations."""
    nf, A, scale = problem.structure.nf, q.matrix.sparse.toarray(), problem.x_scale
    K = scale[:, None] * A[:nf, :nf] * scale
    return Tangent((K + K.T) / 2, scale[:, None] * A[:nf, nf:], A[nf:, :nf] * scale)


def unstable_motions(problem: Rest, q: Equations) -> int | None:
    """Count the independent motions in which an equilibrium is unstable; None if this has no meaning.

    The count is the number of negative eigenvalues of the tangent [K D'; D 0], less one for each condition.  It has no
    meaning if forces have no potential (follower forces, controllers) or wheels roll.
    """
    nf = problem.structure.nf
    scale = diags_array(problem.x_scale)
    A = q.matrix.sparse.tocsc()
    K, D = scale @ A[:nf, :nf] @ scale, A[nf:, :nf] @ scale
    if not _has_potential(K):
        return None
    negative = _negative_pivots(K, D)
    if negative == 0 or (negative is not None and not D.shape[0]):
        return negative
    if not np.array_equal(problem.force_rows, problem.hold_rows):
        return None  # wheels roll
    if q.matrix.pattern.size > MAX_SIZE:
        return _negative_pivots(K, D, RIGID_STIFFNESS)
    here = tangent(problem, q)
    size, conditions = float(np.abs(here.K).max(initial=0.0)), len(here.D)
    if not size:
        return 0
    held = here.D * (size / np.linalg.norm(here.D, axis=1))[:, None]
    raised = here.K + np.diag(_neutral(here.K.diagonal(), size))
    d = ldl(np.block([[raised, held.T], [held, np.zeros((conditions, conditions))]]))[1]
    return max(0, _negative(d) - conditions)


def _neutral(own: Array, size: float) -> Array:
    """Return the stiffness (nf,) of each coordinate that counts as zero, from its own and the largest entry.

    A slender column that stands along an axis is soft across it, whatever its stiffness along it.
    """
    return np.asarray(NEUTRAL_TOLERANCE * np.maximum(np.abs(own), ROUNDED_STIFFNESS * size))


def _has_potential(K: Any) -> bool:
    """Whether a stiffness is symmetric: each difference is small beside the stiffnesses of its two coordinates.

    The moment on a slender beam is nothing beside its stiffness along its axis.
    """
    if K.nnz == 0:
        return True
    largest, off = float(abs(K).max()), (K - K.T).tocoo()
    own = np.sqrt(np.abs(K.diagonal()))
    allowed = SYMMETRY_TOLERANCE * own[off.row] * own[off.col] + SYMMETRY_ROUNDING * largest
    return bool(np.all(np.abs(off.data) <= allowed))


def _negative_pivots(K: csc_array, D: csc_array, stiffness: float = SPRING_STIFFNESS) -> int | None:
    """Count the negative eigenvalues of a symmetric stiffness (nf, nf), with stiff springs on the conditions (nm, nf).

    Zero proves that the equilibrium is stable; other counts hold where there are no conditions (the springs are not
    rigid).  By Sylvester's law of inertia, it is the number of negative pivots of a sparse elimination without
    exchanges.  None if a pivot was exchanged or has lost its digits.
    """
    size = float(np.abs(K.data).max(initial=0.0))
    lengths = np.sqrt(np.asarray(D.multiply(D).sum(axis=1)).ravel())
    D = diags_array(np.sqrt(stiffness * size) / np.maximum(lengths, 1e-300)) @ D
    whole = csc_array((K + K.T) / 2 + diags_array(_neutral(K.diagonal(), size)) + D.T @ D)
    try:
        factors = splu(whole, "MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    except RuntimeError:  # the only sign of a zero pivot
        return None
    if not np.array_equal(factors.perm_r, factors.perm_c):
        return None
    pivots = factors.U.diagonal()
    negative = int(np.sum(pivots < 0))
    grown = float(np.abs(factors.U.data).max(initial=0.0)) > MOST_GROWTH * size
    return None if negative and grown else negative


def _negative(d: Array) -> int:
    """Count the negative eigenvalues of a symmetric matrix with diagonal blocks of one or two rows."""
    diagonal, off, below = d.diagonal(), d.diagonal(-1), np.zeros(len(d), dtype=bool)
    below[1:] = off != 0  # a block of two rows has one negative eigenvalue, by the choice of its pivots
    alone = ~below
    alone[:-1] &= ~below[1:]
    return int(np.sum(diagonal[alone] < 0) + np.sum(below))


@dataclass(frozen=True)
class DescentPoint:
    """A point of a descent: coordinates, multipliers, nearby deformations, and the step that led to it.

    Attributes
    ----------
    reach : float
        Longest part of the next step, in natural scales.
    step : ndarray (nf,)
        The last step, in natural scales.
    slope : float
        Power of the unbalanced forces along it, at its start.
    """

    x: Array
    mu: Array
    unwrap_from: Array
    reach: float
    step: Array
    slope: float


def descend(
    problem: Rest, t: float, x: Array, mu: Array, unwrap_from: Array
) -> tuple[Equations, Array] | None:
    """Descend from a point to an equilibrium; return it with its multipliers, or None if none is reached."""
    if problem.structure.nf + mu.size > MAX_DESCENT_SIZE or problem.roles.zero.size:
        return None
    nf, scale = problem.structure.nf, problem.x_scale

    def evaluate(point: DescentPoint) -> tuple[Equations, float]:
        q = problem.equations(t, point.x, point.mu, point.unwrap_from)
        return q, problem.size(q, q.residual)

    def move(point: DescentPoint, q: Equations) -> DescentPoint:
        here, r = tangent(problem, q), scale * q.residual[:nf]
        overshot = float(r @ point.step) > 0.5 * abs(point.slope) > 0
        reach = 0.5 * point.reach if overshot else min(MAX_STEP, 1.5 * point.reach)
        gap = np.linalg.lstsq(here.D, q.residual[nf:], rcond=1e-12)[0] if point.mu.size else np.zeros(nf)
        step = _downhill(here, r, reach) - gap
        step *= min(1.0, MAX_STEP / max(float(np.abs(step).max(initial=0.0)), 1e-300))
        mu = (
            point.mu - np.linalg.lstsq(here.C, r + here.K @ step, rcond=1e-12)[0]
            if point.mu.size
            else point.mu
        )
        x = point.x.copy()
        x[:nf] += scale * step
        return DescentPoint(x, mu, q.balance.e, reach, step, float(r @ step))

    start = DescentPoint(x, mu, unwrap_from, FIRST_REACH, np.zeros(nf), 0.0)
    here = evaluate(start)[0]
    if not _has_potential(here.matrix.sparse.tocsc()[:nf, :nf]):
        return None  # no potential decreases along the descent
    steepest = SINGULAR_STIFFNESS * max(here.stiffness, here.balance.scale)
    found = newton(start, evaluate, move, tolerance=TOLERANCE, stalled=STALLED_TOLERANCE, most=MAX_STEPS)
    # relative to such a stiffness, every force is small: a cable without slope would seem to be in equilibrium
    if not found.converged or found.equations.stiffness > steepest:
        return None
    return found.equations, found.point.mu


def _downhill(here: Tangent, r: Array, reach: float) -> Array:
    """Return an admissible step (nf,) of descent along every eigenvector, of length `reach` at most."""
    Z, _ = null_space(here.D, r.size)
    w, V = eigh(Z.T @ here.K @ Z)
    # no step in a direction without a force, however soft
    pull = V.T @ (Z.T @ r)
    least = max(
        NEUTRAL_TOLERANCE * float(np.abs(here.K).max(initial=0.0)),
        NEUTRAL_TOLERANCE * float(np.abs(pull).max(initial=0.0)),
    )
    size = np.maximum(np.abs(w), least + 1e-300)
    parts = np.clip(pull / size, -reach, reach)
    free = np.abs(w) <= least  # their eigenvectors are any of many: only all of them together lead downhill
    most = float(np.abs(pull[free]).max(initial=0.0))
    if most:
        parts[free] = pull[free] * min(1 / (least + 1e-300), reach / most)
    return np.asarray(-Z @ (V @ parts))


def way_out(problem: Rest, q: Equations, onward: Array) -> tuple[Array, float]:
    """Return the motion in which an equilibrium is most unstable, and the magnitude of its negative stiffness.

    The motion (nf,) is of unit length, in natural scales.  Forces of that size along it move the model by about its
    size; see `_left` in load_path.py.

    Parameters
    ----------
    onward : ndarray (n,)
        On the side of this displacement, if it has a part in that motion.
    """
    nf, scale = problem.structure.nf, problem.x_scale
    unit = diags_array(scale**-2.0)
    below = -FAR_BELOW * q.stiffness * float(scale.max()) ** 2
    w, V = Pencil.of(problem, q, unit).lowest(MOST_WAYS, below)
    way = V[:, 0].real / scale
    way /= np.linalg.norm(way)
    side = float(way @ (onward[:nf] / scale))
    if abs(side) < NEUTRAL_TOLERANCE:
        side = float(way[np.argmax(np.abs(way))])
    return np.sign(side) * way, abs(float(w[0].real))
