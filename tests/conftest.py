"""What all tests share: the checkout, no window opened by a plot, one thread for small matrices, a random seed."""

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


@pytest.fixture(scope="session")
def checkout() -> Path:
    """Return the root of the checkout."""
    return Path(__file__).resolve().parent.parent
