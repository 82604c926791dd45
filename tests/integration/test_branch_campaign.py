"""Campaign: no motion of hundreds in badly chosen coordinates ends on another branch.

One family: ``python -m pytest tests/integration/test_branch_campaign.py -k double -s``.  One case, to look at it:
``branch_case.verdict(branch_families.case("double", 17), "DOP853", 1e-3)``.
"""

import pytest
from branch_case import table, verdict
from branch_families import COUNTS, cases

pytestmark = [
    pytest.mark.campaign,
    pytest.mark.slow,
    # at rtol 1e-3 the audit tells of steps that are too long; they must not be on another branch nevertheless
    pytest.mark.filterwarnings("ignore::flexel.AuditWarning"),
]


def judge(family: str, method: str, rtol: float, every: int, own: bool = False) -> None:
    verdicts = [verdict(case, method, rtol, own) for case in cases(family, every)]
    found = f"{family}{', own choice' * own}, {method} at {rtol:g}: {table(verdicts)}"
    print(found)
    assert not any(verdict.fails for verdict in verdicts), found


@pytest.mark.parametrize("family", COUNTS)
@pytest.mark.parametrize("rtol", [1e-9, 1e-3])
def test_no_motion_is_on_another_branch(family: str, rtol: float) -> None:
    judge(family, "DOP853", rtol, 1)


@pytest.mark.parametrize("family", COUNTS)
def test_no_motion_in_the_programs_own_choice_is_on_another_branch(family: str) -> None:
    """Changed on the way where it becomes bad, at a tolerance at which steps are long."""
    judge(family, "DOP853", 1e-3, 2, own=True)


@pytest.mark.parametrize("family", COUNTS)
@pytest.mark.parametrize("rtol", [1e-6, 1e-3])
def test_radau_takes_no_motion_onto_another_branch(family: str, rtol: float) -> None:
    """One case of ten, 40 motions for each tolerance."""
    judge(family, "Radau", rtol, 10)
