"""User-defined elements and laws: from a SymPy definition to a component of a model.

The derivation (SymPy, `flexel.derive`) is imported only when something is compiled.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, TypeVar

from flexel.base.arguments import unknown
from flexel.base.errors import CompilerError, ElementError, ModelError
from flexel.declare.declarations import Declarations
from flexel.derive.spec import ElementSpec
from flexel.generated.table import ELEMENTS
from flexel.structure.nodes import Node

if TYPE_CHECKING:
    from flexel.derive import Element, Law
    from flexel.derive.compile import CompiledElement, CompiledLaw

Made = TypeVar("Made")


def compile_element(
    element: Element, ranges: Mapping[str, tuple[float, float]] | None = None
) -> CompiledElement:
    """Derive, compile and verify a user-defined element; use it with ``m.element(name, compiled, …)``.

    The first call takes a few seconds; later ones use the cache, by content.  Every output of every kernel is
    compared with the definition, in 60 digits, at random configurations.

    Parameters
    ----------
    element : flexel.derive.Element
    ranges : mapping of str to (float, float), optional
        Ranges of the random coordinates (``p_x``) and parameters, for a definition that is not real
        everywhere; coordinates lie between -1 and 1, parameters between 0.5 and 1.5 otherwise.

    Raises
    ------
    ElementError
        The definition is invalid, or the verification fails.
    CompilerError
        No C compiler, or it reports an error.
    """
    from flexel.derive import Element as Declared
    from flexel.derive.accept import accepted_element

    if not isinstance(element, Declared):
        raise ElementError(f"compile_element: {element!r} is not a flexel.derive.Element; declare one")
    owner = f"element '{element.name}'"
    return _made(owner, lambda: accepted_element(element, _by_name(owner, ranges)))


def compile_law(law: Law, ranges: Mapping[str, tuple[float, float]] | None = None) -> CompiledLaw:
    """Derive, compile and verify a user-defined law; parameters and errors as in `compile_element`.

    Attach it with ``m.law(on, compiled, …)``.
    """
    from flexel.derive import Law as Declared
    from flexel.derive.accept import accepted_law

    if not isinstance(law, Declared):
        raise ElementError(f"compile_law: {law!r} is not a flexel.derive.Law; declare one")
    owner = f"law '{law.name}'"
    return _made(owner, lambda: accepted_law(law, _by_name(owner, ranges)))


def _by_name(owner: str, ranges: Mapping[str, tuple[float, float]] | None) -> dict[str, tuple[float, float]]:
    given = ranges or {}
    if not isinstance(given, Mapping):
        raise ElementError(f"{owner}: ranges {given!r} have no names; write {{'name': (lowest, highest)}}")
    return dict(given)


def _made(owner: str, make: Callable[[], Made]) -> Made:
    """The compiled result; errors of the derivation are re-raised as flexel errors."""
    from flexel.derive.cache import CacheError
    from flexel.derive.shared_object import CompilationError, CompilerMissingError

    try:
        return make()
    except (CompilerMissingError, CompilationError, CacheError) as error:
        raise CompilerError(f"{owner}: {error}") from error
    except (ValueError, NotImplementedError) as error:
        text = str(error)
        raise ElementError(text if owner in text else f"{owner}: {text}") from error


class Elements(Declarations):
    """Elements by type: built-in and user-defined."""

    def element(
        self, name: str, kind: str | CompiledElement, /, *nodes: Node | str, **parameters: object
    ) -> None:
        """Add an element by its type, between nodes of the kinds that its definition names, in that order.

        Most built-in elements have a more convenient method, such as `beam` or `hinge`.

        Parameters
        ----------
        name : str
        kind : str or CompiledElement
            Name of a built-in element, or what `flexel.compile_element` returned.
        *nodes : Node or str
        **parameters : float or array_like
            Each parameter by name, as in the definition; the default for gravity is that of the model.

        Raises
        ------
        ModelError
            An unknown type, a node of another kind, a parameter that is missing, unknown or of another size.

        Examples
        --------
        >>> m.element("bar", "truss", "A", "B", l0=0.5, rhoA=0.8)  # doctest: +SKIP
        >>> cam = fx.compile_element(CAM)  # doctest: +SKIP
        >>> m.element("cam", cam, "shaft", "tappet", base=0.03, lift=0.01)  # doctest: +SKIP
        >>> m.release("cam.gap")  # doctest: +SKIP
        """
        if isinstance(kind, str):
            if kind not in ELEMENTS:
                raise ModelError(f"element '{name}': {unknown(kind, ELEMENTS, 'element type')}")
            self._place(name, kind, nodes, parameters)
            return
        if not isinstance(getattr(kind, "spec", None), ElementSpec) or not hasattr(kind, "code"):
            raise ModelError(
                f"element '{name}': {kind!r} is not a compiled element; give the result of fx.compile_element(…), or "
                "the name of a built-in one"
            )
        self._place(name, kind.spec, nodes, parameters, kind.code)
