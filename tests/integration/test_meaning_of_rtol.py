"""Forty mechanisms by the default method: the error of what is stored is at most 20 rtol A relative to its range.

A >= 1 is how much a perturbation of the start grows in that motion; see `campaign.accuracy`, which judges the campaign
of default settings, too.  Quantities of which two references differ by more than a tenth of the bound are not judged.
"""

import warnings
from functools import cache

import numpy as np
import pytest
from campaign.accuracy import References, judge, references
from forty import MECHANISMS

import flexel as fx

TOLERANCES = (1e-3, 1e-6, 1e-9)
QUICK = (  # the others are left to `make test-all`
    "pendulum",
    "planar",
    "rigid slider crank",
    "kicked bicycle",
    "van der pol",
    "bouncing ball",
    "governor",
    "loop",
    "squeezer",
    "relaxing tyre",
    "sampled carriage",
    "unstable mass",
    "elastic belt",
)


@cache
def started(name: str) -> tuple[fx.System, fx.State]:
    """The system of a mechanism and the state from which it moves."""
    return MECHANISMS[name].make()


@cache
def known(name: str, implicit: bool) -> References:
    """The references of a motion."""
    mechanism = MECHANISMS[name]
    return references(*started(name), mechanism.duration, mechanism.atol, mechanism.fine, implicit)


def cases() -> list[object]:
    """Each mechanism with each tolerance."""
    found = []
    for name in MECHANISMS:
        for rtol in TOLERANCES:
            marks = [] if name in QUICK else [pytest.mark.slow, pytest.mark.long]
            found.append(pytest.param(name, rtol, marks=marks, id=f"{name}-{rtol:g}"))
    return found


def test_there_are_forty() -> None:
    assert len(MECHANISMS) == 40
    assert set(QUICK) <= set(MECHANISMS)


@pytest.mark.parametrize(("name", "rtol"), cases())
def test_an_error_is_at_most_twenty_tolerances_times_the_growth(name: str, rtol: float) -> None:
    system, start = started(name)
    with warnings.catch_warnings():
        warnings.simplefilter(
            "ignore", fx.RangeWarning
        )  # of beams that are bent far, which no method can help
        motion = system.simulate(MECHANISMS[name].duration, start=start, rtol=rtol, progress=False)
        implicit = "Radau" in motion.message or "generalized-alpha" in motion.message
        found = judge(motion, known(name, implicit), rtol)
    assert np.any(found.decided), "the references decide nothing"
    assert not np.any(found.wrong), found.worst
