"""Elements by type, and user-defined elements and laws: from a SymPy definition to a component of a model.

The derivation (SymPy, `flexel.derive`) is imported only when something is compiled.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from flexel.base.arguments import unknown
from flexel.base.errors import CompilerError, ElementError, ModelError
from flexel.base.meaning import entry
from flexel.derive.spec import ElementSpec
from flexel.generated.table import ELEMENTS
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part

if TYPE_CHECKING:
    from flexel.derive import Element, Law
    from flexel.derive.compiled import CompiledElement, CompiledLaw

Made = TypeVar("Made")


def compile_element(
    element: Element, ranges: Mapping[str, tuple[float, float]] | None = None
) -> CompiledElement:
    """Derive, compile and verify a user-defined element; use it with ``m.element(name, compiled, …)``.

    The first call takes a few seconds; later ones use the cache, keyed by content.  Every output of every kernel is
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
        There is no C compiler, or it reports an error.
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
    """Return the compiled result; errors of the derivation are re-raised as flexel errors."""
    from flexel.derive.cache import CacheError
    from flexel.derive.shared_object import CompilationError, CompilerMissingError

    try:
        return make()
    except (CompilerMissingError, CompilationError, CacheError) as error:
        raise CompilerError(f"{owner}: {error}") from error
    except (ValueError, NotImplementedError) as error:
        text = str(error)
        raise ElementError(text if owner in text else f"{owner}: {text}") from error


@part
class ElementPart(Part[None]):
    """Add an element by its type, between nodes of the kinds that its definition names, in that order.

    Most built-in elements have a more convenient method, such as `beam` or `hinge`.

    Raises
    ------
    ModelError
        An unknown type, a node of the wrong kind, a parameter that is missing, unknown or of the wrong size.

    Examples
    --------
    >>> m.element("bar", "truss", "A", "B", l0=0.5, rhoA=0.8)  # doctest: +SKIP
    >>> cam = fx.compile_element(CAM)  # doctest: +SKIP
    >>> m.element("cam", cam, "shaft", "tappet", base=0.03, lift=0.01)  # doctest: +SKIP
    >>> m.release("cam.gap")  # doctest: +SKIP
    """

    name: str = entry("Name of the element; its quantities are ``name.deformation`` and ``name.slip``.")
    kind: str | CompiledElement = entry(
        "Name of a built-in element, or the result of `flexel.compile_element`."
    )
    nodes: tuple[Node | str, ...] = entry("Nodes in the order of the definition.", spread=True, form="node")
    parameters: Mapping[str, Any] | None = entry(
        "Value of each parameter by name, as in the definition; the default for gravity is the model's gravity.",
        default=None,
        spread=True,
    )

    def lower(self, to: Lowering) -> None:
        """Add the element."""
        parameters = self.parameters or {}
        if isinstance(self.kind, str):
            if self.kind not in ELEMENTS:
                raise ModelError(f"{self.owner}: {unknown(self.kind, ELEMENTS, 'element type')}")
            to.element(self.name, self.kind, self.nodes, parameters)
            return
        if not isinstance(getattr(self.kind, "spec", None), ElementSpec) or not hasattr(self.kind, "code"):
            raise ModelError(
                f"{self.owner}: {self.kind!r} is not a compiled element; give the result of fx.compile_element(…), or "
                "the name of a built-in one"
            )
        to.element(self.name, self.kind.spec, self.nodes, parameters, self.kind.code)
