"""The page of an element as users see it: its symbols, and the values of its functions at one configuration."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from flexel.base.arguments import array, mapping, unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.shown import prints
from flexel.derive.compiled import CompiledElement, CompiledLaw
from flexel.derive.spec import ElementSpec
from flexel.engine.batches import kernel_struct, pointers
from flexel.engine.lanes import LANES, blocks
from flexel.generated.table import ELEMENTS
from flexel.model.node import COMPONENTS
from flexel.parts.elements import compile_element

if TYPE_CHECKING:
    from flexel.derive import Element


@dataclass(frozen=True, repr=False)
class ElementValues:
    """Values of the functions of one element at one configuration.

    Attributes
    ----------
    rows : tuple of str, (m,)
        Names of the deformations, with their units.
    slips : tuple of str, (k,)
        Names of the slips, with their units.
    columns : tuple of str, (n,)
        Names of the coordinates.
    e : ndarray, (m,)
        Deformations.
    De : ndarray, (m, n)
        Their derivatives with respect to the coordinates.
    D2e : ndarray, (m, n, n)
        Their second derivatives.
    V : ndarray, (k, n)
        Derivatives of the slips s = V v with respect to the rates.
    DV : ndarray, (k, n, n)
        ``DV[i, j, l]`` is the derivative of ``V[i, j]`` with respect to coordinate l.
    M : ndarray, (n, n)
        Mass matrix; zero for an element without mass.
    f : ndarray, (n,)
        Forces of the potential, -dU/dx.
    U : float
        Potential of the body forces [J].
    """

    rows: tuple[str, ...]
    slips: tuple[str, ...]
    columns: tuple[str, ...]
    e: Array
    De: Array
    D2e: Array
    V: Array
    DV: Array
    M: Array
    f: Array
    U: float

    @prints
    def __repr__(self) -> str:
        """Return the deformations and slips with their derivatives, as a table with named rows and columns."""
        lines = [["", "e", *self.columns]]
        lines += [
            [row, *map(_number, (e, *De))] for row, e, De in zip(self.rows, self.e, self.De, strict=True)
        ]
        lines += [[slip, "", *map(_number, V)] for slip, V in zip(self.slips, self.V, strict=True)]
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        return "\n".join(
            "  ".join([line[0].ljust(widths[0]), *map(str.rjust, line[1:], widths[1:])]).rstrip()
            for line in lines
        )


class ElementPage:
    """The page of an element: its definition, and `evaluate`; see `flexel.page`.

    Attributes
    ----------
    name : str
    doc, source : str
        Its mathematics in a few lines of text, and its source.
    nodes : dict of str to str
        Kind of each node, in order.
    columns : tuple of str, (n,)
        Names of the coordinates.
    parameters : dict of str to str
        Meaning and unit of each parameter.
    rows, slips : tuple of str, (m,), (k,)
        Names of the deformations and slips, with their units.
    """

    def __init__(self, element: str | CompiledElement) -> None:
        self._element = element
        spec: ElementSpec = ELEMENTS[element] if isinstance(element, str) else element.spec
        self._spec = spec
        self._struct = kernel_struct(spec, None if isinstance(element, str) else element.address)
        self.name, self.doc, self.source = spec.name, spec.doc, spec.source
        self._owner = f"page of '{self.name}'"
        self.nodes = {node.name: node.kind.replace("_", " ") for node in spec.nodes}
        self.columns = tuple(f"{node.name}.{c}" for node in spec.nodes for c in COMPONENTS[node.kind])
        self.parameters = {p.name: f"{p.doc} [{p.unit}]" for p in spec.parameters}
        self.rows = tuple(f"{d.name} [{d.unit}]" for d in spec.deformations)
        self.slips = tuple(f"{s.name} [{s.unit}]" for s in spec.slips)

    def __reduce__(self) -> tuple[type[ElementPage], tuple[str | CompiledElement]]:
        """Pickle the element alone: addresses of kernels are those of this process."""
        return ElementPage, (self._element,)

    @prints
    def __repr__(self) -> str:
        """Return the mathematics, and the names of all symbols."""
        facts = {
            f"element {self.name}": self.doc.splitlines(),
            "nodes": [f"{name}: {kind}" for name, kind in self.nodes.items()],
            "parameters": [f"{name}: {meaning}" for name, meaning in self.parameters.items()],
            "deformations": self.rows,
            "slips": self.slips,
            "source": [self.source] if self.source else [],
        }
        return "\n".join("\n  ".join([title, *lines]) for title, lines in facts.items() if lines)

    def evaluate(
        self, x: ArrayLike | Mapping[str, ArrayLike], parameters: Mapping[str, ArrayLike] | None = None
    ) -> ElementValues:
        """Evaluate the functions of one element, and their first and second derivatives.

        Parameters
        ----------
        x : array_like, (n,) or mapping of str to array_like
            Coordinates of all nodes in order, or those of each node by its name.
        parameters : mapping of str to array_like
            Value of each parameter; ``gravity`` is zero by default.

        Returns
        -------
        ElementValues

        Raises
        ------
        ModelError
            A node or parameter that is missing or unknown, or whose values are too many, too few or not finite.

        Examples
        --------
        >>> at = fx.page("planar_truss").evaluate([0, 0, 3, 4], {"l0": 4.5, "rhoA": 1})
        >>> print(at)
                           e   p.x   p.y  q.x  q.y
        elongation [m]  0.5  -0.6  -0.8  0.6  0.8
        """
        row, p = self._coordinates(x), self._values(parameters)
        n, m, k = len(self.columns), len(self.rows), len(self.slips)
        at = {"x": row[None], "p": p[None], "v": np.zeros((1, n))}
        found = self._call("position", at)
        K = self._stiffness(row, p, m, k)
        inertia = self._call("inertia", at)
        if not all(np.isfinite(values).all() for values in (K, *found.values(), *inertia.values())):
            raise ModelError(f"{self._owner}: its functions are not finite at this x, with these parameters")
        return ElementValues(
            self.rows,
            self.slips,
            self.columns,
            found.get("e", np.zeros((1, 0)))[0],
            found.get("De", np.zeros((1, 0, n)))[0],
            K[:m],
            found.get("V", np.zeros((1, 0, n)))[0],
            K[m:],
            inertia.get("M", np.zeros((1, n, n)))[0],
            inertia.get("f", np.zeros((1, n)))[0],
            float(inertia["U"][0, 0]) if inertia else 0.0,
        )

    def _stiffness(self, x: Array, p: Array, m: int, k: int) -> Array:
        """Return the derivatives (m + k, n, n) of the rows of De and V: the stiffness of a unit stress each."""
        unit = np.eye(m + k)
        repeated = {"x": np.tile(x, (m + k, 1)), "p": np.tile(p, (m + k, 1))}
        found = self._call("stiffness", {**repeated, "sigma": unit[:, :m], "tau": unit[:, m:]})
        return found.get("K", np.zeros((0, len(x), len(x))))

    def _call(self, kernel: str, at: Mapping[str, Array]) -> dict[str, Array]:
        """Return the outputs of a kernel by name, (elements, *shape); none if the element has no such kernel."""
        spec = self._spec.kernels.get(kernel)
        if spec is None:
            return {}
        size = len(at["x"])
        ins = [blocks(at[name]) for name in spec.inputs]
        count = len(ins[0])
        outs = [np.zeros((count, len(output.nonzeros), LANES)) for output in spec.outputs]
        getattr(self._struct, kernel)(count, *pointers(ins, outs))
        found = {}
        for output, stored in zip(spec.outputs, outs, strict=True):
            full = np.zeros((size, int(np.prod(output.shape))))
            full[:, list(output.nonzeros)] = stored.transpose(0, 2, 1).reshape(count * LANES, -1)[:size]
            found[output.name] = full.reshape(size, *output.shape)
        return found

    def _coordinates(self, x: ArrayLike | Mapping[str, ArrayLike]) -> Array:
        if not isinstance(x, Mapping):
            return _numbers(x, self._owner, "x", self.columns)
        nodes = {node.name: COMPONENTS[node.kind] for node in self._spec.nodes}
        _check_names(self._owner, mapping(x, self._owner, "x"), nodes, "node")
        parts = [_numbers(x[name], self._owner, f"x of node '{name}'", c) for name, c in nodes.items()]
        return np.concatenate(parts)

    def _values(self, parameters: Mapping[str, ArrayLike] | None) -> Array:
        specs = {spec.name: spec for spec in self._spec.parameters}
        given = {"gravity": np.zeros(specs["gravity"].size)} if "gravity" in specs else {}
        given |= mapping(parameters, self._owner, "parameters")
        _check_names(self._owner, given, self.parameters, "parameter")
        parts = [_numbers(given[name], self._owner, f"'{name}'", s.size) for name, s in specs.items()]
        return np.concatenate([np.zeros(0), *parts])


def page(element: str | CompiledElement | Element) -> ElementPage:
    """Return the page of an element: its symbols, and the values of its functions and their derivatives anywhere.

    Parameters
    ----------
    element : str, CompiledElement or flexel.derive.Element
        Name of a built-in element, the result of `compile_element`, or a definition, which is then compiled.

    Raises
    ------
    ModelError
        If there is no such element.
    ElementError, CompilerError
        As `compile_element`.

    Examples
    --------
    >>> bar = fx.page("planar_truss")
    >>> bar.columns
    ('p.x', 'p.y', 'q.x', 'q.y')
    >>> bar.evaluate({"p": (0, 0), "q": (3, 4)}, {"l0": 4.5, "rhoA": 1}).D2e.shape
    (1, 4, 4)
    """
    if isinstance(element, str):
        if element not in ELEMENTS:
            raise ModelError(f"page: {unknown(element, ELEMENTS, 'element type')}")
        return ElementPage(element)
    given: object = element
    if isinstance(given, CompiledLaw):
        raise ModelError(f"page: '{given.spec.name}' is a law; give an element")
    return ElementPage(element if isinstance(element, CompiledElement) else compile_element(element))


def _check_names(owner: str, given: Mapping[str, Any], known: Mapping[str, Any], what: str) -> None:
    for name in given:
        if name not in known:
            raise ModelError(f"{owner}: {unknown(name, known, what)}")
    if missing := [name for name in known if name not in given]:
        says = [f"{name}, {known[name]}" if isinstance(known[name], str) else name for name in missing]
        raise ModelError(f"{owner}: no value for {'; '.join(says)}")


def _numbers(given: ArrayLike, owner: str, what: str, names: int | Sequence[str]) -> Array:
    """Return as many numbers as there are names; one may be without brackets."""
    values = array(given, owner, what)
    size = names if isinstance(names, int) else len(names)
    if values.shape not in ((size,), () if size == 1 else (size,)):
        said = "" if isinstance(names, int) else f": {', '.join(names)}"
        raise ModelError(f"{owner}: {what} has shape {values.shape}; give {size} numbers{said}")
    return values.reshape(size)


def _number(value: float) -> str:
    return f"{value:.6g}"
