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


@pytest.mark.parametrize("method", ["DOP853", "Radau"])
@pytest.mark.parametrize("omega", [40.0, 84.4, 160.0, 300.0])
def test_a_mass_that_is_shaken_on_its_way_is_as_exact_as_at_rest(omega: float, method: str) -> None:
    """Closed form; errors of the rate were up to 5e-6 of its range, which is 1e-9 of the speed."""
    for speed in (0.0, 7.0, 700.0):
        m = fx.Model()
        m.point_mass("mass", m.point("P", (0, 0)), 56.0)
        m.load("P.x", lambda t: 12.7 * np.sin(omega * t))
        m.initial("P.x", rate=speed)
        m.initial("P.y", rate=1.0)
        motion = m.build().simulate(0.05, method=method)
        exact = speed + 12.7 / 56.0 / omega * (1 - np.cos(omega * motion.t))
        rounding = 1e-14 * speed / np.ptp(exact)
        assert np.max(np.abs(motion.rate("P.x") - exact)) < (20e-9 + rounding) * np.ptp(exact)
