"""Checks that a user's element or law must pass before it is released: of its definition and of its kernels."""

from dataclasses import replace

import numpy as np
import sympy as sp

from flexel.derive.check.joins import check_element_joins
from flexel.derive.check.smooth import check_smooth
from flexel.derive.check.stored import check_stored
from flexel.derive.compiled import CompiledElement, CompiledLaw
from flexel.derive.declare import Element, Law
from flexel.derive.definition_errors import VerificationError
from flexel.derive.verify import KernelRow, Verification, verify
from flexel.derive.verify.kernel_calls import Compiled, built_in
from flexel.derive.verify.kernel_comparison import BATCH
from flexel.derive.verify.samples import NOTHING, Ranges, element_samples, law_samples

KINKED = (sp.Piecewise, sp.Min, sp.Max, sp.Abs, sp.sign, sp.Heaviside)


def check_definition(declared: Element | Law) -> None:
    """Raise ValueError for an element with the name of a built-in one, or with a function with a kink."""
    if isinstance(declared, Law):
        return
    if declared.name in built_in():
        raise ValueError(f"{declared.owner}: flexel has an element of this name; choose another")
    for what, expr in _expressions(declared):
        check_smooth(declared.owner, what, sp.sympify(expr))
        check_element_joins(declared.owner, what, sp.sympify(expr))


def check_compiled(
    declared: Element | Law, compiled: CompiledElement | CompiledLaw, ranges: Ranges = NOTHING
) -> Verification:
    """Verify compiled kernels; raise VerificationError where they are not finite, or differ from the definition."""
    rows = compared(declared, compiled, ranges)
    if wrong := [row for row in rows if not row.ok]:
        found = Verification(tuple(wrong), 0.0).table()
        raise VerificationError(
            f"{declared.owner}: the compiled kernels differ from the definition:\n{found}\n"
            "write it so that it loses fewer digits (to differences of nearly equal numbers, high powers), or give its "
            "range: ranges={'name': (lowest, highest)}"
        )
    return Verification(tuple(rows), 0.0)


def compared(
    declared: Element | Law, compiled: CompiledElement | CompiledLaw, ranges: Ranges = NOTHING
) -> list[KernelRow]:
    """Return the rows of the verification; differences that may cross the end of a piece are left out.

    Raises
    ------
    VerificationError
        An output is not finite.
    ValueError
        The energy of a law is not that of its stress.
    """
    _check_finite(declared, Compiled(compiled.spec, compiled.address), ranges)
    if isinstance(declared, Law):
        check_stored(declared, law_samples(declared, BATCH, ranges))
    rows = verify(compiled.spec, compiled.address, declared, ranges)
    if not any(sp.sympify(expr).has(*KINKED) for _, expr in _expressions(declared)):
        return rows
    return [
        replace(row, differences=float("nan")) if row.by_definition and not row.ok else row for row in rows
    ]


def _expressions(declared: Element | Law) -> list[tuple[str, sp.Expr]]:
    """Return all expressions of a declaration, each with its name."""
    named = [(f"let '{symbol}'", expr) for symbol, expr in declared.let]
    if isinstance(declared, Law):
        named += [(f"stress {i + 1}", expr) for i, expr in enumerate((*declared.sigma, *declared.tau))]
        named += [(f"the rate of '{state.name}'", state.rate) for state in declared.states]
        return [*named, ("the energy", declared.energy)]
    named += [(f"deformation '{d.name}'", d.expr) for d in declared.deformations]
    named += [(f"slip '{s.name}'", s.expr) for s in declared.slips]
    return [*named, ("the kinetic energy", declared.kinetic_energy), ("the potential", declared.potential)]


def _check_finite(declared: Element | Law, compiled: Compiled, ranges: Ranges) -> None:
    """Refuse a definition that is not real everywhere (a root, a logarithm) without the ranges in which it is."""
    if isinstance(declared, Law):
        data = law_samples(declared, BATCH, ranges)
    else:
        data = element_samples(declared, compiled, BATCH, ranges, redraw=False)
    for kernel in compiled.spec.kernels:
        for name, values in compiled(kernel, data).items():
            if not np.isfinite(values).all():
                raise VerificationError(
                    f"{declared.owner}: {name} is not finite at some of {BATCH} random configurations (coordinates "
                    "between -1 and 1, parameters between 0.5 and 1.5 where no range is given); say where it is "
                    "defined: ranges={'name': (lowest, highest)}"
                )
