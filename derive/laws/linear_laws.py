"""Linear laws: visco-elastic ones of deformations, viscous ones of slips."""

import sympy as sp
from sympy import Expr, Matrix

from flexel.derive.declare import Law, Parameter, symbol


def _symmetric(values: tuple[sp.Symbol, ...], size: int) -> Matrix:
    """Return a symmetric matrix from its upper triangle, row by row."""
    entries = iter(values)
    upper = {(i, j): next(entries) for i in range(size) for j in range(i, size)}
    return Matrix(size, size, lambda i, j: upper[min(i, j), max(i, j)])


def _triangle(name: str, size: int, unit: str, doc: str) -> Parameter:
    """Declare a parameter that holds the upper triangle of a symmetric matrix."""
    names = tuple(f"{i + 1}{j + 1}" for i in range(size) for j in range(i, size))
    return Parameter(name, len(names), unit, doc + ", upper triangle, row by row", names, sign="semidefinite")


def _linear(m: int) -> Law:
    """Declare the linear visco-elastic law of m deformations, with preload."""
    preload = Parameter("preload", m, "N or N m", "stress at zero deformation")
    stiffness = _triangle("S", m, "N/m or N m", "stiffness")
    damping = _triangle("D", m, "N s/m or N m s", "damping")
    e = tuple(symbol(f"e_{i}") for i in range(m))
    ed = tuple(symbol(f"ed_{i}") for i in range(m))
    elastic = _symmetric(stiffness.symbols, m) * Matrix(e)
    sigma = preload.vector + elastic + _symmetric(damping.symbols, m) * Matrix(ed)
    energy: Expr = sp.Add(*(e[i] * (preload.symbols[i] + elastic[i] / 2) for i in range(m)))
    return Law(
        name=f"linear_{m}",
        doc="sigma = preload + S e + D ed\nenergy = preload.e + e.S e/2",
        parameters=(preload, stiffness, damping),
        e=e,
        ed=ed,
        s=(),
        sigma=tuple(sigma),
        tau=(),
        energy=energy,
        source="Kelvin-Voigt model",
    )


def _viscous(k: int) -> Law:
    """Declare the linear viscous law of k slips."""
    viscosity = _triangle("C", k, "N s/m or N m s", "viscosity")
    s = tuple(symbol(f"s_{i}") for i in range(k))
    return Law(
        name=f"viscous_{k}",
        doc="tau = C s",
        parameters=(viscosity,),
        e=(),
        ed=(),
        s=s,
        sigma=(),
        tau=tuple(_symmetric(viscosity.symbols, k) * Matrix(s)),
        source="linear viscous model",
    )


LINEAR: tuple[Law, ...] = (
    *(_linear(m) for m in range(1, 7)),
    *(_viscous(k) for k in range(1, 4)),
)
