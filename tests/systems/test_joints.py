"""The models of the page on joints: what they leave free, and that the page names all of them."""

import re
from pathlib import Path
from typing import Any

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


def test_every_joint_is_on_the_page_with_a_picture() -> None:
    pictures = set(re.findall(r"images/joint_(\w+)\.png", PAGE))
    assert pictures == set(JOINTS)
    assert {z.stem.removeprefix("joint_") for z in (DOCS / "images").glob("joint_*.png")} == set(JOINTS)
    for name in JOINTS.keys() - {"bevel", "worm", "flat_cam"}:
        assert f"m.{name}(" in PAGE


def test_the_program_of_the_page_runs() -> None:
    """The piston runs over twice the crank; at its outer dead centre its acceleration is ω² r (1 + r/l)."""
    names: dict[str, Any] = {}
    for block in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
        exec(block, names)
    motion = names["motion"]
    assert names["s"].dynamic == ("shaft.angle",)
    assert motion["bore.along"].min() == pytest.approx(-0.2, abs=1e-5)
    assert motion.force("wrist.along")[0] == pytest.approx(2.0 * 100**2 * 0.1 * (1 + 0.1 / 0.3), rel=1e-9)
