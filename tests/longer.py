"""Cases of a test, some of which take long and are left to `make test-all`."""

from collections.abc import Iterable

import pytest


def longer(cases: Iterable[object], *long: object) -> list[object]:
    """All cases of a test, in their order; those of ``long`` are marked so.

    Each of ``long`` must be among the cases, so that none is marked that was renamed.
    """
    found = list(cases)
    unknown = [case for case in long if case not in found]
    assert not unknown, f"no cases of this test: {unknown}"
    return [pytest.param(*_values(case), marks=pytest.mark.long) if case in long else case for case in found]


def _values(case: object) -> tuple[object, ...]:
    return case if isinstance(case, tuple) else (case,)
