"""Firefox on a screen that only exists in memory (Xvfb), driven by WebDriver BiDi over a WebSocket.

It is not started with --headless: then it offers no WebGL, whatever its preferences.
"""

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
from websockets.sync.client import connect

PREFERENCES: dict[str, bool | int | str] = {
    "webgl.force-enabled": True,  # by software, without a graphics card
    "dom.w3c_touch_events.enabled": 1,  # without a touch screen
    "app.normandy.enabled": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "toolkit.telemetry.enabled": False,
    "extensions.getAddons.cache.enabled": False,
    "media.gmp-manager.updateEnabled": False,
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
    "services.settings.server": "http://localhost:9",  # nothing is fetched in the background
}
EVENTS = ["log.entryAdded", "network.beforeRequestSent", "network.fetchError"]
# keys that are not one character, as WebDriver names them
KEYS = {"Tab": "\ue004", "End": "\ue010", "Home": "\ue011", "ArrowLeft": "\ue012", "ArrowUp": "\ue013"}
KEYS |= {"ArrowRight": "\ue014", "Shift": "\ue008"}
FOCUSABLE = "button, input, select, summary, canvas, a[href], [tabindex]"


class Firefox(Browser):
    """One page of Firefox."""

    name = "firefox"

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self._count, self._asked = 0, False
        with ExitStack() as stack:
            log = stack.enter_context((folder / "log").open("wb"))
            screen = stack.enter_context(Screen(log.fileno()))
            self._process = stack.enter_context(started(folder, screen.number, log.fileno()))
            stack.callback(lambda: end(self._process, self._asked))
            address = self._address(folder)
            # no proxy: it is on this machine; pictures are larger than the usual limit of a message
            self._socket = stack.enter_context(
                connect(f"{address}/session", proxy=None, max_size=None, open_timeout=PATIENCE)
            )
            self.call("session.new", capabilities={})
            self._page = self.call("browsingContext.getTree")["contexts"][0]["context"]
            self.call("session.subscribe", events=EVENTS)
            self.resize(900, 640)
            self._stack = stack.pop_all()

    def _address(self, folder: Path) -> str:
        """Where it listens, once it has told so."""
        path, deadline = folder / "profile" / "WebDriverBiDiServer.json", time.monotonic() + PATIENCE
        while True:
            assert self._process.poll() is None, (
                f"Firefox ended: {(folder / 'log').read_text(errors='replace')}"
            )
            assert time.monotonic() < deadline, f"Firefox does not listen; see {folder / 'log'}"
            try:
                told = json.loads(path.read_text())
                return f"ws://{told['ws_host']}:{told['ws_port']}"
            except (FileNotFoundError, json.JSONDecodeError):  # not yet, or not all of it
                time.sleep(0.1)

    def close(self) -> None:
        with self._stack:
            self.call("browser.close")
            self._asked = True

    # -- the protocol ----------------------------------------------------------------------------

    def call(self, method: str, **parameters: Any) -> Any:
        """Call a method of the protocol and wait for its result."""
        self._count += 1
        self._socket.send(json.dumps({"id": self._count, "method": method, "params": parameters}))
        while True:
            found = json.loads(self._socket.recv(timeout=PATIENCE))
            if found.get("id") == self._count:
                assert found["type"] == "success", f"{method}: {found}"
                return found["result"]
            self._note(found)

    def _note(self, event: dict[str, Any]) -> None:
        method, p = event.get("method"), event.get("params", {})
        if method == "log.entryAdded":
            # warnings about a page are about what standards say today; those of its own script are its own
            if p["level"] == "error" or (p["level"] == "warn" and p["type"] == "console"):
                self.complaints.append(str(p["text"]))
        elif method == "network.fetchError":
            self.complaints.append(f"{p['request']['url']}: {p['errorText']}")
        elif method == "network.beforeRequestSent":
            self.requests.append(p["request"]["url"])

    def _act(self, *sources: dict[str, Any]) -> None:
        actions = [{"id": f"{source['type']} {i}", **source} for i, source in enumerate(sources)]
        self.call("input.performActions", context=self._page, actions=actions)

    # -- what a person does ----------------------------------------------------------------------

    def navigate(self, address: str) -> None:
        self.call("browsingContext.navigate", context=self._page, url=address, wait="complete")

    def value(self, expression: str) -> Any:
        # as JSON: the protocol's own way to write an object is of many pieces
        whole = f"(async () => JSON.stringify(await ({expression})))()"
        target = {"context": self._page}
        found = self.call("script.evaluate", expression=whole, target=target, awaitPromise=True)
        assert found["type"] == "success", found["exceptionDetails"]
        text = found["result"].get("value")
        return None if text is None else json.loads(text)

    def press(self, key: str) -> None:
        key = KEYS.get(key, key)
        self._act(
            {"type": "key", "actions": [{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]}
        )
        self.frame()

    def drag(self, start: Place, *places: Place) -> None:
        down, up = {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}
        self._act({"type": "pointer", "actions": [moved(start), down, *map(moved, places), up]})
        self.frame()

    def point(self, place: Place) -> None:
        self._act({"type": "pointer", "actions": [moved(place)]})

    def touch(self, *places: Sequence[Place]) -> None:
        self._act(*(finger(path) for path in zip(*places, strict=True)))
        self.frame()

    def resize(self, width: int, height: int, phone: bool = False) -> None:
        size = {"width": width, "height": height}
        self.call("browsingContext.setViewport", context=self._page, viewport=size, devicePixelRatio=1)

    def screenshot(self, box: dict[str, float]) -> bytes:
        clip = {key: box[key] for key in ("x", "y", "width", "height")} | {"type": "box"}
        found = self.call(
            "browsingContext.captureScreenshot", context=self._page, origin="viewport", clip=clip
        )
        return base64.b64decode(found["data"])

    def nameless(self) -> list[str]:
        found = []
        locator = {"type": "accessibility", "value": {"name": ""}}
        for node in self.call("browsingContext.locateNodes", context=self._page, locator=locator)["nodes"]:
            asked = self.call(
                "script.callFunction",
                functionDeclaration=f"(element) => element.matches('{FOCUSABLE}') && "
                "element.checkVisibility() && element.outerHTML",
                arguments=[{"sharedId": node["sharedId"]}],
                target={"context": self._page},
                awaitPromise=False,
            )
            text = asked["result"].get("value")
            if text:
                found.append(text)
        return found


def moved(place: Place) -> dict[str, Any]:
    """The pointer's way to a place."""
    return {"type": "pointerMove", "x": round(place[0]), "y": round(place[1])}


def finger(path: Sequence[Place]) -> dict[str, Any]:
    """A finger that goes a way."""
    down, up = {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}
    actions = [moved(path[0]), down, *map(moved, path[1:]), up]
    return {"type": "pointer", "parameters": {"pointerType": "touch"}, "actions": actions}


def started(folder: Path, screen: int, log: int) -> subprocess.Popen[bytes]:
    """Firefox with a profile and a home of its own, on a screen."""
    program = PROGRAMS["firefox"]
    assert program is not None
    profile, home = folder / "profile", folder / "home"
    profile.mkdir()
    home.mkdir()
    lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in PREFERENCES.items()]
    (profile / "user.js").write_text("\n".join(lines))
    kept = {
        name: v
        for name, v in os.environ.items()
        if not name.startswith(("XDG_", "MOZ_", "WAYLAND_", "DBUS_"))
    }
    own = {"DISPLAY": f":{screen}", "HOME": str(home), "LIBGL_ALWAYS_SOFTWARE": "1"}
    own |= {"MOZ_CRASHREPORTER_DISABLE": "1", "NO_AT_BRIDGE": "1", "GDK_BACKEND": "x11"}
    command = [program, "--no-remote", "--remote-debugging-port=0", "--profile", str(profile), "about:blank"]
    none = subprocess.DEVNULL
    return subprocess.Popen(command, stdin=none, stdout=log, stderr=log, env=kept | own, cwd=folder)


class Screen:
    """A screen in memory, with the first number that is free.

    Attributes
    ----------
    number : int
        Number of the display.
    """

    def __init__(self, log: int) -> None:
        program = PROGRAMS["xvfb"]
        assert program is not None
        told, tells = os.pipe()
        size = ["-screen", "0", "1600x1200x24", "-nolisten", "tcp"]
        command = [program, "-displayfd", str(tells), *size]
        with os.fdopen(told, "rb") as answer:
            none = subprocess.DEVNULL
            try:
                self._process = subprocess.Popen(
                    command, pass_fds=(tells,), stdin=none, stdout=log, stderr=log
                )
            finally:
                os.close(tells)
            ready = select.select([answer], [], [], PATIENCE)[0]
            line = answer.readline().strip() if ready else b""
        if not line:
            self._end()
        assert line, "Xvfb gives no screen"
        self.number = int(line)

    def __enter__(self) -> Screen:
        return self

    def __exit__(self, *_: object) -> None:
        self._end()

    def _end(self) -> None:
        self._process.terminate()
        self._process.wait(PATIENCE)
