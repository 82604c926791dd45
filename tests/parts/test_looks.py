"""m.look: sections and colours of elements in pictures, without effect on the mechanics."""

import pickle
from pathlib import Path
from typing import Any

import pytest

import flexel as fx
from flexel.apps.view import drawing
from flexel.apps.view.page import scene_data
from flexel.apps.view.scene import draw
from flexel.parts.looks import Look


def crane() -> fx.Model:
    """A leaf that carries a bar on a spring, with a mass and a hinge."""
    m = fx.Model()
    m.point("A", (0, 0, 0), fixed=True)
    m.frame("RA", fixed=True)
    m.point("B", (1, 0, 0))
    m.frame("RB")
    m.frame("RC")
    m.beam("leaf", "A", "RA", "B", "RB", EIy=10, EIz=20, direction=(0, 1, 0), mass_per_length=1.0)
    m.hinge("pin", "RB", "RC", axis=(0, 0, 1))
    m.rotary_inertia("J", "RC", (0.1, 0.1, 0.1, 0.0, 0.0, 0.0))
    m.point("C", (1, 1, 0))
    m.fix("C.x", "C.z")
    m.truss("bar", "B", "C")
    m.spring("bar.elongation", stiffness=1e3)
    m.point_mass("load", "C", 1.0)
    return m


def shapes(m: fx.Model, name: str) -> list[drawing.Shape]:
    """The shapes of an element as drawn."""
    return [shape for shape in drawing.shapes(m.build().initial) if shape.name == name]


def test_a_section_and_a_colour_are_drawn() -> None:
    m = crane()
    (before,) = shapes(m, "leaf")
    assert before.outline is None and before.colour is None
    m.look("leaf", section=fx.Rectangle(0.1, 0.02), colour=(0.8, 0.1, 0.1))
    (leaf,) = shapes(m, "leaf")
    assert leaf.outline is not None and leaf.outline.max(axis=0) == pytest.approx([0.05, 0.01])
    assert (leaf.colour, leaf.opacity) == ("#cc1a1a", 1.0)
    assert [shape.style for shape in shapes(m, "bar")] == ["spring"]
    m.look("bar", section=fx.Circle(0.05))
    (bar,) = shapes(m, "bar")
    assert bar.style == "bar" and bar.outline is not None and bar.outline.max() == pytest.approx(0.025)


def test_what_is_said_later_changes_what_was_said_before() -> None:
    m = crane()
    m.look(["leaf", "bar"], colour="#0b5fa5", opacity=0.5)
    m.look("leaf", opacity=0.25)
    assert m.instances["leaf"].look == Look(None, "#0b5fa5", 0.25, None)
    assert m.instances["bar"].look == Look(None, "#0b5fa5", 0.5, None)
    m.look("pin", hidden=True)
    assert shapes(m, "pin") == []
    m.look("pin", hidden=False, colour="#ff0000")
    assert [shape.colour for shape in shapes(m, "pin")] == ["#ff0000"]


def test_the_mechanics_does_not_know_of_it() -> None:
    plain, shown = crane(), crane()
    shown.look("leaf", section=fx.Rectangle(0.1, 0.02))
    one, other = (model.build().equilibrium() for model in (plain, shown))
    assert (one.x == other.x).all()
    with pytest.raises(fx.ModelError, match="section"):
        other.stress("leaf")


def test_it_is_kept_in_files_and_pickles(tmp_path: Path) -> None:
    m = crane()
    m.look("leaf", section=fx.Rectangle(0.1, 0.02), colour="#0b5fa5", opacity=0.5)
    m.look("load", hidden=True)
    motion = m.build().simulate(0.01, samples=2)
    motion.save(tmp_path / "crane.npz")
    for structure in (
        fx.load(tmp_path / "crane.npz").structure,
        pickle.loads(pickle.dumps(motion)).structure,
    ):
        kept = {instance.name: instance.look for instance in structure.instances}
        assert kept["leaf"] == m.instances["leaf"].look
        assert kept["load"] == Look(hidden=True) and kept["bar"] is None


def test_the_viewer_and_the_plots_have_it() -> None:
    m = crane()
    m.look("leaf", section=fx.Rectangle(0.1, 0.02), colour="#0b5fa5", opacity=0.5)
    m.look("bar", colour="#123456")
    motion = m.build().simulate(0.01, samples=2)
    parts = {
        shape["name"]: shape
        for shape in scene_data(motion)["shapes"]
        if shape["style"] in ("beam", "bar", "spring")
    }
    assert (parts["leaf"]["colour"], parts["leaf"]["opacity"]) == ("#0b5fa5", 0.5)
    assert parts["bar"]["colour"] == "#123456" and "opacity" not in parts["bar"]
    axes = draw(motion[0])
    drawn = [
        (tuple(collection.get_edgecolor()[0][:3]), collection.get_alpha()) for collection in axes.collections
    ]
    assert ((0x0B / 255, 0x5F / 255, 0xA5 / 255), 0.5) in drawn
    assert ((0x12 / 255, 0x34 / 255, 0x56 / 255), 1.0) in drawn


@pytest.mark.parametrize(
    ("elements", "given", "message"),
    [
        ("leav", {"hidden": True}, "look: .*'leav'.*leaf"),
        ([], {"hidden": True}, "look: elements is an empty list; give names"),
        (3, {"hidden": True}, "look: elements: 3 is not a list of names"),
        ("A", {"hidden": True}, "look: .*'A'"),
        ("leaf", {}, "look of 'leaf': no property is given; give section=, colour=, opacity= or hidden="),
        ("leaf", {"colour": "red"}, "look of 'leaf': colour 'red' is not of the form '#rrggbb'"),
        ("leaf", {"colour": (255, 0, 0)}, "colour .* is not red, green and blue from 0 to 1"),
        ("leaf", {"colour": (0.5, 0.5)}, "colour .* is not red, green and blue"),
        ("leaf", {"opacity": 2}, "opacity 2 is not between 0 and 1"),
        ("leaf", {"opacity": "half"}, "opacity 'half' is not"),
        ("leaf", {"hidden": "yes"}, "hidden 'yes' is neither True nor False"),
        ("leaf", {"section": 0.1}, "look of 'leaf': 0.1 is not a section; give Rectangle"),
        (
            "pin",
            {"section": fx.Circle(0.1)},
            "look of 'pin': a hinge is not drawn as a line and has no section",
        ),
        (["leaf", "pin"], {"section": fx.Circle(0.1)}, "look of 'pin': a hinge is not drawn as a line"),
    ],
)
def test_bad_looks_are_refused_and_change_nothing(elements: Any, given: Any, message: str) -> None:
    m = crane()
    with pytest.raises(fx.ModelError, match=message):
        m.look(elements, **given)
    assert all(instance.look is None for instance in m.instances.values())
