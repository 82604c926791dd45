"""Flexure mechanisms from tables, beside closed forms and beside the same mechanism declared by hand."""

import json
from pathlib import Path
from typing import Any

import flexure_tables as tables
import numpy as np
import pytest
from coarse import COARSE_MESH
from flexure_tables import ALL, IDEAL, LEAF, LENGTH, RADIUS, ROD, SPACING

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.quaternions import matrix
from flexel.examples.flexures_exact import body_stiffness, guided_stiffness

EI = tables.profile(LEAF).stiffness()["EIy"]
ONCE: dict[str, Any] = {"steps": 1}


def ends(case: str) -> list[tuple[Array, Array]]:
    """Axes of each leaf from its clamped end, and its end on the body from the body's node."""
    if case == "guide":
        at = np.array([[-SPACING / 2, LENGTH / 2, 0], [SPACING / 2, LENGTH / 2, 0]])
        return [(tables.axes((0, 1, 0), (0, 0, 1)), place) for place in at]
    if case == "hinge":
        a = LENGTH / 2 / np.sqrt(2)
        return [(tables.axes((a, s * a, 0), (0, 0, 1)), np.array([a, s * a, 0])) for s in (1, -1)]
    turns = 2 * np.pi / 3 * np.arange(3)
    at = RADIUS * np.column_stack([np.cos(turns), np.sin(turns), np.zeros(3)])
    return [(tables.axes((0, 0, 1), (1, 0, 0)), place) for place in at]


@pytest.mark.parametrize(
    ("case", "node", "section"), [("guide", 5, LEAF), ("hinge", 5, LEAF), ("stage", 7, ROD)]
)
def test_the_compliance_of_a_body_is_that_of_timoshenko_beams(case: str, node: int, section: Any) -> None:
    found = fx.flexure(*getattr(tables, case)(beams=1))
    exact = body_stiffness(tables.profile(section), LENGTH, ends(case))
    C = found.steps[0].node(node).compliance
    assert len(found) == 1 and C is not None  # nothing grows: one step
    scale = np.sqrt(np.outer(np.diag(exact), np.diag(exact)))
    assert np.linalg.inv(C.matrix) / scale == pytest.approx(exact / scale, abs=2e-8)
    assert found.compliance(node)[0] == pytest.approx(C.matrix, rel=0)


def test_a_guide_is_as_stiff_and_shortens_as_its_closed_forms_say() -> None:
    force = 0.02
    found = fx.flexure(*tables.guide(IDEAL, force=(force, 0, 0)), ONCE)
    u = found.steps[1].node(5).displacement
    shear = 12 * EI / (tables.profile(LEAF).stiffness()["GAz"] * LENGTH**2)
    assert force / u[0] == pytest.approx(24 * EI / LENGTH**3 / (1 + shear), rel=1e-6)
    assert u[1] == pytest.approx(-3 * u[0] ** 2 / (5 * LENGTH), rel=1e-4)
    assert found.frequencies[0, 0] == pytest.approx(
        np.sqrt(24 * EI / LENGTH**3 / (0.5 + 2 * 13 / 35 * 7850 * LEAF.A * LENGTH)) / (2 * np.pi), rel=1e-4
    )


def test_a_payload_changes_the_stiffness_of_a_guide_and_buckles_it() -> None:
    payload = 20.0
    found = fx.flexure(*tables.guide(beams=8, force_initial=(0, -payload, 0)), {"buckling": 2})
    C = found.steps[0].node(5).compliance
    assert C is not None
    assert C.stiffness()["x"] == pytest.approx(2 * guided_stiffness(EI, LENGTH, -payload / 2), rel=5e-4)
    assert found.buckling[0, 0] == pytest.approx(2 * np.pi**2 * EI / LENGTH**2 / payload, rel=5e-4)


def test_a_guide_from_tables_is_the_same_as_by_hand() -> None:
    found = fx.flexure(*tables.guide(IDEAL, force=(5.0, 0, 0)), {"steps": 3})
    release = [
        name.replace("element 1 beam ", "AB").replace("element 3 beam ", "CD") for name in found.released
    ]
    system = tables.by_hand(5.0, release, ("torsion", "bend1", "bend2"))
    state = system.equilibrium(t=0.0)
    for step in found.steps:
        state = system.equilibrium(state, t=step.load)
        for node, name in ((2, "B"), (3, "C"), (5, "S")):
            assert step.node(node).position == pytest.approx(state.position(name), abs=1e-10)
            assert step.node(node).quaternion == pytest.approx(state.position(f"R{name}"), abs=1e-10)
        C = system.compliance("S", "RS", state)
        own = step.node(5).compliance
        assert own is not None
        assert own.matrix == pytest.approx(C.matrix, rel=1e-8, abs=1e-10 * C.matrix.max())
        assert own.in_body == pytest.approx(C.in_body, rel=1e-8, abs=1e-10 * C.matrix.max())
        w = [mode.hertz for mode in system.vibrations(state, count=4)]
        assert step.frequencies[:4] == pytest.approx(w, rel=1e-9)
        stress = state.stress("AB1")
        # positions agree to 1e-10 of the size; what bends is softer by 1e-4 than what is stiff, so stresses to less
        assert step.element(1).mises == pytest.approx(stress.mises, rel=1e-6, abs=1e-3)


def test_a_cross_hinge_turns_with_two_ei_over_l_and_its_axis_hardly_shifts() -> None:
    angle = 0.002  # a large one bends the leaf springs by the shift of the axis too
    found = fx.flexure(*tables.hinge(IDEAL, rotation={"z": angle}), ONCE)
    node = found.steps[1].node(5)
    assert node.moment[2] == pytest.approx(2 * EI / LENGTH * angle, rel=1e-4)
    axis, turned = node.axis_angle
    assert axis == pytest.approx([0, 0, 1]) and turned == pytest.approx(angle)
    assert node.euler_angles == pytest.approx([angle, 0, 0], abs=1e-12)
    assert np.linalg.norm(node.displacement) < 0.3 * LENGTH * angle**2
    assert found.steps[1].element(1).mises == pytest.approx(
        tables.STEEL.E * angle * LEAF.width / 2 / LENGTH, rel=2e-3
    )


def test_a_stage_on_three_rods_moves_in_its_plane() -> None:
    found = fx.flexure(*tables.stage(flexible=[2, 3, 4, 5, 6], displacement={"x": 1e-4, "y": 0.0}), ONCE)
    rod = tables.profile(ROD).stiffness()
    shear = 12 * rod["EIz"] / (rod["GAy"] * LENGTH**2)
    node = found.steps[1].node(7)
    assert found.released == () and found.redundant == []
    assert node.force[0] == pytest.approx(36 * rod["EIz"] / LENGTH**3 / (1 + shear) * 1e-4, rel=1e-5)
    assert node.displacement[2] == pytest.approx(-3 * 1e-8 / (5 * LENGTH), rel=1e-4)
    free = fx.flexure(*tables.stage(flexible=[2, 3, 4, 5, 6]))
    C = free.steps[0].node(7).compliance
    assert C is not None
    k = C.stiffness()
    about = 3 * (12 * rod["EIz"] / LENGTH**3 / (1 + shear) * RADIUS**2 + rod["GJ"] / LENGTH)
    assert k["turn z"] == pytest.approx(about, rel=1e-9)
    assert k["z"] == k["turn x"] == np.inf


@pytest.mark.filterwarnings("ignore:flexure. no buckling loads:flexel.IncompleteWarning")  # a moment acts
def test_reactions_balance_the_loads_and_their_moments() -> None:
    force, moment = np.array([3.0, 2.0, -1.0]), np.array([0.02, 0.01, 0.05])
    found = fx.flexure(*tables.guide(force=force, moment_initial=moment), {"steps": 2})
    step = found.steps[-1]
    at = step.node(5).position
    assert found.forces[-1].sum(axis=0) == pytest.approx(-force, abs=1e-9)
    total = sum(
        np.cross(step.node(i).position - at, step.node(i).force) + step.node(i).moment for i in (1, 4)
    )
    assert total == pytest.approx(-moment, abs=1e-9)
    assert not step.node(2).force.any() and not step.node(2).moment.any()
    assert found.forces[0].sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-8)


@pytest.mark.parametrize(
    "given",
    [
        {"rotation": (0.0, 0.0, 2.5)},
        {"rotation_initial": {"z": 0.5}, "rotation": {"z": 2.0}},
        {"rotation": {"z": 2.5}},
        {"rotation_initial": (0.0, 0.0, 2.5)},
    ],
)
def test_a_leaf_bent_by_a_large_rotation_is_an_arc(given: dict[str, Any]) -> None:
    group = tables.leaf([1], beams=20)
    found = fx.flexure([[0, 0, 0], [LENGTH, 0, 0]], [[1, 2]], {1: {"fixed": True}, 2: given}, [group])
    end = found.steps[-1].node(2)
    r = LENGTH / 2.5
    assert end.position == pytest.approx([r * np.sin(2.5), r * (1 - np.cos(2.5)), 0], abs=2e-4 * LENGTH)
    assert end.moment[2] == pytest.approx(EI * 2.5 / LENGTH, rel=3e-3)
    assert end.compliance is not None
    assert end.compliance.rotation[:3, :3] == pytest.approx(matrix(end.quaternion))


def test_a_displacement_in_steps_ends_where_an_initial_one_does() -> None:
    def last(**given: Any) -> Array:
        tip = {"displacement" + key: {"y": value} for key, value in given.items()}
        rows = {1: {"fixed": True}, 2: tip}
        found = fx.flexure([[0, 0, 0], [LENGTH, 0, 0]], [[1, 2]], rows, [tables.leaf([1])], {"steps": 4})
        return np.concatenate([found.steps[-1].node(2).position, found.steps[-1].node(2).force])

    whole = last(_initial=0.02)
    parts = fx.flexure(
        [[0, 0, 0], [LENGTH, 0, 0]],
        [[1, 2]],
        {
            1: {"fixed": True},
            2: {"displacement": [None, 0.015, None], "displacement_initial": (None, 0.005, None)},
        },
        [tables.leaf([1])],
    )
    end = parts.steps[-1].node(2)
    assert np.concatenate([end.position, end.force]) == pytest.approx(whole, rel=1e-8, abs=1e-10)
    assert len(parts) == 11 and parts.displacements[0, 1, 1] == pytest.approx(0.005)


@COARSE_MESH
def test_two_leaf_springs_come_out_as_in_spacar() -> None:
    """UT SPACAR's own results of a mechanism of SPACAR Light, over a prescribed turn of half a radian under weight."""
    theirs = json.loads(
        (Path(__file__).parents[1] / "data" / "two_leaf_pivot.json").read_text(encoding="utf-8")
    )
    leaf = {"elements": [1, 3], "section": "rectangle", "dimensions": (50e-3, 0.2e-3), "flexible": "all"}
    leaf |= {"E": 2.1e11, "G": 7e10, "density": 7800, "orientation": (0, 0, 1)}
    body = {"elements": [2], "section": "rectangle", "dimensions": (50e-3, 10e-3), "density": 3000}
    turned = {"mass": 0.1, "rotation": {"z": 2 * np.arcsin(0.247404)}}
    found = fx.flexure(
        [[0, 0, 0], [0, 0.1, 0], [0.1, 0.1, 0], [0.1, 0, 0]],
        [[1, 3], [2, 3], [2, 4]],
        {1: {"fixed": True}, 4: {"fixed": True}, 3: turned},
        [leaf, body | {"orientation": (0, 0, 1)}],
        {"steps": 9, "gravity": (0, 0, -9.81)},
    )
    modes = ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4")
    for k in (0, 9):
        record = {key: np.array(values) for key, values in theirs["records"][str(k)].items()}
        step = found.steps[k]
        for node, point, frame in ((2, 4, 5), (3, 7, 8)):
            for own, number in ((step.node(node).position, point), (step.node(node).quaternion, frame)):
                places = [i - 1 for i in theirs["LNP"][number - 1] if i]
                assert own == pytest.approx(record["X"][places], abs=1e-14)
        for element in (1, 3):
            places = [i - 1 for i in theirs["LE"][element - 1] if i]
            stresses = [step.state.force(f"element {element}.{mode}") for mode in modes]
            assert stresses == pytest.approx(record["SIG"][places], abs=1e-9 * abs(record["SIG"]).max())


def test_weight_bends_a_cantilever() -> None:
    found = fx.flexure(
        [[0, 0, 0], [LENGTH, 0, 0]],
        [[1, 2]],
        [{"fixed": True}, None],
        [tables.leaf([1])],
        {"gravity": (0, -9.81, 0)},
    )
    w = 7850 * LEAF.A * 9.81
    assert found.steps[0].node(2).displacement[1] == pytest.approx(-w * LENGTH**4 / (8 * EI), rel=1e-3)
    assert found.steps[0].node(1).moment[2] == pytest.approx(w * LENGTH**2 / 2, rel=1e-3)


def test_modal_damping_gives_every_mode_the_same_ratio() -> None:
    step = fx.flexure(*tables.guide(beams=1)).steps[0]
    found = sorted(
        (mode for mode in step.linearize(0.02).modes() if mode.omega > 0), key=lambda mode: mode.omega
    )
    assert [mode.damping for mode in found] == pytest.approx([0.02] * len(found), rel=1e-6)
    assert found[0].hertz == pytest.approx(step.frequencies[0], rel=1e-6)
    A, B, C, D = step.linearize(0.02).state_space(["node 5.x"], ["node 5.x"])
    static = (D - C @ np.linalg.solve(A, B))[0, 0]
    compliance = step.node(5).compliance
    assert compliance is not None and static == pytest.approx(compliance.matrix[0, 0], rel=1e-7)


def test_a_mode_moves_the_nodes_as_the_mechanism_does() -> None:
    mode = fx.flexure(*tables.guide(IDEAL)).steps[0].mode(1)
    assert mode.shape == (5, 6) and not mode[[0, 3]].any()
    assert mode[1:3, 0] == pytest.approx([mode[4, 0]] * 2, rel=1e-9)
    assert abs(mode[4, 1:]).max() < 1e-9 * abs(mode[4, 0])


def test_nothing_without_mass_vibrates() -> None:
    nodes, elements, properties, groups = tables.guide(mass=0.0, inertia=None)
    light = {key: v for key, v in groups[0].items() if key != "material"} | {"E": 206e9, "nu": 0.3}
    found = fx.flexure(nodes, elements, properties, [light])
    assert found.frequencies.shape == (1, 0)
    assert "-" in str(found.steps[0])
    with pytest.raises(fx.ModelError, match="no modes"):
        found.steps[0].mode(1)


def test_all_flexible_means_the_six_modes() -> None:
    a = fx.flexure(*tables.guide(ALL)).frequencies
    b = fx.flexure(*tables.guide(["elongation", 2, "bend1", 4, 5, 6])).frequencies
    assert a == pytest.approx(b)
