"""Springs and dampers on deformations, on coordinates and between two of either, against closed forms."""

import numpy as np
import pytest

import flexel as fx


def masses(planar: bool = False) -> fx.Model:
    """Two points of mass 2 and 3 that can move along x."""
    m = fx.Model()
    for name, x, mass in (("A", 0.0, 2.0), ("B", 1.0, 3.0)):
        m.point(name, (x, 0) if planar else (x, 0, 0))
        m.point_mass(f"{name} mass", name, mass)
        m.fix(*(f"{name}.{z}" for z in ("y" if planar else "yz")))
    return m


@pytest.mark.parametrize("planar", [False, True])
def test_springs_on_and_between_coordinates_give_the_frequencies_of_two_masses(planar: bool) -> None:
    m = masses(planar)
    m.spring("A.x", 7.0)
    m.spring("A.x", 5.0, to="B.x")
    found = [z.omega for z in m.build().vibrations()]
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
    m.spring("A.x", 0.0, damping=4.0, to="B.x")
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
    m.spring("a.angle", 3.0, to="b.angle")
    system = m.build()
    found = [z.omega for z in system.vibrations(system.equilibrium())]
    np.testing.assert_allclose(found, np.sqrt([9.81, 9.81 + 6.0]), rtol=1e-10)


def test_a_torsion_spring_on_a_planar_angle() -> None:
    m = fx.Model()
    m.point("P", (0, 0), fixed=True)
    m.angle("R", 0.3)
    m.body("disc", "P", "R", mass=1.0, inertia=2.0)
    m.spring("R.angle", 8.0)
    assert [z.omega for z in m.build().vibrations()] == pytest.approx([2.0])


def test_springs_on_all_coordinates_make_an_elastic_support_in_global_axes() -> None:
    m = fx.Model()
    m.point("P", (1, 2, 3))
    m.point_mass("mass", "P", 1.0)
    for z, k in zip("xyz", (2.0, 3.0, 5.0), strict=True):
        m.spring(f"P.{z}", k)
    m.load("P", (1.0, 1.0, 1.0))
    state = m.build().equilibrium()
    np.testing.assert_allclose(state.position("P"), np.array([1, 2, 3]) + 1 / np.array([2.0, 3.0, 5.0]))


def test_what_a_spring_measures_with_is_not_drawn() -> None:
    from flexel.pictures.drawing import shapes

    m = masses()
    m.spring("A.x", 7.0)
    assert not [z for z in shapes(m.build().at_rest) if "." in z.name]
