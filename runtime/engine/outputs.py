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


class OutputTable:
    """The outputs of some elements of one type, which are evaluated together.

    Parameters
    ----------
    structure : Structure
    elements : sequence of Instance
        At least one; all of the same type.
    """

    def __init__(self, structure: Structure, elements: Sequence[Instance]) -> None:
        self.elements, self.spec = elements, elements[0].spec
        self.names = [element.name for element in elements]
        self.nothing = np.zeros(structure.m + structure.k)  # stresses, where these do not matter
        self._at = np.array(
            [np.concatenate([structure.places(node) for node in element.nodes]) for element in elements]
        )
        modes = [
            [structure.index[name] for name in (*element.deformations, *element.slips)]
            for element in elements
        ]
        self._of = np.array(modes, dtype=np.intp).reshape(len(elements), -1)
        self._p = np.array([element.p for element in elements])

    def evaluate(self, x: Array, e: Array, stresses: Array) -> dict[str, Array]:
        """Return the outputs by name, (states, elements, ...) each.

        Parameters
        ----------
        x : ndarray (states, n)
            Coordinates of the model.
        e : ndarray (states, m)
            Deformations of the model.
        stresses : ndarray (states, m + k)
            Generalized stresses of the model.
        """
        spec, count, m = self.spec, len(self.elements), len(self.spec.deformations)
        if not spec.outputs:
            return {}
        step = max(AT_ONCE // count, 1)
        parts = []
        for first in range(0, len(x), step):
            some = slice(first, first + step)
            states = len(x[some])
            found = {
                "x": x[some][:, self._at],
                "e": e[some][:, self._of[:, :m]],
                "sigma": stresses[some][:, self._of[:, :m]],
                "tau": stresses[some][:, self._of[:, m:]],
                "p": np.broadcast_to(self._p, (states, *self._p.shape)),
            }
            rows = [found[name] for name in spec.kernels["outputs"].inputs]
            inputs = [values.reshape(states * count, values.shape[-1]) for values in rows]
            parts.append(_called(self.elements[0], inputs))
        return {
            output.name: np.concatenate([part[i] for part in parts]).reshape(len(x), count, *output.shape)
            for i, output in enumerate(spec.outputs)
        }


def element_outputs(
    structure: Structure, elements: Sequence[Instance], x: Array, e: Array, stresses: Array
) -> dict[str, Array]:
    """Return the outputs of some elements of one type by name; parameters as of `OutputTable` and its `evaluate`."""
    return OutputTable(structure, elements).evaluate(x, e, stresses)


def ranged(structure: Structure) -> list[OutputTable]:
    """Return the elements whose pages declare a range, by type."""
    types: dict[int, list[Instance]] = {}
    for element in structure.instances:
        if any(output.limit for output in element.spec.outputs):
            types.setdefault(id(element.spec), []).append(element)
    return [OutputTable(structure, elements) for elements in types.values()]


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
