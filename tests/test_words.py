"""The page of other fields' words names what exists, and links to pages that exist."""

import re
from pathlib import Path

import flexel as fx

PAGE = Path(__file__).parents[1] / "docs" / "words.md"
OWNERS = {
    "m": fx.Model,
    "s": fx.System,
    "lin": fx.Linearization,
    "motion": fx.Motion,
    "state": fx.State,
    "fx": fx,
}


def test_all_that_is_named_exists() -> None:
    names = re.findall(r"`(m|s|lin|motion|state|fx)\.(\w+)", PAGE.read_text(encoding="utf-8"))
    assert len(names) > 50
    known = {key: {*dir(owner), *getattr(owner, "__dataclass_fields__", {})} for key, owner in OWNERS.items()}
    assert [f"{owner}.{name}" for owner, name in names if name not in known[owner]] == []


def test_the_words_that_people_looked_for_are_there() -> None:
    text = PAGE.read_text(encoding="utf-8")
    for word in (
        "backlash",
        "bushing",
        "PSD",
        "FMU",
        "Simulink",
        "eigenfrequency",
        "anti-roll bar",
        "luffing",
    ):
        assert word in text
