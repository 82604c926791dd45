"""Elements of a flexure whose sections warp: Vlasov's closed form, elements in line, and bad tables."""

from typing import Any

import numpy as np
import pytest

import flexel as fx

E, NU, LENGTH, MOMENT = 210e9, 0.3, 0.1, 1e-6
NODES = [[0, 0, 0], [LENGTH, 0, 0]]
HELD = {1: {"fixed": True}, 2: {"moment_initial": (MOMENT, 0, 0)}}
ONCE = {"steps": 1, "frequencies": 3}


def group(width: float, beams: int = 16, **more: Any) -> dict[str, Any]:
    """A leaf along x with its width along y."""
    return {
        "elements": [1],
        "section": "rectangle",
        "dimensions": (width, 0.4e-3),
        "E": E,
        "nu": NU,
        "density": 7850,
        "orientation": (0, 1, 0),
        "beams": beams,
        "flexible": "all",
        "warping": True,
    } | more


def vlasov(width: float) -> tuple[float, float]:
    """Torsional stiffness of the leaf clamped at both ends, and with warping free [N m/rad]."""
    section = fx.Rectangle(width, 0.4e-3)
    GJ = E / (2 * (1 + NU)) * section.J
    half = np.sqrt(GJ / (E * section.Iw)) * LENGTH / 2
    return GJ / (1 - np.tanh(half) / half) / LENGTH, GJ / LENGTH


@pytest.mark.parametrize(("width", "tolerance"), [(25e-3, 2e-4), (50e-3, 3e-5), (100e-3, 1e-5)])
def test_a_leaf_is_as_stiff_in_torsion_as_vlasov_says(width: float, tolerance: float) -> None:
    held, free = vlasov(width)
    found = fx.flexure(NODES, [[1, 2]], HELD, [group(width)], ONCE)
    node = found.steps[0].node(2)
    assert node.compliance is not None
    assert MOMENT / node.axis_angle[1] == pytest.approx(held, rel=tolerance)
    assert 1 / node.compliance.matrix[3, 3] == pytest.approx(held, rel=tolerance)
    plain = fx.flexure(NODES, [[1, 2]], HELD, [group(width, warping=False)], ONCE)
    assert MOMENT / plain.steps[0].node(2).axis_angle[1] == pytest.approx(free, rel=1e-6)
    assert held > 1.1 * free


@pytest.mark.parametrize("second", [[3, 2], [2, 3]])
def test_two_elements_in_line_warp_as_one(second: list[int]) -> None:
    one = fx.flexure(NODES, [[1, 2]], HELD, [group(50e-3)], ONCE)
    places = [*NODES, [LENGTH / 2, 0, 0]]
    two = fx.flexure(places, [[1, 3], second], HELD, [group(50e-3, 8, elements=[1, 2])], ONCE)
    assert two.frequencies == pytest.approx(one.frequencies, rel=1e-8)
    assert two.steps[0].node(2).axis_angle[1] == pytest.approx(one.steps[0].node(2).axis_angle[1], rel=1e-9)


@pytest.mark.parametrize(
    ("places", "middle"),
    [
        ([*NODES, [LENGTH / 2, 0, 0]], {"inertia": (1e-9, 1e-9, 1e-9), "mass": 1e-6}),
        ([*NODES, [LENGTH / 2, 0, 0]], {"moment": (0, 0, 1e-6)}),
        ([[0, 0, 0], [LENGTH / 2, LENGTH / 2, 0], [LENGTH / 2, 0, 0]], {}),
    ],
    ids=["a body", "a moment", "a corner"],
)
def test_sections_stay_plane_where_something_else_holds_them(places: Any, middle: dict[str, Any]) -> None:
    leaves = group(20e-3, 2, elements=[1, 2], orientation=(0, 0, 1))
    m = fx.flexure_model(places, [[1, 3], [3, 2]], {1: {"fixed": True}, 3: middle}, [leaves])
    held = [node.name for node in m.nodes.values() if node.kind == "warping" and node.fixed.all()]
    assert held == [f"element {i} warping {end}" for i in (1, 2) for end in "pq"]
    line = fx.flexure_model([*NODES, [LENGTH / 2, 0, 0]], [[1, 3], [3, 2]], {1: {"fixed": True}}, [leaves])
    assert not line.nodes["warping 3"].fixed.any()


def test_a_guide_of_leaves_that_warp_is_released_as_before() -> None:
    nodes = [[0, 0, 0], [0, 0.1, 0], [0.06, 0.1, 0], [0.06, 0, 0]]
    leaves = group(25e-3, 2, elements=[1, 2], orientation=(0, 0, 1), flexible=[2, 3, 4])
    properties = {1: {"fixed": True}, 4: {"fixed": True}, 2: {"mass": 0.5, "force": (2, 0, 0)}}
    one, other = (
        fx.flexure(nodes, [[1, 2], [3, 4], [2, 3]], properties, [leaves | {"warping": w}], ONCE)
        for w in (True, False)
    )
    assert one.released == other.released and len(one.released) == 1
    assert one.steps[1].node(2).displacement == pytest.approx(other.steps[1].node(2).displacement, rel=1e-5)


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"warping": "yes"}, "element_properties row 1: warping 'yes' is neither True nor False"),
        ({"flexible": []}, "row 1: a rigid element does not warp; drop warping, or name flexible modes"),
        ({"flexible": [3, 4]}, "row 1: .*warping needs GJ; give torsion among the flexible modes"),
        ({"section": "circle", "dimensions": 1e-3}, r"row 1: .*\(Circle does not warp\) or drop warping"),
        (
            {"colour": "blue"},
            "element_properties row 1: look of 'element 1.*colour 'blue' is not of the form",
        ),
        ({"opacity": 7}, "element_properties row 1: .*opacity 7 is not between 0 and 1"),
        ({"hidden": 1}, "element_properties row 1: hidden 1 is neither True nor False"),
    ],
)
def test_bad_tables_are_refused(more: dict[str, Any], message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        fx.flexure_model(NODES, [[1, 2]], HELD, [group(50e-3, 2) | more])


def test_groups_have_colours_in_pictures() -> None:
    leaves = group(50e-3, 2, colour=(0.2, 0.4, 0.6), opacity=0.5)
    m = fx.flexure_model(NODES, [[1, 2]], HELD, [leaves])
    looks = [part.look for part in m.instances.values() if part.look]
    assert {(look.colour, look.opacity) for look in looks} == {("#336699", 0.5)}  # type: ignore[attr-defined]
    hidden = fx.flexure_model(NODES, [[1, 2]], HELD, [group(50e-3, 1, hidden=True)])
    assert hidden.instances["element 1"].look.hidden  # type: ignore[attr-defined]
