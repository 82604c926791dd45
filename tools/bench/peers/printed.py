"""Prints SymPy's equations of motion M(y) u' = f(y) as C, compiles them with cffi, and solves them by elimination.

A user of SymPy can print the equations as C like this instead of turning them into Python functions.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Sequence
from importlib.util import module_from_spec, spec_from_file_location
from typing import Any

import numpy as np

from flexel.base.arrays import Array

Rates = Callable[[Array], Array]
FLAGS = ["-O3", "-march=native", "-ffp-contract=fast", "-fno-math-errno"]
NAME = "printed_equations"
SOURCE = """
#include <math.h>
#include <string.h>
enum { N = %(size)d };

/* mass matrix (N x N), row by row, and behind it the forces (N) */
static void entries(const double *y, double *out)
{
%(body)s
}

/* y = (q, u): speeds, and accelerations by elimination with row pivots */
static void rates(const double *y, double *dy)
{
    double m[N * (N + 1)], A[N][N + 1];
    entries(y, m);
    for (int i = 0; i < N; i++) {
        memcpy(A[i], m + N * i, N * sizeof(double));
        A[i][N] = m[N * N + i];
    }
    for (int p = 0; p < N; p++) {
        int best = p;
        for (int i = p + 1; i < N; i++)
            best = fabs(A[i][p]) > fabs(A[best][p]) ? i : best;
        for (int j = p; best != p && j <= N; j++) {
            const double kept = A[p][j];
            A[p][j] = A[best][j];
            A[best][j] = kept;
        }
        for (int i = p + 1; i < N; i++) {
            const double factor = A[i][p] / A[p][p];
            for (int j = p + 1; factor != 0 && j <= N; j++)
                A[i][j] -= factor * A[p][j];
        }
    }
    for (int p = N; p-- > 0;) {
        double sum = A[p][N];
        for (int j = p + 1; j < N; j++)
            sum -= A[p][j] * dy[N + j];
        dy[N + p] = sum / A[p][p];
    }
    memcpy(dy, y + N, N * sizeof(double));
}
"""


def printed(names: Sequence[Any], entries: Sequence[Any]) -> Rates:
    """Compile the time derivative of y = (q, u), all in C.

    Parameters
    ----------
    names : sequence of sympy.Symbol
        The entries of y, (2 N,).
    entries : sequence of sympy.Expr
        The mass matrix row by row, and behind it the forces, (N * N + N,).
    """
    module = compiled(SOURCE % {"size": len(names) // 2, "body": body(names, entries)})
    state, found = np.zeros(len(names)), np.zeros(len(names))
    y, dy = (module.ffi.from_buffer("double[]", array) for array in (state, found))
    function = module.lib.rates

    def rates(at: Array) -> Array:
        state[:] = at
        function(y, dy)
        return found.copy()

    return rates


def body(names: Sequence[Any], entries: Sequence[Any]) -> str:
    """Print C that computes the entries, with common subexpressions and small powers as products."""
    import sympy
    from sympy.codegen.rewriting import create_expand_pow_optimization

    product = create_expand_pow_optimization(9)
    common, reduced = sympy.cse(list(entries), symbols=sympy.numbered_symbols("c"))
    used = set().union(*(formula.free_symbols for formula in entries))
    lines = [f"const double {name} = y[{i}];" for i, name in enumerate(names) if name in used]
    lines += [f"const double {name} = {sympy.ccode(product(formula))};" for name, formula in common]
    lines += [f"out[{i}] = {sympy.ccode(product(formula))};" for i, formula in enumerate(reduced)]
    return "\n".join(lines)


def compiled(source: str) -> Any:
    """Build the extension module of a source with the function `rates`."""
    from cffi import FFI

    builder = FFI()
    builder.cdef("void rates(const double *y, double *dy);")
    builder.set_source(NAME, source, extra_compile_args=FLAGS)
    with tempfile.TemporaryDirectory() as folder:
        spec = spec_from_file_location(NAME, builder.compile(tmpdir=folder))
        assert spec is not None and spec.loader is not None
        module = module_from_spec(spec)
        spec.loader.exec_module(module)
    return module
