"""Block lower triangular form: the same solutions as dense factors, and where it is taken."""

import numpy as np
import pytest

import flexel as fx
from flexel.base.arrays import Array
from flexel.engine.solvers import Factorization, Solvable
from flexel.engine.triangular import BlockFactors, BlockForm, ExchangedFactors
from flexel.examples.vehicle import vehicle

SIZES = (3, 1, 4, 7, 1, 5, 9, 10)


def scrambled(seed: int = 1) -> Array:
    """A matrix in block form whose rows and columns were put in random order."""
    rng = np.random.default_rng(seed)
    n, start = sum(SIZES), 0
    A = np.zeros((n, n))
    for size in SIZES:
        end = start + size
        A[start:end, start:end] = rng.standard_normal((size, size))
        A[start:end, :start] = rng.standard_normal((size, start)) * (rng.random((size, start)) < 0.2)
        start = end
    return A[rng.permutation(n)][:, rng.permutation(n)]


def factors(A: Array) -> BlockFactors:
    rows, columns = np.nonzero(A)
    form = BlockForm(rows, columns, A.shape[0])
    stored = np.zeros(form.length)
    stored[form.slots] = A[rows, columns]
    return form.factorize(stored)


def same_solutions(found: Solvable, A: Array) -> None:
    """Both solutions, for one and for several right-hand sides, in either order of storage."""
    b = np.random.default_rng(2).standard_normal((A.shape[0], 3))
    allowed = 1e-14 * np.linalg.cond(A) * np.abs(np.linalg.solve(A, b)).max()
    for rhs in (b, np.asfortranarray(b), b[:, 0], b[:, :0]):
        for transposed, matrix in ((False, A), (True, A.T)):
            x, expected = found.solve(rhs, transposed=transposed), np.linalg.solve(matrix, rhs)
            assert x.shape == expected.shape
            assert np.abs(x - expected).max(initial=0.0) < allowed


def test_the_blocks_are_found_again() -> None:
    A = scrambled()
    form = BlockForm(*np.nonzero(A), A.shape[0])
    assert sorted(np.diff(form.start.astype(int))) == sorted(SIZES)
    ordered = A[form.rows][:, form.columns]
    for a, b in zip(form.start[:-1], form.start[1:], strict=True):
        assert not ordered[int(a) : int(b), int(b) :].any()


@pytest.mark.parametrize("seed", range(5))
def test_solutions_are_those_of_dense_factors(seed: int) -> None:
    A = scrambled(seed)
    same_solutions(factors(A), A)


def test_pivots_are_the_largest_of_their_columns() -> None:
    A = np.array([[1e-17, 1.0], [1.0, 1.0]])
    assert factors(A).solve(np.array([1.0, 2.0])) == pytest.approx([1.0, 1.0], rel=1e-15)


def test_singular_matrices_are_seen() -> None:
    assert not factors(np.array([[1.0, 2.0], [2.0, 4.0]])).regular
    nowhere = BlockForm(np.array([0, 1]), np.array([0, 0]), 2)
    assert not nowhere.regular


def test_rows_are_exchanged() -> None:
    A, k, first = scrambled(), 2, 30
    S = np.random.default_rng(3).standard_normal((k, A.shape[0]))
    B = np.vstack([A[:first], S, A[first:-k]])
    same_solutions(ExchangedFactors(factors(A), S, first), B)


@pytest.mark.parametrize("tyres", ["calspan", "zero slip"])
def test_a_vehicle_is_solved_by_small_blocks(tyres: str) -> None:
    system = vehicle(10.0, tyres=tyres)
    same_factors(system)
    blocks = np.diff(BlockForm(*entries(system), system.structure.nf).start.astype(int))
    assert blocks.max() <= 14  # the loop of a suspension


def entries(system: fx.System) -> tuple[Array, Array]:
    rows, nf = system.roles.position_rows, system.structure.nf
    i, j = np.nonzero(system.evaluation.filled[rows][:, :nf])
    return i, j


def same_factors(system: fx.System) -> None:
    kinematics, state = system.kinematics, system.initial
    c = kinematics.position(0.0, state.q, state.x)
    B = kinematics.velocity_matrix(c)
    assert not isinstance(B, Factorization)
    A = c.J[system.roles.velocity_rows][:, : system.structure.nf]
    b = np.random.default_rng(4).standard_normal((A.shape[0], 2))
    scale = np.abs(np.linalg.inv(A)).max()
    assert np.abs(B.solve(b) - np.linalg.solve(A, b)).max() < 1e-12 * scale
    assert np.abs(B.solve(b, transposed=True) - np.linalg.solve(A.T, b)).max() < 1e-12 * scale
