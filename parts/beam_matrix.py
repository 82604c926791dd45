"""Stiffness matrices of beams, from the pages of their laws: for modes that are released or given one by one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.single import law_stiffness
from flexel.generated.table import LAWS
from flexel.parts.beam_laws import beam_laws


def beam_matrix(l0: float, modes: Sequence[str], given: Mapping[str, float], planar: bool = False) -> Array:
    """Return the stiffness matrix (modes, modes) of a beam without damping; zero for modes without a stiffness.

    Parameters
    ----------
    modes : sequence of str
        Names of deformations of the element.
    given : mapping of str to float
        EA, GJ, EIy, EIz, GAy, GAz, EIw, as of `Model.beam`.
    """
    K = np.zeros((len(modes), len(modes)))
    for part in beam_laws(given, planar):
        own = [i for i, mode in enumerate(part.modes) if mode in modes]
        values = {page: given.get(name, 0.0) for page, name in part.called.items()}
        places = [modes.index(part.modes[i]) for i in own]
        K[np.ix_(places, places)] = law_stiffness(LAWS[part.law], values | {"l0": l0})[np.ix_(own, own)]
    return K
