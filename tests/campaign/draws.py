"""Draws by seed: the same cases in every process, and after every change of the program."""

from collections.abc import Callable
from typing import Any, TypeVar
from unittest import mock

from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import seed as seeded
from hypothesis import strategies as st
from hypothesis.internal.conjecture.providers import HypothesisProvider

T = TypeVar("T")


def no_constant(*_given: Any, **_options: Any) -> None:
    """Return None: hypothesis would draw one number in twenty from the sources of the modules that are loaded."""


def each(
    strategy: st.SearchStrategy[T], count: int, seed: str, one: Callable[[T], None], shrink: bool = False
) -> None:
    """Draw so many cases and call a function with each; with `shrink`, one that raises is made shorter first."""
    options = settings(
        max_examples=count,
        database=None,
        deadline=None,
        phases=[Phase.generate, Phase.shrink] if shrink else [Phase.generate],
        report_multiple_bugs=False,
        suppress_health_check=list(HealthCheck),
    )

    def called(case: T) -> None:
        one(case)

    with mock.patch.object(HypothesisProvider, "_maybe_draw_constant", no_constant):
        seeded(seed)(options(given(case=strategy)(called)))()
