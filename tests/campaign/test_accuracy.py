"""What the campaign of default settings judges by: growths in closed form, wrong motions, references that disagree."""

import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import flexel as fx
from campaign import accuracy, drive
from campaign.accuracy import (
    FACTOR,
    FIRST,
    PERTURBATION,
    Accuracy,
    Histories,
    References,
    differ,
    event_times,
    judge,
    passing_times,
    perturbed_start,
    promised,
    tight,
)
from campaign.case import Case, declared, own
from campaign.defaults import drawn, run, summary, table
from campaign.drive import AGREE, PART, REFUSED, SILENT, UNDECIDED, WARNED, Verdict, driven
from campaign.grammar_rides import RIDES
from campaign.journal import Journal, row_of
from campaign.ride import Ride
from campaign.test_parts import PENDULUM

SWING = Ride(replace(PENDULUM, duration=2.0))
RATE = 3.0  # of the unstable mass [1/s]
UNSTABLE = Case(
    "unstable",
    (0.0, 0.0),
    (
        declared("point", "O", (0.0, 0.0), fixed=True),
        declared("point", "P", (1.0, 0.0)),
        declared("fix", "P.y"),
        declared("truss", "bar", "O", "P"),
        declared("point_mass", "m", "P", 1.0),
        declared("law", ("bar.elongation",), own("DRIVER"), name="drive", k=-(RATE**2), c=0.0),
    ),
    rates=(0.01,),
    duration=2.0,
)


def simulated(monkeypatch: pytest.MonkeyPatch, changed: Any, by_default: bool = True) -> None:
    """Let `System.simulate` be called with other options, by default settings or for the references alone."""
    true = fx.System.simulate

    def simulate(self: fx.System, duration: float, **options: Any) -> fx.Motion:
        if ("rtol" not in options) == by_default:
            return changed(true, self, duration, options)
        return true(self, duration, **options)

    monkeypatch.setattr(fx.System, "simulate", simulate)


def test_the_growth_of_a_perturbation_is_that_of_the_closed_form() -> None:
    """x = a cosh wt + b sinh wt; the start is moved by the range of x, and its rate by that of x'."""
    s, T = UNSTABLE.model().build(), UNSTABLE.duration
    start = UNSTABLE.start(s)
    motion = s.simulate(T, start=start, rtol=1e-12)
    beside = s.simulate(T, start=perturbed_start(s, start, motion), rtol=1e-12)
    found = judge(motion, References(motion, motion, beside), 1e-9)
    i = found.names.index("P.x")
    e, large, slope = np.exp(RATE * T), np.cosh(RATE * T), np.sinh(RATE * T)
    grown = {abs(a * large + b * (large - 1)) for a in (1, -1) for b in (1, -1)}
    assert min(abs(found.growth[i] / max(growth, 1.0) - 1) for growth in grown) < 1e-4
    assert found.bounds[i] == FACTOR * 1e-9 * found.growth[i]
    assert slope < e  # the range of x is sinh(wT) / w, that of x' is cosh(wT) - 1


def test_a_quantity_counts_relative_to_its_range_and_only_where_references_agree() -> None:
    t = np.linspace(0, 1, 11)
    names, kinds = ("large", "small", "doubtful", "still"), np.zeros(4, int)
    true = np.stack([t, 1e-3 * t, t, np.full(11, 2.0)], axis=1)

    def moved(*by: float) -> Histories:
        return Histories(names, true + np.array(by) * t[:, None], kinds)

    judged = accuracy.judged(
        moved(1e-8, 1e-8, 1e-8, 1.0), moved(0, 0, 0, 0), moved(0, 0, 3e-9, 0), moved(0, 2e-10, 0, 0), 1e-9
    )
    assert judged.moving.tolist() == [True, True, True, False]
    assert judged.decided.tolist() == [True, True, False, False]
    assert judged.growth[:2] == pytest.approx([1.0, 2e-7 / PERTURBATION])
    assert judged.wrong.tolist() == [False, True, False, False]
    assert judged.undecided.tolist() == [False, False, True, False]
    assert judged.excess == pytest.approx(1e-5 / (FACTOR * 2e-9))
    assert judged.worst.startswith("small: ")
    short = Histories(names, true[:-1], kinds)
    still = moved(0, 0, 0, 0)
    assert accuracy.judged(short, still, still, still, 1e-9).excess == np.inf


def test_a_quantity_whose_growth_is_not_known_is_not_decided() -> None:
    """A perturbation that has grown to the range of a chaotic motion says nothing about a small error."""
    t = np.linspace(0, 1, 11)[:, None]
    true, beside = (Histories(("x",), z, np.zeros(1, int)) for z in (t, 1.2 * t))
    found = accuracy.judged(beside, true, true, beside, 1e-12)
    assert found.undecided.tolist() == [True] and not found.wrong.any()


def test_times_of_events_must_be_as_many() -> None:
    assert differ([0.1, 0.2], [0.1, 0.3]) == pytest.approx(0.1)
    assert differ([], []) == 0.0
    assert differ([0.1], []) == np.inf


def test_a_pendulum_agrees_with_the_tolerance_of_its_method() -> None:
    verdict = driven(replace(SWING, watched="P.x"))
    assert (verdict.outcome, verdict.method) == (AGREE, "DOP853")
    assert 0 < verdict.excess < 1
    s = SWING.case.model().build()
    assert promised(s.simulate(0.1)) == 1e-9
    assert promised(s.simulate(0.1, rtol=1e-4), 1e-4) == 1e-4


def test_a_method_that_is_wrong_is_a_silent_error_unless_it_warns(monkeypatch: pytest.MonkeyPatch) -> None:
    def loose(true: Any, system: fx.System, duration: float, options: dict[str, Any]) -> fx.Motion:
        found: fx.Motion = true(system, duration, **options, method="DOP853", rtol=1e-5)
        for text in said:
            warnings.warn(text, fx.AuditWarning, stacklevel=1)
        return found

    said: tuple[str, ...] = ()
    simulated(monkeypatch, loose)
    silent = driven(SWING)
    assert silent.outcome == SILENT and silent.excess > 3
    said = ("some energy is lost",)
    assert driven(SWING).outcome == WARNED
    report = summary([row_of("1/pendulum/0", silent)], 1)
    assert report["outcomes"][SILENT] == 1 and "m.point_mass" in table(report)


def test_a_journal_keeps_verdicts_for_the_same_ride_and_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, verdict = tmp_path / "moved.jsonl", driven(SWING)
    row = Journal(path).keep("1/pendulum/0", verdict)
    assert Journal(path).row("1/pendulum/0", SWING) == row
    assert Journal(path).row("1/pendulum/0", replace(SWING, watched="P.x")) is None
    monkeypatch.setattr("campaign.journal.version", lambda: "another")
    assert Journal(path).row("1/pendulum/0", SWING) is None


def test_a_run_continues_from_its_journal(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, judged = tmp_path / "moved.jsonl", []

    def interrupted(ride: Ride) -> Verdict:
        if len(judged) == 2:
            raise RuntimeError
        judged.append(ride)
        return Verdict(ride, AGREE, seconds=1.0)

    some = {"inverted pendulums": RIDES["inverted pendulums"]}
    monkeypatch.setattr("campaign.defaults.driven", interrupted)
    with pytest.raises(RuntimeError):
        run(4, 7, some, journal=Journal(path))
    judged.clear()
    found = run(4, 7, some, journal=Journal(path))
    assert len(judged) == 2  # of four; the others were there
    assert (found["models"], found["seconds"], found["outcomes"][AGREE]) == (4, 4.0, 4)


def test_an_event_that_is_missed_is_a_silent_error(monkeypatch: pytest.MonkeyPatch) -> None:
    def blind(true: Any, system: fx.System, duration: float, options: dict[str, Any]) -> fx.Motion:
        found: fx.Motion = true(system, duration, **options)
        found.events = found.events[1:]
        return found

    simulated(monkeypatch, blind)
    verdict = driven(replace(SWING, watched="P.x"))
    assert verdict.outcome == SILENT and verdict.excess == np.inf


def test_references_that_differ_decide_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(accuracy, "SECOND", Accuracy("DOP853", 1e-4, 1))
    assert driven(SWING).outcome in (UNDECIDED, PART)


def test_references_that_fail_are_replaced_by_looser_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    def noisy(true: Any, system: fx.System, duration: float, options: dict[str, Any]) -> fx.Motion:
        if options["rtol"] < accuracy.FIRST.rtol:
            raise fx.DynamicsError("rounding")
        found: fx.Motion = true(system, duration, **options)
        return found

    simulated(monkeypatch, noisy, by_default=False)
    assert driven(SWING).outcome == AGREE
    monkeypatch.setattr(drive, "LOOSER", 1.0)
    assert driven(SWING).outcome == UNDECIDED


def test_events_are_located_between_stored_states() -> None:
    s = SWING.case.model().build()
    start, event = SWING.case.start(s), fx.Event("middle", lambda state: state["P.x"] - 0.1)
    known = tight(s, start, 2.0, FIRST, 1e-14, events=[event])
    found = passing_times(s, known, event, FIRST, 1e-14, 1)
    assert found.size > 1
    assert differ(found, event_times(known)) < 1e-11


def test_what_is_fixed_passes_nothing() -> None:
    assert driven(replace(SWING, watched="O.x")).outcome == AGREE


def test_what_takes_too_long_is_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drive, "PATIENCE", 100)
    verdict = driven(replace(SWING, case=replace(SWING.case, duration=1e4)))
    assert verdict.outcome == UNDECIDED and "too long" in verdict.why


def test_a_model_that_cannot_be_built_is_refused() -> None:
    broken = Ride(PENDULUM.having(declared("truss", "again", "O", "P")))
    verdict = driven(broken)
    assert verdict.outcome == REFUSED and "over-constrained" in verdict.why


def test_the_printed_program_makes_the_motion() -> None:
    for ride in drawn(RIDES["planar chain"], 2, "program"):
        names: dict[str, Any] = {}
        exec(ride.program(), names)
        system = ride.built()
        motion = system.simulate(ride.case.duration, start=ride.case.start(system))
        np.testing.assert_array_equal(names["motion"].x, motion.x)


def test_rides_of_a_seed_are_always_the_same() -> None:
    first, second, other = (drawn(RIDES["balls"], 3, seed) for seed in ("1", "1", "2"))
    assert (
        [ride.program() for ride in first]
        == [ride.program() for ride in second]
        != [ride.program() for ride in other]
    )
    assert len(first) == 3
