"""What small works cost is what tools/cost.json says, to 5 %; a work that grew is named with its functions."""

from dataclasses import replace

import cost
import pytest


def test_no_work_costs_more_than_it_did() -> None:
    if reason := cost.locked():
        pytest.skip(reason)
    before, found = cost.kept(), cost.measured()
    assert before.keys() == found.keys()
    lines = [line for name in found for line in cost.changed(name, found[name], before[name])]
    assert not lines, "\n".join(lines)


def test_what_grew_is_named() -> None:
    kept = cost.Cost(100, 200, 10, {"flexel.a": 60, "flexel.b": 40})
    assert cost.changed("work", kept, kept) == []
    more = replace(kept, own=106, functions={"flexel.a": 60, "flexel.b": 46})
    assert cost.changed("work", more, kept) == ["work: own 100 → 106; flexel.b (+6)"]
    assert cost.changed("work", replace(kept, evaluations=11), kept)[0].startswith(
        "work: evaluations 10 → 11"
    )
    less = replace(kept, others=150)
    assert cost.changed("work", less, kept) == ["work: others only 150 for 200: python tools/cost.py --write"]
