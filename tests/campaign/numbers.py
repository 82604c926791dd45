"""Numbers that the grammar draws: of two or three digits, so that the program of a failure is short."""

from typing import Any

import numpy as np
from hypothesis import strategies as st

Draw = Any  # what hypothesis hands to a composite strategy


def number(least: float, most: float, step: float = 0.01) -> st.SearchStrategy[float]:
    """A multiple of a step in a range."""
    return st.integers(round(least / step), round(most / step)).map(lambda i: round(i * step, 6))


def vectors(size: int, most: float = 1.0) -> st.SearchStrategy[tuple[float, ...]]:
    """Vectors of which no component exceeds `most`."""
    return st.tuples(*[number(-most, most)] * size)


def masses() -> st.SearchStrategy[float]:
    """[kg]"""
    return st.sampled_from((0.5, 1.0, 1.7, 2.3, 4.0))


def rates(count: int = 6, most: float = 4.0) -> st.SearchStrategy[tuple[float, ...]]:
    """Rates of degrees of freedom, not zero."""
    one = st.one_of(number(0.2, most), number(-most, -0.2))
    return st.lists(one, min_size=count, max_size=count).map(tuple)


def inertias() -> st.SearchStrategy[tuple[float, ...]]:
    """Inertia tensors of real bodies: principal moments turned about a diagonal."""
    return st.tuples(number(0.02, 0.2), number(0.02, 0.2), number(0.1, 0.9), number(-0.3, 0.3)).map(_tensor)


def _tensor(drawn: tuple[float, float, float, float]) -> tuple[float, ...]:
    a, b, share, turn = drawn
    J = np.diag([a, b, abs(a - b) + share * (a + b - abs(a - b))])
    c, s = np.cos(turn), np.sin(turn)
    R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    J = R @ J @ R.T
    six = J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[0, 2], J[1, 2]
    return tuple(round(float(v), 5) for v in six)


def directions() -> st.SearchStrategy[tuple[float, float, float]]:
    """Directions in space, some along the axes."""
    part = number(-1, 1, 0.1)
    return st.tuples(part, part, part).map(
        lambda direction: direction if np.linalg.norm(direction) > 0.3 else (0.0, 0.0, 1.0)
    )


def links(size: int) -> st.SearchStrategy[tuple[float, ...]]:
    """The vector from one joint to the next, between 0.2 and 1 m."""
    return st.tuples(number(0.2, 1.0), number(-3, 3, 0.1), number(-1.4, 1.4, 0.1)).map(
        lambda drawn: _arm(drawn, size)
    )


def _arm(drawn: tuple[float, float, float], size: int) -> tuple[float, ...]:
    l, turn, rise = drawn
    if size == 2:
        arm = l * np.array([np.cos(turn), np.sin(turn)])
    else:
        arm = l * np.array([np.cos(turn) * np.cos(rise), np.sin(turn) * np.cos(rise), np.sin(rise)])
    return tuple(round(float(v), 3) for v in arm)


def orientations() -> st.SearchStrategy[tuple[float, ...]]:
    """Euler parameters of a frame as drawn; often none."""
    turned = st.tuples(directions(), number(-3, 3, 0.1)).map(_quaternion)
    return st.one_of(st.just((1.0, 0.0, 0.0, 0.0)), turned)


def _quaternion(drawn: tuple[tuple[float, float, float], float]) -> tuple[float, ...]:
    axis, turn = np.array(drawn[0]) / np.linalg.norm(drawn[0]), drawn[1]
    return tuple(float(v) for v in (np.cos(turn / 2), *(np.sin(turn / 2) * axis)))


def moved(x: tuple[float, ...], arm: tuple[float, ...]) -> tuple[float, ...]:
    """The end of an arm from a place."""
    return tuple(round(a + b, 6) for a, b in zip(x, arm, strict=True))
