"""The declaration of an element: frozen data, with the mathematics and its source.

An element is written as a few plain SymPy expressions in its nodes' coordinates ``x`` and rates ``v`` and in its
parameters; everything else (derivatives, mass matrix, tangents) is obtained by ``flexel.derive.program``.
"""

from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Matrix, Symbol

from flexel.derive.declare.checks import (
    check_array,
    check_functions,
    check_list,
    check_name,
    check_scalar,
    check_symbols,
    check_text,
    check_unique,
    rate_degrees,
)
from flexel.derive.declare.constants import Parameter
from flexel.derive.declare.deformations import Deformation, Slip
from flexel.derive.declare.element_nodes import Node
from flexel.derive.declare.output import Output
from flexel.derive.declare.winding import check_period
from flexel.derive.declare.words import PICTURES, check_family, check_word
from flexel.derive.definition_errors import ElementError


@dataclass(frozen=True)
class Element:
    """An element *is* its functions D, V, T and U of the coordinates of its nodes.

    Parameters
    ----------
    name : str
        A name in C.
    nodes : tuple of Node
        Their coordinates, one after another, are x (n).
    parameters : tuple of Parameter
    let : tuple of (Symbol, Expr)
        Named intermediates, each in terms of x, v, parameters and earlier ones.
    deformations : tuple of Deformation
        e = D(x), m of them.
    slips : tuple of Slip
        s = V(x) v, k of them.
    kinetic_energy : Expr
        T = v'M(x)v / 2 [J].
    potential : Expr
        U(x) of the body forces [J].
    doc : str
        The mathematics in a few lines of plain text; head comment of the generated C.
    source : str
        Author, year, equation.
    family : str, optional
        How analyses treat it, one of `flexel.derive.declare.words.FAMILIES`; its nodes are those of the family.
    picture : str, optional
        Its painter, one of `flexel.derive.declare.words.PICTURES`; by default a line through its points.
    span : str, optional
        Name of the built-in element that carries a load along its length: on its first nodes, or on the first and the
        last of them, with parameters that it has itself.
    outputs : tuple of Output, optional
        What it reports besides its deformations, such as section forces, and the points and lines that a picture draws.

    Raises
    ------
    ElementError
        A name is used twice or is not a name in C, a unit or a meaning is missing, an expression is not scalar or
        contains an unknown symbol or function, D, U or an output depends on v, a slip is not linear or T not
        quadratic in v, a family has other nodes.
    """

    name: str
    nodes: tuple[Node, ...]
    parameters: tuple[Parameter, ...] = ()
    let: tuple[tuple[Symbol, Expr], ...] = ()
    deformations: tuple[Deformation, ...] = ()
    slips: tuple[Slip, ...] = ()
    kinetic_energy: Expr = sp.S.Zero
    potential: Expr = sp.S.Zero
    doc: str = ""
    source: str = ""
    family: str = ""
    picture: str = ""
    span: str = ""
    outputs: tuple[Output, ...] = ()

    def __post_init__(self) -> None:
        owner = self.owner
        kinds: dict[str, type] = {"nodes": Node, "parameters": Parameter, "outputs": Output}
        for what, kind in (kinds | {"deformations": Deformation, "slips": Slip}).items():
            check_list(owner, what, getattr(self, what), kind)
        check_name(owner, self.name)
        if not self.nodes:
            raise ElementError(f"{owner} has no nodes")
        symbols = [*self.x, *self.v, *self.parameter_symbols, *(s for s, _ in self.let)]
        for s in (*symbols, *self.deformations, *self.slips):
            check_name(owner, s.name)
        check_unique(owner, [s.name for s in symbols])
        check_unique(owner, [d.name for d in self.deformations] + [s.name for s in self.slips])
        check_unique(owner, [node.name for node in self.nodes])
        check_unique(owner, [p.name for p in self.parameters])
        check_family(owner, self.family, [node.kind for node in self.nodes])
        check_word(owner, "picture", self.picture, PICTURES)
        self._check_expressions(owner)

    def _check_expressions(self, owner: str) -> None:
        degrees = dict.fromkeys(self.arguments, frozenset({0}))
        degrees.update(dict.fromkeys(self.v, frozenset({1})))
        moving = {*self.x}  # symbols that change with the coordinates

        def check(what: str, expr: object, allowed: int, fact: str) -> None:
            check_scalar(owner, what, expr)
            check_symbols(owner, what, expr, degrees)
            if not rate_degrees(expr, degrees) <= {allowed}:
                raise ElementError(f"{owner}: {what} {fact}")
            check_functions(owner, what, expr)

        for s, expr in self.let:
            check_scalar(owner, f"let '{s}'", expr)
            check_symbols(owner, f"let '{s}'", expr, degrees)
            check_functions(owner, f"let '{s}'", expr)
            degrees[s] = rate_degrees(expr, degrees)
            if not moving.isdisjoint(expr.free_symbols):
                moving.add(s)
        modes: tuple[Deformation | Slip, ...] = (*self.deformations, *self.slips)
        for mode in modes:
            if not mode.unit:
                raise ElementError(f"{owner}: '{mode.name}' has no unit; give an SI unit, or '1'")
        for d in self.deformations:
            check(f"deformation '{d.name}'", d.expr, 0, "depends on rates; declare it as a slip")
            if moving.isdisjoint(d.expr.free_symbols):
                raise ElementError(
                    f"{owner}: deformation '{d.name}' depends on no coordinate; use those of its nodes"
                )
            check_period(owner, d, self.let, self.parameters)
        for slip in self.slips:
            check(f"slip '{slip.name}'", slip.expr, 1, "is not linear in the rates")
        check("the kinetic energy", self.kinetic_energy, 2, "is not quadratic in the rates")
        check("the potential", self.potential, 0, "depends on rates")
        if not (modes or self.kinetic_energy or self.potential):
            raise ElementError(f"{owner}: it has no deformation, slip or energy; declare one")
        check_text(owner, "the element", self.doc)
        self._check_outputs(owner, degrees)

    def _check_outputs(self, owner: str, degrees: dict[Symbol, frozenset[int]]) -> None:
        """Check the outputs; `degrees` has the degree in the rates of all other symbols."""
        if not self.outputs:
            return
        given = [*self.forces, *self.values, *self.stresses]
        check_unique(owner, [s.name for s in (*degrees, *given)])
        check_unique(owner, [output.name for output in self.outputs])
        known = degrees | dict.fromkeys(given, frozenset({0}))
        planar = all(node.kind.startswith("planar_") for node in self.nodes)
        for output in self.outputs:
            what = f"output '{output.name}'"
            check_array(owner, output.name)
            for expr in output.exprs:
                check_scalar(owner, what, expr)
                check_symbols(owner, what, expr, known)
                if not rate_degrees(expr, known) <= {0}:
                    raise ElementError(
                        f"{owner}: {what} depends on rates; it is a function of positions and forces"
                    )
                check_functions(owner, what, expr)
            if output.draws and output.shape[-1] != (2 if planar else 3):
                row = "(x, y)" if planar else "(x, y, z)"
                raise ElementError(
                    f"{owner}: {what} is drawn, but its shape is {output.shape}; give a row {row} for each point"
                )
            self._check_carrier(owner, output, 2 if planar else 3)

    def _check_carrier(self, owner: str, output: Output, size: int) -> None:
        """Check that the frame that carries a drawn line is among the outputs: its origin, then its axes."""
        shapes = {other.name: other.shape for other in self.outputs}
        found = [shapes.get(name) for name in output.carrier]
        if output.carrier and found != [(size,), (size, size)]:
            raise ElementError(
                f"{owner}: the carrier {output.carrier} of output '{output.name}' is not a frame; name two outputs, "
                f"its origin ({size} components) and its axes ({size} rows)"
            )

    @property
    def owner(self) -> str:
        """Kind and name, as messages begin."""
        return f"element '{self.name}'"

    @property
    def arguments(self) -> tuple[Symbol, ...]:
        """Coordinates and parameters: all symbols that its deformations are functions of."""
        return (*self.x, *self.parameter_symbols)

    @property
    def x(self) -> Matrix:
        """Coordinates of all nodes, column (n, 1)."""
        return Matrix([c for node in self.nodes for c in node.x])

    @property
    def v(self) -> Matrix:
        """Their rates, column (n, 1)."""
        return Matrix([c for node in self.nodes for c in node.v])

    @property
    def forces(self) -> Matrix:
        """Forces at all nodes, column (n, 1), as outputs know them."""
        return Matrix([c for node in self.nodes for c in node.f])

    @property
    def values(self) -> tuple[Symbol, ...]:
        """Values of all deformations (m,), as outputs know them."""
        return tuple(d.value for d in self.deformations)

    @property
    def stresses(self) -> tuple[Symbol, ...]:
        """Stresses of all deformations, then of all slips (m + k,), as outputs know them."""
        return (*(d.stress for d in self.deformations), *(s.stress for s in self.slips))

    @property
    def parameter_symbols(self) -> tuple[Symbol, ...]:
        """All parameters, flattened in declared order."""
        return tuple(s for p in self.parameters for s in p.symbols)
