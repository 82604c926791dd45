"""Compliance of a body and the report of over- and under-constraint, against closed forms."""

import numpy as np
import pytest

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.quaternions import matrix
from flexel.parts.materials import Profile

L = 0.1
SECTION = fx.Rectangle(2e-3, 10e-3)
MATERIAL = fx.Material(E=200e9, nu=0.3, rho=7800.0)


def cantilever(n: int = 1, turn: Array | None = None) -> fx.Model:
    """Clamped beam of length L along x, turned as a whole, in n elements; ends in the nodes Q and S."""
    R = np.eye(3) if turn is None else matrix(turn)
    m = fx.Model()
    names = [("P", "R"), *((f"P{i}", f"R{i}") for i in range(1, n)), ("Q", "S")]
    for i, (p, r) in enumerate(names):
        m.point(p, R @ [L * i / n, 0, 0], fixed=i == 0)
        m.frame(r, (1, 0, 0, 0) if turn is None else turn, fixed=i == 0)
    for i in range(n):
        ends = (*names[i], *names[i + 1])
        m.beam(f"b{i}", *ends, direction=R[:, 1], section=SECTION, material=MATERIAL)
    return m


def exact() -> Array:
    """Compliance of the end of a Timoshenko cantilever."""
    k = Profile(SECTION, MATERIAL).stiffness()
    C = np.diag(
        [
            L / k["EA"],
            L**3 / (3 * k["EIz"]) + L / k["GAy"],
            L**3 / (3 * k["EIy"]) + L / k["GAz"],
            L / k["GJ"],
            L / k["EIy"],
            L / k["EIz"],
        ]
    )
    C[1, 5] = C[5, 1] = L**2 / (2 * k["EIz"])
    C[2, 4] = C[4, 2] = -(L**2) / (2 * k["EIy"])
    return C


@pytest.mark.parametrize("n", [1, 3])
def test_the_end_of_a_cantilever_has_its_textbook_compliance(n: int) -> None:
    found = cantilever(n).build().compliance("Q", "S")
    np.testing.assert_allclose(found.matrix, exact(), rtol=1e-8, atol=1e-14)
    assert found.stiffness()["turn x"] == pytest.approx(1 / exact()[3, 3])
    np.testing.assert_allclose(found.stiffness_matrix() @ found.matrix, np.eye(6), atol=1e-8)


def test_in_body_axes_a_turned_cantilever_has_the_compliance_of_a_straight_one() -> None:
    found = cantilever(turn=fx.turn((1, 2, 3), 0.7)).build().compliance("Q", "S")
    np.testing.assert_allclose(found.in_body, exact(), rtol=1e-9, atol=1e-14)
    assert abs(found.matrix - exact()).max() > 0.1 * exact().max()


def test_an_offset_moves_the_point_where_forces_act() -> None:
    d = np.array([0.01, 0.02, -0.03])
    found = cantilever().build().compliance("Q", "S", offset=d)
    T = np.eye(6)
    T[:3, 3:] = [[0, d[2], -d[1]], [-d[2], 0, d[0]], [d[1], -d[0], 0]]
    np.testing.assert_allclose(found.matrix, T @ exact() @ T.T, rtol=1e-9, atol=1e-14)


def test_a_held_direction_is_rigid_and_stiffens_the_others() -> None:
    found = cantilever().build().compliance("Q", "S", hold=["Q.y"])
    C = exact()
    assert found.stiffness()["y"] == np.inf
    assert found.matrix[5, 5] == pytest.approx(C[5, 5] - C[1, 5] ** 2 / C[1, 1])
    with pytest.raises(fx.DynamicsError, match="no stiffness matrix: y cannot move"):
        found.stiffness_matrix()


def test_compliance_is_the_derivative_of_the_equilibrium_under_preload() -> None:
    m = cantilever(3)
    m.load("Q", (5.0, lambda t: 20.0 + t, 10.0))
    system = m.build()
    states = [system.equilibrium(t=t) for t in (-1e-3, 1e-3)]
    rate = (states[1].position("Q") - states[0].position("Q")) / 2e-3
    found = system.compliance("Q", "S", system.equilibrium(t=0.0))
    np.testing.assert_allclose(found.matrix[:3, 1], rate, rtol=1e-6, atol=1e-9)


def test_planar_and_spatial_models_have_the_same_compliance() -> None:
    m = fx.Model()
    m.point("P", (0, 0), fixed=True)
    m.angle("R", fixed=True)
    m.point("Q", (L, 0))
    m.angle("S")
    m.beam("b", "P", "R", "Q", "S", section=SECTION, material=MATERIAL)
    found = m.build().compliance("Q", "S")
    assert found.directions == ("x", "y", "turn")
    np.testing.assert_allclose(found.matrix, exact()[np.ix_([0, 1, 5], [0, 1, 5])], rtol=1e-9, atol=1e-14)


def test_a_loaded_column_is_as_soft_as_beam_column_theory_says() -> None:
    k = Profile(SECTION, MATERIAL).stiffness()
    P = 0.8 * np.pi**2 * k["EIz"] / (4 * L**2)
    m = cantilever(8)
    m.load("Q.x", -P)
    system = m.build()
    x = L * np.sqrt(P / k["EIz"])
    expected = L / P * (np.tan(x) / x - 1)
    found = system.compliance("Q", "S", system.equilibrium())
    assert found.matrix[1, 1] == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("S", "S"), "node 'S' is a frame; give a point node here"),
        (("Q", "Q"), "node 'Q' is a point; give a frame node here"),
        (("X", "S"), "unknown node 'X'"),
    ],
)
def test_nodes_that_are_no_body_are_named(arguments: tuple[str, str], message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        cantilever().build().compliance(*arguments)


def test_a_motion_without_stiffness_is_named() -> None:
    m = cantilever()
    m.point("T", (1, 0, 0))
    m.frame("U")
    m.beam("loose", "T", "U", "Q")
    with pytest.raises(fx.DynamicsError, match="nothing resists a motion"):
        m.build().compliance("T", "U")


# -- over- and under-constraint -------------------------------------------------------------------


def guide(flexible: list[str] | None) -> fx.Model:
    """Two parallel leaf springs between the ground and a rigid shuttle."""
    m = fx.Model()
    m.point("S", (L, 0, 0))
    m.frame("R")
    for name, y in (("a", -0.02), ("b", 0.02)):
        m.point(f"{name}0", (0, y, 0), fixed=True)
        m.frame(f"{name}f", fixed=True)
        m.point(f"{name}1", (L, y, 0))
        leaf = fx.Rectangle(0.3e-3, 20e-3)
        ends = (f"{name}0", f"{name}f", f"{name}1", "R")
        m.beam(name, *ends, direction=(0, 1, 0), section=leaf, material=MATERIAL, flexible=flexible)
        m.beam(f"{name} arm", "S", "R", f"{name}1")
    return m


def test_two_leaf_springs_repeat_one_in_plane_bending() -> None:
    found = guide(["torsion", "bend3", "bend4"]).constraint_report()
    assert found.dofs == 1 and len(found.redundant) == 1 and not found.motions
    assert set(found.redundant[0]) == {"a.bend1", "a.bend2", "b.bend1", "b.bend2"}
    assert "over-constrained: " in str(found)


def test_rigid_torsion_of_two_leaf_springs_is_named_and_its_release_makes_them_work() -> None:
    m = guide(["bend3", "bend4"])
    found = m.constraint_report()
    assert len(found.redundant) == len(found.release) == 3
    assert any(set(names) == {"a.torsion", "b.torsion"} for names in found.redundant)
    assert any(name.endswith(".torsion") for name in found.release)
    with pytest.raises(fx.ConstraintError, match="torsion"):
        m.build()
    m.release(*found.release)
    assert m.build().counts["degrees_of_freedom"] == 1
    assert m.constraint_report().redundant == []


def test_all_modes_flexible_leave_nothing_redundant() -> None:
    found = guide(None).constraint_report()
    assert (found.dofs, found.redundant, found.motions, found.release) == (6, [], [], [])


def test_a_free_body_is_under_constrained_and_its_motions_are_named() -> None:
    m = guide(None)
    m.point("T", (1, 0, 0))
    m.frame("U")
    m.beam("loose", "T", "U", "S")
    motions = m.constraint_report().motions
    assert len(motions) == 3 and all(
        any(name.startswith(("T.", "U.")) for name in motion) for motion in motions
    )


def test_a_state_is_reported_on_too() -> None:
    state = guide(None).build().at_rest
    assert state.constraint_report().dofs == 6
