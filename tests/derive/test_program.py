"""Straight-line programs: what is lowered is what SymPy means, and every way to differentiate gives the same."""

import math
import random
from collections.abc import Callable
from fractions import Fraction

import pytest
import sympy as sp

from flexel.derive.program.differentiate import elimination, forward, gradient
from flexel.derive.program.layers import hessian, jacobian, linear_layer, pulled_jacobian
from flexel.derive.program.lower import LoweringError, ProgramLowering
from flexel.derive.program.narrowest import narrowest
from flexel.derive.program.straight_line import Program

X = sp.symbols("x0:4", real=True)
P = sp.symbols("p0:2", real=True)
POINT = dict(zip(X + P, (0.7, -0.4, 1.3, 0.9, 0.6, 1.7), strict=True))

FUNCTIONS: dict[str, Callable[..., float]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "neg": lambda a: -a,
    "mul": lambda a, b: a * b,
    "inv": lambda a: 1 / a,
    "abs": abs,
    "min": min,
    "max": max,
    "lt": lambda a, b: a < b,
    "le": lambda a, b: a <= b,
    "eq": lambda a, b: a == b,
    "not": lambda a: not a,
    "and": lambda a, b: a and b,
    "or": lambda a, b: a or b,
    "select": lambda c, a, b: a if c else b,
    "pow": pow,
}


def evaluate(program: Program, outputs: list[int], values: dict[str, float]) -> list[float]:
    """Evaluate rows of a program, in plain floating-point numbers."""
    result: dict[int, float] = {}
    for number in program.reachable(outputs):
        op, args, value = program.rows[number]
        if isinstance(value, Fraction):
            result[number] = float(value)
        elif isinstance(value, str):
            result[number] = values[value]
        else:
            function = FUNCTIONS.get(op) or getattr(math, op)
            result[number] = function(*(result[arg] for arg in args))
    return [result[number] for number in outputs]


def lowered(*exprs: sp.Expr) -> tuple[Program, list[int], list[int]]:
    """Program, rows of the variables X, rows of the expressions; P are parameters."""
    program = Program()
    x = [program.input(s.name) for s in X]
    p = [program.input(s.name, parameter=True) for s in P]
    lowering = ProgramLowering(program, dict(zip(X + P, x + p, strict=True)))
    return program, x, [lowering.lower(expr) for expr in exprs]


def at_point(expr: sp.Expr) -> float:
    """Value of an expression at the point of comparison."""
    return float(expr.subs(POINT))


def values(program: Program, rows: list[int]) -> list[float]:
    """Values of rows at the same point."""
    return evaluate(program, rows, {s.name: value for s, value in POINT.items()})


def random_expr(seed: int) -> sp.Expr:
    """A random expression that is smooth and defined at the point."""
    rng = random.Random(seed)

    def build(depth: int) -> sp.Expr:
        if depth == 0:
            return rng.choice([*X, *P, sp.Rational(rng.randint(-5, 5) or 2, rng.randint(1, 7))])
        a, b = build(depth - 1), build(depth - 1)
        chosen: Callable[[], sp.Expr] = rng.choice(
            [
                lambda: a + b,
                lambda: a - 2 * b,
                lambda: a * b,
                lambda: a / (1 + b**2),
                lambda: sp.sqrt(1 + a**2) * b,
                lambda: sp.sin(a) + sp.cos(b),
                lambda: sp.atan2(a, 2 + b**2),
                lambda: sp.exp(-(a**2)) * b,
                lambda: sp.tanh(a) - sp.atan(b),
                lambda: (1 + a**2) ** sp.Rational(-3, 2),
                lambda: sp.Max(a, b + sp.Rational(1, 97)),
                lambda: sp.Piecewise((a**2, a < sp.Rational(1, 89)), (b**3, True)),
                lambda: sp.Abs(a + sp.Rational(1, 83)),
                lambda: (2 + a**2) ** sp.Rational(7, 5),
            ]
        )
        return chosen()

    return build(3)


@pytest.mark.parametrize("seed", range(40))
def test_a_program_has_the_value_of_its_expression(seed: int) -> None:
    expr = random_expr(seed)
    program, _, rows = lowered(expr)
    assert values(program, rows) == pytest.approx([at_point(expr)], rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("seed", range(40))
def test_forward_reverse_and_elimination_agree_with_sympy(seed: int) -> None:
    expr = random_expr(seed)
    program, x, rows = lowered(expr)
    expected = [at_point(sp.diff(expr, s)) for s in X]
    ahead = [forward(program, rows, {i: program.one})[0] for i in x]
    for ways in (ahead, gradient(program, rows[0], x), elimination(program, rows, x)[0]):
        assert values(program, ways) == pytest.approx(expected, rel=1e-10, abs=1e-10)


@pytest.mark.parametrize("seed", range(10))
def test_second_derivatives_agree_with_sympy(seed: int) -> None:
    expr = random_expr(seed) * random_expr(seed + 100)
    program, x, rows = lowered(expr)
    matrix = hessian(program, rows[0], x)
    assert all(matrix[i][j] == matrix[j][i] for i in range(4) for j in range(4))
    for i, a in enumerate(X):
        slope = sp.diff(expr, a)
        expected = [at_point(sp.diff(slope, b)) for b in X[i:]]
        assert values(program, matrix[i][i:]) == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_a_jacobian_goes_through_the_linear_layer() -> None:
    """Four coordinates that enter by two combinations are differentiated by these two."""
    u, w = P[0] * X[0] - X[1], X[2] / P[1] + X[3]
    exprs = [sp.sqrt(u**2 + w**2), sp.sin(u) * w]
    program, x, rows = lowered(*exprs)
    assert len(linear_layer(program, rows, x).rows) == 2
    left = [[program.one, program.const(2)], [program.zero, program.one]]
    pulled = pulled_jacobian(program, left, rows, x)
    for matrix, functions in (
        (jacobian(program, rows, x), exprs),
        (pulled, [exprs[0] + 2 * exprs[1], exprs[1]]),
    ):
        for row, function in zip(matrix, functions, strict=True):
            expected = [at_point(sp.diff(function, s)) for s in X]
            assert values(program, row) == pytest.approx(expected, rel=1e-12)


def test_the_narrowest_place_is_the_one_nearest_to_the_targets() -> None:
    arguments: dict[int, list[int]] = {0: [], 1: [], 2: [0, 1], 3: [2], 4: [3], 5: [3]}
    assert narrowest(arguments, [0, 1], [4, 5]) == [3]
    assert narrowest(arguments, [0, 1], [4, 1]) == [1, 4]


def test_equal_rows_are_one_row() -> None:
    program, _, rows = lowered(X[0] * X[1] + sp.sin(X[2]), sp.sin(X[2]) + X[1] * X[0])
    assert rows[0] == rows[1]


def test_small_identities_leave_no_operations() -> None:
    program = Program()
    x, y = program.input("x"), program.input("y")
    zero, one = program.zero, program.one
    assert program.add(x, zero) == program.mul(x, one) == program.neg(program.neg(x)) == x
    assert program.mul(x, zero) == program.sub(x, x) == program.add(x, program.neg(x)) == zero
    assert program.add(x, program.neg(y)) == program.sub(x, y)
    assert program.sub(y, x) == program.neg(program.sub(x, y))
    assert program.add(x, x) == program.mul(program.const(2), x)
    assert program.mul(x, program.inv(x)) == one
    assert program.scale(Fraction(1, 3), program.scale(Fraction(3), x)) == x


def test_constants_stay_exact() -> None:
    program, _, rows = lowered(
        sp.Rational(1, 420) * X[0] * 13 - X[0] * sp.Rational(13, 420) + sp.Rational(1, 3)
    )
    assert program.constant(rows[0]) == Fraction(1, 3)


def test_zero_seeds_vanish() -> None:
    program, x, rows = lowered(X[0] * sp.sin(X[1]))
    assert forward(program, rows, {x[2]: program.one}) == [program.zero]
    assert gradient(program, rows[0], [x[3]]) == [program.zero]


def test_pruning_keeps_what_the_outputs_need() -> None:
    program, _, rows = lowered(X[0] + X[1], sp.exp(X[2]) * X[3])
    assert program.operations(rows[:1]) == 1
    assert program.operations(rows[1:]) == 2
    order = program.in_order(rows)
    assert all(order.index(arg) < order.index(row) for row in order for arg in program.rows[row].args)


def test_long_sums_need_no_recursion() -> None:
    program = Program()
    total = x = program.input("x")
    for _ in range(20000):
        total = program.call("sin", total)
    assert forward(program, [total], {x: program.one}) != [program.zero]
    assert gradient(program, total, [x]) != [program.zero]


def test_what_cannot_be_compiled_is_named() -> None:
    with pytest.raises(LoweringError, match="gamma"):
        lowered(sp.gamma(X[0]))
    with pytest.raises(LoweringError, match="symbol 'z'"):
        lowered(sp.Symbol("z"))
    with pytest.raises(LoweringError, match="True"):
        lowered(sp.Piecewise((X[0], X[0] > 0)))
