"""Deformations and slips: the quantities that an element measures and on which laws and conditions act."""

from dataclasses import dataclass

from sympy import Expr, Symbol

from flexel.derive.declare.symbols import symbol
from flexel.derive.declare.words import KINDS, check_word


@dataclass(frozen=True)
class Deformation:
    """Generalized deformation e = D(x).

    Parameters
    ----------
    name, unit : str
    expr : Expr
    free : bool, optional
        Whether it is free by default; otherwise rigid.
    period : Expr, optional
        The jump after a full turn: 2 pi, or a sum of products of powers of parameters. Zero states that it never
        jumps, although an atan2 in it could.
    kind : str, optional
        The gap of a contact ("gap"), the height of one that is never lost ("touch"), or the norm of a frame's Euler
        parameters ("norm").
    kinked : bool, optional
        Whether its derivatives jump at configurations that motions reach; it is then never chosen as a degree of
        freedom.
    """

    name: str
    unit: str
    expr: Expr
    free: bool = False
    period: Expr | int | float | None = None
    kind: str = ""
    kinked: bool = False

    def __post_init__(self) -> None:
        check_word(f"deformation '{self.name}'", "kind", self.kind, KINDS)

    @property
    def value(self) -> Symbol:
        """Its value e, over any number of turns, for outputs."""
        return symbol(f"e_{self.name}")

    @property
    def stress(self) -> Symbol:
        """Its generalized stress, for outputs."""
        return symbol(f"sigma_{self.name}")


@dataclass(frozen=True)
class Slip:
    """Generalized slip s = V(x) v, linear in the rates.

    Parameters
    ----------
    name : str
    unit : str
        Of the slip, such as "m/s".
    expr : Expr
        The slip in terms of coordinates and rates.
    free : bool
        Whether it is free by default; zero otherwise.
    """

    name: str
    unit: str
    expr: Expr
    free: bool = False

    @property
    def stress(self) -> Symbol:
        """Its generalized stress, for outputs."""
        return symbol(f"tau_{self.name}")
