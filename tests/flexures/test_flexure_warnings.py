"""What `fx.flexure` says of numbers in another unit, of coarse leaves and of broken ones: each once."""

import warnings
from typing import Any

import pytest

import flexel as fx

PLACES = [[0, 0, 0], [0, 0.1, 0], [0.06, 0.1, 0], [0.06, 0, 0]]


def guide(force: float = 5.0, **changes: Any) -> fx.Flexure:
    """A parallel guide of two leaf springs of eight beams."""
    leaf: dict[str, Any] = {
        "elements": [1, 3],
        "section": "rectangle",
        "dimensions": (25e-3, 0.4e-3),
        "material": "spring steel",
        "orientation": (0, 0, 1),
        "beams": 8,
        "flexible": [2, 3, 4],
    }
    leaf |= changes
    if "E" in changes:
        del leaf["material"]
    return fx.flexure(
        PLACES,
        [[1, 2], [2, 3], [3, 4]],
        {1: {"fixed": True}, 4: {"fixed": True}, 2: {"force": (force, 0, 0), "mass": 0.5}},
        [leaf],
        {"steps": 2},
    )


def said(force: float = 5.0, **changes: Any) -> list[str]:
    """The warnings of an analysis of the guide; each points at the line that calls it."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        guide(force, **changes)
    assert all(w.filename == __file__ for w in caught)
    return [f"{w.category.__name__}: {w.message}" for w in caught]


def test_an_ordinary_guide_gives_no_warning() -> None:
    assert said() == []


def test_a_modulus_in_gigapascals_is_one_line_for_all_beams() -> None:
    first, *_ = said(E=210.0, G=80.0, density=7800.0, force=0.0)
    assert first == (
        "ModelWarning: build: beams 'element 1 beam 1', 'element 1 beam 2' and 14 more: Young's modulus E = 210 Pa "
        "looks like another unit; steel has 210e9 Pa"
    )


def test_a_leaf_20_m_wide_is_named() -> None:
    (only,) = said(dimensions=(20.0, 0.4e-3))
    assert only.startswith(
        "ModelWarning: build: beams 'element 1 beam 1', 'element 1 beam 2' and 14 more: the section"
    )
    assert "in a model of 0.1" in only


def test_a_stress_beyond_the_strength_of_its_material_is_named_once() -> None:
    found = [line for line in said(60.0, beams=16) if "strength" in line]
    assert len(found) == 1
    assert found[0].startswith("ModelWarning: flexure: at step 2 the stress of 2.")
    assert found[0].endswith("exceeds the strength of its material, 1.1e+09 Pa")


def test_leaves_that_are_bent_too_far_are_named_once() -> None:
    found = [line for line in said(60.0, beams=4) if line.startswith("RangeWarning")]
    assert len(found) == 1 and "RangeWarning: flexure: 'element" in found[0]


def test_findings_of_many_beams_are_grouped_in_a_check() -> None:
    m = fx.Model()
    section = fx.Rectangle(0.3e-3, 20e-3)
    for i in range(17):
        m.point(f"P{i}", (0.01 * i, 0, 0), fixed=i == 0)
        m.frame(f"R{i}", fixed=i == 0)
    for i in range(16):
        ends = f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"
        m.beam(f"b{i}", *ends, section=section, material=fx.Material(E=210, rho=7850, nu=0.3))
    m.point("loose", (0, 0, 1))
    m.point("other", (0, 1, 0))
    found = [finding.message for finding in m.check().warnings]
    assert [line for line in found if "modulus" in line] == [
        "beams 'b0', 'b1' and 14 more: Young's modulus E = 210 Pa looks like another unit; steel has 210e9 Pa"
    ]
    assert "points 'loose', 'other' belong to no element; drop them, or connect them" in found


def test_the_line_that_builds_is_the_one_that_is_shown() -> None:
    m = fx.Model()
    m.point("A", (0, 0, 0))
    m.point_mass("mass", "A", 1.0)
    m.point("B", (1, 0, 0))
    with pytest.warns(fx.ModelWarning, match="build: point 'B' belongs to no element") as caught:
        m.build()
    assert [w.filename for w in caught] == [__file__]


@pytest.mark.filterwarnings("ignore:equilibrium. the one found:flexel.UnstableWarning")
def test_steps_without_buckling_loads_are_counted_with_the_first_reason() -> None:
    """A moment about a fixed axis has no potential in space."""
    leaf = {"elements": [1], "section": "circle", "dimensions": 1e-3, "material": "spring steel"}
    leaf |= {"orientation": (0, 1, 0), "beams": 4, "flexible": [2, 3, 4, 5, 6]}
    properties = {1: {"fixed": True}, 2: {"moment": (0.01, 0.0, 0.01)}}
    with pytest.warns(
        fx.IncompleteWarning, match=r"no buckling loads at \d of 3 steps, load .* no potential"
    ):
        fx.flexure([[0, 0, 0], [0.1, 0, 0]], [[1, 2]], properties, [leaf], {"steps": 2, "frequencies": 0})
