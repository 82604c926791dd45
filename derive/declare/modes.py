"""Deformations and slips: what an element measures, and what laws and conditions act on."""

from dataclasses import dataclass

from sympy import Expr


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
