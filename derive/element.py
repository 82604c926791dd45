"""What an element and a law are: frozen data, with the mathematics and its source beside it.

This room declares and checks; it derives nothing. It may import sympy and the checks beside it. An
element is written as a few plain SymPy expressions in its nodes' coordinates ``x`` and rates ``v`` and in its
parameters; everything else (derivatives, mass matrix, tangents) is obtained by ``flexel.derive.program``.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Matrix, Symbol

from flexel.derive.checks import (
    check_functions,
    check_list,
    check_name,
    check_scalar,
    check_symbols,
    check_text,
    check_unique,
    rate_degrees,
)


def symbol(name: str) -> Symbol:
    """Real symbol, the only kind used in elements and laws (equal names are equal symbols)."""
    return Symbol(name, real=True)


@dataclass(frozen=True)
class Node:
    """Node of an element: a name and the names of its coordinates (use `Point`, `Frame`, ... to make one)."""

    name: str
    kind: str
    components: tuple[str, ...]

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return len(self.components)

    @property
    def x(self) -> Matrix:
        """Coordinates, column (size, 1), named ``p_x`` and so on."""
        return Matrix([symbol(f"{self.name}_{c}") for c in self.components])

    @property
    def v(self) -> Matrix:
        """Rates of the coordinates, column (size, 1), named ``p_vx`` and so on."""
        return Matrix([symbol(f"{self.name}_v{c}") for c in self.components])


def Point(name: str) -> Node:  # noqa: N802 (a kind of node)
    """Position in space: x, y, z [m]."""
    return Node(name, "point", ("x", "y", "z"))


def Frame(name: str) -> Node:  # noqa: N802
    """Orientation in space: Euler parameters l0, l1, l2, l3 [1]."""
    return Node(name, "frame", ("l0", "l1", "l2", "l3"))


def PlanarPoint(name: str) -> Node:  # noqa: N802
    """Position in the plane: x, y [m]."""
    return Node(name, "planar_point", ("x", "y"))


def PlanarAngle(name: str) -> Node:  # noqa: N802
    """Orientation in the plane: one angle [rad]."""
    return Node(name, "planar_angle", ("angle",))


def Slope(name: str) -> Node:  # noqa: N802
    """Derivative of position by the undeformed arc length of a cable: x, y, z [1]; a unit vector if unstretched."""
    return Node(name, "slope", ("x", "y", "z"))


def PlanarSlope(name: str) -> Node:  # noqa: N802
    """Derivative of position by the undeformed arc length of a cable in the plane: x, y [1]."""
    return Node(name, "planar_slope", ("x", "y"))


@dataclass(frozen=True)
class Parameter:
    """Constant of an element or a law.

    Parameters
    ----------
    name : str
    size : int
        Number of components.
    unit : str
        SI unit, "1" if it has none.
    doc : str
        What it is, in a few words.
    components : tuple of str, optional
        Suffixes of the names of the components, 0, 1, ... by default.
    """

    name: str
    size: int
    unit: str
    doc: str
    components: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.size < 1 or (self.components and len(self.components) != self.size):
            raise ValueError(f"parameter '{self.name}': size {self.size} does not fit {self.components}")
        if not self.unit:
            raise ValueError(f"parameter '{self.name}' has no unit; give an SI unit, or '1'")
        check_text("a declaration", f"parameter '{self.name}'", self.doc)

    @property
    def symbols(self) -> tuple[Symbol, ...]:
        """The symbol of a scalar, or one for each component."""
        if self.size == 1:
            return (symbol(self.name),)
        suffixes = self.components or tuple(str(i) for i in range(self.size))
        return tuple(symbol(f"{self.name}_{c}") for c in suffixes)

    @property
    def symbol(self) -> Symbol:
        """The symbol of a scalar parameter."""
        if self.size != 1:
            raise ValueError(f"parameter '{self.name}' has {self.size} components; use .vector")
        return self.symbols[0]

    @property
    def vector(self) -> Matrix:
        """The components as a column (size, 1)."""
        return Matrix(self.symbols)


@dataclass(frozen=True)
class Deformation:
    """Generalized deformation e = D(x): `angle` says it has period 2 pi, `free` that it is free at first."""

    name: str
    unit: str
    expr: Expr
    angle: bool = False
    free: bool = False


@dataclass(frozen=True)
class Slip:
    """Generalized slip s = V(x) v, linear in the rates; `free` says it is free by default (else zero)."""

    name: str
    unit: str
    expr: Expr
    free: bool = False


class Let:
    """Collects named intermediates: ``let.scalar("l", expr)`` notes l = expr and returns the symbol l.

    Vectors take the suffixes x, y, z (three components), x, y (two) or 0, 1, ... The names survive into the
    C.
    """

    def __init__(self) -> None:
        self._entries: list[tuple[Symbol, Expr]] = []

    def scalar(self, name: str, expr: Expr) -> Symbol:
        """Name one expression."""
        s = symbol(name)
        self._entries.append((s, sp.sympify(expr)))
        return s

    def vector(self, name: str, exprs: Iterable[Expr]) -> Matrix:
        """Name the components of a column."""
        values = list(exprs)
        suffixes = "xyz" if len(values) in (2, 3) else "0123456789"
        return Matrix([self.scalar(f"{name}_{suffixes[i]}", value) for i, value in enumerate(values)])

    @property
    def entries(self) -> tuple[tuple[Symbol, Expr], ...]:
        """The pairs (symbol, expression), in order."""
        return tuple(self._entries)


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

    Raises
    ------
    ValueError
        A name is used twice or is not a name in C, a unit or a meaning is missing, an expression is not scalar or
        contains an unknown symbol or function, D or U depends on v, a slip is not linear or T not quadratic
        in v.
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

    def __post_init__(self) -> None:
        owner = f"element '{self.name}'"
        kinds = {"nodes": Node, "parameters": Parameter, "deformations": Deformation, "slips": Slip}
        for what, kind in kinds.items():
            check_list(owner, what, getattr(self, what), kind)
        check_name(owner, self.name)
        if not self.nodes:
            raise ValueError(f"{owner} has no nodes")
        symbols = [*self.x, *self.v, *self.parameter_symbols, *(s for s, _ in self.let)]
        for s in symbols:
            check_name(owner, s.name)
        check_unique(owner, [s.name for s in symbols])
        check_unique(owner, [d.name for d in self.deformations] + [s.name for s in self.slips])
        check_unique(owner, [node.name for node in self.nodes])
        check_unique(owner, [p.name for p in self.parameters])
        self._check_expressions(owner)

    def _check_expressions(self, owner: str) -> None:
        degrees = dict.fromkeys([*self.x, *self.parameter_symbols], frozenset({0}))
        degrees.update(dict.fromkeys(self.v, frozenset({1})))
        moving = {*self.x}  # what changes with the coordinates

        def check(what: str, expr: object, allowed: int, fact: str) -> None:
            check_scalar(owner, what, expr)
            check_symbols(owner, what, expr, degrees)
            if not rate_degrees(expr, degrees) <= {allowed}:
                raise ValueError(f"{owner}: {what} {fact}")
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
                raise ValueError(f"{owner}: '{mode.name}' has no unit; give an SI unit, or '1'")
        for d in self.deformations:
            check(f"deformation '{d.name}'", d.expr, 0, "depends on rates; declare it as a slip")
            if moving.isdisjoint(d.expr.free_symbols):
                raise ValueError(
                    f"{owner}: deformation '{d.name}' depends on no coordinate; use those of its nodes"
                )
        for slip in self.slips:
            check(f"slip '{slip.name}'", slip.expr, 1, "is not linear in the rates")
        check("the kinetic energy", self.kinetic_energy, 2, "is not quadratic in the rates")
        check("the potential", self.potential, 0, "depends on rates")
        if not (modes or self.kinetic_energy or self.potential):
            raise ValueError(f"{owner}: it has no deformation, slip or energy; declare one")
        check_text(owner, "the element", self.doc)

    @property
    def x(self) -> Matrix:
        """Coordinates of all nodes, column (n, 1)."""
        return Matrix([c for node in self.nodes for c in node.x])

    @property
    def v(self) -> Matrix:
        """Their rates, column (n, 1)."""
        return Matrix([c for node in self.nodes for c in node.v])

    @property
    def parameter_symbols(self) -> tuple[Symbol, ...]:
        """All parameters, flattened in declared order."""
        return tuple(s for p in self.parameters for s in p.symbols)


@dataclass(frozen=True)
class Internal:
    """Internal state z of a law (a bristle's deflection, a lagging slip), with its rate."""

    name: str
    unit: str
    rate: Expr

    @property
    def symbol(self) -> Symbol:
        """The symbol that stands for its value."""
        return symbol(self.name)


TIME = symbol("t")


@dataclass(frozen=True)
class Law:
    """Constitutive law: (sigma, tau, dz/dt) and the stored energy as functions of (e, ed, s, z, t) and parameters.

    Parameters
    ----------
    name, doc : str
    parameters : tuple of Parameter
    e, ed : tuple of Symbol, (m,)
        Deformations and their rates.
    s : tuple of Symbol, (k,)
        Slips.
    sigma : tuple of Expr, (m,)
    tau : tuple of Expr, (k,)
    energy : Expr
        Stored energy U(e, z) [J]; zero if the law stores none.
    source : str
    states : tuple of Internal, (nz,)
        Internal states with their rates.
    let : tuple of (Symbol, Expr)
        Named intermediates, each in terms of the arguments, parameters and earlier ones.

    Raises
    ------
    ValueError
        A name is used twice or is not a name in C, a unit or a stress is missing, an expression is not scalar or
        contains an unknown symbol, the energy depends on rates.

    Notes
    -----
    The time is the symbol `TIME`.
    """

    name: str
    doc: str
    parameters: tuple[Parameter, ...]
    e: tuple[Symbol, ...]
    ed: tuple[Symbol, ...]
    s: tuple[Symbol, ...]
    sigma: tuple[Expr, ...]
    tau: tuple[Expr, ...]
    energy: Expr = sp.S.Zero
    source: str = ""
    states: tuple[Internal, ...] = ()
    let: tuple[tuple[Symbol, Expr], ...] = ()

    def __post_init__(self) -> None:
        owner = f"law '{self.name}'"
        kinds = {"parameters": Parameter, "states": Internal, "e": Symbol, "ed": Symbol, "s": Symbol}
        for what, kind in {**kinds, "sigma": object, "tau": object}.items():
            check_list(owner, what, getattr(self, what), kind)
        check_name(owner, self.name)
        symbols = [*self.e, *self.ed, *self.s, *self.z, TIME, *self.parameter_symbols]
        for s in (*symbols, *(s for s, _ in self.let)):
            check_name(owner, s.name)
        check_unique(owner, [s.name for s in (*symbols, *(s for s, _ in self.let))])
        check_unique(owner, [p.name for p in self.parameters])
        if not len(self.e) == len(self.ed) == len(self.sigma) or len(self.s) != len(self.tau):
            raise ValueError(f"{owner}: give a stress for each deformation (with its rate) and slip")
        self._check_expressions(owner, symbols)

    def _check_expressions(self, owner: str, symbols: list[Symbol]) -> None:
        def check(what: str, expr: object) -> None:
            check_scalar(owner, what, expr)
            check_symbols(owner, what, expr, known)
            check_functions(owner, what, expr)

        known, on_rates = set(symbols), {*self.ed, *self.s, TIME}
        for s, expr in self.let:
            check(f"let '{s}'", expr)
            known.add(s)
            if expr.free_symbols & on_rates:
                on_rates.add(s)
        for i, expr in enumerate((*self.sigma, *self.tau)):
            check(f"stress {i + 1}", expr)
        for state in self.states:
            check(f"the rate of '{state.name}'", state.rate)
            if not state.unit:
                raise ValueError(f"{owner}: '{state.name}' has no unit; give an SI unit, or '1'")
        check("the energy", self.energy)
        if self.energy.free_symbols & on_rates:
            raise ValueError(f"{owner}: the energy depends on rates, slips or the time; it is one of (e, z)")
        check_text(owner, "the law", self.doc)

    @property
    def z(self) -> tuple[Symbol, ...]:
        """Internal states (nz,)."""
        return tuple(state.symbol for state in self.states)

    @property
    def parameter_symbols(self) -> tuple[Symbol, ...]:
        """All parameters, flattened in declared order."""
        return tuple(s for p in self.parameters for s in p.symbols)
