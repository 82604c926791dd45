"""Messages show NumPy's numbers as Python's."""

from collections.abc import Callable

import numpy as np
import pytest

import flexel as fx

ONE = np.float64(1.5)


def point() -> fx.Model:
    m = fx.Model()
    m.point("A", (0, 0))
    return m


@pytest.mark.parametrize(
    "call",
    [
        lambda: fx.Polynomial(ONE),  # type: ignore[arg-type]
        lambda: point().relation("r", [ONE]),  # type: ignore[arg-type]
        lambda: point().load("A", ONE),
    ],
)
def test_a_refused_number_of_numpy_is_shown_as_a_number(call: Callable[[], object]) -> None:
    with pytest.raises(fx.ModelError, match=r"1\.5") as refused:
        call()
    assert "np." not in str(refused.value)


def test_numbers_within_lists_are_shown_as_numbers() -> None:
    given = {"a": [ONE, (np.int64(2), np.True_, np.str_("b"))]}
    assert str(fx.ModelError(f"model: {given!r} is wrong")) == "model: {'a': [1.5, (2, True, 'b')]} is wrong"
