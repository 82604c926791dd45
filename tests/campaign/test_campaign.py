"""Random models of all families, checked for all properties; see docs/verification.md.

The random seed is in the header of pytest; ``FLEXEL_CAMPAIGN_SEED=N`` repeats it.
"""

import os

import pytest

from campaign.run import run, table

PARTS = 10


def check(models: int, seed: int) -> None:
    found = run(models, seed)
    print(table(found))
    assert not found["failures"], table(found)
    assert found["models"] == models


def test_models_of_a_fixed_seed() -> None:
    check(200, 15)


@pytest.mark.campaign
@pytest.mark.parametrize("part", range(PARTS), ids=lambda part: f"part{part}")
def test_models_of_a_random_seed(part: int) -> None:
    check(5000 // PARTS, int(os.environ["FLEXEL_CAMPAIGN_SEED"]) * PARTS + part)
