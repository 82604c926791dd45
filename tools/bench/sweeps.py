"""Times the overhead of a sweep: starting workers, distributing, collecting, writing and reading."""

from __future__ import annotations

import time
from typing import Any

import numpy as np

import flexel as fx
from bench.timing import Work

POINTS = 20_000


def overhead() -> Work:
    """Time a sweep with joblib over points without work, with automatic chunks; wall time."""
    values = np.linspace(0.0, 1.0, POINTS)

    def run() -> Any:
        return fx.sweep(_point, {"a": values}, _result, progress=False)

    def error(found: Any) -> float:
        return float(np.abs(found.square - values**2).max())

    return Work(run, error, POINTS, clock=time.perf_counter)


def _point(a: float) -> float:
    return a


def _result(a: float) -> dict[str, float]:
    return {"square": a * a}
