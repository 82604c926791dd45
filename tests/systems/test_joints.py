"""The models of the page on joints: what they leave free, and that the page names all of them."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from flexel.examples.joints import JOINTS, sketches

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGE = (DOCS / "joints.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", JOINTS)
def test_a_model_has_the_degrees_of_freedom_that_it_is_shown_with(name: str) -> None:
    """The named coordinates, all of them and no others, and it can be moved in each."""
    shown = JOINTS[name]
    m = shown.make()
    m.independent(*shown.free)
    for quantity, value in shown.moved.items():
        m.initial(quantity, value)
    s = m.build()
    assert s.dynamic == shown.free
    assert set(shown.moved) <= set(shown.free)
    for quantity, value in shown.moved.items():
        assert s.initial[quantity] == pytest.approx(value, rel=1e-12)
    assert sketches(name)


LAWFUL = [(name, free) for name, shown in JOINTS.items() for free in shown.free if not free.startswith("a")]


@pytest.mark.parametrize(("name", "free"), LAWFUL)
def test_friction_and_stops_act_on_every_free_coordinate_of_every_joint(name: str, free: str) -> None:
    limit, speed, high, stiffness = 3.0, 0.2, 0.05, 400.0
    for value, rate, force in (
        (0.0, 0.5, limit * 0.5 / np.hypot(0.5, speed)),
        (0.08, 0.0, stiffness * (0.08 - high)),
    ):
        m = JOINTS[name].make()
        m.independent(*JOINTS[name].free)
        m.friction(free, limit, speed)
        m.limits(free, -high, high, stiffness)
        m.initial(free, value, rate)
        assert m.build().initial.force(free) == pytest.approx(force, rel=1e-9)


def test_every_joint_is_on_the_page_with_a_picture() -> None:
    pictures = set(re.findall(r"images/joint_(\w+)\.png", PAGE))
    assert pictures == set(JOINTS)
    assert {path.stem.removeprefix("joint_") for path in (DOCS / "images").glob("joint_*.png")} == set(JOINTS)
    for name in JOINTS.keys() - {"bevel", "worm", "flat_cam"}:
        assert f"m.{name}(" in PAGE


def test_the_program_of_the_page_runs() -> None:
    """The piston runs over twice the crank; at its outer dead centre its acceleration is ω² r (1 + r/l)."""
    names: dict[str, Any] = {}
    exec(re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)[0], names)
    motion = names["motion"]
    assert names["s"].dynamic == ("shaft.angle",)
    assert motion["bore.along"].min() == pytest.approx(-0.2, abs=1e-5)
    assert motion.force("wrist.along")[0] == pytest.approx(2.0 * 100**2 * 0.1 * (1 + 0.1 / 0.3), rel=1e-9)
