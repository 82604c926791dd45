"""User-defined elements and laws: derived once (`flexel.derive.derived_code`), and compiled once."""

from flexel.derive.compiled import CompiledElement, CompiledLaw
from flexel.derive.declare import Element, Law
from flexel.derive.derived_code import element_code, law_code
from flexel.derive.shared_object import SharedObject


def compile_element(element: Element) -> CompiledElement:
    """Derive and compile an element; later calls use the cache.

    Raises
    ------
    CompilerMissingError
        No C compiler.
    CompilationError
        The compiler failed.
    CacheError
        Others can write to the cache.
    """
    source, spec = element_code(element)
    return CompiledElement(_loaded(element.name, source), spec)


def compile_law(law: Law) -> CompiledLaw:
    """Derive and compile a law; errors as in `compile_element`."""
    source, spec = law_code(law)
    return CompiledLaw(_loaded(law.name, source), spec)


def _loaded(name: str, source: str) -> SharedObject:
    """Return the shared object, compiled now, so that the error of a compiler is reported here."""
    code = SharedObject(name, source)
    _ = code.address
    return code
