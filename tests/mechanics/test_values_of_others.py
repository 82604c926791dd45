"""Values of a state may be given to quantities that are no degrees of freedom."""

import numpy as np
import pytest

import flexel as fx
from flexel.examples.bicycle import bicycle


def rods() -> fx.System:
    """Two rods of one metre; heights are the degrees of freedom."""
    m = fx.Model(gravity=(0, -9.81))
    O, A, B = m.point("O", (0, 0), fixed=True), m.point("A", (0.8, -0.6)), m.point("B", (1.4, -1.4))
    for name, ends in (("upper", (O, A)), ("lower", (A, B))):
        m.truss(name, *ends)
        m.point_mass(f"mass of {name}", ends[1], 1.0)
    m.independent("A.y", "B.y")
    return m.build()


def test_the_coordinate_of_a_mass_on_a_spring_can_be_given() -> None:
    """The spring makes its stretch the degree of freedom; every user gives the place of the mass."""
    m = fx.Model()
    m.point_mass("mass", m.point("A", (0, 0)), 1.0)
    m.fix("A.y")
    m.spring("A.x", 10.0)
    system = m.build()
    assert system.dynamic == ("A.displacement.along",)
    start = system.state_at({"A.x": 0.1})
    assert start["A.x"] == 0.1
    motion = system.simulate(1.0, start=start)
    assert motion["A.x"][-1] == pytest.approx(0.1 * np.cos(np.sqrt(10)), abs=1e-10)


@pytest.mark.parametrize(
    ("values", "places"),
    [
        ({"A.x": 0.6}, {"A.x": 0.6, "A.y": -0.8, "B.y": -1.4}),
        ({"B.x": 1.5}, {"B.x": 1.5, "A.y": -0.6}),
        ({"A.x": 0.6, "B.y": -1.2}, {"A.x": 0.6, "A.y": -0.8, "B.y": -1.2}),
        ({"A.y": -0.8, "B.x": 1.2}, {"A.x": 0.6, "A.y": -0.8, "B.x": 1.2, "B.y": -1.6}),
        ({"A.x": 0.6, "B.x": 1.2}, {"A.x": 0.6, "A.y": -0.8, "B.x": 1.2, "B.y": -1.6}),
    ],
)
def test_the_other_degrees_of_freedom_keep_their_values(
    values: dict[str, float], places: dict[str, float]
) -> None:
    system = rods()
    state = system.state_at(values, rates={"A.y": 0.3})
    assert {name: state[name] for name in places} == pytest.approx(places, abs=1e-13)
    assert state.rate("A.y") == pytest.approx(0.3)
    for name in ("upper", "lower"):
        assert state[f"{name}.elongation"] == pytest.approx(0, abs=1e-13)
    assert state.roles is system.roles


@pytest.mark.parametrize(
    ("values", "message"),
    [
        (
            {"upper.elongation": 0.1},
            "'upper.elongation' is not a degree of freedom, and does not move at this start",
        ),
        ({"O.x": 0.1}, "'O.x' is not a degree of freedom, and does not move at this start"),
        (
            {"A.y": -0.8, "A.x": 0.6},
            "'A.x' is not .* does not move at this start while the other named values stay",
        ),
    ],
)
def test_what_is_fixed_or_determined_is_refused_by_name(values: dict[str, float], message: str) -> None:
    with pytest.raises(fx.ModelError, match=message + ".*values can be given to 'A.y', 'B.y'"):
        rods().state_at(values)


def test_a_value_out_of_reach_is_refused() -> None:
    with pytest.raises(fx.PositionError, match="cannot be reached"):
        rods().state_at({"A.x": 3.0})


def test_a_state_finds_a_node_by_itself() -> None:
    m = fx.Model()
    A = m.point("A", (0.3, 0.4))
    m.point_mass("mass", A, 1.0)
    state = m.build().initial
    assert state.position(A).tolist() == state.position("A").tolist() == [0.3, 0.4]
    assert state.velocity(A).tolist() == [0.0, 0.0]


def test_a_value_of_a_large_model() -> None:
    """A chain of 250 rods, whose heights are most of its degrees of freedom: one point is moved aside by 0.1 mm."""
    m = fx.Model(gravity=(0, -9.81))
    last, x = m.point("O", (0, 0), fixed=True), np.zeros(2)
    for i in range(250):
        slope = 0.3 * np.sin(i / 9)
        x = x + 0.01 * np.array([np.cos(slope), np.sin(slope)])
        point = m.point(f"P{i}", x)
        m.truss(f"rod{i}", last, point)
        m.point_mass(f"mass{i}", point, 0.01)
        last = point
    system = m.build()
    assert system.kinematics.lists.saddle and "P40.x" not in system.dynamic
    before = system.initial
    state = system.state_at({"P40.x": before["P40.x"] - 1e-4})
    assert state["P40.x"] == pytest.approx(before["P40.x"] - 1e-4, abs=1e-12)
    moved = [name for name in system.dynamic if abs(state[name] - before[name]) > 1e-12]
    assert len(moved) == 1


def test_nothing_moves_where_all_is_prescribed() -> None:
    m = fx.Model()
    A = m.point("A", (1, 0))
    m.fix("A.y")
    m.point_mass("mass", A, 1.0)
    m.prescribe("A.x", 1.0)
    with pytest.raises(
        fx.ModelError, match="'A.x' is not .* values can be given to nothing: all motion is prescribed"
    ):
        m.build().state_at({"A.x": 2.0})


def test_a_bicycle_is_placed_by_its_hub_and_not_by_slips() -> None:
    """The place of the contact, a kinematic coordinate, gives way; slips have no values."""
    b = bicycle()
    state = b.state_at({"rear hub.x": 0.05, "lean.angle": 0.1})
    assert [state["rear hub.x"], state["lean.angle"]] == pytest.approx([0.05, 0.1], rel=1e-14)
    assert state["steer.angle"] == pytest.approx(0, abs=1e-15) and abs(state["rear contact.x"]) > 0.01
    with pytest.raises(fx.ModelError, match="'rear.spin' is not a degree of freedom"):
        b.state_at({"rear.spin": 0.1})
