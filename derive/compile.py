"""User-defined elements and laws: derived, and compiled once (`flexel.derive.shared_object`)."""

from dataclasses import dataclass
from pathlib import Path

from flexel.derive.declare import Element, Law
from flexel.derive.emit.source import digest_of, element_source, laws_source
from flexel.derive.emit.specification import element_spec, law_spec
from flexel.derive.program.kernels import derive_element, derive_law
from flexel.derive.shared_object import SYMBOL, SharedObject
from flexel.derive.spec import ElementSpec, LawSpec


@dataclass(frozen=True)
class _Compiled:
    """What elements and laws have in common: the shared object with their kernels."""

    code: SharedObject

    @property
    def address(self) -> int:
        """Address of the ``flexel_element`` or ``flexel_law``."""
        return self.code.address

    @property
    def path(self) -> Path:
        """The shared object in the cache."""
        return self.code.path


@dataclass(frozen=True)
class CompiledElement(_Compiled):
    """A compiled element: its spec and its kernels; pickled with its C code, without SymPy."""

    spec: ElementSpec


@dataclass(frozen=True)
class CompiledLaw(_Compiled):
    """A compiled law: its spec and its kernels; pickled with its C code, without SymPy."""

    spec: LawSpec


def compile_element(element: Element) -> CompiledElement:
    """Derive and compile an element; later calls use the cache.

    Raises
    ------
    CompilerMissingError
        No C compiler.
    CompilationError
        The compiler failed.
    """
    derived = derive_element(element)
    source = element_source(element, derived, SYMBOL)
    spec = element_spec(element, derived, digest_of(source))
    return CompiledElement(_loaded(element.name, source), spec)


def compile_law(law: Law) -> CompiledLaw:
    """Derive and compile a law; errors as in `compile_element`."""
    derived = derive_law(law)
    source = laws_source([law], [derived], SYMBOL)
    return CompiledLaw(_loaded(law.name, source), law_spec(law, derived, digest_of(source)))


def _loaded(name: str, source: str) -> SharedObject:
    """The shared object, compiled now, so that the error of a compiler is reported here."""
    code = SharedObject(name, source)
    _ = code.address
    return code
