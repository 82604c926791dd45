"""Declaring beams that warp: nodes, sections, mistakes; the sections' warping constants and shear centres."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.engine.single import law_stiffness

LEAF = fx.Rectangle(20e-3, 0.3e-3)
NUMBERS = {"EA": 1e6, "GJ": 10.0, "EIy": 5.0, "EIz": 20.0, "EIw": 1e-3}


def model() -> fx.Model:
    m = fx.Model()
    m.point("P", (0, 0, 0), fixed=True)
    m.point("Q", (0.5, 0, 0))
    m.frame("R", fixed=True)
    m.frame("S")
    m.warping("V", fixed=True)
    m.warping("W")
    return m


def beam(**options: Any) -> fx.Model:
    m = model()
    m.beam("b", "P", "R", "Q", "S", direction=(0, 1, 0), **options)
    return m


@pytest.mark.filterwarnings("ignore:build.*'W' belongs to no element:flexel.ModelWarning")
def test_warping_true_makes_two_free_nodes() -> None:
    m = beam(warping=True, **NUMBERS)
    assert m.instances["b"].nodes[4:] == ("b_warping_p", "b_warping_q")
    assert not m.nodes["b_warping_p"].fixed.any()
    assert m.nodes["b_warping_p"].coordinates == ("b_warping_p.twist",)
    assert m.build().counts["degrees_of_freedom"] == 8 + 1  # and W, which nothing needs: 9 independent


def test_the_laws_are_those_of_the_plain_beam_and_one_of_warping() -> None:
    plain = beam(**{key: k for key, k in NUMBERS.items() if key != "EIw"})
    warping = beam(warping=("V", "W"), damping=0.1, **NUMBERS)
    assert [law.deformations for law in warping.laws[:-1]] == [law.deformations for law in plain.laws]
    for one, other in zip(plain.laws, warping.laws, strict=False):
        assert (one.spec, one.parameters | {"damping": 0.1}) == (other.spec, other.parameters)
    assert warping.laws[-1].deformations == ("b.warp1", "b.warp2")
    K = law_stiffness(
        warping.laws[-1].spec, {key: float(v[0]) for key, v in warping.laws[-1].parameters.items()}
    )
    l0 = 0.5
    GJ, EIw = NUMBERS["GJ"], NUMBERS["EIw"]
    expected = [GJ * c / (30 * l0**3) + EIw * d / l0**5 for c, d in ((4, 4), (-1, 2), (-1, 2), (4, 4))]
    np.testing.assert_allclose(K.ravel(), expected)


def test_the_polar_radius_is_that_of_the_section() -> None:
    def polar(given: Mapping[str, Any]) -> Any:
        return (given["EIy"] + given["EIz"]) / given["EA"]

    assert polar(beam(warping=True, **NUMBERS).instances["b"].parameters) == pytest.approx(25e-6)
    named = beam(warping=True, section=LEAF, material="steel").instances["b"].parameters
    assert polar(named) == pytest.approx((20e-3**2 + 0.3e-3**2) / 12)
    assert named["rhoIw"] == pytest.approx(7850.0 * LEAF.Iw)


def test_a_beam_without_warping_is_declared_as_before() -> None:
    m = beam(section=LEAF, material="steel")
    assert m.instances["b"].spec.name == "beam"
    assert "b.warp1" not in [name for law in m.laws for name in law.deformations]


STEEL = {"material": "steel"}


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (NUMBERS, ("EIw has no effect without warping", "drop it")),
        ({"EA": 1.0, "warping_inertia_per_length": 1.0}, ("warping_inertia_per_length has no effect",)),
        ({"warping": True, "rigid": True}, ("a rigid beam has no warping",)),
        ({"warping": True, "second_order": False, **NUMBERS}, ("a first-order beam has no warping",)),
        ({"warping": True, "EA": 1.0, "GJ": 1.0}, ("needs EIw", "give it, or a section")),
        ({"warping": True, "EIw": 1.0}, ("needs GJ",)),
        ({"warping": True, "EA": 1.0}, ("needs GJ and EIw", "give them")),
        ({"warping": True, "section": fx.Circle(0.01), **STEEL}, ("needs EIw", "Circle does not warp")),
        ({"warping": True, "section": LEAF, "flexible": ["elongation"], **STEEL}, ("needs GJ", "torsion among")),
        ({"warping": True, "section": fx.UBeam(0.1, 0.05, 0.005, 0.005), **STEEL}, ("shear centre of UBeam",)),
        ({"warping": True, "section": fx.LBeam(0.1, 0.05, 0.005), **STEEL}, ("shear centre of LBeam",)),
        ({"warping": True, "section": fx.WireRope(0.01), **STEEL}, ("no Iw and shear_centre", "add these")),
        ({"warping": ("V",), **NUMBERS}, ("neither True nor two nodes", "m.warping")),
        ({"warping": 3, **NUMBERS}, ("neither True nor two nodes",)),
        ({"warping": ("V", "V"), **NUMBERS}, ("both ends have the warping node 'V'",)),
        ({"warping": ("V", "S"), **NUMBERS}, ("'S' is a frame", "it needs a warping")),
        ({"warping": ("V", "X"), **NUMBERS}, ("'X'",)),
        ({"warping": True, "section": LEAF, "EIw": 1.0, **STEEL}, ("already give EIw",)),
        (
            {"warping": True, "section": LEAF, "warping_inertia_per_length": 1.0, **STEEL},
            ("already give warping_inertia_per_length",),
        ),
        ({"warping": True, **NUMBERS, "EIw": -1.0}, ("EIw -1",)),
        ({"warping": True, "warping_inertia_per_length": -1.0, **NUMBERS}, ("warping_inertia_per_length",)),
    ],
)  # fmt: skip
def test_a_mistake_is_named_with_its_remedy_and_leaves_the_model_as_it_was(
    options: dict[str, Any], words: tuple[str, ...]
) -> None:
    m = model()
    before = list(m.nodes), list(m.instances), list(m.laws)
    with pytest.raises(fx.ModelError, match="beam 'b'") as error:
        m.beam("b", "P", "R", "Q", "S", direction=(0, 1, 0), **options)
    for word in words:
        assert word in str(error.value)
    assert (list(m.nodes), list(m.instances), list(m.laws)) == before


def test_planar_and_three_node_beams_do_not_warp() -> None:
    m = fx.Model()
    m.point("P", (0, 0), fixed=True)
    m.angle("R", fixed=True)
    m.point("Q", (1, 0))
    m.angle("S")
    with pytest.raises(fx.ModelError, match="a planar beam has no warping"):
        m.beam("b", "P", "R", "Q", "S", EA=1.0, EIz=1.0, warping=True)
    with pytest.raises(fx.ModelError, match="a rigid beam has no warping"):
        model().beam("b", "P", "R", "Q", warping=True)


def test_a_warping_coordinate_takes_neither_springs_nor_follower_loads() -> None:
    m = beam(warping=("V", "W"), **NUMBERS)
    with pytest.raises(fx.ModelError, match="cannot carry springs; make it a deformation by m.relation"):
        m.spring("W.twist", 1.0)
    with pytest.raises(fx.ModelError, match="a bimoment has no direction"):
        m.load("W", 1.0, follower=True)
    with pytest.raises(fx.ModelError, match="'W' has no coordinate 'x'; it has twist"):
        m.fix("W.x")


@pytest.mark.filterwarnings("ignore:build.*'W' belongs to no element:flexel.ModelWarning")
def test_a_distributed_load_acts_on_the_points_and_frames() -> None:
    plain, warping = (
        beam(**{key: k for key, k in NUMBERS.items() if w or key != "EIw"}, **w)
        for w in ({}, {"warping": True})
    )
    found = []
    for m in (plain, warping):
        m.distributed_load("b", (0.0, 0.0, 2.0))
        found.append(m.build().equilibrium().position("Q"))
    assert found[0] == pytest.approx(found[1], rel=1e-9)


def test_units_of_warping() -> None:
    motion = beam(warping=("V", "W"), mass_per_length=1.0, inertia_per_length=(1e-3,) * 3, **NUMBERS)
    state = motion.build().simulate(0.001, samples=2, progress=False)
    assert (state.unit("W.twist"), state.unit("force:V.twist")) == ("rad/m", "N m²")
    assert state.unit("b.warp1") == "m"
