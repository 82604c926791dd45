"""A headless Chromium to be driven by tests: its DevTools protocol over a pipe, with the standard library only."""

from __future__ import annotations

import base64
import io
import json
import os
import select
import shutil
import subprocess
import time
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

PROGRAM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
MISSING = "no Chromium here; install it to test the viewer: apt-get install chromium"
SWITCHES = (
    "--headless=new --no-sandbox --remote-debugging-pipe --enable-unsafe-swiftshader --use-angle=swiftshader "
    "--use-gl=angle --no-first-run --disable-extensions --disable-background-networking --hide-scrollbars"
)
PATIENCE = 60.0  # seconds for anything


class Browser:
    """One page of a browser.

    Attributes
    ----------
    complaints : list of str
        Console errors, uncaught exceptions and failed requests so far.
    requests : list of str
        Addresses requested by the page.
    """

    def __init__(self, profile: Path, size: tuple[int, int] = (900, 640)) -> None:
        assert PROGRAM is not None, MISSING
        switches = [*SWITCHES.split(), f"--user-data-dir={profile}", f"--window-size={size[0]},{size[1]}"]
        # the protocol wants the descriptors 3 and 4
        command = [
            "/bin/sh",
            "-c",
            'exec "$@" 3<&0 4>&1 0</dev/null 1>&2',
            "sh",
            PROGRAM,
            *switches,
            "about:blank",
        ]
        self._log = profile.with_suffix(".log")
        with self._log.open("wb") as log:
            pipe = subprocess.PIPE
            self._process = subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=log, bufsize=0)
        assert self._process.stdin is not None and self._process.stdout is not None
        self._write, self._read = self._process.stdin.fileno(), self._process.stdout.fileno()
        self._buffer, self._count, self._session = b"", 0, ""
        self.complaints: list[str] = []
        self.requests: list[str] = []
        targets = self.call("Target.getTargets")["targetInfos"]
        target = next(z["targetId"] for z in targets if z["type"] == "page")
        self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network", "Accessibility"):
            self.call(f"{domain}.enable")
        self.resize(*size)

    def __enter__(self) -> Browser:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._session = ""
        self.call("Browser.close")
        with self._process:  # closes the pipes
            self._process.wait(PATIENCE)

    # -- the protocol ----------------------------------------------------------------------------

    def call(self, method: str, **parameters: Any) -> Any:
        """Call a method of the protocol and wait for its result."""
        self._count += 1
        message = {"id": self._count, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        while True:
            found = self._message()
            if found.get("id") == self._count:
                assert "error" not in found, f"{method}: {found['error']}"
                return found["result"]
            self._note(found)

    def _message(self) -> dict[str, Any]:
        deadline = time.monotonic() + PATIENCE
        while b"\0" not in self._buffer:
            assert select.select([self._read], [], [], max(0.0, deadline - time.monotonic()))[0], "no answer"
            piece = os.read(self._read, 1 << 20)
            assert piece, f"the browser ended; see {self._log}"
            self._buffer += piece
        line, _, self._buffer = self._buffer.partition(b"\0")
        message: dict[str, Any] = json.loads(line)
        return message

    def _note(self, event: dict[str, Any]) -> None:
        method, p = event.get("method"), event.get("params", {})
        if method == "Runtime.exceptionThrown":
            self.complaints.append(json.dumps(p["exceptionDetails"]))
        elif method == "Runtime.consoleAPICalled" and p["type"] in ("error", "warning", "assert"):
            self.complaints.append(json.dumps(p["args"]))
        elif method == "Log.entryAdded" and p["entry"]["level"] == "error":
            self.complaints.append(p["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(p["request"]["url"])

    # -- what a person does ----------------------------------------------------------------------

    def open(self, path: Path, part: str = "") -> None:
        """Open a file and wait until the viewer has drawn it, or says why not."""
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=path.as_uri() + part)
        ready = "document.querySelector('canvas')?.dataset.frame !== undefined"
        self.wait(f"{ready} || document.querySelector('[role=alert]:not([hidden])') !== null")

    def wait(self, condition: str) -> None:
        """Wait until a JavaScript expression is true."""
        deadline = time.monotonic() + PATIENCE
        while not self.value(condition):
            assert time.monotonic() < deadline, f"never true: {condition}; {self.complaints}"
            time.sleep(0.05)

    def value(self, expression: str) -> Any:
        """Value of a JavaScript expression."""
        found = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in found, found["exceptionDetails"]
        return found["result"].get("value")

    def frame(self) -> None:
        """Wait until the requested drawing is complete."""
        self.value("new Promise((z) => requestAnimationFrame(() => requestAnimationFrame(() => z(0))))")

    def press(self, key: str, shift: bool = False) -> None:
        """Press and release a key, named as in KeyboardEvent.key."""
        code = {
            "Tab": 9,
            " ": 32,
            "End": 35,
            "Home": 36,
            "ArrowLeft": 37,
            "ArrowUp": 38,
            "ArrowRight": 39,
        }.get(key)
        event = {"key": key, "code": "Space" if key == " " else key, "modifiers": 8 * shift}
        event |= {"windowsVirtualKeyCode": code} if code else {"text": key}
        event |= {"text": " "} if key == " " else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", **event)
        event.pop("text", None)
        self.call("Input.dispatchKeyEvent", type="keyUp", **event)
        self.frame()

    def click(self, selector: str) -> None:
        """Click in the middle of an element."""
        x, y = self.middle(selector)
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1)
        self.frame()

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Drag the mouse from one place to another."""
        for kind, (x, y) in (("mousePressed", start), ("mouseMoved", end), ("mouseReleased", end)):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1)
        self.frame()

    def touch(self, *places: list[tuple[float, float]]) -> None:
        """Put fingers down at the first places, move them over the others, and lift them."""
        for kind, fingers in zip(["touchStart"] + ["touchMove"] * (len(places) - 1), places, strict=True):
            points = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(fingers)]
            self.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.frame()

    def middle(self, selector: str) -> tuple[float, float]:
        """Middle of an element in the window."""
        box = self.value(
            f"(() => {{ const b = document.querySelector({json.dumps(selector)}).getBoundingClientRect(); "
            "return [b.x + b.width / 2, b.y + b.height / 2, b.width] })()"
        )
        assert box[2] > 0, f"{selector} is not to be seen"
        return box[0], box[1]

    def choose(self, selector: str, value: str) -> None:
        """Choose an option, or set an input, as its own events would."""
        where = json.dumps(selector)
        self.value(
            f"(() => {{ const z = document.querySelector({where}); z.value = {json.dumps(value)}; "
            "z.dispatchEvent(new Event('input', {bubbles: true})); z.dispatchEvent(new Event('change')); })()"
        )
        self.frame()

    def resize(self, width: int, height: int, phone: bool = False) -> None:
        """Size of the window; a phone has fingers."""
        self.call(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=phone,
        )
        self.call("Emulation.setTouchEmulationEnabled", enabled=phone)

    def picture(self) -> NDArray[np.int16]:
        """What is on the canvas (height, width, 3), without what lies over it."""
        from PIL import Image

        self.frame()
        box = self.value(
            "(() => { const b = document.querySelector('#picture').getBoundingClientRect(); "
            "return {x: b.x, y: b.y, width: b.width, height: b.height, scale: 1} })()"
        )
        hidden = "#panel, #keys, #tip { visibility: hidden } canvas { outline: none !important }"
        self.value(
            f"document.head.append(Object.assign(document.createElement('style'), {{textContent: '{hidden}'}}))"
        )
        data = self.call("Page.captureScreenshot", format="png", clip=box)["data"]
        self.value("document.head.lastChild.remove()")
        with Image.open(io.BytesIO(base64.b64decode(data))) as picture:
            return np.asarray(picture.convert("RGB"), dtype=np.int16)
