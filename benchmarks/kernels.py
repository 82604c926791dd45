"""Nanoseconds per element of the compiled kernels, batched in blocks of 8, without any Python in between."""

from typing import Any

import numpy as np
from timing import Row, best

from flexel.engine.lanes import LANES, blocks
from flexel.generated._kernels import ffi, lib
from flexel.generated.table import ELEMENTS
from flexel.structure.nodes import COMPONENTS

ELEMENTS_IN_BATCH = 128  # inputs and outputs stay in the second-level cache
RUNS = 200  # passes over the batch in one C call


def calls(element: str, kinds: tuple[str, ...]) -> tuple[Any, list[Any]]:
    """A table of C calls of the given kernels of one element type, at random configurations, and what it points to."""
    spec, rng = ELEMENTS[element], np.random.default_rng(2)
    size = {"x": 0, "v": 0, "a": 0, "sigma": len(spec.deformations), "tau": len(spec.slips)}
    n = sum(len(COMPONENTS[node.kind]) for node in spec.nodes)
    size |= {"x": n, "v": n, "a": n, "p": sum(z.size for z in spec.parameters)}
    values = {key: blocks(rng.uniform(0.5, 1.0, (ELEMENTS_IN_BATCH, k))) for key, k in size.items()}
    keep: list[Any] = [values]
    rows = []
    count = ELEMENTS_IN_BATCH // LANES
    for kind in kinds:
        kernel = spec.kernels[kind]
        outs = [np.zeros(max(count * len(out.nonzeros) * LANES, 1)) for out in kernel.outputs]
        ins = ffi.new("double *[]", [ffi.cast("double *", values[z].ctypes.data) for z in kernel.inputs])
        pointers = ffi.new("double *[]", [ffi.cast("double *", z.ctypes.data) for z in outs])
        keep += [outs, ins, pointers]
        rows.append(
            {
                "kernel": getattr(getattr(lib, f"flexel_{element}"), kind),
                "nblocks": count,
                "in": ffi.cast("const double *const *", ins),
                "out": pointers,
            }
        )
    return ffi.new("flexel_call[]", rows * RUNS), keep


def per_element(element: str, *kinds: str) -> float:
    """Seconds for one element's share of the given kernels."""
    table, keep = calls(element, kinds)
    seconds = best(lambda: lib.flexel_run(len(table), table), repeat=9)
    del keep
    return seconds / (RUNS * ELEMENTS_IN_BATCH)


def measure() -> list[Row]:
    """The figures of this file."""
    rows = [Row("beam: e, De, D²e(v,v)", per_element("beam", "position", "acceleration"), 60e-9, 20e-9)]
    rows += [Row(f"beam: {kind}", per_element("beam", kind)) for kind in ELEMENTS["beam"].kernels]
    other = [z for z in ("hinge", "wheel", "truss", "body") if z in ELEMENTS]
    for element in other:
        kinds = [k for k in ("position", "acceleration", "inertia") if k in ELEMENTS[element].kernels]
        rows.append(Row(f"{element}: {', '.join(kinds)}", per_element(element, *kinds)))
    return rows
