"""A motion that the tests of files share."""

import pytest
from rides import ride

import flexel as fx


@pytest.fixture(scope="module")
def motion() -> fx.Motion:
    """It steers through a given angle on the way."""
    motion = ride(0.5, 9, events=[fx.Event("steered", lambda state: state["steer.angle"] - 0.01)])
    assert motion.events
    return motion
