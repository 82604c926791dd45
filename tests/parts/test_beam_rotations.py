"""The option `rotations` of beams and leaf springs: what it makes, what it refuses, what else works with it."""

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.apps.view.drawing import shapes

BEAM = {"EA": 50.0, "GJ": 2.0, "EIy": 3.0, "EIz": 5.0}
PLANAR = {"EA": 50.0, "EIz": 5.0, "GAy": 20.0}


def model(planar: bool) -> fx.Model:
    m = fx.Model()
    m.point("P", (0, 0) if planar else (0, 0, 0), fixed=True)
    m.point("Q", (1, 0) if planar else (1, 0, 0))
    for name, fixed in (("R", True), ("S", False)):
        (m.angle if planar else m.frame)(name, fixed=fixed)
    return m


def beam(planar: bool, rotations: str = "logarithmic", **more: Any) -> fx.Model:
    m = model(planar)
    options = PLANAR if planar else {"direction": (0, 1, 0), **BEAM}
    m.beam("b", "P", "R", "Q", "S", rotations=rotations, **options, **more)
    return m


@pytest.mark.parametrize(("planar", "prefix"), [(True, "planar_"), (False, "")])
def test_the_classic_beam_is_the_default(planar: bool, prefix: str) -> None:
    m = model(planar)
    m.beam("b", "P", "R", "Q", "S", **({"EIz": 1.0} if planar else {"direction": (0, 1, 0), **BEAM}))
    assert m.instances["b"].spec.name == f"{prefix}beam" == beam(planar, "classic").instances["b"].spec.name
    assert beam(planar).instances["b"].spec.name == f"{prefix}beam_logarithmic"


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"rotations": "logaritmic"}, ("unknown rotations= 'logaritmic'", "did you mean logarithmic?")),
        ({"rotations": 3}, ("unknown rotations= '3'", "classic, logarithmic")),
        ({"second_order": False}, ("a first-order beam has no logarithmic rotations", "second-order terms")),
        (
            {"warping": True, "EIw": 1.0},
            ("a beam with warping has no logarithmic rotations", "drop rotations="),
        ),
        (dict.fromkeys(BEAM) | {"rigid": True}, ("a rigid beam has no logarithmic rotations",)),
    ],
)
def test_a_mistake_is_named_with_its_remedy_and_leaves_the_model_as_it_was(
    options: dict[str, Any], words: tuple[str, ...]
) -> None:
    m = model(planar=False)
    before = list(m.nodes), list(m.instances), list(m.laws)
    with pytest.raises(fx.ModelError, match="beam 'b'") as error:
        m.beam(
            "b", "P", "R", "Q", "S", **{"direction": (0, 1, 0), "rotations": "logarithmic", **BEAM, **options}
        )
    for word in words:
        assert word in str(error.value)
    assert (list(m.nodes), list(m.instances), list(m.laws)) == before


def test_a_three_node_beam_has_no_logarithmic_rotations() -> None:
    with pytest.raises(fx.ModelError, match="beam 'b': a rigid beam has no logarithmic rotations"):
        model(planar=True).beam("b", "P", "R", "Q", rotations="logarithmic")


def test_leaf_springs_hand_the_option_to_their_beams() -> None:
    m = model(planar=False)
    leaf = {
        "section": fx.Rectangle(0.3e-3, 20e-3),
        "material": "steel",
        "elements": 2,
        "direction": (0, 1, 0),
    }
    names = m.leaf_spring("leaf", "P", "R", "Q", "S", rotations="logarithmic", **leaf)
    assert {m.instances[name].spec.name for name in names} == {"beam_logarithmic"}


@pytest.mark.filterwarnings("ignore:.*small beside the model")
@pytest.mark.parametrize("planar", [True, False])
def test_a_beam_is_drawn_loaded_along_its_length_saved_and_pickled_as_the_classic_one(
    planar: bool, tmp_path: Path
) -> None:
    """The deflections under a small load per length are equal, so are the pictures; files and copies keep them."""
    ends, drawn = [], []
    for rotations in ("classic", "logarithmic"):
        m = beam(planar, rotations, mass_per_length=1.0)
        m.distributed_load("b", (0, 1e-6) if planar else (0, 1e-6, 2e-6))
        s = pickle.loads(pickle.dumps(m.build()))
        state = s.equilibrium()
        ends.append(state.position("Q"))
        drawn.append(
            [(shape.style, shape.name, [np.shape(line) for line in shape.lines]) for shape in shapes(state)]
        )
        motion = s.simulate(0.01)
        motion.save(tmp_path / f"{rotations}.npz")
        assert np.array_equal(fx.load(tmp_path / f"{rotations}.npz").x, motion.x)
    assert np.max(np.abs(ends[0] - ends[1])) < 1e-12
    assert drawn[0] == drawn[1]
