"""Jacobians through the linear layer below a program: the chain rule across its narrowest place.

Elements see their coordinates through linear combinations with constant coefficients: xq - xp, or the quaternion
lambda o t of a triad. Derivatives are taken with respect to these, where they are sparse, and carried over to the
coordinates by one product with the constant matrix B of the layer.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from flexel.derive.program.differentiate import elimination, forward, gradient
from flexel.derive.program.narrowest import narrowest
from flexel.derive.program.straight_line import Program

Rows = list[int]
Matrix = list[list[int]]


@dataclass(frozen=True)
class Layer:
    """Rows through which alone outputs depend on inputs, and their constant derivatives B = d rows/d inputs."""

    rows: Rows
    B: Matrix


def linear_layer(program: Program, outputs: Sequence[int], inputs: Sequence[int]) -> Layer:
    """Find the fewest rows, linear in the inputs with constant coefficients, that separate inputs from outputs."""
    region, used = _linear_region(program, outputs, inputs)
    rows = narrowest(region, inputs, used)
    columns = [forward(program, rows, {row: program.one}) for row in inputs]
    return Layer(rows, [[column[i] for column in columns] for i in range(len(rows))])


def _linear_region(
    program: Program, outputs: Sequence[int], inputs: Sequence[int]
) -> tuple[dict[int, list[int]], Rows]:
    """Find rows linear in the inputs with constant coefficients (and their arguments), and the last of them."""
    region: dict[int, list[int]] = {row: [] for row in inputs}
    used = {row for row in outputs if row in region}
    for number in program.reachable(outputs):
        op, args, _ = program.rows[number]
        inside = [arg for arg in args if arg in region]
        if number in region or not inside:
            continue
        fixed = sum(program.is_constant(arg) for arg in args)
        sums = op in ("add", "sub", "neg") and fixed + len(inside) == len(args)
        if sums or (op == "mul" and fixed == 1):
            region[number] = inside
        else:
            used.update(inside)
    return region, sorted(used.union(row for row in outputs if row in region))


def product(program: Program, first: Matrix, second: Matrix) -> Matrix:
    """Multiply matrices; the inner dimension is the length of the second."""
    columns = list(zip(*second, strict=True))
    return [
        [program.sum(program.mul(a, b) for a, b in zip(row, column, strict=True)) for column in columns]
        for row in first
    ]


def transpose(matrix: Matrix) -> Matrix:
    """Return the rows as columns."""
    return [list(row) for row in zip(*matrix, strict=True)]


def flat(matrix: Matrix) -> Rows:
    """Return all entries, row by row."""
    return [entry for row in matrix for entry in row]


def _plain(program: Program, outputs: Rows, inputs: Rows) -> Matrix:
    """Compute the Jacobian by forward sweeps, reverse sweeps or elimination, whichever takes the fewest operations."""
    columns = [forward(program, outputs, {i: program.one}, inputs) for i in inputs]
    candidates = [
        [gradient(program, output, inputs) for output in outputs],
        [[column[i] for column in columns] for i in range(len(outputs))],
        elimination(program, outputs, inputs),
    ]
    return _cheapest(program, candidates, outputs)


def _cheapest(program: Program, candidates: Iterable[Matrix], also: Rows) -> Matrix:
    return min(candidates, key=lambda matrix: program.operations(flat(matrix) + also))


def jacobian(program: Program, outputs: Rows, inputs: Rows) -> Matrix:
    """Compute derivatives of the outputs by the inputs, in whichever way takes the fewest operations."""
    candidates = [_plain(program, outputs, inputs)]
    layer = linear_layer(program, outputs, inputs)
    if layer.rows and layer.rows != inputs:
        candidates.append(product(program, _plain(program, outputs, layer.rows), layer.B))
    return _cheapest(program, candidates, outputs)


def pulled_jacobian(program: Program, left: Matrix, outputs: Rows, inputs: Rows) -> Matrix:
    """Compute a constant matrix times the Jacobian of the outputs."""
    layer = linear_layer(program, outputs, inputs)
    A = _plain(program, outputs, layer.rows)
    candidates = [
        product(program, product(program, left, A), layer.B),
        product(program, left, product(program, A, layer.B)),
        _plain(program, flat(product(program, left, [[row] for row in outputs])), inputs),
    ]
    return _cheapest(program, candidates, [])


def hessian(program: Program, output: int, inputs: Rows) -> Matrix:
    """Compute second derivatives of a row: one triangle is computed and serves for both."""
    layer = linear_layer(program, [output], inputs)
    if not layer.rows:
        return [[program.zero] * len(inputs) for _ in inputs]
    gradients = gradient(program, output, layer.rows)
    A = _cheapest(program, _mirrored(_plain(program, gradients, layer.rows)), gradients)
    whole = product(program, transpose(layer.B), product(program, A, layer.B))
    direct = _plain(program, gradient(program, output, inputs), inputs)
    return _cheapest(program, [*_mirrored(whole), *_mirrored(direct)], [])


def _mirrored(matrix: Matrix) -> list[Matrix]:
    """Return a symmetric matrix, from its upper and from its lower triangle."""
    n = range(len(matrix))
    upper = [[matrix[min(i, j)][max(i, j)] for j in n] for i in n]
    return [upper, [[matrix[max(i, j)][min(i, j)] for j in n] for i in n]]
