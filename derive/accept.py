"""User-defined elements and laws: compiled, then verified once; failures are not released.

Verification is that of `flexel verify`: every output of every kernel at random configurations, against the
definition in 60 digits and against numerical differences. Its success is noted beside the shared object in the
cache, which is named by content.
"""

import logging
import zlib
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import sympy as sp

from flexel.derive.check.joins import check_element_joins
from flexel.derive.check.smooth import check_smooth
from flexel.derive.check.stored import check_stored
from flexel.derive.compile import CompiledElement, CompiledLaw, compile_element, compile_law
from flexel.derive.declare import Element, Law
from flexel.derive.verify import verify
from flexel.derive.verify.check import BATCH
from flexel.derive.verify.compiled import Compiled, built_in
from flexel.derive.verify.report import Verification
from flexel.derive.verify.samples import NOTHING, Ranges, check_ranges, element_samples, law_samples

if TYPE_CHECKING:
    from flexel.derive.verify import Row

log = logging.getLogger("flexel.compile")


class VerificationError(ValueError):
    """The compiled kernels do not agree with the definition, or not everywhere."""


def accepted_element(element: Element, ranges: Ranges = NOTHING) -> CompiledElement:
    """Derive, compile and verify an element; earlier verification is reused.

    Parameters
    ----------
    element : Element
    ranges : mapping of str to (float, float)
        Where coordinates (``p_x``) and parameters (``l0``) lie; by default between -1 and 1, and 0.5 and 1.5.

    Raises
    ------
    ValueError
        The name of a built-in element; a function with a kink; a wrong range.
    VerificationError
    CompilerMissingError, CompilationError
        As `flexel.derive.compile.compile_element`.
    """
    if element.name in built_in():
        raise ValueError(f"element '{element.name}': flexel has an element of this name; choose another")
    for what, expr in _expressions(element):
        check_smooth(_owner(element), what, sp.sympify(expr))
        check_element_joins(_owner(element), what, sp.sympify(expr))
    check_ranges(element, ranges)
    compiled = compile_element(element)
    _verify_once(element, compiled, ranges)
    return compiled


def accepted_law(law: Law, ranges: Ranges = NOTHING) -> CompiledLaw:
    """Derive, compile and verify a law; errors as in `accepted_element`, and for an energy of another stress."""
    check_ranges(law, ranges)
    compiled = compile_law(law)
    _verify_once(law, compiled, ranges)
    return compiled


def _verify_once(declared: Element | Law, compiled: CompiledElement | CompiledLaw, ranges: Ranges) -> None:
    note = compiled.path.with_suffix(f"{_mark(ranges)}.verified")
    if note.exists():
        return
    _check_finite(declared, Compiled(compiled.spec, compiled.address), ranges)
    if isinstance(declared, Law):
        check_stored(declared, law_samples(declared, BATCH, ranges))
    rows = verify(compiled.spec, compiled.address, declared, ranges)
    kinds = (sp.Piecewise, sp.Min, sp.Max, sp.Abs, sp.sign, sp.Heaviside)
    smooth = not any(sp.sympify(expr).has(*kinds) for _, expr in _expressions(declared))
    if wrong := [row for row in rows if not _accepted(row, smooth)]:
        found = Verification(tuple(wrong), 0.0).table()
        raise VerificationError(
            f"{_owner(declared)}: the compiled kernels differ from the definition:\n{found}\n"
            "write it so that it loses fewer digits (by differences of nearly equal numbers, high powers), or name its "
            "range: ranges={'name': (lowest, highest)}"
        )
    log.info("%s agrees with its definition: %d outputs of its kernels", _owner(declared), len(rows))
    _write(note, Verification(tuple(rows), 0.0).table())


def _mark(ranges: Ranges) -> str:
    """Part of a file's name for the ranges of a verification: it holds in these only."""
    if not ranges:
        return ""
    listed = sorted((name, float(low), float(high)) for name, (low, high) in ranges.items())
    return f".{zlib.crc32(repr(listed).encode()):08x}"


def _accepted(row: "Row", smooth: bool) -> bool:
    """Whether the errors are small; differences that may cross the end of a piece are ignored."""
    return row.ok or (not smooth and row.by_definition)


def _expressions(declared: Element | Law) -> list[tuple[str, sp.Expr]]:
    """All expressions of a declaration, each with its name."""
    named = [(f"let '{symbol}'", expr) for symbol, expr in declared.let]
    if isinstance(declared, Law):
        named += [(f"stress {i + 1}", expr) for i, expr in enumerate((*declared.sigma, *declared.tau))]
        named += [(f"the rate of '{state.name}'", state.rate) for state in declared.states]
        return [*named, ("the energy", declared.energy)]
    named += [(f"deformation '{d.name}'", d.expr) for d in declared.deformations]
    named += [(f"slip '{s.name}'", s.expr) for s in declared.slips]
    return [*named, ("the kinetic energy", declared.kinetic_energy), ("the potential", declared.potential)]


def _check_finite(declared: Element | Law, compiled: Compiled, ranges: Ranges) -> None:
    """A definition that is not real everywhere (a root, a logarithm) needs the ranges in which it is."""
    if isinstance(declared, Law):
        data = law_samples(declared, BATCH, ranges)
    else:
        data = element_samples(declared, compiled, BATCH, ranges, redraw=False)
    for kernel in compiled.spec.kernels:
        for name, values in compiled(kernel, data).items():
            if not np.isfinite(values).all():
                raise VerificationError(
                    f"{_owner(declared)}: {name} is not finite at some of {BATCH} random configurations (coordinates "
                    "between -1 and 1, parameters between 0.5 and 1.5 where no range is given); say where it is "
                    "defined: ranges={'name': (lowest, highest)}"
                )


def _owner(declared: Element | Law) -> str:
    return f"{'law' if isinstance(declared, Law) else 'element'} '{declared.name}'"


def _write(note: Path, text: str) -> None:
    """Record the result atomically: another process may be doing the same."""
    part = note.with_suffix(f".{id(text)}.part")
    part.write_text(text + "\n", encoding="utf-8")
    part.replace(note)
