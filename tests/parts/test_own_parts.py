"""Parts of users: their own subclasses, found by name, and what a model shows of its parts."""

from collections.abc import Sequence
from dataclasses import KW_ONLY
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from equal_values import assert_same_model

import flexel as fx
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.parts.beams import Beam
from flexel.parts.bodies import PointMass
from flexel.parts.nodes import Angle, Point
from flexel.parts.springs import Spring


@part
class Antenna(Part[Node]):
    """A flexible rod with a mass at its end, held by a spring."""

    name: str = entry("Of the antenna.")
    foot: Node | str = entry("Where it stands.")
    frame: Node | str = entry("What carries it.")
    _: KW_ONLY
    tip: Sequence[float] = array_quantity("m", "Where its end is.")
    EIz: float = quantity("N m²", "positive", "Bending stiffness.")
    mass: float = quantity("kg", "positive", "Of the end.")
    stay: float = quantity("N/m", "not negative", "Of the spring at the end.", default=0.0)

    def lower(self, to: Lowering) -> Node:
        """Add the end, the rod, the mass and the spring."""
        tip = Point(f"{self.name} tip", self.tip).lower(to)
        end = Angle(f"{self.name} angle").lower(to)
        Beam(self.name, self.foot, self.frame, tip, end, EA=1e6, EIz=self.EIz, mass_per_length=0.1).lower(to)
        PointMass(f"{self.name} mass", tip, self.mass).lower(to)
        if self.stay:
            Spring(f"{self.name} tip.y", self.stay).lower(to)
        return tip


def mast(**changes: Any) -> fx.Model:
    """An antenna on a wall."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.angle("wall", fixed=True)
    given: dict[str, Any] = {"tip": (1, 0), "EIz": 10.0, "mass": 0.2, "stay": 5.0}
    m.add(Antenna("antenna", "O", "wall", **(given | changes)))
    return m


def test_a_user_s_part_is_part_of_the_program_and_of_the_file(tmp_path: Path) -> None:
    m = mast()
    program = m.program()
    assert 'm.add(test_own_parts.Antenna("antenna", "O", "wall", ' in program.replace("\n    ", "")
    assert "import test_own_parts" in program.splitlines()
    names: dict[str, Any] = {}
    exec(program, names)
    assert_same_model(m, names["m"])
    loaded = fx.load(m.save(tmp_path / "model.json"))
    assert isinstance(loaded, fx.Model)
    assert_same_model(m, loaded)


def test_numbers_of_a_user_s_part_are_parameters() -> None:
    s = mast().build()
    assert s.parameters["antenna.stay"] == 5.0
    for name, value in {"EIz": 20.0, "mass": 0.3, "stay": 7.0, "tip": (1.1, 0.1)}.items():
        found = s.with_parameters({f"antenna.{name}": value})
        wanted = mast(**{name: value}).build()
        for own, other in (
            *zip(found.structure.instances, wanted.structure.instances, strict=True),
            *zip(found.structure.laws, wanted.structure.laws, strict=True),
        ):
            np.testing.assert_array_equal(own.p, other.p)
        for key in "MCK":
            np.testing.assert_array_equal(getattr(found.linearize(), key), getattr(wanted.linearize(), key))
    with pytest.raises(fx.ModelError, match="'antenna.stay'.*which nodes, elements or laws"):
        s.with_parameters({"antenna.stay": 0.0})
    with pytest.raises(fx.ModelError, match="antenna 'antenna': mass -1"):
        s.with_parameters({"antenna.mass": -1.0})


def test_messages_name_a_user_s_part() -> None:
    with pytest.raises(fx.ModelError, match="^antenna 'antenna': mass -1"):
        Antenna("antenna", "O", "wall", tip=(1, 0), EIz=1.0, mass=-1.0)
    with pytest.raises(fx.ModelError, match="^antenna 'antenna': EIz 'x'"):
        mast(EIz="x")


def test_a_class_that_cannot_be_imported_is_refused(tmp_path: Path) -> None:
    @part
    class Local(Part[None]):
        name: str = entry("Of it.")

        def lower(self, to: Lowering) -> None:
            to.node(self.name, "point", np.zeros(3), False)

    m = fx.Model()
    m.add(Local("here"))
    for write in (m.program, lambda: m.save(tmp_path / "model.json")):
        with pytest.raises(fx.ModelError, match="^local 'here': class .*Local cannot be imported by name"):
            write()
    assert not list(tmp_path.iterdir())


def test_a_model_shows_its_parts() -> None:
    m = mast()
    assert isinstance(m["antenna"], Antenna)
    assert m["antenna"].mass == 0.2
    assert [getattr(found, "name", None) for found in m.parts] == ["O", "wall", "antenna"]
    assert repr(m["antenna"]).startswith(
        "Antenna(name='antenna', foot='O', frame='wall', tip=(1, 0), EIz=10.0"
    )
    with pytest.raises(fx.ModelError, match="unknown part 'antena'.*antenna"):
        m["antena"]
    with pytest.raises(fx.ModelError, match="is not a part"):
        m.add("antenna")  # type: ignore[arg-type]


def test_nodes_are_kept_by_name() -> None:
    m = fx.Model()
    A, B = m.point("A", (0, 0), fixed=True), m.point("B", (1, 0))
    m.truss("bar", A, B)
    m.fix(A, "B.y")
    assert (m["bar"].p, m["bar"].q) == ("A", "B")  # type: ignore[attr-defined]
    assert m.parts[-1].names == ("A", "B.y")  # type: ignore[attr-defined]


def test_a_model_of_some_parts_is_the_model_without_the_others() -> None:
    m = mast()
    m.point_mass("rider", "antenna tip", 1.0)
    without = fx.Model.of(m.gravity, [found for found in m.parts if found is not m["rider"]])
    assert_same_model(without, mast())
    with pytest.raises(fx.ModelError, match="antenna tip"):
        fx.Model.of(m.gravity, [found for found in m.parts if found is not m["antenna"]])


def test_a_refusal_leaves_the_model_as_it_was() -> None:
    m = mast()
    before, parts = mast(), m.parts
    refused = (
        lambda: m.add(Antenna("second", "O", "wall", tip=(1, 0, 0), EIz=1.0, mass=1.0)),
        lambda: m.add(Antenna("second", "O", "wall", tip=(1, 0), EIz=1.0, mass=1.0, stay=[1.0])),  # type: ignore[arg-type]
        lambda: m.add(Antenna("antenna", "O", "wall", tip=(1, 0), EIz=1.0, mass=1.0)),
        lambda: m.point("O", (0, 0)),
        lambda: m.initial("antenna tip.x", "x"),  # type: ignore[arg-type]
        lambda: m.fix("antenna tip", "nowhere"),
        lambda: m.release("antenna.bend1", "nowhere.bend1"),
        lambda: m.prescribe("nowhere.x", 1.0),
        lambda: m.rigid_body("O", (0, 0), mass=1.0, inertia=1.0),
    )
    for number, call in enumerate(refused):
        with pytest.raises(fx.ModelError):
            call()
            pytest.fail(f"call {number} was accepted")
        assert m.parts == parts
        assert_same_model(m, before)
    m.add(Antenna("second", "O", "wall", tip=(1, 0), EIz=1.0, mass=1.0))  # its names are free


def test_what_the_caller_changes_afterwards_changes_nothing() -> None:
    place, tip, quadratic = np.array([0.5, 0.5]), [1.0, 0.0], [[1.0, 0.0], [0.0, 2.0]]
    terms, breaks = {"A.x": 1.0, "A.y": -1.0}, [0.07]
    m = mast(tip=tip)
    m.point("A", place)
    m.point_mass("a", "A", 1.0)
    m.spring(["A.x", "A.y"], quadratic)
    m.spring("A.x", fx.Curve([[0, 3e4], [-700.0, 4e4]], breaks=breaks))
    m.relation("line", terms)
    program = m.program()
    place[:] = 7.0
    tip[0] = 7.0
    quadratic[0][0] = 7.0
    breaks[0] = 0.5
    terms["A.x"] = 7.0
    assert m.program() == program
    with pytest.raises(ValueError, match="read-only"):
        m["A"].position[0] = 7.0  # type: ignore[attr-defined]


def test_nested_lists_in_tuples_are_copied() -> None:
    inner = [1.0, 0.0]
    m = fx.Model()
    m.cable_line("line", ([0.0, 0.0], inner), 2, EA=1e3, EI=1.0, mass_per_length=0.1)
    program = m.program()
    inner[0] = 7.0
    assert m.program() == program
