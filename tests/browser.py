"""A browser to be driven by tests: what a person does, said in the same words for Chromium and for Firefox.

`chromium.py` speaks the DevTools protocol, `firefox.py` WebDriver BiDi. Tests ask for the fixture `browser` or `fresh`
of conftest.py, and run in both.
"""

from __future__ import annotations

import importlib.util
import io
import json
import os
import shutil
import subprocess
import time
from abc import ABC, abstractmethod
from collections.abc import Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

NAMES = tuple(os.environ.get("FLEXEL_BROWSERS", "chromium").split())  # `make test-all` has firefox as well
PROGRAMS = {
    "chromium": shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome"),
    "firefox": shutil.which("firefox-esr") or shutil.which("firefox"),
    "xvfb": shutil.which("Xvfb"),
}
NEEDED = {"chromium": ("chromium",), "firefox": ("firefox", "xvfb")}  # Firefox has no WebGL without a screen
PACKAGES = {"chromium": "chromium", "firefox": "firefox-esr", "xvfb": "xvfb"}  # of Debian
PATIENCE = 180.0  # seconds for anything; on a busy machine a browser may take long to start
VIEWER_READY = (
    "document.querySelector('canvas')?.dataset.frame !== undefined || "
    "document.querySelector('[role=alert]:not([hidden])') !== null"
)
# Only the drawing is to be in a picture, without what lies over it.
BARE = "#panel, #keys, #tip, #cursor { visibility: hidden } canvas { outline: none !important }"

Place = tuple[float, float]


def missing(name: str) -> str:
    """Why a browser cannot be driven here; empty where it can."""
    wanted = [PACKAGES[program] for program in NEEDED[name] if PROGRAMS[program] is None]
    if wanted:
        return f"the viewer in {name.title()} is not tested: apt-get install {' '.join(wanted)}"
    if name == "firefox" and importlib.util.find_spec("websockets") is None:
        return "the viewer in Firefox is not tested: pip install 'flexel[test]' (websockets)"
    return ""


def start(name: str, folder: Path) -> Browser:
    """Start a browser with a new profile in a folder."""
    if name == "chromium":
        from chromium import Chromium

        return Chromium(folder)
    from firefox import Firefox

    return Firefox(folder)


def end(process: subprocess.Popen[bytes], asked: bool) -> None:
    """Wait for a process that was asked to end; another is killed."""
    if not asked:
        process.kill()
    try:
        process.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()


class Browser(ABC):
    """One page of a browser.

    Attributes
    ----------
    complaints : list of str
        Console errors, uncaught exceptions and failed requests so far.
    requests : list of str
        Addresses requested by the page.
    """

    name: str

    def __init__(self) -> None:
        self.complaints: list[str] = []
        self.requests: list[str] = []

    def __enter__(self) -> Browser:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    # -- what the protocols do, each in its own way ----------------------------------------------

    @abstractmethod
    def close(self) -> None:
        """End the browser and all that was started for it."""

    @abstractmethod
    def navigate(self, address: str) -> None:
        """Go to an address."""

    @abstractmethod
    def value(self, expression: str) -> Any:
        """Value of a JavaScript expression, waited for if it is a promise."""

    @abstractmethod
    def press(self, key: str) -> None:
        """Press and release a key, named as in KeyboardEvent.key."""

    @abstractmethod
    def drag(self, start: Place, *places: Place) -> None:
        """Press the mouse at one place, move it over others, and release it; a click where there are none."""

    @abstractmethod
    def point(self, place: Place) -> None:
        """Move the mouse to a place without pressing it."""

    @abstractmethod
    def touch(self, *places: Sequence[Place]) -> None:
        """Put fingers down at the first places, move them over the others, and lift them."""

    @abstractmethod
    def resize(self, width: int, height: int, phone: bool = False) -> None:
        """Size of the window; a phone has fingers."""

    @abstractmethod
    def screenshot(self, box: dict[str, float]) -> bytes:
        """A PNG of a part of the window: x, y, width, height."""

    @abstractmethod
    def nameless(self) -> list[str]:
        """What can have the focus and tells a screen reader no name."""

    # -- what is common --------------------------------------------------------------------------

    def go(self, address: str) -> None:
        """Go to an address and wait until it has been loaded."""
        self.navigate("about:blank")  # else a change of the part behind # would load nothing
        self.navigate(address)
        self.wait("location.href !== 'about:blank' && document.readyState === 'complete'")

    def open(self, path: Path, part: str = "") -> None:
        """Open a file and wait until the viewer has drawn it, or says why not."""
        self.go(path.as_uri() + part)
        self.wait(VIEWER_READY)

    def wait(self, condition: str) -> None:
        """Wait until a JavaScript expression is true."""
        deadline, pause = time.monotonic() + PATIENCE, 0.002
        while not self.value(condition):
            assert time.monotonic() < deadline, f"never true: {condition}; {self.complaints}"
            time.sleep(pause)
            pause = min(2 * pause, 0.05)

    def frame(self) -> None:
        """Wait until the requested drawing is complete."""
        self.value(
            "new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve(0))))"
        )

    def click(self, selector: str) -> None:
        """Click in the middle of an element."""
        self.drag(self.middle(selector))

    def middle(self, selector: str) -> Place:
        """Middle of an element in the window."""
        box = self.box(selector)
        assert box["width"] > 0, f"{selector} is not to be seen"
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def box(self, selector: str) -> dict[str, float]:
        """Where an element is in the window: x, y, width, height, right, bottom."""
        found: dict[str, float] = self.value(
            f"document.querySelector({json.dumps(selector)}).getBoundingClientRect().toJSON()"
        )
        return found

    def choose(self, selector: str, value: str) -> None:
        """Choose an option, or set an input, as its own events would."""
        where = json.dumps(selector)
        self.value(
            f"(() => {{ const field = document.querySelector({where}); field.value = {json.dumps(value)}; "
            "field.dispatchEvent(new Event('input', {bubbles: true})); field.dispatchEvent(new Event('change')); })()"
        )
        self.frame()

    def picture(self, selector: str = "#picture") -> NDArray[np.int16]:
        """What is on a canvas (height, width, 3), without what lies over it."""
        from PIL import Image

        style = f"Object.assign(document.createElement('style'), {{textContent: '{BARE}'}})"
        self.value(f"document.head.append({style})")
        self.frame()
        data = self.screenshot(self.box(selector))
        self.value("document.head.lastChild.remove()")
        with Image.open(io.BytesIO(data)) as picture:
            return np.asarray(picture.convert("RGB"), dtype=np.int16)
