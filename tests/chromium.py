"""Chromium without a screen, driven by its DevTools protocol over a pipe, with the standard library only."""

from __future__ import annotations

import base64
import json
import os
import select
import subprocess
import time
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from browser import PATIENCE, PROGRAMS, Browser, Place, end

SWITCHES = (
    "--headless=new --no-sandbox --remote-debugging-pipe --enable-unsafe-swiftshader --use-angle=swiftshader "
    "--use-gl=angle --no-first-run --disable-extensions --disable-background-networking --hide-scrollbars"
)
CODES = {"Tab": 9, " ": 32, "End": 35, "Home": 36, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39}
WRAPPER = 'exec "$@" 3<&0 4>&1 0</dev/null 1>&2'  # the protocol wants the descriptors 3 and 4


class Chromium(Browser):
    """One page of Chromium."""

    name = "chromium"

    def __init__(self, folder: Path) -> None:
        super().__init__()
        program = PROGRAMS["chromium"]
        assert program is not None
        command = [
            "/bin/sh",
            "-c",
            WRAPPER,
            "sh",
            program,
            *SWITCHES.split(),
            f"--user-data-dir={folder}/profile",
        ]
        self._log = folder / "log"
        self._buffer, self._count, self._session, self._asked = b"", 0, "", False
        with ExitStack() as stack:
            log = stack.enter_context(self._log.open("wb"))
            pipe = subprocess.PIPE
            self._process = stack.enter_context(
                subprocess.Popen([*command, "about:blank"], stdin=pipe, stdout=pipe, stderr=log, bufsize=0)
            )
            stack.callback(lambda: end(self._process, self._asked))
            assert self._process.stdin is not None and self._process.stdout is not None
            self._write, self._read = self._process.stdin.fileno(), self._process.stdout.fileno()
            targets = self.call("Target.getTargets")["targetInfos"]
            target = next(entry["targetId"] for entry in targets if entry["type"] == "page")
            self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
            for domain in ("Page", "Runtime", "Log", "Network", "Accessibility"):
                self.call(f"{domain}.enable")
            self.resize(900, 640)
            self._stack = stack.pop_all()

    def close(self) -> None:
        with self._stack:
            self._session = ""
            self.call("Browser.close")
            self._asked = True

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

    def navigate(self, address: str) -> None:
        self.call("Page.navigate", url=address)

    def value(self, expression: str) -> Any:
        found = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in found, found["exceptionDetails"]
        return found["result"].get("value")

    def press(self, key: str) -> None:
        event: dict[str, Any] = {"key": key, "code": "Space" if key == " " else key}
        event |= {"windowsVirtualKeyCode": CODES[key]} if key in CODES else {}
        text = {"text": key} if len(key) == 1 else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", **event, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", **event)
        self.frame()

    def drag(self, start: Place, *places: Place) -> None:
        end = places[-1] if places else start
        for kind, (x, y) in (
            ("mousePressed", start),
            *(("mouseMoved", place) for place in places),
            ("mouseReleased", end),
        ):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1)
        self.frame()

    def point(self, place: Place) -> None:
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=place[0], y=place[1])

    def touch(self, *places: Sequence[Place]) -> None:
        for kind, fingers in zip(["touchStart"] + ["touchMove"] * (len(places) - 1), places, strict=True):
            points = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(fingers)]
            self.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.frame()

    def resize(self, width: int, height: int, phone: bool = False) -> None:
        size = {"width": width, "height": height}
        self.call("Emulation.setDeviceMetricsOverride", **size, deviceScaleFactor=1, mobile=phone)
        self.call("Emulation.setTouchEmulationEnabled", enabled=phone)

    def screenshot(self, box: dict[str, float]) -> bytes:
        clip = {key: box[key] for key in ("x", "y", "width", "height")} | {"scale": 1}
        return base64.b64decode(self.call("Page.captureScreenshot", format="png", clip=clip)["data"])

    def nameless(self) -> list[str]:
        found = []
        for node in self.call("Accessibility.getFullAXTree")["nodes"]:
            can = {entry["name"]: entry["value"].get("value") for entry in node.get("properties", [])}
            if can.get("focusable") and not node["ignored"] and not node["name"]["value"].strip():
                found.append(json.dumps(node["role"]))
        return found
