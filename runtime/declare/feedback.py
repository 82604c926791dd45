"""Feedback controllers as laws: forces from measured deformations, their rates and a controller's own states.

A controller is a law like any other, so the closed loop is simulated, linearized (analytically),
solved for steady motions and saved like everything else.  The derivation is imported only when a controller is
attached; controllers of one size are derived and compiled once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from flexel.base.arguments import array, names, numbers, quantities, text
from flexel.base.arrays import Array
from flexel.base.errors import CompilerError, ModelError
from flexel.declare.laws import Laws

UNITS = {"P": "N/m or N m", "D": "N s/m or N m s", "C": "N or N m", "A": "1/s", "B": "1/s", "B_rate": "1"}


class Feedback(Laws):
    """Controllers as laws."""

    def feedback(
        self,
        name: str,
        *,
        act: Sequence[str],
        measure: Sequence[str],
        P: Any = None,
        D: Any = None,
        C: Any = None,
        A: Any = None,
        B: Any = None,
        B_rate: Any = None,
        reference: Mapping[str, float] | None = None,
    ) -> None:
        """Attach a linear controller, u = -P (y - r) - D y' - C z with z' = A z + B (y - r) + B_rate y'.

        The forces u act on the deformations `act` and are positive when they do positive work as these grow, like
        loads; y are the deformations `measure`.  All of them become free.

        Parameters
        ----------
        name : str
            Its states are called ``name.z0``, ``name.z1``, …
        act : sequence of str (na,)
        measure : sequence of str (ny,)
        P, D : array_like (na, ny)
            Gains of the values and rates; none means zero.
        C : array_like (na, nz), A : array_like (nz, nz), B, B_rate : array_like (nz, ny)
            Of a controller with its own states: integral action, a filter, an observer.
        reference : mapping of str to float
            Values r of measured deformations, zero where none is given.  For a moving reference, measure against a
            frame whose hinge is prescribed.

        Raises
        ------
        ModelError
            Matrices of wrong shape, names that are duplicate or not measured.
        CompilerError
            If there is no C compiler.

        Examples
        --------
        State feedback from a linear-quadratic regulator, with the states in the order (q', q):

        >>> K, *_ = control.lqr(plant, Q, R)  # doctest: +SKIP
        >>> D, P = np.split(K, 2, axis=1)  # doctest: +SKIP
        >>> m.feedback("regulator", act=["motor.angle"], measure=lin.dynamic, P=P, D=D)  # doctest: +SKIP
        """
        owner = f"feedback '{text(name, 'feedback', 'name')}'"
        act, measure = names(act, owner), names(measure, owner)
        quantities([*act, *measure], owner)
        if not act or not measure or len(set(act)) < len(act) or len(set(measure)) < len(measure):
            raise ModelError(
                f"{owner}: acts on {act}, measures {measure}; name one or more deformations, each once"
            )
        na, ny = len(act), len(measure)
        nz = 0 if A is None else len(np.atleast_1d(array(A, owner, "A")))
        asked = {
            "P": (na, ny),
            "D": (na, ny),
            "C": (na, nz),
            "A": (nz, nz),
            "B": (nz, ny),
            "B_rate": (nz, ny),
        }
        given = {"P": P, "D": D, "C": C, "A": A, "B": B, "B_rate": B_rate}
        gains = {key: _matrix(given[key], owner, key, shape) for key, shape in asked.items()}
        r = numbers(reference, owner, "reference")
        for other in r.keys() - set(measure):
            raise ModelError(
                f"{owner}: the reference '{other}' is not measured; it measures {', '.join(measure)}"
            )
        on = list(dict.fromkeys([*act, *measure]))
        places = [on.index(z) for z in measure]
        parameters: dict[str, Any] = {key: z.ravel() for key, z in gains.items() if z.size}
        parameters["r"] = np.array([r.get(z, 0.0) for z in measure])
        compiled = _law(owner, len(on), na, nz, tuple(places))
        self._add_law(owner, compiled.spec, on, parameters, code=compiled.code, label=name)


def _matrix(value: Any, owner: str, key: str, shape: tuple[int, int]) -> Array:
    if value is None:
        return np.zeros(shape)
    found = array(value, owner, key)
    if found.shape != shape:
        raise ModelError(f"{owner}: {key} has shape {found.shape}; give {shape}")
    return found


def _law(owner: str, m: int, na: int, nz: int, places: tuple[int, ...]) -> Any:
    """The compiled law of a controller that acts on the first `na` of m deformations and measures those in `places`."""
    import sympy

    from flexel.derive import Internal, Law, Parameter, symbol
    from flexel.derive.cache import CacheError
    from flexel.derive.compile import compile_law
    from flexel.derive.shared_object import CompilationError, CompilerMissingError

    ny = len(places)
    sizes = {"P": (na, ny), "D": (na, ny), "C": (na, nz), "A": (nz, nz), "B": (nz, ny), "B_rate": (nz, ny)}
    gains = {
        key: Parameter(key, a * b, UNITS[key], "gains, row by row") for key, (a, b) in sizes.items() if a * b
    }
    r = Parameter("r", ny, "m or rad", "reference")
    matrix = {
        key: sympy.Matrix(*sizes[key], list(gains[key].symbols)) if key in gains else sympy.zeros(*sizes[key])
        for key in sizes
    }
    e, ed = (tuple(symbol(f"{letter}_{i}") for i in range(m)) for letter in ("e", "ed"))
    y = sympy.Matrix([e[i] for i in places]) - r.vector
    yd = sympy.Matrix([ed[i] for i in places])
    z = sympy.Matrix(nz, 1, [symbol(f"z{i}") for i in range(nz)])
    minus_u = matrix["P"] * y + matrix["D"] * yd + matrix["C"] * z
    zd = matrix["A"] * z + matrix["B"] * y + matrix["B_rate"] * yd
    law = Law(
        name="feedback",
        doc="sigma = P (y - r) + D y' + C z, z' = A z + B (y - r) + B_rate y'",
        parameters=(r, *gains.values()),
        e=e,
        ed=ed,
        s=(),
        sigma=(*minus_u, *([sympy.S.Zero] * (m - na))),
        tau=(),
        source="linear feedback",
        states=tuple(Internal(f"z{i}", "1", zd[i]) for i in range(nz)),
    )
    try:
        return compile_law(law)
    except (CompilerMissingError, CompilationError, CacheError) as error:
        raise CompilerError(f"{owner}: {error}") from error
