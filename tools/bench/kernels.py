"""Times the compiled kernels, in nanoseconds per element, called in batches without a system around them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from bench.timing import Work
from flexel.generated._kernels import ffi, lib
from flexel.generated.table import ELEMENTS
from flexel.model.node import COMPONENTS

LANES = 8  # elements in a block, see generated/kernels.h
BLOCKS = 16  # inputs and outputs stay in the second-level cache
PASSES = 50  # in one run


def beam() -> Work:
    """Time position and acceleration of a beam: e, De and D²e(v,v)."""
    calls = [batch("beam", kind) for kind in ("position", "acceleration")]

    def passes(blocks: int) -> None:
        for _ in range(PASSES):
            for call in calls:
                call(blocks)

    return Work(lambda: passes(BLOCKS), count=PASSES * BLOCKS * LANES, idle=lambda: passes(0))


def batch(element: str, kind: str) -> Callable[[int], None]:
    """Time a kernel of one element type at random configurations, called with a number of blocks."""
    spec, rng = ELEMENTS[element], np.random.default_rng(2)
    kernel = spec.kernels[kind]
    n = sum(len(COMPONENTS[node.kind]) for node in spec.nodes)
    size = {"x": n, "v": n, "p": sum(parameter.size for parameter in spec.parameters)}
    ins = [rng.uniform(0.5, 1.0, size[name] * BLOCKS * LANES) for name in kernel.inputs]
    outs = [np.zeros(max(len(output.nonzeros) * BLOCKS * LANES, 1)) for output in kernel.outputs]
    given, found = pointers(ins), pointers(outs)
    function = getattr(getattr(lib, f"flexel_{element}"), kind)

    def call(blocks: int, arrays: Any = (ins, outs)) -> None:  # kept alive for the pointers
        function(blocks, given, found)

    return call


def pointers(arrays: list[Any]) -> Any:
    """Return a C array of pointers to arrays."""
    return ffi.new("double *[]", [ffi.cast("double *", array.ctypes.data) for array in arrays])
