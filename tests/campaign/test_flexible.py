"""The twins of flexible elements: errors in them are noticed, and a rope written as parts is the rope that was laid."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import flexel as fx
from campaign import beam_twins, contact_twins, rope_twins, tyre_twins
from campaign.case import Case, declared
from campaign.families import FAMILIES
from campaign.grammar_ropes import laid
from campaign.run import run
from flexel.model.part import Part

SLIGHTLY = 1 + 1e-6
WRONG: list[tuple[str, Any, str]] = [
    ("spatial beams", beam_twins, "bending"),
    ("spatial beams", beam_twins, "sections"),
    ("planar beams", beam_twins.PlanarBeam, "moment"),
    ("cables", rope_twins, "first"),
    ("cables", rope_twins.Cable, "kinetic"),
    ("ropes", contact_twins.RopeContact, "potential"),
    ("ropes", contact_twins, "on_arc"),
    ("tyres", tyre_twins, "pressed"),
    ("tyres", tyre_twins.Tyre, "rates"),
]


def scaled(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function with results that are slightly too large."""
    return lambda *args: SLIGHTLY * function(*args)


@pytest.mark.parametrize(("family", "owner", "name"), WRONG, ids=[f"{case[0]}-{case[2]}" for case in WRONG])
def test_a_twin_that_is_wrong_by_a_millionth_is_noticed(
    family: str, owner: Any, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(owner, name, scaled(getattr(owner, name)))
    found = run(2, 3, {family: FAMILIES[family]}, shrink=False)
    assert {failure["property"] for failure in found["failures"]} & {"accelerations", "stresses"}


def test_the_parts_of_a_rope_make_the_rope_that_is_laid() -> None:
    gravity = (0.0, -9.81)
    parts: list[Part[Any]] = [
        declared("point", "C", (0.0, 0.0), fixed=True),
        declared("angle", "S"),
        declared("body", "rim", "C", "S", mass=1.0, inertia=0.05),
        declared("sheave", "sheave", "C", "S", radius=0.2),
        *(declared("point", name, (x, -0.2)) for name, x in (("A", -0.2), ("B", 0.2))),
        *(declared("point_mass", f"mass {name}", name, 1.5) for name in "AB"),
    ]
    contact = fx.Contact(1e5, friction=0.3)
    data = {"EA": 900.0, "EI": 0.2, "mass_per_length": 0.5}
    path = ["A", ("sheave", -1), "B"]
    written = laid(gravity, parts, path, 8, contact=contact, radius=5e-3, tension=9.0, **data)
    by_parts = Case("", gravity, (*parts, *written)).model().build()
    m = Case("", gravity, tuple(parts)).model()
    m.rope("rope", path, 8, contact=fx.Contact(1e5, friction=0.3), radius=5e-3, tension=9.0, **data)
    as_laid = m.build()
    names = [name for name in as_laid.structure.coordinate_of if not name.startswith("C.")]
    a, b = (np.array([s.initial.acceleration(name) for name in names]) for s in (by_parts, as_laid))
    assert len(names) > 30
    assert a == pytest.approx(b, rel=1e-9, abs=1e-9 * np.max(np.abs(b)))
