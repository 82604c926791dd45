"""Bad tables of flexure mechanisms: each is refused by a message that names the table, its row, and a remedy."""

from collections.abc import Callable
from typing import Any

import flexure_tables as tables
import pytest

import flexel as fx

Change = Callable[[list[Any]], Any]


def leaf(**values: Any) -> Change:
    """The group of leaf springs with other values; None removes one."""

    def change(given: list[Any]) -> None:
        group = given[3][0] | values
        given[3] = [{key: value for key, value in group.items() if value is not None}]

    return change


def node(i: int, **values: Any) -> Change:
    """A node with further properties."""

    def change(given: list[Any]) -> None:
        given[2][i] = given[2].get(i, {}) | values

    return change


def table(place: int, value: Any) -> Change:
    """Another table."""
    return lambda given: given.__setitem__(place, value)


def row(place: int, i: int, value: Any) -> Change:
    """Another row of a table."""
    return lambda given: given[place].__setitem__(i, value)


CASES: list[tuple[Change, str]] = [
    (table(0, "nodes"), "nodes 'nodes' is not a table; give a list"),
    (table(0, [[0, 0, 0]]), "nodes has 1 rows; give at least two"),
    (row(0, 1, [0, 0.1]), r"nodes row 2: place \[0, 0.1\] has shape .*; give 3 numbers"),
    (row(0, 1, [0, 0.1, "a"]), "nodes row 2: place .* is not numeric; give real numbers"),
    (row(0, 1, [0, float("nan"), 0]), "nodes row 2: place .* is not finite"),
    (row(0, 1, [0, 0, 0]), "elements row 1: its nodes 1 and 2 are at the same position; move one"),
    (table(1, []), "elements has no rows; give at least one"),
    (row(1, 2, [3, 9]), "elements row 3: there is no node 9; they are numbered from 1 to 5"),
    (row(1, 2, [3, 0]), "elements row 3: there is no node 0"),
    (row(1, 2, [3, 1.5]), "elements row 3: node 1.5 is not a whole number"),
    (row(1, 2, [3, 3]), "elements row 3: its nodes 3 and 3"),
    (row(1, 2, [3]), "elements row 3: .* are not two nodes"),
    (row(1, 3, [2, 3]), "nodes row 5: no element uses this node; connect it"),
    (table(2, {9: {"fixed": True}}), "node_properties: there is no node 9"),
    (table(2, [None] * 6), "node_properties has 6 entries for 5 nodes"),
    (table(2, {1: True}), r"node_properties of node 1: True is not a set of properties; give \{"),
    (node(1, fixd=True), "node_properties of node 1: unknown property 'fixd'; did you mean fixed"),
    (node(1, fixed="all"), "node_properties of node 1: fixed 'all' is unknown; give True"),
    (node(1, fixed=2), "node_properties of node 1: fixed: 2 is not a list of names"),
    (node(5, force=(1, 2)), r"node_properties of node 5: force \(1, 2\) has shape"),
    (node(1, force=(1, 0, 0)), "node_properties of node 1: force in x acts on a fixed direction; drop it"),
    (node(1, moment=(0, 0, 1)), "node_properties of node 1: moment in z acts on a fixed direction"),
    (node(1, displacement={"x": 1e-3}), "node 1: displacement in x is both fixed and prescribed; drop one"),
    (node(1, rotation={"z": 0.1}), "node 1: rotation in z is both fixed and prescribed; drop one"),
    (node(5, displacement={"u": 1e-3}), "node 5: displacement: unknown axis 'u'"),
    (node(5, displacement=(1, 2)), "node 5: displacement .*give three numbers"),
    (node(5, rotation={"z": 5.0}), "node 5: rotation of 5 rad; give less than half a turn"),
    (node(5, rotation={"z": 0.1, "x": 0.0}, rotation_initial={"x": 0.1}), "node 5: .* different axes"),
    (node(5, mass=-1.0, inertia=None), "node 5: .*mass -1 is not positive"),
    (node(5, mass="1"), "node 5: mass '1' is not numeric"),
    (node(5, mass=0.0), "node 5: an inertia without a mass; give the mass"),
    (node(5, inertia=(1, 1, 9)), "node 5: .*triangle inequality"),
    (table(3, {"elements": [1]}), "element_properties is one mapping; give a list of groups"),
    (table(3, [{"section": "circle"}]), "element_properties row 1: its elements are missing"),
    (table(3, [3]), "element_properties row 1: 3 is not a set of properties"),
    (leaf(elements=[1, 9]), "element_properties row 1: there is no element 9; they are numbered from 1 to 4"),
    (leaf(elements=[1, 1]), "element_properties row 1: element 1 is already in row 1"),
    (leaf(elements=[]), "element_properties row 1: elements .*give a list of rows"),
    (leaf(width=3), "element_properties row 1: unknown property 'width'"),
    (leaf(section="square"), "element_properties row 1: section 'square' is unknown; give one of rectangle"),
    (leaf(section=3, dimensions=None), "element_properties row 1: .*3 is not a section"),
    (leaf(section=None), "element_properties row 1: dimensions without the name of a section"),
    (leaf(section=None, dimensions=None, flexible=None, beams=None), "row 1: a material without a section"),
    (leaf(section=None, dimensions=None, material=None), "row 1: flexible modes without a section"),
    (leaf(dimensions=(1e-3,)), "element_properties row 1: dimensions .* for a rectangle; give 2 number"),
    (leaf(dimensions=(1e-3, -1e-3)), "element_properties row 1: Rectangle: width -0.001 is not positive"),
    (leaf(dimensions=None), "element_properties row 1: dimensions None for a rectangle"),
    (leaf(material="stel"), "element_properties row 1: unknown material 'stel'; did you mean steel"),
    (leaf(material=None), "element_properties row 1: neither a material nor E; give material"),
    (leaf(material=None, E=2e11), "element_properties row 1: give one of nu and G with E"),
    (leaf(material=None, E=-2e11, nu=0.3), "element_properties row 1: Material: E .* is not positive"),
    (leaf(E=2e11), "element_properties row 1: material and also E; drop one"),
    (leaf(flexible=7), "element_properties row 1: flexible 7 is not a list"),
    (
        leaf(flexible=[7]),
        "element_properties row 1: flexible 7 is not a mode of a beam; give numbers from 1 to 6",
    ),
    (leaf(flexible=[2, 3]), r"element_properties row 1: flexible has only one of 3 and 4"),
    (leaf(flexible=(), beams=3), "element_properties row 1: a rigid element is one beam; drop beams=3"),
    (leaf(beams=0), "element_properties row 1: beams 0; give a whole number"),
    (leaf(beams=2.5), "element_properties row 1: beams 2.5 is not a whole number"),
    (leaf(orientation=(0, 1, 0)), "element_properties row 1: .*is parallel to the axis"),
    (leaf(orientation="z"), "element_properties row 1: .*direction 'z' is not numeric"),
    (table(4, {"stps": 3}), "options: unknown property 'stps'; did you mean steps"),
    (table(4, {"steps": 0}), "options: steps 0; give a whole number, 1 or more"),
    (table(4, {"gravity": 9.81}), "options: gravity 9.81 has shape"),
    (table(4, {"release": "element 1.bend3"}), "options: release: .* is not a list of names"),
    (table(4, {"compliance": [9]}), "options: compliance: there is no node 9"),
    (table(4, {"frequencies": -1}), "options: frequencies -1; give a whole number, 0 or more"),
    (table(4, 3), "options: 3 is not a set of properties"),
]


@pytest.mark.parametrize(("change", "message"), CASES, ids=[case[1][:50] for case in CASES])
def test_it_is_refused_by_name(change: Change, message: str) -> None:
    given: list[Any] = [*tables.guide(), None]
    change(given)
    with pytest.raises(fx.ModelError, match=message):
        fx.flexure(*given)


def test_a_mechanism_that_cannot_move_is_refused() -> None:
    rows = {1: {"fixed": True}, 2: {"fixed": True}}
    with pytest.raises(fx.ModelError, match="all nodes are fixed"):
        fx.flexure([[0, 0, 0], [1, 0, 0]], [[1, 2]], rows, [tables.leaf([1])])


def test_nodes_and_steps_that_do_not_exist_are_refused() -> None:
    found = fx.flexure(*tables.guide(beams=1), {"compliance": [5], "frequencies": 1})
    step = found.steps[0]
    with pytest.raises(fx.ModelError, match="node 6; give a whole number, at most 5"):
        step.node(6)
    with pytest.raises(fx.ModelError, match="element 0; give a whole number, 1 or more"):
        step.element(0)
    with pytest.raises(fx.ModelError, match="mode 2; give a whole number, at most 1"):
        step.mode(2)
    with pytest.raises(fx.ModelError, match="compliance of node 2 was not computed; name it in options"):
        found.compliance(2)
    assert step.node(2).compliance is None
