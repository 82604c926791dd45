"""Random models of all families, checked for all properties; see docs/verification.md.

The random seed is in the header of pytest; ``FLEXEL_CAMPAIGN_SEED=N`` repeats it.
"""

import os
from typing import Any

import pytest

from campaign.families import FAMILIES
from campaign.properties import PROPERTIES
from campaign.run import run, table

PARTS = 10


def check(models: int, seed: int) -> dict[str, Any]:
    found = run(models, seed)
    print(table(found))
    assert not found["failures"], table(found)
    assert found["models"] == models
    return found


@pytest.mark.long
def test_models_of_a_fixed_seed() -> None:
    """Four of each family; together they show every property."""
    found = check(4 * len(FAMILIES), 15)
    assert found["families"] == dict.fromkeys(sorted(FAMILIES), 4)
    assert {entry["name"] for entry in found["properties"]} == {check.name for check in PROPERTIES}


@pytest.mark.campaign
@pytest.mark.parametrize("part", range(PARTS), ids=lambda part: f"part{part}")
def test_models_of_a_random_seed(part: int) -> None:
    check(5000 // PARTS, int(os.environ["FLEXEL_CAMPAIGN_SEED"]) * PARTS + part)
