"""Calls compiled kernels on arrays, whatever shared object they live in.

Works on any pair of a spec (as in ``flexel.generated.table``) and the address of a ``flexel_element`` or
``flexel_law``.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexel.derive.processor import check_processor
from flexel.derive.spec import ElementSpec, LawSpec

Array = NDArray[np.float64]
BLOCK = 8


def blocks(values: Array) -> Array:
    """Arrange rows of elements (count, r) as blocks (nblocks, r, 8), filled up with not-a-number."""
    count, rows = values.shape
    nblocks = -(-count // BLOCK)
    filled = np.full((nblocks * BLOCK, rows), np.nan)
    filled[:count] = values
    return np.ascontiguousarray(filled.reshape(nblocks, BLOCK, rows).transpose(0, 2, 1))


class Compiled:
    """Compiled kernels of an element or a law.

    Parameters
    ----------
    spec : ElementSpec or LawSpec
    address : int
        Address of the ``flexel_element`` or ``flexel_law``.
    """

    def __init__(self, spec: ElementSpec | LawSpec, address: int) -> None:
        from flexel.generated._kernels import ffi

        self.spec = spec
        self._ffi: Any = ffi
        kind = "flexel_element" if isinstance(spec, ElementSpec) else "flexel_law"
        self.struct: Any = ffi.cast(f"const {kind} *", address)

    def has(self, kernel: str) -> bool:
        """Whether there is such a kernel, in the spec and in the struct."""
        return kernel in self.spec.kernels and getattr(self.struct, kernel) != self._ffi.NULL

    def __call__(self, kernel: str, data: Mapping[str, Array]) -> dict[str, Array]:
        """Evaluate a kernel.

        Parameters
        ----------
        kernel : str
        data : mapping
            Inputs by name, each (count, r).

        Returns
        -------
        dict
            Outputs by name, each (count, *shape), structural zeros filled in; not-a-number where the kernel
            writes nothing, or anything beyond the rows that its spec names.
        """
        spec = self.spec.kernels[kernel]
        count = len(data[spec.inputs[0]])
        inputs = [blocks(data[name]) for name in spec.inputs]
        nblocks = len(inputs[0])
        results = [np.full(nblocks * BLOCK * int(np.prod(output.shape)), np.nan) for output in spec.outputs]
        pointers = [self._pointers(arrays) for arrays in (inputs, results)]
        constant, variable = "const double *const *", "double *const *"
        call = getattr(self.struct, kernel)
        call(nblocks, self._ffi.cast(constant, pointers[0]), self._ffi.cast(variable, pointers[1]))
        outputs = {}
        for output, result in zip(spec.outputs, results, strict=True):
            rows = len(output.nonzeros)
            stored, beyond = np.split(result, [nblocks * rows * BLOCK])
            full = np.zeros((count, int(np.prod(output.shape))))
            by_element = (
                stored.reshape(nblocks, rows, BLOCK).transpose(0, 2, 1).reshape(nblocks * BLOCK, rows)
            )
            full[:, list(output.nonzeros)] = by_element[:count]
            if not np.isnan(beyond).all():  # the kernel stores more than its spec says
                full[:] = np.nan
            outputs[output.name] = full.reshape(count, *output.shape)
        return outputs

    def _pointers(self, arrays: list[Array]) -> Any:
        pointers = [self._ffi.cast("double *", array.ctypes.data if array.size else 0) for array in arrays]
        return self._ffi.new("double *[]", pointers)


def generated_elements() -> dict[str, tuple[ElementSpec | LawSpec, int]]:
    """Return spec and address of every element and law in ``flexel.generated``, laws as ``law_<name>``."""
    from flexel.generated._kernels import ffi, lib
    from flexel.generated.table import ELEMENTS, LAWS

    check_processor(ffi, lib)
    found: dict[str, tuple[ElementSpec | LawSpec, int]] = {}
    for prefix, table in (("", ELEMENTS), ("law_", LAWS)):
        for name, spec in table.items():
            struct = ffi.addressof(getattr(lib, f"flexel_{prefix}{name}"))
            found[prefix + name] = (spec, int(ffi.cast("uintptr_t", struct)))
    return found


def built_in() -> frozenset[str]:
    """Return the names of the elements in ``flexel.generated``."""
    from flexel.generated.table import ELEMENTS

    return frozenset(ELEMENTS)
