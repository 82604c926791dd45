"""Every analysis uses one thread of BLAS; the setting of before returns when the last caller has left."""

import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from types import FunctionType
from typing import Any

import numpy as np
import pytest
import scipy.linalg
from mechanisms import cantilever, disc, pendulum, slider_crank
from threadpoolctl import ThreadpoolController

from flexel.base.blas import LIMIT, one_thread

OF_LAPACK = (
    "cholesky",
    "det",
    "eig",
    "eigh",
    "eigvals",
    "eigvalsh",
    "inv",
    "lstsq",
    "pinv",
    "qr",
    "solve",
    "svd",
)


def test_the_setting_of_before_returns() -> None:
    with ThreadpoolController().limit(limits=2, user_api="blas"):
        before = LIMIT.threads()
        with one_thread():
            with one_thread():
                assert set(LIMIT.threads()) == {1}
            assert set(LIMIT.threads()) == {1}
        assert LIMIT.threads() == before
        system = slider_crank("B.x").build()
        with ThreadPoolExecutor(8) as pool:
            list(pool.map(lambda _: system.use_coordinates(["B.x"]), range(100)))
        assert LIMIT.threads() == before


def of_scipy(held: Any) -> bool:
    """Whether it is a function of scipy.linalg, or of LAPACK as SciPy wraps it."""
    function = isinstance(held, FunctionType) and held.__module__.startswith("scipy.linalg")
    return type(held).__name__ == "fortran" or (function and not held.__name__.startswith("get_"))


def everything() -> None:
    """One call of each analysis, and of what is asked of its results."""
    leaf, rolling = cantilever(), disc().build()
    rest = leaf.equilibrium()
    leaf.buckling(rest, increment={"A.x": -1.0})
    leaf.vibrations(rest)
    leaf.compliance("A", "tip", rest)
    lin = leaf.linearize(rest)
    lin.eigenvalues(), lin.modes(), lin.mode_shape(0), lin.state_space(["A.y"], ["A.y"])
    lin.frequency_response(["A.y"], ["A.y"], [1.0, 2.0])
    leaf.linearize_many(rest, parameters={"leaf.EIz": [1.0, 2.0]}, progress=False).eigenvalues()
    rolling.state_at(rates={rolling.dynamic[0]: 0.1})
    for method in ("DOP853", "Radau", "generalized-alpha"):
        motion = leaf.simulate(1e-3, method=method, samples=3)
    leaf.along(motion).at(5e-4)
    stepper = pendulum().stepper(0.01, inputs=["pivot.angle"])
    stepper.step([0.1])
    slider_crank("B.x").build().use_coordinates(["B.x"])


def test_no_analysis_calls_lapack_with_more_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    """A user sets no variable: where BLAS may use two threads, each call is within the limit of one."""
    outside: list[str] = []
    calls = 0

    def watched(name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*args: Any, **options: Any) -> Any:
            nonlocal calls
            calls += 1
            if (
                not LIMIT.active and max(map(np.size, args)) > 9
            ):  # parts check tensors (3, 3) when they are declared
                outside.append(name)
            return function(*args, **options)

        return call

    everything()  # imports what it needs
    ours = [module for name, module in sorted(sys.modules.items()) if name.partition(".")[0] == "flexel"]
    for module in (np.linalg, scipy.linalg, *ours):
        for name, held in list(vars(module).items()):
            if module is np.linalg and name in OF_LAPACK or of_scipy(held):
                monkeypatch.setattr(module, name, watched(f"{module.__name__}.{name}", held))
    with ThreadpoolController().limit(limits=2, user_api="blas"):
        everything()
    assert calls > 50
    assert outside == []
