"""Evaluates the outputs of elements: section forces, tensions, places that a picture draws."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.batches import kernel_struct, pointers
from flexel.engine.lanes import LANES, blocks
from flexel.model.instances import Instance
from flexel.model.structure import Structure

AT_ONCE = 4096  # elements in a call, so that the arrays of a long motion stay small


def element_outputs(
    structure: Structure, elements: Sequence[Instance], x: Array, e: Array, stresses: Array
) -> dict[str, Array]:
    """Return the outputs of some elements of one type by name, (states, elements, ...) each.

    Parameters
    ----------
    structure : Structure
    elements : sequence of Instance
        At least one; all of the same type.
    x : ndarray (states, n)
        Coordinates of the model.
    e : ndarray (states, m)
        Deformations of the model.
    stresses : ndarray (states, m + k)
        Generalized stresses of the model.
    """
    spec, states = elements[0].spec, len(x)
    if not spec.outputs:
        return {}
    at = np.array(
        [np.concatenate([structure.places(node) for node in element.nodes]) for element in elements]
    )
    modes = [
        [structure.index[name] for name in (*element.deformations, *element.slips)] for element in elements
    ]
    of = np.array(modes, dtype=np.intp).reshape(len(elements), -1)
    m, p = len(spec.deformations), np.array([element.p for element in elements])
    step = max(AT_ONCE // len(elements), 1)
    parts = []
    for first in range(0, states, step):
        some = slice(first, first + step)
        count = len(x[some]) * len(elements)
        found = {
            "x": x[some][:, at],
            "e": e[some][:, of[:, :m]],
            "sigma": stresses[some][:, of[:, :m]],
            "tau": stresses[some][:, of[:, m:]],
            "p": np.broadcast_to(p, (len(x[some]), *p.shape)),
        }
        inputs = [found[name] for name in spec.kernels["outputs"].inputs]
        parts.append(_called(elements[0], [rows.reshape(count, rows.shape[-1]) for rows in inputs]))
    return {
        output.name: np.concatenate([part[i] for part in parts]).reshape(states, len(elements), *output.shape)
        for i, output in enumerate(spec.outputs)
    }


def _called(element: Instance, inputs: Sequence[Array]) -> list[Array]:
    """Return the outputs (count, entries) of elements of one type from the inputs (count, rows) of their kernel."""
    spec, count, ins = element.spec, len(inputs[0]), [blocks(values) for values in inputs]
    outs = [np.empty((len(ins[0]), len(output.nonzeros), LANES)) for output in spec.outputs]
    kernel_struct(spec, element.kernels).outputs(len(ins[0]), *pointers(ins, outs))
    found = [np.zeros((count, prod(output.shape))) for output in spec.outputs]
    for full, output, out in zip(found, spec.outputs, outs, strict=True):
        by_element = out.transpose(0, 2, 1).reshape(len(ins[0]) * LANES, len(output.nonzeros))
        full[:, list(output.nonzeros)] = by_element[:count]
    return found
