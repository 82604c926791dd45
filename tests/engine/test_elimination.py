"""Sparse elimination with an order of pivots that is found once: solutions, signs, and when the order is replaced."""

import pickle
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from flexel.base.arrays import Array
from flexel.engine import elimination
from flexel.engine.elimination import Elimination


def scattered(n: int, density: float, seed: int) -> Array:
    """A random matrix, regular, with zeros on most of the diagonal."""
    rng = np.random.default_rng(seed)
    A = rng.standard_normal((n, n)) * (rng.random((n, n)) < density)
    A[np.diag_indices(n)] = 0.0
    A[rng.permutation(n), rng.permutation(n)] += 1.0 + rng.random(n)
    return A


def saddle(n: int, seed: int) -> Array:
    """[K C'; C 0] of a chain, K singular without the conditions."""
    rng = np.random.default_rng(seed)
    d = np.diff(np.eye(n), axis=0)
    K = d.T @ np.diag(10 ** rng.uniform(-2, 4, n - 1)) @ d
    C = np.zeros((3, n))
    C[[0, 1, 1, 2, 2], [0, n // 3, n // 3 + 1, n - 2, n - 1]] = 1.0
    return np.block([[K, C.T], [C, np.zeros((3, 3))]])


def badly_scaled(n: int, seed: int) -> Array:
    rng = np.random.default_rng(seed)
    return (
        2.0 ** rng.integers(-40, 40, n)[:, None] * scattered(n, 0.1, seed) * 2.0 ** rng.integers(-30, 30, n)
    )


KINDS: dict[str, Callable[[int], Array]] = {
    "scattered": lambda seed: scattered(60, 0.05, seed),
    "dense": lambda seed: np.random.default_rng(seed).standard_normal((25, 25)),
    "saddle": lambda seed: saddle(40, seed),
    "badly scaled": lambda seed: badly_scaled(50, seed),
    "triangular": lambda seed: np.tril(scattered(30, 0.2, seed), -1) + np.eye(30)[::-1][::-1],
    "one unknown": lambda seed: np.full((1, 1), seed - 2.5),
}


def of(*matrices: Array) -> tuple[Elimination, list[Array]]:
    """The common pattern of matrices, and the matrices as it stores them."""
    rows, columns = np.nonzero(sum(np.abs(matrix) for matrix in matrices))
    pattern = Elimination(rows, columns, matrices[0].shape[0])
    return pattern, [matrix[pattern.rows, pattern.columns] for matrix in matrices]


def error(A: Array, x: Array, b: Array) -> float:
    """Backward error, rows and columns free of scale."""
    return float(np.max(np.abs(A @ x - b) / (np.abs(A) @ np.abs(x) + np.abs(b) + 1e-300), initial=0.0))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("kind", KINDS)
def test_solutions_and_signs_are_those_of_numpy(kind: str, seed: int) -> None:
    A = KINDS[kind](seed)
    pattern, (stored,) = of(A)
    np.testing.assert_array_equal(pattern.matrix(stored).toarray(), A)
    factors = pattern.factorize(stored)
    assert factors.regular
    assert factors.sign == np.linalg.slogdet(A)[0]
    b = np.random.default_rng(seed).standard_normal((A.shape[0], 13))
    b[: A.shape[0] // 2, 5] = 0.0
    for rhs in (b, np.asfortranarray(b), b[:, :4], b[:, 5], b[:, :0], np.zeros_like(b[:, 0])):
        for transposed, matrix in ((False, A), (True, A.T)):
            given = rhs.copy()
            x = factors.solve(rhs, transposed=transposed)
            assert x.shape == rhs.shape
            np.testing.assert_array_equal(rhs, given)
            assert error(matrix, x, rhs) < 1e-10


def test_entries_of_one_place_are_stored_once_and_others_are_dropped() -> None:
    pattern = Elimination(np.array([0, 1, 7, 0]), np.array([0, 1, 0, 0]), 2)
    np.testing.assert_array_equal(pattern.matrix(np.array([2.5, 3.0])).toarray(), np.diag([2.5, 3.0]))


def test_a_matrix_without_unknowns_is_regular() -> None:
    nothing = np.zeros(0, dtype=int)
    pattern = Elimination(nothing, nothing, 0)
    factors = pattern.factorize(np.zeros(0))
    assert factors.regular
    assert factors.sign == 1
    assert factors.solve(np.zeros((0, 3))).shape == (0, 3)


def rank_short(n: int, seed: int) -> Array:
    """Singular by one, without structure."""
    A = np.random.default_rng(seed).standard_normal((n, n))
    A[-1] = A[0] + A[1]
    return A


SINGULAR = {
    "empty row": np.diag([1.0, 0.0, 2.0]),
    "two columns for three rows": np.array([[1.0, 2.0, 0.0], [3.0, 4.0, 0.0], [5.0, 6.0, 0.0]]),
    "proportional rows": np.array([[1.0, 2.0], [2.0, 4.0]]),
    "to rounding": rank_short(20, 1),
    "to rounding, scaled": 2.0 ** np.arange(-40, 40, 4)[:, None] * rank_short(20, 2),
    "a free chain": np.diff(np.eye(30), axis=0).T @ np.diff(np.eye(30), axis=0),
    "not a number": np.array([[np.nan, 1.0], [1.0, 1.0]]),
    "infinite": np.array([[np.inf, 1.0], [1.0, 1.0]]),
}


@pytest.mark.parametrize("name", SINGULAR)
def test_singular_matrices_are_refused(name: str) -> None:
    pattern, (stored,) = of(SINGULAR[name])
    factors = pattern.factorize(stored)
    assert not factors.regular
    assert factors.sign == 0


@pytest.mark.parametrize("kind", ["scattered", "saddle", "badly scaled"])
def test_one_order_serves_many_matrices(kind: str) -> None:
    A = KINDS[kind](1)
    rng = np.random.default_rng(2)
    others = [A * rng.uniform(0.8, 1.25, A.shape) for _ in range(10)]
    pattern, stored = of(A, *others)
    orders = {id(pattern.factorize(values).order) for values in stored}
    assert len(orders) == 1
    b = rng.standard_normal(A.shape[0])
    for B, values in zip((A, *others), stored, strict=True):
        assert error(B, pattern.factorize(values).solve(b), b) < 1e-12


def test_an_order_that_is_unsound_for_a_matrix_is_replaced() -> None:
    """Pivots of the first matrix vanish one after another: the solutions stay accurate."""
    n = 30
    first, second = np.eye(n) + 0.01, np.eye(n)[::-1] + 0.01
    path = [(1 - share) * first + share * second for share in np.linspace(0.0, 1.0, 41)]
    pattern, stored = of(*path)
    b, orders = np.arange(1.0, n + 1), set()
    for A, values in zip(path, stored, strict=True):
        factors = pattern.factorize(values)
        if not factors.regular:
            assert np.linalg.cond(A) > 1e13
            continue
        orders.add(factors.order)
        assert factors.sign == np.linalg.slogdet(A)[0]
        assert error(A, factors.solve(b), b) < 1e-11
    assert 1 < len(orders) < 10


@pytest.mark.parametrize("pivot", [1e-3, 1e-6, 1e-10, 1e-16, 0.0, -1e-16])
def test_a_pivot_that_becomes_small_costs_no_accuracy(pivot: float) -> None:
    A, B = np.array([[4.0, 1.0], [1.0, 1.0]]), np.array([[pivot, 1.0], [1.0, 1.0]])
    pattern, (first, second) = of(A, B)
    assert pattern.factorize(first).regular
    factors = pattern.factorize(second)
    assert error(B, factors.solve(np.array([1.0, 2.0])), np.array([1.0, 2.0])) < 1e-12


def test_near_a_singular_matrix_factors_are_accurate_or_refused() -> None:
    rng = np.random.default_rng(4)
    A, n = rng.standard_normal((30, 30)), 30
    U, s, V = np.linalg.svd(A)
    path = [(U * np.append(s[:-1], value)) @ V for value in (1.0, 1e-4, 1e-8, 1e-11, 1e-18, -1e-11, -1.0)]
    pattern, stored = of(*path)
    found = [pattern.factorize(values) for values in stored]
    assert [factors.regular for factors in found] == [True, True, True, True, False, True, True]
    for B, factors in zip(path, found, strict=True):
        if factors.regular:
            assert factors.sign == np.linalg.slogdet(B)[0]
            assert error(B, factors.solve(np.ones(n)), np.ones(n)) < 1e-10


def test_rows_and_columns_times_powers_of_two_change_nothing() -> None:
    A = scattered(50, 0.1, 5)
    rng = np.random.default_rng(6)
    rows, columns = (2.0 ** rng.integers(-60, 60, 50) for _ in range(2))
    pattern, (plain, scaled) = of(A, rows[:, None] * A)
    b = rng.standard_normal(50)
    first, second = pattern.factorize(plain), pattern.factorize(scaled)
    assert second.order is first.order
    np.testing.assert_array_equal(second.solve(rows * b), first.solve(b))
    both = rows[:, None] * A * columns
    pattern, (stored,) = of(both)
    assert error(both, pattern.factorize(stored).solve(rows * b), rows * b) < 1e-12


def test_a_pattern_can_be_pickled() -> None:
    A = saddle(20, 3)
    pattern, (stored,) = of(A)
    x = pattern.factorize(stored).solve(np.ones(23))
    copy = pickle.loads(pickle.dumps(pattern))
    np.testing.assert_array_equal(copy.factorize(stored).solve(np.ones(23)), x)


def test_threads_share_an_order_and_may_replace_it() -> None:
    path = [
        np.eye(40) * (1 - share) + np.eye(40)[::-1] * share + 0.01 for share in np.linspace(0.0, 0.45, 50)
    ]
    pattern, stored = of(*path)
    b = np.arange(40.0)

    def worst(part: int) -> float:
        rounds = [(path[i], stored[i]) for i in range(part, 50, 2)] * 10
        return max(error(A, pattern.factorize(values).solve(b), b) for A, values in rounds)

    with ThreadPoolExecutor(4) as pool:
        assert max(pool.map(worst, [0, 1, 0, 1])) < 1e-11


def test_large_matrices_without_much_fill_are_left_to_superlu_only_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(elimination, "BORDER", 10)
    pattern, (stored,) = of(saddle(40, 7))
    found = [pattern.factorize(stored) for _ in range(2)]
    assert [isinstance(factors, elimination.LargeFactors) for factors in found] == [True, False]
    assert found[0].sign == found[1].sign


def test_large_matrices_are_factorized_by_superlu(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(elimination, "BORDER", 10)
    monkeypatch.setattr(elimination, "MUCH", 0)
    A = saddle(40, 7)
    pattern, (stored,) = of(A)
    pattern.factorize(stored)
    factors = pattern.factorize(stored)
    assert pattern.order is None
    assert factors.sign == np.linalg.slogdet(A)[0]
    for transposed, matrix in ((False, A), (True, A.T)):
        b = np.ones(43)
        assert error(matrix, factors.solve(b, transposed=transposed), b) < 1e-10
    pattern, (stored,) = of(np.diag(np.append(np.arange(1.0, 20.0), 0.0)) + 0.0)
    assert pattern.factorize(stored).sign == 0
