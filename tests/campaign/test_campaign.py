"""Random models of all families, held against all properties; see docs/verification.md."""

import secrets

import pytest

from campaign.run import run, table


def check(models: int, seed: int) -> None:
    found = run(models, seed)
    print(table(found))
    assert not found["failures"], table(found)
    assert found["models"] == models


def test_models_of_a_fixed_seed() -> None:
    check(200, 15)


@pytest.mark.campaign
def test_models_of_a_random_seed() -> None:
    check(5000, secrets.randbelow(10**6))
