"""Which kernels an element or a law has, and the rows of their outputs.

Here the contract of ``generated/kernels.h`` is filled in: from D, V, T and U of an element, lowered to one program,
to the outputs of its seven kernels. Second and third derivatives are always contracted with rates, accelerations
or stresses. May import the rooms of the program and the declarations of elements and laws.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from flexel.derive.differentiate import forward, gradient
from flexel.derive.element import Element, Law
from flexel.derive.lower import Lowering
from flexel.derive.program import Program


@dataclass(frozen=True)
class Output:
    """One output array of a kernel.

    Parameters
    ----------
    name : str
    shape : tuple of int
        Shape of the full array.
    nonzeros : tuple of int
        Flat indices of the entries that are not structurally zero; only these are stored.
    rows : tuple of int
        Their rows in the program.
    """

    name: str
    shape: tuple[int, ...]
    nonzeros: tuple[int, ...]
    rows: tuple[int, ...]


@dataclass(frozen=True)
class Kernel:
    """A set of outputs that are computed together from the same inputs."""

    name: str
    inputs: tuple[str, ...]
    outputs: tuple[Output, ...]
    operations: int


@dataclass(frozen=True)
class Derived:
    """Everything derived from an element or a law: a program, its inputs (array name to rows), the kernels."""

    program: Program
    inputs: dict[str, tuple[int, ...]]
    kernels: dict[str, Kernel]


Rows = list[int]
Matrix = list[list[int]]


class _Builder:
    """Program, input arrays and kernels while they are made."""

    def __init__(self) -> None:
        self.program = Program()
        self.inputs: dict[str, tuple[int, ...]] = {}
        self.kernels: dict[str, Kernel] = {}

    def array(self, name: str, component_names: Sequence[str]) -> Rows:
        """Declare an input array, with a name for each component."""
        rows = [self.program.input(f"{name}.{i}") for i in range(len(component_names))]
        self.inputs[name] = tuple(rows)
        self.program.names.update(zip(rows, component_names, strict=True))
        return rows

    def kernel(self, name: str, inputs: Sequence[str], outputs: Mapping[str, tuple[tuple[int, ...], Rows]]) -> None:
        """Note a kernel; zero entries of its outputs are dropped."""
        arrays: list[Output] = []
        for array, (shape, rows) in outputs.items():
            kept = tuple(i for i, row in enumerate(rows) if row != self.program.zero)
            arrays.append(Output(array, shape, kept, tuple(rows[i] for i in kept)))
        count = self.program.operations([row for output in arrays for row in output.rows])
        self.kernels[name] = Kernel(name, tuple(inputs), tuple(arrays), count)

    def derived(self) -> Derived:
        return Derived(self.program, self.inputs, self.kernels)


def _flat(matrix: Matrix) -> Rows:
    return [entry for row in matrix for entry in row]


def jacobian(program: Program, outputs: Rows, inputs: Rows) -> Matrix:
    """Derivatives of the outputs by the inputs, by forward or reverse sweeps: whichever takes fewer operations."""
    backward = [gradient(program, output, inputs) for output in outputs]
    columns = [forward(program, outputs, {i: program.one}) for i in inputs]
    ahead = [list(row) for row in zip(*columns, strict=True)] if columns else [[] for _ in outputs]
    fewer = program.operations(_flat(backward) + outputs) <= program.operations(_flat(ahead) + outputs)
    return backward if fewer else ahead


def symmetric_jacobian(program: Program, outputs: Rows, inputs: Rows) -> Matrix:
    """Derivatives of a gradient: one triangle is computed and serves for both, again the cheaper one."""
    n = len(inputs)
    candidates: list[Matrix] = []
    for upper in (True, False):
        matrix = [[program.zero] * n for _ in range(n)]
        for j in range(n):
            kept = range(j + 1) if upper else range(j, n)
            column = forward(program, [outputs[i] for i in kept], {inputs[j]: program.one})
            for i, entry in zip(kept, column, strict=True):
                matrix[i][j] = matrix[j][i] = entry
        candidates.append(matrix)
    return min(candidates, key=lambda matrix: program.operations(_flat(matrix)))


def _weighted(program: Program, weights: Rows, rows: Rows) -> int:
    return program.sum(program.mul(weight, row) for weight, row in zip(weights, rows, strict=True))


def _plus(program: Program, first: Matrix, second: Matrix) -> Matrix:
    return [[program.add(a, b) for a, b in zip(r, s, strict=True)] for r, s in zip(first, second, strict=True)]


def _names(symbols: Sequence[sp.Symbol]) -> list[str]:
    return [symbol.name for symbol in symbols]


@dataclass(frozen=True)
class _Lowered:
    """An element as rows: inputs x, v, a and outputs e, s, T, U."""

    x: Rows
    v: Rows
    a: Rows
    sigma: Rows
    tau: Rows
    e: Rows
    s: Rows
    T: int
    U: int


def _lower(builder: _Builder, element: Element) -> _Lowered:
    x = builder.array("x", _names(element.x))
    v = builder.array("v", _names(element.v))
    p = builder.array("p", _names(element.parameter_symbols))
    known = dict(zip((*element.x, *element.v, *element.parameter_symbols), x + v + p, strict=True))
    lowering = Lowering(builder.program, known)
    for symbol, expr in element.let:
        lowering.let(symbol, expr)
    e = [lowering.lower(d.expr) for d in element.deformations]
    s = [lowering.lower(d.expr) for d in element.slips]
    energy, potential = lowering.lower(element.kinetic_energy), lowering.lower(element.potential)
    a = builder.array("a", [f"{node.name}_a{c}" for node in element.nodes for c in node.components])
    sigma = builder.array("sigma", [f"sigma_{d.name}" for d in element.deformations])
    tau = builder.array("tau", [f"tau_{d.name}" for d in element.slips])
    return _Lowered(x, v, a, sigma, tau, e, s, energy, potential)


def _kinematic_kernels(b: _Builder, rows: _Lowered) -> None:
    p, x, v = b.program, rows.x, rows.v
    n, m, k = len(x), len(rows.e), len(rows.s)
    along_v = dict(zip(x, v, strict=True))
    De, V = jacobian(p, rows.e, x), jacobian(p, rows.s, v)
    ed = forward(p, rows.e, along_v)
    g, gs = forward(p, ed, along_v), forward(p, rows.s, along_v)
    b.kernel("position", "xp", {"e": ((m,), rows.e), "De": ((m, n), _flat(De)), "V": ((k, n), _flat(V))})
    b.kernel("velocity", "xvp", {"ed": ((m,), ed), "s": ((k,), rows.s)})
    b.kernel("acceleration", "xvp", {"g": ((m,), g), "gs": ((k,), gs)})

    De_a = forward(p, rows.e, dict(zip(x, rows.a, strict=True)))
    V_a = forward(p, rows.s, dict(zip(v, rows.a, strict=True)))
    Psi_e = [p.add(*pair) for pair in zip(g, De_a, strict=True)]
    Psi_s = [p.add(*pair) for pair in zip(gs, V_a, strict=True)]
    ed_x, s_x = jacobian(p, ed, x), jacobian(p, rows.s, x)
    twice = [[p.add(entry, entry) for entry in row] for row in ed_x]  # d(D2e(v,v))/dv = 2 D2e(v,.)
    Psi_x = jacobian(p, Psi_e, x) + jacobian(p, Psi_s, x)
    Psi_v = twice + jacobian(p, Psi_s, v)
    shape = (m + k, n)
    outputs = {"Phi_x": (shape, _flat(ed_x + s_x)), "Psi_x": (shape, _flat(Psi_x)), "Psi_v": (shape, _flat(Psi_v))}
    b.kernel("kinematics", "xvap", outputs)

    K = symmetric_jacobian(p, gradient(p, _weighted(p, rows.sigma, rows.e), x), x)
    if k:
        K = _plus(p, K, jacobian(p, gradient(p, _weighted(p, rows.tau, rows.s), v), x))
    b.kernel("stiffness", ("x", "sigma", "tau", "p"), {"K": ((n, n), _flat(K))})


def _inertia_kernels(b: _Builder, rows: _Lowered) -> None:
    p, x, v, n = b.program, rows.x, rows.v, len(rows.x)
    momentum, T_x, U_x = gradient(p, rows.T, v), gradient(p, rows.T, x), gradient(p, rows.U, x)
    M = symmetric_jacobian(p, momentum, v)
    Mdot_v = forward(p, momentum, dict(zip(x, v, strict=True)))
    h = [p.sub(*pair) for pair in zip(Mdot_v, T_x, strict=True)]
    f = [p.neg(row) for row in U_x]
    outputs = {"M": ((n, n), _flat(M)), "h": ((n,), h), "f": ((n,), f), "U": ((1,), [rows.U])}
    b.kernel("inertia", "xvp", outputs)

    rate = forward(p, momentum, dict(zip(x + v, v + rows.a, strict=True)))  # d(dT/dv)/dt = M a + Mdot v
    R = [p.add(p.sub(dp, t), u) for dp, t, u in zip(rate, T_x, U_x, strict=True)]
    R_x, R_v = jacobian(p, R, x), jacobian(p, R, v)
    b.kernel("tangent", "xvap", {"R_x": ((n, n), _flat(R_x)), "R_v": ((n, n), _flat(R_v))})


def derive_element(element: Element) -> Derived:
    """Kernels of an element; those that it does not need are missing."""
    builder = _Builder()
    rows = _lower(builder, element)
    if rows.e or rows.s:
        _kinematic_kernels(builder, rows)
    if builder.program.zero != rows.T or builder.program.zero != rows.U:
        _inertia_kernels(builder, rows)
    return builder.derived()


def derive_law(law: Law) -> Derived:
    """Kernels of a law: ``law`` and ``tangent``."""
    b = _Builder()
    p = b.program
    e, ed, s = (b.array(name, _names(part)) for name, part in (("e", law.e), ("ed", law.ed), ("s", law.s)))
    parameters = b.array("p", _names(law.parameter_symbols))
    symbols = (*law.e, *law.ed, *law.s, *law.parameter_symbols)
    lowering = Lowering(p, dict(zip(symbols, e + ed + s + parameters, strict=True)))
    sigma, tau = [lowering.lower(expr) for expr in law.sigma], [lowering.lower(expr) for expr in law.tau]
    energy = lowering.lower(law.energy)
    m, k, inputs = len(e), len(s), ("e", "ed", "s", "p")
    b.kernel("law", inputs, {"sigma": ((m,), sigma), "tau": ((k,), tau), "U": ((1,), [energy])})
    J = jacobian(p, sigma + tau, e + ed + s)
    b.kernel("tangent", inputs, {"J": ((m + k, 2 * m + k), _flat(J))})
    return b.derived()
