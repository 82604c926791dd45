"""Eigenvalues of linearizations are right to the last digits where stiffnesses differ by many orders."""

import mpmath
import numpy as np
import pytest

import flexel as fx
from flexel.mechanics.soft import corrected


def leaf(n: int, mass: float, damping: float = 0.0) -> fx.System:
    """A planar cantilever, drawn oblique, with a mass at its tip; EA l²/EI is 1e7."""
    m = fx.Model(gravity=(0, 0))
    way = np.array([0.6, 0.8])
    points = [m.point(f"P{i}", way * i / n, fixed=i == 0) for i in range(n + 1)]
    angles = [m.angle(f"R{i}", fixed=i == 0) for i in range(n + 1)]
    for i in range(n):
        ends = points[i], angles[i], points[i + 1], angles[i + 1]
        m.beam(f"b{i}", *ends, EA=3e7, EIz=3.0, mass_per_length=mass, damping=damping)
    m.point_mass("tip", f"P{n}", 2.0)
    return m.build()


def exact(lin: fx.Linearization) -> list[complex]:
    """Eigenvalues of the reduced matrices in 40 digits, those with positive imaginary parts (own, other arithmetic)."""
    with mpmath.workdps(40):
        M, C, K = (mpmath.matrix(part) for part in (lin.M, lin.C, lin.K))
        n, A = M.rows, mpmath.zeros(2 * M.rows)
        A[:n, :n], A[:n, n:], A[n:, :n] = -(M**-1) * C, -(M**-1) * K, mpmath.eye(n)
        found = mpmath.eig(A, left=False, right=False)
        return sorted((complex(w) for w in found if mpmath.im(w) > 0), key=abs)


@pytest.mark.parametrize(("n", "mass"), [(3, 1e-3), (8, 1e-3), (8, 1.0)])
def test_the_lowest_frequency_of_a_stiff_leaf_spring_is_that_of_its_redundant_equations(
    n: int, mass: float
) -> None:
    """`vibrations` iterates with stresses and multipliers as unknowns (own, independent of reduced matrices)."""
    system = leaf(n, mass)
    w = system.linearize().eigenvalues()
    assert w.imag[w.imag > 0].min() == pytest.approx(system.vibrations(count=1)[0].omega, rel=1e-13)


def test_damped_modes_of_a_stiff_leaf_spring_have_fourteen_digits() -> None:
    lin = leaf(3, 1e-2, damping=0.3).linearize()
    reference = exact(lin)
    found = sorted((mode.eigenvalue for mode in lin.modes() if mode.eigenvalue.imag > 0), key=abs)
    assert reference[0].real < -0.1 * abs(reference[0])
    assert abs(found[0] / reference[0] - 1) < 1e-13


def test_equal_frequencies_are_corrected_together() -> None:
    """A round rod bends alike in all directions."""
    m = fx.Model(gravity=(0, 0, 0))
    m.point("P0", (0, 0, 0), fixed=True)
    m.frame("R0", fixed=True)
    for i in range(2):
        m.point(f"P{i + 1}", (0.3 * (i + 1), 0.4 * (i + 1), 0))
        m.frame(f"R{i + 1}")
        ends = f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"
        options = {"mass_per_length": 0.02, "inertia_per_length": (2e-6, 1e-6, 1e-6), "direction": (0, 0, 1)}
        m.beam(f"b{i}", *ends, EA=3e7, GJ=2.0, EIy=3.0, EIz=3.0, **options)
    m.point_mass("tip", "P2", 2.0)
    lin = m.build().linearize()
    w = lin.eigenvalues()
    lowest = np.sort(w.imag[w.imag > 0])[:4]
    np.testing.assert_allclose(lowest, [value.imag for value in exact(lin)[:4]], rtol=1e-13)
    # coordinates are rounded, which strains the rod: it is not quite alike in all directions
    np.testing.assert_allclose(lowest[::2], lowest[1::2], rtol=1e-11)


def test_vectors_of_corrected_eigenvalues_belong_together() -> None:
    lin = leaf(8, 1e-3, damping=1e-4).linearize()
    n = len(lin.dynamic)
    values, left, right = lin._spectrum()
    small = np.flatnonzero(np.abs(values) < 1e-3 * np.abs(values).max())
    assert small.size > 4
    for place in small:
        x = right[:, place]
        assert np.allclose(x[:n], values[place] * x[n:], rtol=1e-9, atol=1e-13)
        others = np.abs(left[:, place].conj() @ np.delete(right, place, axis=1))
        assert (
            abs(left[:, place].conj() @ x) > 1e4 * others.max()
        )  # left and right vectors of others are orthogonal


def test_eigenvalues_that_nearly_meet_on_the_real_axis_stay_a_pair() -> None:
    """Two poles at -1 ± 1e-7 i beside one at -1e5: x'' + 2 x' + (1 + 1e-14) x = 0 (closed form)."""
    M, C, K = np.eye(2), np.diag([2.0, 1e5]), np.diag([1 + 1e-14, 1.0])
    A = np.block([[-C, -K], [np.eye(2), np.zeros((2, 2))]])
    values, left = np.linalg.eig(A.T)
    right = np.linalg.inv(left).T
    values = values.astype(complex)
    found, _, _ = corrected((values, left.astype(complex), right.astype(complex)), M, np.hstack([C, K]), A)
    near = found[np.abs(found + 1) < 1e-3]
    assert near.size == 2 and near.sum() == pytest.approx(-2.0, abs=1e-12)
    assert near.prod() == pytest.approx(1.0, abs=1e-12)


def test_a_zero_that_rounding_has_split_needs_no_correction() -> None:
    """Two bodies that may spin about the vertical together: shifted by such a zero, the equations are singular."""
    m = fx.Model(gravity=(0.0, 0.0, -9.81))
    m.point("O", (0.0, 0.0, 0.0), fixed=True)
    m.point("P0", (0.196, -0.04, 0.0))
    m.frame("R0")
    m.body_point("l0", "O", "R0", "P0")
    inertia = (0.02, 0.02, 0.004, 0.0, 0.0, 0.0)
    m.body("b0", "P0", "R0", mass=0.5, inertia=inertia, offset=(0.0, 0.01, 0.0))
    m.point("P1", (1.019, -0.207, 0.0))
    m.frame("R1")
    m.hinge("h1", "R0", "R1", axis=(0.0, 0.0, 1.0))
    m.body_point("l1", "P0", "R1", "P1")
    m.body("b1", "P1", "R1", mass=4.0, inertia=inertia, offset=(0.01, 0.01, -0.16))
    s = m.build()
    found = s.linearize(s.equilibrium(stable=True)).eigenvalues()
    assert np.sum(np.abs(found) < 1e-4) == 2
    assert np.abs(found[np.abs(found) > 1e-4].real).max() < 1e-12  # nothing is damped
