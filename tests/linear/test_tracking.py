"""Branches of eigenvalues are followed by the shapes of their modes, and their stability boundaries are refined."""

import numpy as np
import pytest

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import bicycle_data as data
from flexel.linear.mode_tracking import among_lowest, ranks
from flexel.linear.tracking import Branches

SPEEDS = np.linspace(0, 10, 41)


def pair(k1: float, k2: float, coupling: float = 0.0) -> Array:
    """Two oscillators of unit mass, "a" and "b", joined by a spring."""
    K = np.array([[k1 + coupling, -coupling], [-coupling, k2 + coupling]])
    return np.block([[np.diag([-0.02, -0.04]), -K], [np.eye(2), np.zeros((2, 2))]])


def crossing(p: Array, coupling: float = 0.0) -> Branches:
    """Natural frequencies 1 + p and 3 - p, which cross at p = 1."""
    return Branches.of(
        p, [pair((1 + value) ** 2, (3 - value) ** 2, coupling) for value in p], ("a", "b", "a", "b")
    )


def bicycle(v: float) -> Array:
    """State matrix of lean and steer of the published benchmark."""
    M, C1, K0, K2 = (np.array(matrix) for matrix in (data.M, data.C1, data.K0, data.K2))
    lower = np.linalg.solve(M, np.hstack([v * C1, data.BENCHMARK["g"] * K0 + v**2 * K2]))
    return np.vstack([-lower, np.eye(2, 4)])


@pytest.mark.parametrize("count", [40, 41, 6])  # between the points, at one of them, coarse
def test_modes_whose_frequencies_cross_keep_their_names(count: int) -> None:
    p = np.linspace(0, 2, count)
    found = crossing(p)
    assert found.names == ["a", "b"] or found.names == ["b", "a"]
    exact = {"a": (1 + p, 0.01), "b": (3 - p, 0.02)}
    for name, family in zip(found.names, found.families, strict=True):
        omega, decay = exact[name]
        assert len(family) == 2
        for j in family:
            assert np.abs(found.eigenvalues[:, j].imag) == pytest.approx(
                np.sqrt(omega**2 - decay**2), rel=1e-9
            )
            assert found.eigenvalues[:, j].real == pytest.approx(np.full(count, -decay), abs=1e-9)


def test_order_alone_would_swap_them() -> None:
    """The lower frequency belongs to "a" at the start and to "b" at the end."""
    found = crossing(np.linspace(0, 2, 40))
    a = found.families[found.names.index("a")][0]
    lower = np.abs(found.eigenvalues.imag).min(axis=1)
    assert abs(found.eigenvalues[0, a].imag) == pytest.approx(lower[0])
    assert abs(found.eigenvalues[-1, a].imag) > 1.5 * lower[-1]


def test_a_veering_pair_is_followed_along_its_continuous_shapes() -> None:
    """Coupled, frequencies avoid each other: finely sampled, the lower branch stays the lower one, and "a" becomes
    "b" in it; in steps that leap over the veering, the shape goes on.
    """
    fine = crossing(np.linspace(0, 2, 401), 0.08)
    first = [np.abs(fine.eigenvalues[0, j].imag) for j in range(4)]
    low = int(np.argmin(first))
    assert np.abs(fine.eigenvalues[:, low].imag) == pytest.approx(np.abs(fine.eigenvalues.imag).min(axis=1))
    assert fine.shares is not None
    of_a = fine.shares[:, low, 0] + fine.shares[:, low, 2]
    assert of_a[0] > 0.99 and of_a[-1] < 0.01 and np.abs(np.diff(of_a)).max() < 0.2
    leaping = crossing(np.linspace(0, 2, 7), 0.08)
    low = int(np.argmin(np.abs(leaping.eigenvalues[0].imag)))
    assert np.abs(leaping.eigenvalues[-1, low].imag) == pytest.approx(
        np.abs(leaping.eigenvalues[-1].imag).max()
    )


def test_boundaries_of_the_bicycle_are_the_published_ones_to_the_last_digits() -> None:
    """From a coarse grid: the equations are polynomials of the speed, which the interpolation reproduces."""
    found = Branches.of(SPEEDS, [bicycle(v) for v in SPEEDS], ("lean", "steer") * 2)
    weave, capsize = found.boundaries()
    assert (weave.value, capsize.value) == pytest.approx((data.WEAVE_SPEED, data.CAPSIZE_SPEED), rel=1e-12)
    assert capsize.frequency == 0 and weave.frequency == pytest.approx(3.43503384866144, rel=1e-10)
    assert sorted(len(family) for family in found.families) == [1, 1, 2]
    assert len(set(found.names)) == 3


@pytest.mark.parametrize(
    ("damping", "load", "frequency"), [(0.0, 3.5 - np.sqrt(2), 2**-0.25), (0.01, 41 / 28, None)]
)
def test_the_boundary_of_a_column_with_a_follower_load(
    damping: float, load: float, frequency: float | None
) -> None:
    """Ziegler 1952: masses 2 m and m, P l/k = 7/2 - √2 without damping, where two vibrations meet; 41/28 with some."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    for name in "ab":
        m.angle(name)
    for x, name in enumerate("AB", 1):
        m.point(name, (x, 0))
        m.point_mass(f"mass {name}", name, 3.0 - x)
    m.hinge("h1", "ground", "a", stiffness=1.0, damping=damping)
    m.hinge("h2", "a", "b", stiffness=1.0, damping=damping)
    m.beam("r1", "O", "a", "A", rigid=True)
    m.beam("r2", "A", "b", "B", rigid=True)
    m.load("B", (-1.0, 0.0), follower="b")
    loads = -np.linspace(0.5, 3.0, 26)
    (only,) = m.build().root_loci(parameters={"load B.value[0]": loads}).branches().boundaries()
    assert only.value == pytest.approx(-load, rel=1e-9 if not damping else 2e-4)
    if frequency is not None:
        assert only.frequency == pytest.approx(frequency, rel=1e-3)


def test_eigenvalues_alone_continue_smoothly_with_interpolated_boundaries() -> None:
    """Shuffled eigenvalues come out as continuous branches."""
    p = np.linspace(0, 2, 41)
    smooth = np.column_stack([p - 1.21, -1 - p, -0.5 + 1j * (1 + p), -0.5 - 1j * (1 + p)])
    shuffled = np.array([np.random.default_rng(i).permutation(row) for i, row in enumerate(smooth)])
    found = Branches.of(p, shuffled)
    assert np.max(np.abs(np.diff(found.eigenvalues, axis=0))) < 0.06
    (only,) = found.boundaries()
    assert only.value == pytest.approx(1.21, rel=1e-12) and only.frequency == 0
    rows = [Branches.of(SPEEDS, np.array([np.linalg.eigvals(bicycle(v)) for v in SPEEDS])).boundaries()]
    assert [boundary.value for boundary in rows[0]] == pytest.approx(
        [data.WEAVE_SPEED, data.CAPSIZE_SPEED], rel=1e-4
    )


def test_what_failed_stays_unknown_and_branches_go_on_behind_it() -> None:
    p = np.linspace(0, 2, 41)
    matrices = np.array([pair((1 + value) ** 2, (3 - value) ** 2) for value in p])
    matrices[[0, 12, 13]] = np.nan
    found = Branches.of(p, matrices, ("a", "b", "a", "b"))
    assert np.flatnonzero(np.isnan(found.eigenvalues).all(axis=1)).tolist() == [0, 12, 13]
    a = found.families[found.names.index("a")][0]
    known = np.isfinite(found.eigenvalues[:, a])
    assert np.abs(found.eigenvalues[known, a].imag) == pytest.approx(np.sqrt((1 + p[known]) ** 2 - 1e-4))
    assert Branches.of(p, np.full((41, 4), np.nan)).boundaries() == []


def test_rigid_body_motions_are_no_boundaries() -> None:
    """Their eigenvalues are zero but for rounding, of any sign."""
    matrices = []
    for k in np.linspace(1, 2, 21):
        K = k * np.array([[1.0, -1.0], [-1.0, 1.0]])
        matrices.append(np.block([[-1e-3 * K, -K], [np.eye(2), np.zeros((2, 2))]]))
    assert Branches.of(np.linspace(1, 2, 21), matrices).boundaries() == []


@pytest.mark.parametrize("angle", [-0.6, -0.2, 0.0, 0.3, 0.7])
def test_combinations_of_equal_modes_do_not_change_names(angle: float) -> None:
    """Two modes, each with two displacements of one size, cross in the middle, where their shapes are arbitrary."""
    p, own = np.linspace(-1.0, 1.0, 5), np.array([[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 0.0, 1.0]])
    values = np.sort(np.stack([2.0 + p, 2.0 - p, np.full(5, 4.0)], axis=1), axis=1)
    turned = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    shapes = np.stack([own, own, turned @ own, own[[1, 0, 2]], own[[1, 0, 2]]])
    assert Branches.of_shapes(p, values, shapes, ["x", "y", "z"]).names == ["x (1)", "x (2)", "z"]


@pytest.mark.parametrize("off", [-1e-12, 0.0, 1e-12])
def test_of_modes_that_are_equal_up_to_rounding_the_first_is_among_the_lowest(off: float) -> None:
    values = np.array([[1.0, 2.0, 5.0, np.nan], [1.0, 4.0, 4.0 + off, 3.0], [1.0, 2.0, 5.0, 9.0]])
    assert ranks(values)[1].tolist() == [0, 2, 3, 1]
    assert among_lowest(values, 3).tolist() == [True, True, True, True]
    assert among_lowest(values[1:2], 3).tolist() == [True, True, False, True]


def inverted(length: float = 1.0) -> fx.System:
    """A pendulum of 1 kg upright on a damped spring of 5 N m/rad: stable while m g L is less."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.hinge("h", m.angle("g", fixed=True), m.angle("arm"))
    m.beam("r", "O", "arm", m.point("T", (0, length)))
    m.point_mass("m", "T", 1.0)
    m.spring("h.angle", 5.0, 0.2)
    return m.build()


@pytest.mark.parametrize("count", [5, 9, 17])
def test_boundaries_over_a_parameter_are_exact_however_few_values_there_are(count: int) -> None:
    """5 / 9.81, over a length and over a mass; 7 % off with nine lengths, by a cubic through four matrices."""
    system = inverted()
    lengths = {"T.position[1]": np.linspace(0.2, 1.5, count)}
    masses = {"m.mass": np.linspace(1.0, 0.2, count)}
    for loci in (
        system.root_loci(lambda s: s.initial, parameters=lengths),
        system.root_loci(system.initial, parameters=masses, of=["h.angle"]),
    ):
        (found,) = loci.branches().boundaries()
        assert found.value == pytest.approx(5 / 9.81, rel=1e-12)
        assert found.frequency == 0.0


@pytest.mark.parametrize("values", [[1.0, 0.2, 0.8], [0.2, 0.4, 0.4, 0.6], [0.3, 0.2, 0.3]])
def test_values_must_increase_or_decrease(values: list[float]) -> None:
    system = inverted()
    branches = system.root_loci(system.initial, parameters={"m.mass": values}).branches()
    with pytest.raises(
        fx.ModelError, match=r"must increase, or decrease: [01]\.?\d? comes after 0\.\d|comes after 1"
    ):
        branches.boundaries()
