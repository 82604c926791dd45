"""Mistakes in what a simulation is given."""

import math

import pytest
from mistakes import Case, check, drawing, each, pendulum, system

import flexel as fx
from flexel.base.errors import DynamicsError
from flexel.integration.events import Event

E1 = Event("e", lambda state: 1.0)
SIMULATIONS = {
    "no duration": system(lambda s: s.simulate(0), "simulate", "duration", "give a positive"),
    "duration None": system(lambda s: s.simulate(None), "simulate", "duration", "give real"),
    "duration NaN": system(lambda s: s.simulate(math.nan), "simulate", "duration", "give finite"),
    "negative duration": system(lambda s: s.simulate(-1), "simulate", "duration -1", "give a positive"),
    "duration as text": system(lambda s: s.simulate("1"), "simulate", "duration", "give real"),
    "unknown method": system(lambda s: s.simulate(1, method="RK4"), "'RK4'", "choose one of auto, DOP853"),
    "method in small letters": system(lambda s: s.simulate(1, method="radau"), "'radau'", "choose one of"),
    "method None": system(lambda s: s.simulate(1, method=None), "method None", "choose one of"),
    "method as a list": system(
        lambda s: s.simulate(1, method=["DOP853"]), "method ['DOP853']", "choose one of"
    ),
    "times backwards": system(lambda s: s.simulate(1, times=[0, 0.5, 0.4]), "times", "sort them"),
    "times before the start": system(lambda s: s.simulate(1, times=[-1, 0.4]), "times", "from 0 s"),
    "times after the end": system(lambda s: s.simulate(1, times=[0, 2]), "time 2 s", "lengthen the duration"),
    "no times": system(lambda s: s.simulate(1, times=[]), "times", "a list"),
    "one time": system(lambda s: s.simulate(1, times=0.4), "times", "a list"),
    "times NaN": system(lambda s: s.simulate(1, times=[0, math.nan]), "times", "give finite"),
    "times as text": system(lambda s: s.simulate(1, times="abc"), "times", "give real"),
    "no samples": system(lambda s: s.simulate(1, samples=0), "samples 0", "2 or more"),
    "half a sample": system(lambda s: s.simulate(1, samples=2.5), "samples 2.5", "whole number"),
    "negative tolerance": system(lambda s: s.simulate(1, rtol=-5), "rtol", "give more than"),
    "tolerance below rounding": system(lambda s: s.simulate(1, rtol=0), "rtol", "give more than 1e-13"),
    "tolerance as text": system(lambda s: s.simulate(1, rtol="tight"), "rtol", "give real"),
    "negative absolute tolerance": system(lambda s: s.simulate(1, atol=-5), "atol", "give more than"),
    "no step": system(lambda s: s.simulate(1, max_step=0), "max_step", "give more than"),
    "event not in a list": system(lambda s: s.simulate(1, events=E1), "events", "[Event(name, function)]"),
    "function for an event": system(lambda s: s.simulate(1, events=[lambda state: 1]), "events", "[Event("),
    "event upwards": system(
        lambda s: s.simulate(1, events=[Event("e", lambda state: 1.0, direction="up")]),
        "event 'e'",
        "direction 'up'",
        "give 1 (up)",
    ),
    "event without a function": system(
        lambda s: s.simulate(1, events=[Event("e", 3.0)]), "event 'e'", "3.0 is not a function", "lambda s"
    ),
    "event of nothing": system(
        lambda s: s.simulate(1, events=[Event("e", lambda state: None)]), "event 'e'", "give real"
    ),
    "event of NaN": system(
        lambda s: s.simulate(1, events=[Event("e", lambda state: math.nan)]), "event 'e'", "give finite"
    ),
    "event of an unknown quantity": system(
        lambda s: s.simulate(1, events=[Event("e", lambda state: state["A.q"])]), "'A.q'", "'A' has A.x"
    ),
    "start of another model": system(
        lambda s: s.simulate(1, start=pendulum().build().initial), "simulate", "another model", "of this one"
    ),
    "start no state": system(
        lambda s: s.simulate(1, start=3), "simulate", "int is not a state", "system.initial"
    ),
}


@each(SIMULATIONS)
def test_a_mistake_in_a_simulation_is_named_with_its_remedy(case: Case) -> None:
    check(case)


@pytest.mark.filterwarnings("ignore:build.*belongs to no element:flexel.ModelWarning")
def test_massless_dof_is_named() -> None:
    m = drawing()
    m.point_mass("b", "A", 1.0)
    with pytest.raises(DynamicsError, match=r"'R1\.lambda\d' moves no mass; give its bodies mass"):
        m.build().simulate(1.0, method="DOP853")


def test_an_event_that_calls_itself_without_end_is_named() -> None:
    m = fx.Model(gravity=(0, -9.81))
    m.point("A", (0, 0))
    m.point_mass("stone", "A", 1.0)

    def height(state: fx.State) -> float:
        return height(state)

    with pytest.raises(fx.ModelError, match="event 'ground'.*calls itself endlessly"):
        m.build().simulate(1.0, events=[fx.Event("ground", height)])


@pytest.mark.parametrize("method", ["DOP853", "Radau"])
def test_a_truss_that_shrinks_to_no_length_is_named(method: str) -> None:
    """Two masses on a line that would pass one another."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    for i in (1, 2):
        m.point_mass(f"m{i}", m.point(f"P{i}", (0.5 * i, 0)), 1.0)
        m.fix(f"P{i}.y")
        m.truss(f"t{i}", "O" if i == 1 else "P1", f"P{i}")
        m.spring(f"t{i}.elongation", 10.0)
    m.initial("P1.x", rate=0.0)
    m.initial("P2.x", rate=-4.0)
    named = r"at t = 0\.1\d* s: 't2' has shrunk to .* m: 'P1' and 'P2' meet there"
    with pytest.raises(fx.DynamicsError, match=named):
        m.build().simulate(1.0, method=method)
