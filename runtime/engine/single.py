"""A single built-in law, without a model."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from flexel.base.arrays import Array
from flexel.derive.spec import LawSpec
from flexel.engine.batches import kernel_struct, pointers
from flexel.engine.lanes import LANES, blocks


def law_stiffness(spec: LawSpec, parameters: Mapping[str, float]) -> Array:
    """Return the stiffness matrix (m, m) of a law without slips, at zero deformations and rates.

    Parameters
    ----------
    parameters : mapping of str to float
        By name; each a single number.
    """
    m = spec.deformations
    p = np.array([[parameters[parameter.name] for parameter in spec.parameters]])
    none = np.zeros((1, m))
    ins = [blocks(values) for values in (none, none, none[:, :0], none[:, :0], np.zeros((1, 1)), p)]
    (output,) = spec.kernels["tangent"].outputs
    out = np.zeros((len(output.nonzeros), LANES))
    struct = kernel_struct(spec, None)
    struct.tangent(1, *pointers(ins, [out]))
    J = np.zeros(output.shape)
    J.flat[list(output.nonzeros)] = out[:, 0]
    return J[:, :m]
