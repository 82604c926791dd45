"""What all tests share: the checkout, no window of a plot, a random seed, an order."""

from __future__ import annotations  # the oldest pytest does not export all types

import gc
import os
import secrets
from collections.abc import Iterator
from pathlib import Path

import browser as browsers
import pytest

os.environ.setdefault("MPLBACKEND", "Agg")

SEED = "FLEXEL_CAMPAIGN_SEED"  # of the random models; workers of pytest have that of the process that starts them
os.environ.setdefault(SEED, str(secrets.randbelow(10**6)))

LONGEST = (  # files of more than ten seconds: begun first, so that all workers end at the same time
    "derive/test_verify.py",
    "view/test_view_browser.py",
    "view/test_view_parts.py",
    "test_docs_built.py",
    "parts/test_varied_parts.py",
    "integration/test_branches.py",
    "test_docs.py",
    "parts/test_rope_laying.py",
    "integration/test_change_points.py",
    "integration/test_flat_positions.py",
    "analyses/test_elastic_parameters.py",
    "parts/test_helical_drums.py",
    "sweeps/test_folder.py",
)
RANK = {f"tests/{file}": i for i, file in enumerate(LONGEST)}


def pytest_report_header() -> str:
    """The seed, in the first lines of the output."""
    return f"random models: {SEED}={os.environ[SEED]}"


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """For parallel workers the longest files come first; they need --no-loadscope-reorder to keep to it."""
    if hasattr(config, "workerinput"):
        items.sort(key=lambda item: RANK.get(item.nodeid.split("::")[0], len(RANK)))


def pytest_sessionstart() -> None:
    """Collecting makes objects that stay: the collector of garbage would look at all of them again and again."""
    gc.disable()


def pytest_collection_finish() -> None:
    """What is there before the first test is never looked at; garbage that a test makes is found as ever."""
    gc.collect()
    gc.freeze()
    gc.enable()


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """What .ci/run could not install, in the last lines of the output."""
    for line in os.environ.get("FLEXEL_NOT_RUN", "").splitlines():
        terminalreporter.write_line(line)


@pytest.fixture(scope="session")
def checkout() -> Path:
    """Return the root of the checkout."""
    return Path(__file__).resolve().parent.parent


@pytest.fixture(scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """An empty cache for a file of tests: what users compile is derived, compiled and verified here."""
    folder = tmp_path_factory.mktemp("cache")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(folder))
        yield folder / "flexel"


@pytest.fixture(scope="module", params=browsers.NAMES)
def browser(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[browsers.Browser]:
    """Each browser of $FLEXEL_BROWSERS, started once for all tests of a file; what cannot be started is skipped."""
    reason = browsers.missing(request.param)
    if reason:
        pytest.skip(reason)
    with browsers.start(request.param, tmp_path_factory.mktemp(request.param)) as found:
        yield found


@pytest.fixture
def fresh(browser: browsers.Browser) -> Iterator[browsers.Browser]:
    """The browser without old errors; at the end there must be no new ones, and no network requests."""
    browser.value("0")  # what comes before its answer is old
    browser.complaints.clear()
    browser.requests.clear()
    browser.resize(900, 640)
    yield browser
    browser.value("0")
    assert browser.complaints == []
    assert {address.partition(":")[0] for address in browser.requests} <= {"file", "blob", "about", "data"}
