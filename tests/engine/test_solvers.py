"""Factorizations by pattern: every kind gives the same solution, and each pattern gets the kind that suits it."""

import numpy as np
import pytest

from flexel.base.arrays import Array, Index
from flexel.engine.solvers import Pattern


def chain(elements: int, hubs: int = 0, seed: int = 1) -> tuple[Index, Index, int]:
    """Entries of a chain of 12 x 12 elements in blocks of 6, unknowns in random order, with hubs that touch all."""
    size = 6 * (elements + 1) + hubs
    order = np.random.default_rng(seed).permutation(size)
    rows, columns = [], []
    for i in range(elements):
        own = order[np.concatenate([6 * i + np.arange(12), size - hubs + np.arange(hubs)])]
        rows.append(np.repeat(own, own.size))
        columns.append(np.tile(own, own.size))
    return np.concatenate(rows), np.concatenate(columns), size


def dense(rows: Index, columns: Index, entries: Array, size: int) -> Array:
    A = np.zeros((size, size))
    np.add.at(A, (rows, columns), entries)
    return A


@pytest.mark.parametrize("hubs", [0, 3])
@pytest.mark.parametrize("kind", ["dense", "banded", "sparse"])
def test_every_kind_of_storage_gives_the_same_solution(kind: str, hubs: int) -> None:
    rows, columns, size = chain(30, hubs)
    rng = np.random.default_rng(2)
    entries, b = rng.standard_normal(rows.size), rng.standard_normal((size, 2))
    entries[rows == columns] += 30.0
    pattern = Pattern(rows, columns, size, kind)
    stored = pattern.assemble(entries)
    A = dense(rows, columns, entries, size)
    np.testing.assert_allclose(pattern.matrix(stored).toarray(), A, atol=1e-13)
    factors = pattern.factorize(stored)
    np.testing.assert_allclose(factors.solve(b), np.linalg.solve(A, b), rtol=0, atol=1e-12)
    np.testing.assert_allclose(factors.solve(b[:, 0]), np.linalg.solve(A, b[:, 0]), rtol=0, atol=1e-12)


def test_entries_outside_the_matrix_are_dropped() -> None:
    pattern = Pattern(np.array([0, 1, 7]), np.array([0, 1, 0]), 2)
    np.testing.assert_array_equal(
        pattern.matrix(pattern.assemble(np.array([2.0, 3.0, 9.0]))).toarray(), np.diag([2, 3])
    )


@pytest.mark.parametrize(
    ("elements", "hubs", "described"),
    [(8, 0, "dense"), (60, 0, "banded, half width 11"), (60, 7, "banded, half width 11, border 7")],
)
def test_the_kind_follows_from_the_pattern(elements: int, hubs: int, described: str) -> None:
    assert Pattern(*chain(elements, hubs)).description == described


def test_a_pattern_without_a_narrow_band_is_factorized_sparse() -> None:
    rng = np.random.default_rng(3)
    i, j = rng.integers(0, 3000, (2, 6000))
    diagonal = np.arange(3000)
    assert Pattern(np.concatenate([i, diagonal]), np.concatenate([j, diagonal]), 3000).description == "sparse"


@pytest.mark.parametrize("kind", ["dense", "banded", "sparse"])
def test_a_singular_matrix_is_recognized(kind: str) -> None:
    pattern = Pattern(np.array([0, 0, 1]), np.array([0, 1, 1]), 2, kind)
    assert not pattern.factorize(pattern.assemble(np.array([1.0, 1.0, 0.0]))).regular


def test_a_border_whose_band_alone_is_singular_is_still_solved() -> None:
    rows, columns, size = chain(20, 1)
    hub = np.bincount(rows).argmax()
    entries = np.where((rows == hub) | (columns == hub), 1.0, 0.0)
    entries[rows == columns] += 5.0
    lonely = rows[rows != hub][0]  # no diagonal entry: regular only through the border
    entries[(rows == lonely) & (columns == lonely)] = 0.0
    A = dense(rows, columns, entries, size)
    assert np.linalg.matrix_rank(A) == size
    pattern = Pattern(rows, columns, size, "banded")
    b = np.arange(size, dtype=float)
    solved = pattern.factorize(pattern.assemble(entries)).solve(b)
    np.testing.assert_allclose(solved, np.linalg.solve(A, b), rtol=1e-9, atol=1e-9)
