"""Compares every output of every kernel of one element or law with its expected value.

A relative error is |computed - reference| over the largest entry of that output, floored by the natural scale
(l0 or 1).
"""

import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from flexel.derive.declare import Element, Law
from flexel.derive.spec import ElementSpec, LawSpec
from flexel.derive.verify.definition import Definition, LawDefinition
from flexel.derive.verify.differences import Differences, law_differences
from flexel.derive.verify.kernel_calls import Compiled
from flexel.derive.verify.reference import Reference, law_outputs
from flexel.derive.verify.report import KernelRow
from flexel.derive.verify.samples import NOTHING, Ranges, element_samples, lanes, law_samples

Array = NDArray[np.float64]
Outputs = Mapping[str, Array]

BATCH = 33  # four full blocks and one element
SIZES = (1, 7, 8)  # smaller batches that must give the same bits
CHOSEN = (
    0,
    9,
    23,
    32,
)  # elements of the batch compared with the definition: two anywhere, two near zero deformation
KINEMATIC = ("position", "acceleration", "rates", "kinematics", "stiffness")
DYNAMIC = ("inertia", "tangent")


def relative_error(computed: Array, reference: Array, scale: Array) -> float:
    """Return the largest relative error over a batch; entries of the reference that are nan were not requested.

    Parameters
    ----------
    computed, reference : ndarray, (count, ...)
    scale : ndarray, (count,)
        Natural scale of each element.
    """
    if computed.shape != reference.shape:
        return math.inf
    if not computed.size:
        return 0.0
    if not np.isfinite(computed).all():
        return math.inf
    axes = tuple(range(1, computed.ndim))
    largest = np.maximum(np.nanmax(np.abs(reference), axis=axes, initial=0.0), scale)
    worst = np.nanmax(np.abs(computed - reference), axis=axes, initial=0.0)
    return float((worst / largest).max())


def same_bits(compiled: Compiled, kernel: str, data: Outputs, batch: Outputs) -> dict[str, bool]:
    """Whether batches of other sizes, and every element alone, give exactly what the whole batch gives."""
    parts = [slice(i, i + 1) for i in range(BATCH)] + [slice(0, size) for size in SIZES]
    same = dict.fromkeys(batch, True)
    for part in parts:
        for name, values in compiled(kernel, lanes(data, part)).items():
            same[name] &= bool(np.array_equal(values, batch[name][part]))
    return same


def _kernel_rows(
    name: str,
    kernel: str,
    compiled: Compiled,
    data: Outputs,
    scale: Array,
    differences: Outputs,
    references: Sequence[Outputs],
    compared: Sequence[int] = CHOSEN,
) -> list[KernelRow]:
    """Return one row for each output of one kernel; the references are those of the elements that are compared."""
    computed = compiled(kernel, data)
    same = same_bits(compiled, kernel, data, computed)
    chosen = list(compared)
    rows = []
    for output in references[0]:
        reference = np.array([r[output] for r in references])
        if output not in computed:
            rows.append(KernelRow(name, kernel, output, math.nan, math.inf, False, "output is missing"))
            continue
        below = differences.get(output)
        by_differences = math.nan if below is None else relative_error(computed[output], below, scale)
        by_definition = relative_error(computed[output][chosen], reference, scale[chosen])
        rows.append(KernelRow(name, kernel, output, by_differences, by_definition, same[output]))
    return rows


def _missing(name: str, kernel: str) -> KernelRow:
    return KernelRow(name, kernel, "*", math.nan, math.inf, False, "kernel is missing")


def _mismatch(compiled: Compiled, sizes: Mapping[str, int]) -> list[KernelRow]:
    """Return rows for sizes in the struct that differ from the definition."""
    found = {key: int(getattr(compiled.struct, key)) for key in sizes}
    wrong = [f"{key} = {found[key]}, not {size}" for key, size in sizes.items() if found[key] != size]
    return [
        KernelRow(compiled.spec.name, "struct", "sizes", math.nan, math.inf, True, text) for text in wrong
    ]


def element_rows(element: Element, compiled: Compiled, ranges: Ranges = NOTHING) -> list[KernelRow]:
    """Verify all kernels of an element, within ranges of coordinates and parameters."""
    sizes = {"n": len(element.x), "m": len(element.deformations), "k": len(element.slips)}
    sizes["np"] = len(element.parameter_symbols)
    if wrong := _mismatch(compiled, sizes):
        return wrong
    wanted = (KINEMATIC if element.deformations or element.slips else ()) + (
        DYNAMIC if element.kinetic_energy != 0 or element.potential != 0 else ()
    )
    wanted += ("outputs",) if element.outputs else ()
    if missing := [_missing(element.name, kernel) for kernel in wanted if not compiled.has(kernel)]:
        return missing
    data = element_samples(element, compiled, BATCH, ranges)
    differences = Differences(compiled, data, _periods(compiled.spec, data["p"]))
    definition = Definition(element)
    scale = _scale(element, data["p"])
    rows = []
    for kernel in wanted:
        expected = [
            Reference(definition, one_element(data, i), _columns(sizes["n"], turn)).outputs(kernel)
            for turn, i in enumerate(CHOSEN)
        ]
        below = differences.outputs(kernel)
        rows += _kernel_rows(element.name, kernel, compiled, data, scale, below, expected)
    return rows


def _periods(spec: ElementSpec | LawSpec, p: Array) -> Array:
    """Return the periods (count, m) of the deformations of each element of a batch, zero where there is none."""
    if not isinstance(spec, ElementSpec):
        return np.zeros((len(p), 0))
    ends = np.cumsum([0, *(parameter.size for parameter in spec.parameters)])
    places = {parameter.name: slice(*ends[i : i + 2]) for i, parameter in enumerate(spec.parameters)}
    by_element = ({name: row[place] for name, place in places.items()} for row in p)
    return np.array([[d.repeats(values) for d in spec.deformations] for values in by_element])


def _columns(n: int, turn: int) -> Sequence[int]:
    """Return the columns of the inertia's tangents: all if they are few, else those whose turn it is."""
    return range(n) if n <= 8 else range(turn, n, len(CHOSEN))


def _scale(element: Element, p: Array) -> Array:
    """Return the natural scale of each element of a batch: its length l0 if it has one, else 1."""
    names = [s.name for s in element.parameter_symbols]
    return np.abs(p[:, names.index("l0")]) if "l0" in names else np.ones(len(p))


def law_rows(law: Law, compiled: Compiled, ranges: Ranges = NOTHING) -> list[KernelRow]:
    """Verify both kernels of a law, within ranges of deformations, slips and parameters."""
    name = f"law {law.name}"
    sizes = {"m": len(law.e), "k": len(law.s), "nz": len(law.z), "np": len(law.parameter_symbols)}
    if wrong := _mismatch(compiled, sizes):
        return wrong
    kernels = ("law", "tangent")
    if missing := [_missing(name, kernel) for kernel in kernels if not compiled.has(kernel)]:
        return missing
    data = law_samples(law, BATCH, ranges)
    definition = LawDefinition(law)
    rows = []
    for kernel in kernels:
        below = law_differences(compiled, kernel, data)
        expected = [law_outputs(definition, kernel, one_element(data, i)) for i in CHOSEN]
        found = _kernel_rows(name, kernel, compiled, data, np.ones(BATCH), below, expected)
        if any(row.by_definition and not row.ok for row in found):
            found = _by_definition_alone(name, kernel, compiled, data, definition, found)
        rows += found
    return rows


def _by_definition_alone(
    name: str,
    kernel: str,
    compiled: Compiled,
    data: Outputs,
    definition: LawDefinition,
    found: Sequence[KernelRow],
) -> list[KernelRow]:
    """Compare the whole batch with the definition where differences of double numbers have lost their digits.

    A small change of a large quantity, such as the weight of a satellite over some metres, has few digits in double
    precision, whatever the step.  The definition has 60.
    """
    everywhere = range(BATCH)
    expected = [law_outputs(definition, kernel, one_element(data, i)) for i in everywhere]
    again = _kernel_rows(name, kernel, compiled, data, np.ones(BATCH), {}, expected, everywhere)
    return [
        row if row.ok or not row.by_definition else other for row, other in zip(found, again, strict=True)
    ]


def one_element(data: Outputs, i: int) -> dict[str, Array]:
    """Return the inputs of one element of a batch, one column each."""
    return {name: values[i] for name, values in data.items()}
