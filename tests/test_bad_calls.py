"""Bad input: every public function with junk in place of each argument raises flexel's own error.

One function: ``python -m pytest tests/test_bad_calls.py -k whole -s`` prints what was found; one case, to look at it:
``bad_calls.called(bad_calls.Case("System.rhs", "y", "complex"))``.
"""

import inspect
import random
from collections.abc import Sequence
from pathlib import Path

import pytest
from bad_calls import MADE_BY_FLEXEL, VALID, Case, cases, public_calls
from bad_process import verdicts

SAMPLE = 160  # cases of every run


def judge(chosen: Sequence[Case], folder: Path) -> None:
    """None of the cases hangs, crashes, raises a foreign error, or is accepted in silence."""
    wrong = verdicts(chosen, folder)
    listed = "\n".join(f"{case}: {what}" for case, what in wrong.items())
    print(f"{len(chosen)} bad calls, {len(wrong)} defects")
    assert not wrong, f"{len(wrong)} of {len(chosen)} bad calls:\n{listed}"


def test_every_public_call_has_a_valid_one() -> None:
    """A new function must be given a valid call (tests/valid_*.py), from which the campaign makes bad ones."""
    public = dict(public_calls())
    assert sorted(public.keys() - VALID.keys()) == []
    assert sorted(VALID.keys() - public.keys()) == []
    assert {name.split(".")[0] for name in VALID} >= {"Model", "System", "Motion", "State", "sweep"}
    assert not MADE_BY_FLEXEL & VALID.keys()


@pytest.mark.parametrize("name", sorted(VALID))
def test_arguments_of_valid_calls_are_those_of_the_signature(name: str) -> None:
    valid = VALID[name]()
    assert set(valid.arguments) <= set(inspect.signature(valid.function).parameters)


@pytest.mark.long
def test_a_sample_of_bad_calls_is_refused_by_name(tmp_path: Path) -> None:
    judge(random.Random(15).sample(cases(), SAMPLE), tmp_path)


@pytest.mark.campaign
@pytest.mark.slow
def test_no_bad_call_slips_through(tmp_path: Path) -> None:
    judge(cases(), tmp_path)
