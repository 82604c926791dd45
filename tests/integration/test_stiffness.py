"""DOP853, if named for a stiff system, says early how long it will take, and disturbs nothing."""

import warnings

import numpy as np
import pytest

import flexel as fx
from flexel.engine import covered
from flexel.integration import stiffness, watch


def mass(fast: float) -> fx.System:
    """A mass on two springs, with frequencies of 1 rad/s and of the given one, both excited."""
    m = fx.Model()
    m.point("A", (1, 0))
    m.point_mass("a", "A", 1.0)
    m.spring("A.x", 1.0)
    m.spring("A.y", fast**2)
    m.initial("A.x", 0.1)
    m.initial("A.y", 1e-3)
    return m.build()


SAID = (
    r"simulate: DOP853 takes about \S+ steps: its largest eigenvalue is 3e\+04 1/s in magnitude at t = .* s; "
)


def test_a_long_stiff_motion_is_announced_at_the_call() -> None:
    """As an error here, which ends the motion at once."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", fx.StiffWarning)
        with pytest.raises(fx.StiffWarning, match=SAID + ".*omit method, so that a faster one is chosen$"):
            mass(3e4).simulate(10.0, method="DOP853")


def test_the_estimated_number_of_steps_is_that_of_the_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watch, "STIFF", 300.0)
    monkeypatch.setattr(watch, "LOOK", 100)
    monkeypatch.setattr(watch, "LONG", 500)
    monkeypatch.setattr(covered, "FULL", 1e9)  # as in stiff motions, whose steps do not depend on tolerances
    with pytest.warns(fx.StiffWarning) as said:
        motion = mass(1e3).simulate(1.0, method="DOP853")
    assert said[0].filename == __file__
    told = float(motion.message.partition("about ")[2].partition(" steps")[0])
    assert told == pytest.approx(motion.statistics["steps"], rel=0.1)
    assert motion.message.startswith("reached the end (DOP853 takes about ")


def test_the_look_changes_nothing_of_the_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    plain = mass(1e3).simulate(0.3, method="DOP853")
    assert plain.message == f"reached the end ({plain.verdict})"
    monkeypatch.setattr(watch, "STIFF", 1.0)
    monkeypatch.setattr(watch, "LOOK", 50)
    monkeypatch.setattr(watch, "LONG", 50)
    with pytest.warns(fx.StiffWarning):
        seen = mass(1e3).simulate(0.3, method="DOP853")
    assert seen.statistics == plain.statistics
    for name in ("A.x", "A.y", "A.y'"):
        assert np.array_equal(seen.series(name)[0], plain.series(name)[0])


def test_events_do_not_change_the_method(monkeypatch: pytest.MonkeyPatch) -> None:
    """In stiff motions DOP853 was chosen with events, since generalized-alpha did not locate them."""
    monkeypatch.setattr(stiffness, "STIFF", 1.0)
    event = fx.Event("middle", lambda state: state["A.x"])
    alone, watched = (mass(1e3).simulate(0.3, events=events) for events in ([], [event]))
    assert "generalized-alpha, chosen because" in alone.message
    assert watched.message.partition(";")[0] == alone.message.partition(";")[0]
    assert np.array_equal(watched["A.x"], alone["A.x"])


def test_many_steps_for_accuracy_alone_are_not_called_stiff(monkeypatch: pytest.MonkeyPatch) -> None:
    """As many turns as below the limit of `auto`, however many steps they take."""
    monkeypatch.setattr(watch, "LOOK", 50)
    monkeypatch.setattr(watch, "LONG", 50)
    motion = mass(1e3).simulate(0.3, method="DOP853")
    assert motion.message == f"reached the end ({motion.verdict})" and motion.statistics["steps"] > 100
