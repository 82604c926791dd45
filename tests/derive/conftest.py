"""What tests of definitions share."""

import random

import pytest
from element_numbers import named

from flexel.derive.declare import Element


@pytest.fixture
def rng(request: pytest.FixtureRequest) -> random.Random:
    return random.Random(request.node.name)


@pytest.fixture
def element(request: pytest.FixtureRequest) -> Element:
    """The element of which the test is given the name; see element_numbers.every."""
    return named(request.param)
