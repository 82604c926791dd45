"""Springs and dampers on deformations, on coordinates and between two of either, against closed forms."""

import numpy as np
import pytest
from mechanisms import strut

import flexel as fx


def masses(planar: bool = False) -> fx.Model:
    """Two points of mass 2 and 3 that can move along x."""
    m = fx.Model()
    for name, x, mass in (("A", 0.0, 2.0), ("B", 1.0, 3.0)):
        m.point(name, (x, 0) if planar else (x, 0, 0))
        m.point_mass(f"{name} mass", name, mass)
        m.fix(*(f"{name}.{axis}" for axis in ("y" if planar else "yz")))
    return m


@pytest.mark.parametrize("planar", [False, True])
def test_springs_on_and_between_coordinates_give_the_frequencies_of_two_masses(planar: bool) -> None:
    m = masses(planar)
    m.spring("A.x", 7.0)
    m.spring(("A.x", "B.x"), 5.0)
    found = [mode.omega for mode in m.build().vibrations()]
    w2 = np.linalg.eigvals(np.linalg.inv(np.diag([2.0, 3.0])) @ np.array([[12.0, -5.0], [-5.0, 5.0]]))
    np.testing.assert_allclose(found, np.sqrt(np.sort(w2)), rtol=1e-12)


def test_a_spring_to_the_ground_is_at_rest_where_it_is_drawn_and_takes_its_preload() -> None:
    m = masses()
    m.spring("A.x", 7.0)
    m.spring("B.x", 5.0, preload=-2.0)
    state = m.build().equilibrium()
    assert state["A.x"] == pytest.approx(0.0, abs=1e-12)
    assert state["B.x"] == pytest.approx(1.4)


def test_a_damper_between_two_masses_takes_their_relative_speed_and_no_momentum() -> None:
    m = masses()
    m.spring(("A.x", "B.x"), damping=4.0)
    m.initial("A.x", rate=1.0)
    system = m.build()
    motion = system.simulate(0.5, rtol=1e-11, atol=1e-12)
    v = np.array([motion[-1].rate("A.x"), motion[-1].rate("B.x")])
    assert v @ [2.0, 3.0] == pytest.approx(2.0, rel=1e-9)
    assert v[0] - v[1] == pytest.approx(np.exp(-4.0 * 0.5 * (1 / 2 + 1 / 3)), rel=1e-8)


def test_a_spring_between_two_hinge_angles_couples_two_pendulums() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    for name, y in (("a", 0.0), ("b", 1.0)):
        m.point(f"{name}0", (0, y, 0), fixed=True)
        m.frame(f"{name}f", fixed=True)
        m.frame(f"{name}r")
        m.point(f"{name}1", (0, y, -1))
        m.hinge(name, f"{name}f", f"{name}r", axis=(0, 1, 0))
        m.beam(f"{name} rod", f"{name}0", f"{name}r", f"{name}1", rigid=True)
        m.point_mass(f"{name} bob", f"{name}1", 1.0)
    m.spring(("a.angle", "b.angle"), 3.0)
    system = m.build()
    found = [mode.omega for mode in system.vibrations(system.equilibrium())]
    np.testing.assert_allclose(found, np.sqrt([9.81, 9.81 + 6.0]), rtol=1e-10)


def test_a_torsion_spring_on_a_planar_angle() -> None:
    m = fx.Model()
    m.point("P", (0, 0), fixed=True)
    m.angle("R", 0.3)
    m.body("disc", "P", "R", mass=1.0, inertia=2.0)
    m.spring("R.angle", 8.0)
    assert [mode.omega for mode in m.build().vibrations()] == pytest.approx([2.0])


def test_springs_on_all_coordinates_make_an_elastic_support_in_global_axes() -> None:
    m = fx.Model()
    m.point("P", (1, 2, 3))
    m.point_mass("mass", "P", 1.0)
    for axis, k in zip("xyz", (2.0, 3.0, 5.0), strict=True):
        m.spring(f"P.{axis}", k)
    m.load("P", (1.0, 1.0, 1.0))
    state = m.build().equilibrium()
    np.testing.assert_allclose(state.position("P"), np.array([1, 2, 3]) + 1 / np.array([2.0, 3.0, 5.0]))


def test_what_a_spring_measures_with_is_not_drawn() -> None:
    from flexel.apps.view.drawing import shapes

    m = masses()
    m.spring("A.x", 7.0)
    assert not [shape for shape in shapes(m.build().at_rest) if "." in shape.name]


def test_a_free_length_is_the_length_of_a_bar_without_force() -> None:
    m = strut(0.5)
    m.spring("strut.elongation", 200.0, free_length=0.42)
    system = m.build()
    assert system.initial.force("strut.elongation") == pytest.approx(200.0 * (0.5 - 0.42))
    assert system.equilibrium()["A.x"] == pytest.approx(0.42)


def test_a_free_length_counts_from_that_of_the_element_and_not_from_the_drawing() -> None:
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0.5, 0, 0))
    m.fix("A.y", "A.z")
    m.element("strut", "truss", "O", "A", l0=0.4, rhoA=1.0)
    m.spring("strut.elongation", 200.0, free_length=0.42)
    m.initial("strut.elongation", 0.1)
    assert m.build().initial.force("strut.elongation") == pytest.approx(200.0 * 0.08)


def test_a_free_length_of_another_deformation_is_its_value() -> None:
    m = masses()
    m.spring("A.x", 7.0, free_length=0.3)
    m.spring("B.x", 5.0)
    m.spring(("A.x", "B.x"), 2.0, free_length=-0.1)
    state = m.build().equilibrium()
    a, b = np.linalg.solve([[9.0, -2.0], [-2.0, 7.0]], [7.0 * 0.3 - 2.0 * 0.1, 2.0 * 0.1])
    assert [state["A.x"], state["B.x"] - 1.0] == pytest.approx([a, b])


def test_a_list_of_coordinates_is_coupled_by_matrices() -> None:
    K, D, free = np.array([[7.0, -2.0], [-2.0, 5.0]]), np.array([[0.3, 0.1], [0.1, 0.2]]), [0.1, -0.2]
    m = masses()
    m.spring(["A.x", "B.x"], K, D, free_length=free)
    m.initial("A.x", 0.05, rate=0.4)
    m.initial("B.x", 1.02, rate=-0.3)
    state = m.build().initial
    forces = np.array([state.force(f"{name}.displacement.along") for name in "AB"])
    np.testing.assert_allclose(forces, K @ ([0.05, 0.02] - np.array(free)) + D @ [0.4, -0.3], rtol=1e-12)


def test_numbers_curves_and_formulas_are_the_same_spring() -> None:
    k, c, e, rate, free = 300.0, 7.0, 0.03, -0.4, 0.46
    ways = {
        "numbers": (k, c),
        "curves": (fx.Curve([[0.0, k]]), fx.Curve([[0.0, c]])),
        "formula": (lambda e: k * e, lambda ed: c * ed),
        "formula of both": (lambda e, ed: k * e + c * ed, None),
        "curve and number": (fx.Curve([[0.0, k]]), c),
        "number and curve": (k, fx.Curve([[0.0, c]])),
    }
    for given in ways.values():
        m = strut(0.5)
        m.spring("strut.elongation", *given, free_length=free)
        m.initial("strut.elongation", e, rate=rate)
        state = m.build().initial
        assert state.force("strut.elongation") == pytest.approx(k * (0.5 + e - free) + c * rate, rel=1e-12)
        assert state.dissipated == pytest.approx(c * rate**2, rel=1e-12)


def test_a_curve_of_the_length_itself_has_the_free_length_zero() -> None:
    m = strut(0.5)
    m.spring("strut.elongation", fx.Curve([[-80.0, 200.0]]), free_length=0.0)
    assert m.build().initial.force("strut.elongation") == pytest.approx(20.0)


def test_a_preload_is_the_force_as_drawn() -> None:
    m = strut(0.5)
    m.spring("strut.elongation", 200.0, preload=16.0)
    assert m.build().equilibrium()["A.x"] == pytest.approx(0.42)


def test_dampers_on_slips_may_be_coupled() -> None:
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("R")
    m.body("top", "O", "R", mass=1.0, inertia=(1.0, 1.0, 1.0))
    m.angular_velocity("R")
    C = np.array([[3.0, 1.0], [1.0, 2.0]])
    m.spring(["R.omega.wx", "R.omega.wy"], damping=C)
    m.spring("R.omega.wz", damping=4.0)
    m.spring(("R.omega.wx", "R.omega.wz"), damping=0.5)
    m.initial("R.lambda1", rate=0.1)  # half the angular velocity
    m.initial("R.lambda2", rate=-0.2)
    m.initial("R.lambda3", rate=0.05)
    state = m.build().initial
    w = np.array([0.2, -0.4, 0.1])
    expected = np.append(C @ w[:2], 4.0 * w[2]) + 0.5 * (w[0] - w[2]) * np.array([1.0, 0.0, -1.0])
    np.testing.assert_allclose([state.force(f"R.omega.w{axis}") for axis in "xyz"], expected, rtol=1e-12)


def test_what_is_refused_leaves_the_model_as_it_was() -> None:
    m = strut(0.5)
    for wrong in ({"stiffness": -1.0}, {"stiffness": 1.0, "damping": -1.0}, {"preload": "x"}):
        with pytest.raises(fx.ModelError, match="spring on 'strut.elongation'"):
            m.spring("strut.elongation", **wrong)  # type: ignore[arg-type]
    with pytest.raises(fx.ModelError, match="spring on 'A.x': stiffness -1 is negative"):
        m.spring("A.x", -1.0)
    assert m.laws == []
    assert list(m.instances) == ["strut", "mass"]
