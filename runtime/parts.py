"""Parameters of the elements from the drawn geometry: lengths, reference triads, stiffness matrices.

One function per element family; each takes the initial coordinates of the nodes and what the user gave, and
returns the parameters that the kernels need.  Imports numpy, the errors and the orientation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from flexel.errors import ModelError
from flexel.orientation import conjugate, matrix, product, triad, unit, vector
from flexel.structure import Array

Parameters = dict[str, Array]


def positive(value: float, owner: str, what: str) -> float:
    """A positive finite number, or a ModelError."""
    number = float(vector([value], owner, what, 1)[0])
    if number <= 0:
        raise ModelError(f"{owner}: {what} {number:g} is not positive; give a positive value")
    return number


def not_negative(value: float, owner: str, what: str) -> float:
    """A finite number that is zero or positive, or a ModelError."""
    number = float(vector([value], owner, what, 1)[0])
    if number < 0:
        raise ModelError(f"{owner}: {what} {number:g} is negative; give zero or a positive value")
    return number


def span(xp: Array, xq: Array, owner: str) -> tuple[Array, float]:
    """Direction and length of the line between two points."""
    line = xq - xp
    length = float(np.linalg.norm(line))
    if length < 1e-12 * max(1.0, float(np.max(np.abs(xp)))):
        raise ModelError(
            f"{owner}: its two points coincide at {tuple(xp)}; the element has no length, move one"
        )
    return line / length, length


def inertia_tensor(value: Any, owner: str) -> Array:
    """Inertia tensor as (xx, yy, zz, xy, xz, yz), from three principal values, six entries or a matrix.

    Raises
    ------
    ModelError
        If it is not positive definite, or a principal moment exceeds the sum of the other two.
    """
    J = np.asarray(value, dtype=float)
    if J.shape == (3,):
        J = np.diag(J)
    elif J.shape == (6,):
        xx, yy, zz, xy, xz, yz = J
        J = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if J.shape != (3, 3) or not np.all(np.isfinite(J)) or not np.allclose(J, J.T, rtol=1e-12, atol=0):
        raise ModelError(
            f"{owner}: inertia must be 3 principal moments, (xx, yy, zz, xy, xz, yz) or symmetric 3x3"
        )
    w = np.linalg.eigvalsh(J)
    if w[0] <= 0:
        raise ModelError(
            f"{owner}: inertia is not positive definite (principal moments {w}); check the signs"
        )
    if w[2] > (w[0] + w[1]) * (1 + 1e-12):
        raise ModelError(
            f"{owner}: principal moments {w} violate the triangle inequality (none may exceed the sum of the others); "
            "no body has such inertia"
        )
    return np.array([J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[0, 2], J[1, 2]])


def in_frame(frame: Array, triad_: Array) -> Array:
    """Triad, given in global axes, as seen from a body frame."""
    return product(conjugate(frame), triad_)


def hinge(rp: Array, rq: Array, axis: Any, owner: str) -> Parameters:
    """Reference triads of a hinge about an axis given in global directions of the drawing."""
    t = triad(unit(axis, owner, "axis"), None, owner)
    return {"tp": in_frame(rp, t), "tq": in_frame(rq, t)}


def bearing(xp: Array, rp: Array, xq: Array, rq: Array, axis: Any, owner: str) -> Parameters:
    """Reference triads and offset of a bearing."""
    t = triad(unit(axis, owner, "axis"), None, owner)
    return {"tp": in_frame(rp, t), "tq": in_frame(rq, t), "d0": matrix(t).T @ (xq - xp)}


def beam(
    xp: Array, rp: Array, xq: Array, rq: Array, direction: Any, owner: str, *, rhoA: float, rhoJ: Any
) -> Parameters:
    """Length, triads and mass of a straight beam; `direction` gives the section's y axis."""
    e_x, l0 = span(xp, xq, owner)
    t = triad(e_x, direction, owner)
    return {
        "l0": np.array([l0]),
        "tp": in_frame(rp, t),
        "tq": in_frame(rq, t),
        "rhoA": np.array([not_negative(rhoA, owner, "mass_per_length")]),
        "rhoJ": section_inertia(rhoJ, owner),
    }


def beam3(xp: Array, rp: Array, xq: Array, owner: str, *, rhoA: float, rhoJ: Any) -> Parameters:
    """Offset and mass of a rigid three-node beam; with coinciding points, a mere connection."""
    line = xq - xp
    l0 = float(np.linalg.norm(line))
    t = triad(line / l0, None, owner) if l0 > 0 else rp
    return {
        "tp": in_frame(rp, t),
        "d0": matrix(t).T @ line,
        "l0": np.array([l0]),
        "rhoA": np.array([not_negative(rhoA, owner, "mass_per_length")]),
        "rhoJ": section_inertia(rhoJ, owner),
    }


def section_inertia(value: Any, owner: str) -> Array:
    """Rotary inertia of a section per length (x, y, z), entries zero or positive."""
    J = vector(value, owner, "inertia_per_length", 3)
    if np.any(J < 0):
        raise ModelError(f"{owner}: inertia_per_length {tuple(J)} has a negative entry; give zero or more")
    return J


def direction_angle(xp: Array, xq: Array, owner: str) -> tuple[float, float]:
    """Angle to the x axis and length of a line in the plane."""
    e, l0 = span(xp, xq, owner)
    return float(np.arctan2(e[1], e[0])), l0


def planar_beam(
    xp: Array, phi_p: float, xq: Array, phi_q: float, owner: str, *, rhoA: float, rhoJ: float
) -> Parameters:
    """Length, reference directions and mass of a planar beam."""
    alpha, l0 = direction_angle(xp, xq, owner)
    return {
        "l0": np.array([l0]),
        "alpha0": np.array([alpha - phi_p]),
        "alphaq0": np.array([alpha - phi_q]),
        "rhoA": np.array([not_negative(rhoA, owner, "mass_per_length")]),
        "rhoJ": np.array([not_negative(rhoJ, owner, "inertia_per_length")]),
    }


def planar_beam3(xp: Array, phi: float, xq: Array, owner: str, *, rhoA: float, rhoJ: float) -> Parameters:
    """Reference direction, offset and mass of a planar rigid link."""
    alpha, l0 = direction_angle(xp, xq, owner) if np.any(xq != xp) else (phi, 0.0)
    return {
        "alpha0": np.array([alpha - phi]),
        "d0": np.array([l0, 0.0]),
        "l0": np.array([l0]),
        "rhoA": np.array([not_negative(rhoA, owner, "mass_per_length")]),
        "rhoJ": np.array([not_negative(rhoJ, owner, "inertia_per_length")]),
    }


def wheel(
    xw: Array, rw: Array, xc: Array, radius: float, axle: Any, normal: Any, height: float, owner: str
) -> Parameters:
    """Radius, axle in body axes and road of a wheel; `axle` is a global direction of the drawing.

    Raises
    ------
    ModelError
        If the axle is normal to the road: the wheel lies flat and has no lowest point.
    """
    a, n = unit(axle, owner, "axle"), unit(normal, owner, "road normal")
    if np.linalg.norm(np.cross(a, n)) < 1e-6:
        raise ModelError(
            f"{owner}: its axle {tuple(a)} is normal to the road, so that no point is lowest; tilt it"
        )
    if np.linalg.norm(xc - xw) < 1e-12:
        raise ModelError(
            f"{owner}: contact point and hub coincide at {tuple(xw)}; put the contact on the road"
        )
    return {
        "radius": np.array([positive(radius, owner, "radius")]),
        "axle": matrix(rw).T @ a,
        "normal": n,
        "height": vector([height], owner, "road height", 1),
    }


def shear_numbers(
    l0: float, EIy: float, EIz: float, GAy: float | None, GAz: float | None
) -> tuple[float, float]:
    """Shear numbers (Φ_y, Φ_z) = 12 E I / (k G A l0²) of deflection in y and in z; 0 without shear stiffness."""
    phi_y = 12 * EIz / (GAy * l0**2) if GAy else 0.0
    phi_z = 12 * EIy / (GAz * l0**2) if GAz else 0.0
    return phi_y, phi_z


def bending_block(EI: float, phi: float, l0: float) -> Array:
    """Stiffness (2, 2) of the two bending modes of one plane."""
    return np.array([[4 + phi, -2 + phi], [-2 + phi, 4 + phi]]) * EI / ((1 + phi) * l0**3)


def beam_stiffness(
    l0: float, modes: Sequence[str], given: Mapping[str, float | None], phi_y: float, phi_z: float
) -> tuple[list[str], Array]:
    """Flexible modes, in the order of `modes`, and their stiffness matrix.

    Parameters
    ----------
    modes : sequence of str
        The element's deformations.
    given : mapping
        EA, GJ, EIy, EIz; None or absent means that these modes are rigid.
    """
    K = np.zeros((6, 6))
    names = ["elongation", "torsion", "bend1", "bend2", "bend3", "bend4"]
    flexible = np.zeros(6, dtype=bool)
    for key, place, scale in (("EA", 0, 1 / l0), ("GJ", 1, 1 / l0**3)):
        if given.get(key) is not None:
            K[place, place], flexible[place] = float(given[key] or 0.0) * scale, True
    for key, place, phi in (("EIy", 2, phi_z), ("EIz", 4, phi_y)):
        if given.get(key) is not None:
            K[place : place + 2, place : place + 2] = bending_block(float(given[key] or 0.0), phi, l0)
            flexible[place : place + 2] = True
    if len(modes) == 3:  # planar: elongation, and the bending modes of the plane with normal z
        names, flexible, K = list(modes), flexible[[0, 4, 5]], K[np.ix_([0, 4, 5], [0, 4, 5])]
    keep = np.flatnonzero(flexible)
    return [names[i] for i in keep], K[np.ix_(keep, keep)]
