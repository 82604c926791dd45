"""Over-constraint of flexure mechanisms: released and reported, refused, or released by name."""

from typing import Any

import flexure_tables as tables
import pytest
from flexure_tables import IDEAL

import flexel as fx


def test_what_is_released_is_of_a_leaf_spring_and_is_reported() -> None:
    found = fx.flexure(*tables.guide(IDEAL))
    assert len(found.released) == len(found.redundant) == 1
    element, mode = found.released[0].split(".")
    assert element in [f"element {i} beam {k}" for i in (1, 3) for k in range(1, 5)]
    assert mode in ("bend3", "bend4")  # parallel leaf springs repeat one in-plane bending
    assert found.released[0] in found.redundant[0]
    assert f"over-constrained; released '{found.released[0]}'" in str(found)


def test_a_released_mechanism_is_no_longer_over_constrained() -> None:
    m = fx.flexure_model(*tables.hinge([3, 4]))  # torsion is rigid too
    report = m.constraint_report()
    found = fx.flexure(*tables.hinge([3, 4]))
    assert found.released == tuple(report.release) and len(found.released) > 1
    assert found.motion[-1].constraint_report().redundant == []


@pytest.mark.filterwarnings("ignore:flexure. no buckling loads:flexel.IncompleteWarning")  # a moment acts
def test_a_released_deformation_keeps_the_stiffness_of_its_section() -> None:
    """Bent by 20 mm, parallel leaf springs strain one another; what was released resists with 4 EI/l³ (shear aside)."""
    found = fx.flexure(*tables.guide(IDEAL, displacement={"x": 0.02}, moment=(1.0, 0, 0)), {"steps": 4})
    state, name = found.steps[-1].state, found.released[0]
    k, l0 = tables.profile(tables.LEAF).stiffness(), tables.LENGTH / 4
    shear = 12 * k["EIz"] / (k["GAy"] * l0**2)
    assert abs(state[name]) > 1e-9
    assert state.force(name) == pytest.approx(
        (4 + shear) * k["EIz"] / ((1 + shear) * l0**3) * state[name], rel=1e-9
    )


def test_over_constraint_is_refused_on_demand() -> None:
    with pytest.raises(
        fx.ConstraintError, match=r"over-constrained 1 times, among 'element .*options: release"
    ):
        fx.flexure(*tables.guide(IDEAL), {"release": False})
    assert fx.flexure(*tables.guide(), {"release": False}).released == ()


def test_deformations_are_released_by_name() -> None:
    found = fx.flexure(*tables.guide(IDEAL), {"release": ["element 3 beam 1.bend3"]})
    assert found.released == ("element 3 beam 1.bend3",) and len(found.redundant) == 1
    with pytest.raises(fx.ModelError, match="unknown name 'element 3 beam 1.bend7'"):
        fx.flexure(*tables.guide(IDEAL), {"release": ["element 3 beam 1.bend7"]})
    with pytest.raises(fx.ModelError, match="unknown name 'leaf.bend3'"):
        fx.flexure(*tables.guide(IDEAL), {"release": ["leaf.bend3"]})
    with pytest.raises(fx.ConstraintError, match="over-constrained 1 times"):
        fx.flexure(*tables.guide(IDEAL), {"release": ["element 3 beam 1.bend1"]})


def test_a_rigid_loop_is_released_by_name() -> None:
    """Four rigid sides of a square are six conditions too many, though no flexible element is among them."""
    nodes = [[0, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0], [0, 0.1, 0], [0, -0.1, 0]]
    rows: dict[int, Any] = {5: {"fixed": True}, 3: {"force": (0.1, 0, 0), "mass": 1.0}}
    found = fx.flexure(nodes, [[1, 2], [2, 3], [3, 4], [4, 1], [5, 1]], rows, [tables.leaf([5])])
    assert len(found.released) == 6
    assert {name.split(".")[0] for name in found.released} <= {f"element {i}" for i in (1, 2, 3, 4)}
    open_loop = fx.flexure(nodes, [[1, 2], [2, 3], [3, 4], [5, 1]], rows, [tables.leaf([4])])
    assert open_loop.released == ()
    for a, b in zip(found.steps, open_loop.steps, strict=True):
        assert a.node(3).position == pytest.approx(b.node(3).position, abs=1e-10)


def test_a_rigid_element_between_supports_is_released() -> None:
    found = fx.flexure(
        [[0, 0, 0], [0.1, 0, 0], [0.2, 0, 0]],
        [[1, 2], [2, 3]],
        {1: {"fixed": True}, 2: {"fixed": True}, 3: {"mass": 1.0}},
        [tables.leaf([2])],
    )
    assert sorted(found.released) == [
        f"element 1.{mode}" for mode in ("bend1", "bend2", "bend3", "bend4", "elongation", "torsion")
    ]


def test_a_motion_that_nothing_resists_is_refused_by_name() -> None:
    nodes, elements, properties, groups = tables.guide()
    with pytest.raises(fx.ConstraintError, match="nothing resists a motion of 'node"):
        fx.flexure(nodes, elements, {5: properties[5]}, groups)


def test_a_mechanism_of_many_beams_is_reported_on_too() -> None:
    """Its matrix is sparse: more than five hundred coordinates."""
    m = fx.flexure_model(*tables.guide(IDEAL, beams=40))
    report = m.constraint_report()
    few = fx.flexure_model(*tables.guide(IDEAL, beams=4)).constraint_report()
    assert len(report.redundant) == len(few.redundant) == 1
    m.release(*report.release)
    assert m.constraint_report().redundant == []
