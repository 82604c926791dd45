"""Compiled elements and laws of a user: their specification and their shared object, without SymPy."""

from dataclasses import dataclass
from pathlib import Path

from flexel.derive.shared_object import SharedObject
from flexel.derive.spec import ElementSpec, LawSpec


@dataclass(frozen=True)
class _Compiled:
    """What elements and laws have in common: the shared object with their kernels."""

    code: SharedObject

    def __repr__(self) -> str:
        spec: ElementSpec | LawSpec = self.spec  # type: ignore[attr-defined]
        parameters = ", ".join(f"{parameter.name} [{parameter.unit}]" for parameter in spec.parameters)
        return f"{type(self).__name__}({spec.name}: {parameters or 'no parameters'})"

    @property
    def address(self) -> int:
        """Address of the ``flexel_element`` or ``flexel_law``."""
        return self.code.address

    @property
    def path(self) -> Path:
        """The shared object in the cache."""
        return self.code.path


@dataclass(frozen=True, repr=False)
class CompiledElement(_Compiled):
    """A compiled element: its spec and its kernels; pickled with its C code, without SymPy."""

    spec: ElementSpec


@dataclass(frozen=True, repr=False)
class CompiledLaw(_Compiled):
    """A compiled law: its spec and its kernels; pickled with its C code, without SymPy."""

    spec: LawSpec
