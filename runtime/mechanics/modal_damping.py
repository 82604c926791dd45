"""Adds modal damping: every mode of a linearization gets the same damping ratio."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.linalg import eigh

from flexel.base.arguments import not_negative
from flexel.base.errors import DynamicsError, LinearizationError
from flexel.mechanics.linearized_system import LinearizedSystem


def with_modal_damping(lin: LinearizedSystem, ratio: float) -> LinearizedSystem:
    """Add the damping 2 ζ ω of each undamped mode to C; unstable modes get none.

    Parameters
    ----------
    lin : LinearizedSystem
        About a state of rest, without rolling wheels.
    ratio : float
        Damping ratio ζ of all modes.

    Raises
    ------
    LinearizationError
        If there are kinematic coordinates.
    DynamicsError
        If a motion has no mass.
    """
    zeta = not_negative(ratio, "modal damping", "damping ratio")
    if lin.kinematic:
        raise LinearizationError(
            "modal damping: a mechanism with rolling wheels has no undamped modes; use dampers"
        )
    if not zeta:
        return lin
    try:
        w2, V = eigh((lin.K + lin.K.T) / 2, lin.M)
    except np.linalg.LinAlgError as error:
        raise DynamicsError("modal damping: a motion has no mass; give it a mass or a density") from error
    MV = lin.M @ V
    return replace(lin, C=lin.C + (MV * (2 * zeta * np.sqrt(np.maximum(w2, 0.0)))) @ MV.T)
