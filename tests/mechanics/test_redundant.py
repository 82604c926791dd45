"""Reports of redundant constraints list every release that is as good: every rigid deformation is tried."""

from collections.abc import Callable

import numpy as np
import pytest

import flexel as fx

LENGTH = 0.1


def four_bar() -> fx.Model:
    """A planar four-bar linkage of bodies in space: its four parallel hinges are three conditions too many."""
    m = fx.Model()
    places = {"crank": (0.0, 0.5, 0.0), "coupler": (1.0, 1.0, 0.0), "rocker": (2.0, 0.5, 0.0)}
    m.rigid_body("base", (1, -1, 0), fixed=True)
    for name, x in places.items():
        m.rigid_body(name, x, mass=1.0, inertia=np.eye(3))
    ends = ("base", "crank", "coupler", "rocker", "base")
    for name, p, q, at in zip(
        "abcd", ends, ends[1:], ((0, 0, 0), (0, 1, 0), (2, 1, 0), (2, 0, 0)), strict=False
    ):
        m.revolute(name, p, q, at=at, axis=(0, 0, 1))
    return m


def cardan_shaft() -> fx.Model:
    """Two shafts in bearings and a shaft with a universal joint at each end, bent alike: one condition too many."""
    m = fx.Model()
    m.rigid_body("base", (0, 0, -1), fixed=True)
    lean = np.array([np.cos(0.3), 0.0, np.sin(0.3)])
    ends = np.array([[0.0, 0, 0], lean])
    m.rigid_body("input", (-0.5, 0, 0), mass=1.0, inertia=np.eye(3))
    m.rigid_body("shaft", lean / 2, mass=1.0, inertia=np.eye(3))
    m.rigid_body("output", lean + [0.5, 0, 0], mass=1.0, inertia=np.eye(3))
    m.revolute("in", "base", "input", at=(-0.5, 0, 0), axis=(1, 0, 0))
    m.revolute("out", "base", "output", at=lean + [0.5, 0, 0], axis=(1, 0, 0))
    across = np.array([-np.sin(0.3), 0, np.cos(0.3)])
    m.universal("first", "input", "shaft", at=ends[0], axis_p=(0, 1, 0), axis_q=across)
    m.universal("second", "output", "shaft", at=ends[1], axis_p=(0, 1, 0), axis_q=across)
    return m


def parallel_guide() -> fx.Model:
    """A stage on two parallel leaf springs: they repeat one in-plane bending."""
    m = fx.Model()
    m.point("S", (LENGTH, 0, 0))
    m.frame("R")
    for name, y in (("a", -0.02), ("b", 0.02)):
        m.point(f"{name}0", (0, y, 0), fixed=True)
        m.frame(f"{name}f", fixed=True)
        m.point(f"{name}1", (LENGTH, y, 0))
        ends = (f"{name}0", f"{name}f", f"{name}1", "R")
        m.beam(
            name,
            *ends,
            direction=(0, 1, 0),
            section=fx.Rectangle(0.3e-3, 20e-3),
            material="steel",
            flexible=["torsion", "bend3", "bend4"],
        )
        m.beam(f"{name} arm", "S", "R", f"{name}1")
    return m


CLASSICS: dict[str, tuple[Callable[[], fx.Model], int]] = {
    "four-bar": (four_bar, 3),
    "cardan shaft": (cardan_shaft, 1),
    "parallel guide": (parallel_guide, 1),
}


def redundancies(make: Callable[[], fx.Model], released: list[str]) -> int:
    m = make()
    m.release(*released)
    return len(m.constraint_report().redundant)


@pytest.mark.parametrize(("make", "count"), CLASSICS.values(), ids=CLASSICS)
def test_exactly_the_listed_conditions_can_take_the_place_of_a_release(
    make: Callable[[], fx.Model], count: int
) -> None:
    found = make().constraint_report()
    assert len(found.release) == count and list(found.alternatives) == found.release
    elements = [instance for instance in make().instances.values() if not instance.name.endswith("arm")]
    rigid = [
        f"{element.name}.{d.name}" for element in elements for d in element.spec.deformations if not d.free
    ]
    for name in found.release:
        others = [other for other in found.release if other != name]
        assert redundancies(make, others) == 1
        for candidate in [condition for condition in rigid if condition not in found.release]:
            good = redundancies(make, [*others, candidate]) == 0
            assert good == (candidate in found.alternatives[name]), (name, candidate)


def test_the_report_and_the_check_print_them() -> None:
    m = parallel_guide()
    line = "alternatives to 'a.bend2': 'a.bend1', 'b.bend1', 'b.bend2'"
    assert line in str(m.constraint_report())
    assert line in str(m.check())


def test_joints_are_released_before_the_arms_of_bodies() -> None:
    assert [name for name in cardan_shaft().constraint_report().release if "link" in name] == []


def test_a_mechanism_without_redundancy_has_no_alternatives() -> None:
    m = parallel_guide()
    m.release("a.bend2")
    assert m.constraint_report().alternatives == {}
