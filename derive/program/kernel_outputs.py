"""Which kernels an element or a law has, and the rows of their outputs.

Here the contract of ``generated/kernels.h`` is filled in: from D, V, T and U of an element, lowered to one program,
to the outputs of its kernels. Second and third derivatives are always contracted with rates, accelerations
or stresses.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from flexel.derive.declare import TIME, Element, Law
from flexel.derive.program.differentiate import forward, gradient
from flexel.derive.program.factor import factored
from flexel.derive.program.layers import (
    Matrix,
    Rows,
    flat,
    hessian,
    jacobian,
    linear_layer,
    product,
    pulled_jacobian,
    transpose,
)
from flexel.derive.program.lower import ProgramLowering
from flexel.derive.program.straight_line import Program


@dataclass(frozen=True)
class OutputArray:
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
    outputs: tuple[OutputArray, ...]
    operations: int


@dataclass(frozen=True)
class Derived:
    """Everything derived from an element or a law: a program, its inputs (array name to rows), the kernels."""

    program: Program
    inputs: dict[str, tuple[int, ...]]
    kernels: dict[str, Kernel]


class _Builder:
    """Program, input arrays and kernels while they are made."""

    def __init__(self) -> None:
        self.program = Program()
        self.inputs: dict[str, tuple[int, ...]] = {}
        self.kernels: dict[str, Kernel] = {}

    def array(self, name: str, component_names: Sequence[str]) -> Rows:
        """Declare an input array, with a name for each component."""
        rows = [self.program.input(f"{name}.{i}", name == "p") for i in range(len(component_names))]
        self.inputs[name] = tuple(rows)
        self.program.names.update(zip(rows, component_names, strict=True))
        return rows

    def kernel(
        self, name: str, inputs: Sequence[str], outputs: Mapping[str, tuple[tuple[int, ...], Rows]]
    ) -> None:
        """Note a kernel; zero entries of its outputs are dropped."""
        arrays: list[OutputArray] = []
        fewer = iter(factored(self.program, [row for _, rows in outputs.values() for row in rows]))
        for array, (shape, unfactored) in outputs.items():
            rows = [next(fewer) for _ in unfactored]
            kept = tuple(i for i, row in enumerate(rows) if row != self.program.zero)
            arrays.append(OutputArray(array, shape, kept, tuple(rows[i] for i in kept)))
        count = self.program.operations([row for output in arrays for row in output.rows])
        self.kernels[name] = Kernel(name, tuple(inputs), tuple(arrays), count)

    def derived(self) -> Derived:
        return Derived(self.program, self.inputs, self.kernels)


def _weighted(program: Program, weights: Rows, rows: Rows) -> int:
    return program.sum(program.mul(weight, row) for weight, row in zip(weights, rows, strict=True))


def _plus(program: Program, first: Matrix, second: Matrix) -> Matrix:
    return [
        [program.add(a, b) for a, b in zip(r, s, strict=True)] for r, s in zip(first, second, strict=True)
    ]


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
    lowering: ProgramLowering


def _lower(builder: _Builder, element: Element) -> _Lowered:
    x = builder.array("x", _names(element.x))
    v = builder.array("v", _names(element.v))
    p = builder.array("p", _names(element.parameter_symbols))
    known = dict(zip((*element.x, *element.v, *element.parameter_symbols), x + v + p, strict=True))
    lowering = ProgramLowering(builder.program, known)
    for symbol, expr in element.let:
        lowering.let(symbol, expr)
    e = [lowering.lower(d.expr) for d in element.deformations]
    s = [lowering.lower(d.expr) for d in element.slips]
    energy, potential = lowering.lower(element.kinetic_energy), lowering.lower(element.potential)
    a = builder.array("a", [f"{node.name}_a{c}" for node in element.nodes for c in node.components])
    sigma = builder.array("sigma", [f"sigma_{d.name}" for d in element.deformations])
    tau = builder.array("tau", [f"tau_{d.name}" for d in element.slips])
    return _Lowered(x, v, a, sigma, tau, e, s, energy, potential, lowering)


def _kinematic_kernels(b: _Builder, rows: _Lowered) -> None:
    p, x, v = b.program, rows.x, rows.v
    n, m, k = len(x), len(rows.e), len(rows.s)
    along_v = dict(zip(x, v, strict=True))
    De, V = jacobian(p, rows.e, x), jacobian(p, rows.s, v)
    ed = forward(p, rows.e, along_v)
    g, gs = forward(p, ed, along_v), forward(p, rows.s, along_v)
    b.kernel("position", "xp", {"e": ((m,), rows.e), "De": ((m, n), flat(De)), "V": ((k, n), flat(V))})
    b.kernel("acceleration", "xvp", {"g": ((m,), g), "gs": ((k,), gs)})

    De_a = forward(p, rows.e, dict(zip(x, rows.a, strict=True)))
    V_a = forward(p, rows.s, dict(zip(v, rows.a, strict=True)))
    ed_x, s_x = jacobian(p, ed, x), jacobian(p, rows.s, x)
    b.kernel("rates", "xvp", {"Phi_x": ((m + k, n), flat(ed_x + s_x))})
    Psi_e = [p.add(*pair) for pair in zip(g, De_a, strict=True)]
    Psi_s = [p.add(*pair) for pair in zip(gs, V_a, strict=True)]
    twice = [[p.add(entry, entry) for entry in row] for row in ed_x]  # d(D2e(v,v))/dv = 2 D2e(v,.)
    Psi_x = jacobian(p, Psi_e, x) + jacobian(p, Psi_s, x)
    Psi_v = twice + jacobian(p, Psi_s, v)
    shape = (m + k, n)
    b.kernel("kinematics", "xvap", {"Psi_x": (shape, flat(Psi_x)), "Psi_v": (shape, flat(Psi_v))})

    K = hessian(p, _weighted(p, rows.sigma, rows.e), x)
    if k:
        K = _plus(p, K, jacobian(p, gradient(p, _weighted(p, rows.tau, rows.s), v), x))
    b.kernel("stiffness", ("x", "sigma", "tau", "p"), {"K": ((n, n), flat(K))})


def _inertia_kernels(b: _Builder, rows: _Lowered) -> None:
    """Derive M, h, f, U and the tangent of R = d(dT/dv)/dt - dT/dx + dU/dx, summed over the rows of linear layers."""
    p, x, v, n = b.program, rows.x, rows.v, len(rows.x)
    along_v = dict(zip(x, v, strict=True))
    along = {**along_v, **dict(zip(v, rows.a, strict=True))}
    layer_v, layer_x = linear_layer(p, [rows.T], v), linear_layer(p, [rows.T], x)
    momentum = gradient(p, rows.T, layer_v.rows)
    T_x = list(zip(layer_x.B, map(p.neg, gradient(p, rows.T, layer_x.rows)), strict=True))
    convective = list(zip(layer_v.B, forward(p, momentum, along_v), strict=True))
    complete = list(zip(layer_v.B, forward(p, momentum, along), strict=True))
    U_x = gradient(p, rows.U, x)
    left, inner = _gathered(p, convective + T_x, n)
    M, h = hessian(p, rows.T, v), flat(product(p, left, [[row] for row in inner]))
    f = [p.neg(row) for row in U_x]
    outputs = {"M": ((n, n), flat(M)), "h": ((n,), h), "f": ((n,), f), "U": ((1,), [rows.U])}
    b.kernel("inertia", "xvp", outputs)

    layer_U = linear_layer(p, [rows.U], x)
    stiff = list(zip(layer_U.B, gradient(p, rows.U, layer_U.rows), strict=True))
    left, inner = _gathered(p, complete + T_x + stiff, n)
    R_x, R_v = pulled_jacobian(p, left, inner, x), pulled_jacobian(p, left, inner, v)
    b.kernel("tangent", "xvap", {"R_x": ((n, n), flat(R_x)), "R_v": ((n, n), flat(R_v))})


def _gathered(p: Program, terms: list[tuple[Rows, int]], n: int) -> tuple[Matrix, Rows]:
    """Sum B' r (n,) over rows r of layers, as one matrix and one column; rows with the same B are added up."""
    sums: dict[tuple[int, ...], int] = {}
    for B, row in terms:
        sums[tuple(B)] = p.add(sums.get(tuple(B), p.zero), row)
    kept = {B: row for B, row in sums.items() if row != p.zero}
    if not kept:
        return [[p.zero] for _ in range(n)], [p.zero]
    return transpose([list(B) for B in kept]), list(kept.values())


def _output_kernel(b: _Builder, rows: _Lowered, element: Element) -> None:
    """Derive the outputs from coordinates, deformations, stresses and the forces De' sigma + V' tau on the nodes."""
    p = b.program
    of_e = gradient(p, _weighted(p, rows.sigma, rows.e), rows.x)
    of_s = gradient(p, _weighted(p, rows.tau, rows.s), rows.v)
    forces = [p.add(*pair) for pair in zip(of_e, of_s, strict=True)]
    given = [*zip(element.forces, forces, strict=True)]
    used = {symbol for output in element.outputs for expr in output.exprs for symbol in expr.free_symbols}
    inputs = ["x", "sigma", "tau", "p"]
    if not used.isdisjoint(element.values):
        inputs.insert(1, "e")
        given += zip(element.values, b.array("e", _names(element.values)), strict=True)
    given += zip(element.stresses, rows.sigma + rows.tau, strict=True)
    for symbol, row in given:
        rows.lowering.name(symbol, row)
    outputs = {o.name: (o.shape, [rows.lowering.lower(expr) for expr in o.exprs]) for o in element.outputs}
    b.kernel("outputs", inputs, outputs)


def derive_element(element: Element) -> Derived:
    """Derive the kernels of an element; those that it does not need are missing."""
    builder = _Builder()
    rows = _lower(builder, element)
    if rows.e or rows.s:
        _kinematic_kernels(builder, rows)
    if builder.program.zero != rows.T or builder.program.zero != rows.U:
        _inertia_kernels(builder, rows)
    if element.outputs:
        _output_kernel(builder, rows, element)
    return builder.derived()


def derive_law(law: Law) -> Derived:
    """Derive the kernels of a law: ``law`` and ``tangent``.

    What the stresses do and the law does not store, sigma.ed + tau.s - dU/dt, is the dissipated power P.
    """
    b = _Builder()
    p = b.program
    parts = {"e": law.e, "ed": law.ed, "s": law.s, "z": law.z, "t": (TIME,), "p": law.parameter_symbols}
    rows = {name: b.array(name, _names(symbols)) for name, symbols in parts.items()}
    known = {
        symbol: row
        for name, symbols in parts.items()
        for symbol, row in zip(symbols, rows[name], strict=True)
    }
    lowering = ProgramLowering(p, known)
    for name, expr in law.let:
        lowering.let(name, expr)
    sigma, tau = [lowering.lower(expr) for expr in law.sigma], [lowering.lower(expr) for expr in law.tau]
    zd, U = [lowering.lower(state.rate) for state in law.states], lowering.lower(law.energy)
    e, ed, s, z = (rows[name] for name in ("e", "ed", "s", "z"))
    work = p.add(_weighted(p, sigma, ed), _weighted(p, tau, s))
    (stored,) = forward(p, [U], dict(zip(e + z, ed + zd, strict=True)))
    P = p.add(work, p.neg(stored))
    m, k, nz, inputs = len(e), len(s), len(z), tuple(parts)
    outputs = {
        "sigma": ((m,), sigma),
        "tau": ((k,), tau),
        "zd": ((nz,), zd),
        "U": ((1,), [U]),
        "P": ((1,), [P]),
    }
    b.kernel("law", inputs, outputs)
    J = jacobian(p, sigma + tau + zd, e + ed + s + z)
    b.kernel("tangent", inputs, {"J": ((m + k + nz, 2 * m + k + nz), flat(J))})
    return b.derived()
