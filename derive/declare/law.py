"""The declaration of a law: stresses, internal states and stored energy, with the source."""

from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Symbol

from flexel.derive.declare.checks import (
    check_functions,
    check_list,
    check_name,
    check_scalar,
    check_symbols,
    check_text,
    check_unique,
)
from flexel.derive.declare.constants import Parameter
from flexel.derive.declare.symbols import TIME, symbol
from flexel.derive.declare.winding import Term, terms_of
from flexel.derive.definition_errors import ElementError


@dataclass(frozen=True)
class Internal:
    """Internal state z of a law (a bristle's deflection, a lagging slip), with its rate.

    Parameters
    ----------
    name, unit : str
    rate : Expr
        dz/dt.
    lasting : bool
        Whether it changes with displacements only, and stays as it is at rest, such as the deflection of a bristle:
        an equilibrium lets it follow. Other states are held in statics.
    """

    name: str
    unit: str
    rate: Expr
    lasting: bool = False

    @property
    def symbol(self) -> Symbol:
        """The symbol that stands for its value."""
        return symbol(self.name)


@dataclass(frozen=True)
class Limit:
    """The limit of a law's data: the largest stress of its first deformation, and the extrapolation beyond.

    Parameters
    ----------
    parameter : Symbol
        The parameter, or the component of one, that is the largest stress.
    beyond : str
        The extrapolation, in a few words.
    """

    parameter: Symbol
    beyond: str


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
    limit : Limit, optional
        The limit of its data.
    begins : tuple of Expr, optional
        What is zero where the law begins to act, such as e - gap: linear in the first deformation and its rate, with
        sums of products of parameters as coefficients. Steps end there.
    units : tuple of str, (m + k,), optional
        Units of the deformations and slips; empty text for one of any unit.  None are given by default.

    Raises
    ------
    ElementError
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
    limit: Limit | None = None
    begins: tuple[Expr, ...] = ()
    units: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        owner = self.owner
        kinds = {"parameters": Parameter, "states": Internal, "e": Symbol, "ed": Symbol, "s": Symbol}
        for what, kind in {**kinds, "sigma": object, "tau": object}.items():
            check_list(owner, what, getattr(self, what), kind)
        check_name(owner, self.name)
        symbols = list(self.arguments)
        for s in (*symbols, *(s for s, _ in self.let)):
            check_name(owner, s.name)
        self._check_names(owner)
        check_unique(owner, [p.name for p in self.parameters])
        if not len(self.e) == len(self.ed) == len(self.sigma) or len(self.s) != len(self.tau):
            raise ElementError(f"{owner}: give a stress for each deformation (with its rate) and slip")
        if self.units and len(self.units) != len(self.e) + len(self.s):
            raise ElementError(
                f"{owner}: give a unit for each deformation and slip, '' for any, or none at all"
            )
        if self.limit is not None and self.limit.parameter not in self.parameter_symbols:
            raise ElementError(
                f"{owner}: the limit {self.limit.parameter} is not one of its parameters; declare it"
            )
        for expr in self.begins:
            begin_terms(self, expr)
        self._check_expressions(owner, symbols)

    def _check_names(self, owner: str) -> None:
        named = [*self.e, *self.ed, *self.s, *self.z, *self.parameter_symbols, *(s for s, _ in self.let)]
        if TIME in named:
            raise ElementError(f"{owner}: the name '{TIME}' is reserved for the time; rename it")
        check_unique(owner, [s.name for s in named])

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
                raise ElementError(f"{owner}: '{state.name}' has no unit; give an SI unit, or '1'")
        check("the energy", self.energy)
        if self.energy.free_symbols & on_rates:
            raise ElementError(
                f"{owner}: the energy depends on rates, slips or the time; it must be a function of (e, z)"
            )
        check_text(owner, "the law", self.doc)

    @property
    def owner(self) -> str:
        """Kind and name, as messages begin."""
        return f"law '{self.name}'"

    @property
    def arguments(self) -> tuple[Symbol, ...]:
        """All symbols that its expressions are functions of, in the order of the kernels' arrays."""
        return (*self.e, *self.ed, *self.s, *self.z, TIME, *self.parameter_symbols)

    @property
    def z(self) -> tuple[Symbol, ...]:
        """Internal states (nz,)."""
        return tuple(state.symbol for state in self.states)

    @property
    def parameter_symbols(self) -> tuple[Symbol, ...]:
        """All parameters, flattened in declared order."""
        return tuple(s for p in self.parameters for s in p.symbols)


def begin_terms(law: Law, expr: Expr) -> tuple[tuple[Term, ...], ...]:
    """Return the coefficients of the first deformation and of its rate, and the rest, of one of `Law.begins`.

    Raises
    ------
    ElementError
        It is not linear in them, or a coefficient is not a sum of products of parameters.
    """
    owner = f"{law.owner}: begins"
    form = sp.Poly(expr, law.e[0], law.ed[0]) if law.e else None
    if form is None or form.total_degree() != 1:
        raise ElementError(
            f"{owner} {expr} is not linear in its first deformation and the rate of that; give what is zero where it "
            "begins to act, such as e - gap"
        )
    parts = (form.coeff_monomial(law.e[0]), form.coeff_monomial(law.ed[0]), form.coeff_monomial(1))
    return tuple(terms_of(part, law.parameters, owner) for part in parts)
