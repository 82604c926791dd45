"""What all tests share: the checkout, no window opened by a plot, one thread for small matrices, a random seed."""

import gc
import os
import secrets
from pathlib import Path

import pytest

os.environ.setdefault("MPLBACKEND", "Agg")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is first imported

SEED = "FLEXEL_CAMPAIGN_SEED"  # of the random models; workers of pytest have that of the process that starts them
os.environ.setdefault(SEED, str(secrets.randbelow(10**6)))


def pytest_report_header() -> str:
    """The seed, in the first lines of the output."""
    return f"random models: {SEED}={os.environ[SEED]}"


def pytest_sessionstart() -> None:
    """Collecting makes objects that stay: the collector of garbage would look at all of them again and again."""
    gc.disable()


def pytest_collection_finish() -> None:
    """What is there before the first test is never looked at; garbage that a test makes is found as ever."""
    gc.collect()
    gc.freeze()
    gc.enable()


@pytest.fixture(scope="session")
def checkout() -> Path:
    """Return the root of the checkout."""
    return Path(__file__).resolve().parent.parent
