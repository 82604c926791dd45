"""The twins of flexible elements: errors in them are noticed, and a rope written as calls is the rope that was laid."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import flexel as fx
from campaign import beam_twins, contact_twins, rope_twins, tyre_twins
from campaign.calls import Call, Case, Made, call
from campaign.families import FAMILIES
from campaign.grammar_ropes import laid
from campaign.run import run

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


@pytest.mark.parametrize(("family", "owner", "name"), WRONG, ids=[f"{z[0]}-{z[2]}" for z in WRONG])
def test_a_twin_that_is_wrong_by_a_millionth_is_noticed(
    family: str, owner: Any, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(owner, name, scaled(getattr(owner, name)))
    found = run(2, 3, {family: FAMILIES[family]}, shrink=False)
    assert {z["property"] for z in found["failures"]} & {"accelerations", "stresses"}


def test_the_calls_of_a_rope_make_the_rope_that_is_laid() -> None:
    gravity = (0.0, -9.81)
    calls: list[Call] = [
        call("point", "C", (0.0, 0.0), fixed=True),
        call("angle", "S"),
        call("body", "rim", "C", "S", mass=1.0, inertia=0.05),
        call("sheave", "sheave", "C", "S", radius=0.2),
        *(call("point", name, (x, -0.2)) for name, x in (("A", -0.2), ("B", 0.2))),
        *(call("point_mass", f"mass {name}", name, 1.5) for name in "AB"),
    ]
    contact = Made("Contact", (1e5,), {"friction": 0.3})
    data = {"EA": 900.0, "EI": 0.2, "mass_per_length": 0.5}
    path = ["A", ("sheave", -1), "B"]
    written = laid(gravity, calls, path, 8, contact=contact, radius=5e-3, tension=9.0, **data)
    by_calls = Case("", gravity, (*calls, *written)).model().build()
    m = Case("", gravity, tuple(calls)).model()
    m.rope("rope", path, 8, contact=fx.Contact(1e5, friction=0.3), radius=5e-3, tension=9.0, **data)
    as_laid = m.build()
    names = [z for z in as_laid.structure.coordinate_of if not z.startswith("C.")]
    a, b = (np.array([s.initial.acceleration(z) for z in names]) for s in (by_calls, as_laid))
    assert len(names) > 30
    assert a == pytest.approx(b, rel=1e-9, abs=1e-9 * np.max(np.abs(b)))
