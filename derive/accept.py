"""User-defined elements and laws: compiled, then verified once; failures are not released.

A successful verification is noted next to the shared object in the cache, by the definition and the ranges.
The module that verifies (`flexel.derive.acceptance`) is imported only where there is no note.
"""

import hashlib
import logging
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TypeVar

from flexel.derive.clipped import with_real_powers
from flexel.derive.compiled import CompiledElement, CompiledLaw
from flexel.derive.declare import Element, Law
from flexel.derive.definition_key import definition_key
from flexel.derive.derived_code import is_derived
from flexel.derive.user_definitions import compile_element, compile_law

log = logging.getLogger("flexel.compile")
Ranges = Mapping[str, tuple[float, float]]
Declared = TypeVar("Declared", Element, Law)
Compiled = TypeVar("Compiled", CompiledElement, CompiledLaw)


def accepted_element(element: Element, ranges: Ranges | None = None) -> CompiledElement:
    """Derive, compile and verify an element; earlier verification is reused.

    Parameters
    ----------
    element : Element
    ranges : mapping of str to (float, float), optional
        Where coordinates (``p_x``) and parameters (``l0``) lie; by default between -1 and 1, and 0.5 and 1.5.

    Raises
    ------
    ValueError
        The name of a built-in element; a function with a kink; a wrong range.
    VerificationError
    CompilerMissingError, CompilationError
        As `flexel.derive.user_definitions.compile_element`.
    """
    return _accepted(element, compile_element, ranges or {})


def accepted_law(law: Law, ranges: Ranges | None = None) -> CompiledLaw:
    """Derive, compile and verify a law; errors as in `accepted_element`, and for an energy of another stress."""
    return _accepted(with_real_powers(law), compile_law, ranges or {})


def _accepted(declared: Declared, compile_it: Callable[[Declared], Compiled], ranges: Ranges) -> Compiled:
    if is_derived(declared):
        compiled = compile_it(declared)
        if _note(declared, compiled, ranges).exists():
            return compiled
    from flexel.derive.acceptance import check_compiled, check_definition
    from flexel.derive.verify.samples import check_ranges

    check_definition(declared)
    check_ranges(declared, ranges)
    compiled = compile_it(declared)
    rows = check_compiled(declared, compiled, ranges)
    log.info("%s agrees with its definition: %d outputs of its kernels", declared.owner, len(rows.rows))
    _write(_note(declared, compiled, ranges), rows.table())
    return compiled


def _note(declared: Element | Law, compiled: CompiledElement | CompiledLaw, ranges: Ranges) -> Path:
    """Return the file that notes that a definition was verified; it holds in these ranges only."""
    listed = sorted((repr(name), repr(limits)) for name, limits in ranges.items())
    mark = hashlib.sha256(f"{definition_key(declared)} {listed}".encode()).hexdigest()[:8]
    return compiled.path.with_suffix(f".{mark}.verified")


def _write(note: Path, text: str) -> None:
    """Record the result atomically: another process may be doing the same."""
    part = note.with_suffix(f".{id(text)}.part")
    part.write_text(text + "\n", encoding="utf-8")
    part.replace(note)
