"""The elementary functions that an expression may contain, with the names of their rows in a program."""

import sympy as sp
from sympy.core.basic import Basic

# SymPy functions of one and two arguments and the names of their rows.
FUNCTIONS: dict[type[Basic], str] = {
    sp.sin: "sin",
    sp.cos: "cos",
    sp.tan: "tan",
    sp.asin: "asin",
    sp.acos: "acos",
    sp.atan: "atan",
    sp.atan2: "atan2",
    sp.exp: "exp",
    sp.log: "log",
    sp.sinh: "sinh",
    sp.cosh: "cosh",
    sp.tanh: "tanh",
    sp.Abs: "abs",
}

# functions with a kink, allowed only in laws
KINKED = (sp.Abs, sp.Min, sp.Max, sp.sign, sp.Heaviside)
