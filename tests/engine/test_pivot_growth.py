"""Pivots found for another matrix are kept as long as the rounding that they enlarge stays below what is allowed."""

from typing import Any

import numpy as np
import pytest

from flexel.generated._kernels import ffi, lib

SAMPLE = np.array([1.0, 0.5, 0.5, 1.0])  # row by row; its first pivot is in the first row and column


def matrix(noise: float) -> tuple[Any, list[Any]]:
    """A full matrix of two rows with the pivots of the sample, and what it points to."""
    A = ffi.gc(ffi.new("flexel_matrix *"), lib.flexel_matrix_clear)
    places = [np.array(indices, dtype=np.int32) for indices in ([0, 0, 1, 1], [0, 1, 0, 1], [0, 1, 2, 3])]
    kept: list[Any] = [ffi.from_buffer("int[]", indices) for indices in places]
    A.n, A.nentries, A.noise = 2, 4, noise
    A.rows, A.columns, A.source = kept
    lib.flexel_matrix_prepare(A, 1, ffi.from_buffer("double[]", SAMPLE), SAMPLE.size)
    return A, kept


@pytest.mark.parametrize(
    ("pivot", "noise", "anew"),
    [(2e-4, 1e-6, False), (2e-4, 1e-13, True), (2e-4, 0.0, True), (5e-5, 1e-6, True), (2e-3, 0.0, False)],
)
def test_pivots_are_sought_anew_where_they_enlarge_rounding_too_much(
    pivot: float, noise: float, anew: bool
) -> None:
    A, _kept = matrix(noise)
    before = A.orders
    values = np.array([pivot, 1.0, 1.0, 1.0])
    assert lib.flexel_matrix_factor(A, ffi.from_buffer("double[]", values)) == 0
    assert (A.orders > before) == anew
    b, x, work = np.array([1.0, 2.0]), np.zeros(2), np.zeros(2)
    lib.flexel_matrix_solve(A, 1, *(ffi.from_buffer("double[]", array) for array in (b, x, work)))
    exact, eps = np.array([1.0, 1.0 - 2 * pivot]) / (1 - pivot), float(np.finfo(float).eps)
    assert x == pytest.approx(exact, abs=10 * eps if anew else 10 * eps / pivot)
