"""Firefox and WebKit for tests, controlled by WebDriver, the standard protocol for browsers.

Debian has no geckodriver, so Firefox is controlled by WebDriver BiDi. WebKit has a driver for the
classic WebDriver, and needs a virtual screen. If CI is set, a missing browser is a failure.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from http.client import HTTPConnection
from pathlib import Path
from typing import Any, TypeVar

from tornado.websocket import websocket_connect

from browser import need

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox") or ""
WEBKIT = {"WebKitWebDriver": "webkit2gtk-driver", "Xvfb": "xvfb"}  # command -> Debian's package
CONTROL, ENTER = "\ue009", "\ue007"  # keys, as WebDriver encodes them
STARTED = 60.0  # s; machines of CI are slow
BEGUN = 40.0  # s for WebKit to start, which takes one
ANSWERED = 150.0  # s; longer than any script waits

Found = TypeVar("Found")


class Browser:
    """A browser with one page. It downloads files to somewhere in its home folder."""

    def __init__(self, home: Path) -> None:
        self.home = home

    def begin(self) -> None:
        """Give the browser a new visitor, for whom nothing is stored yet."""
        raise NotImplementedError

    def open(self, address: str) -> None:
        """Open a page, and wait until it has loaded."""
        raise NotImplementedError

    def run(self, script: str) -> Any:
        """Run the body of an async function in the page. Return its result, which must be JSON."""
        raise NotImplementedError

    def press(self, *keys: str) -> None:
        down = [{"type": "keyDown", "value": key} for key in keys]
        up = [{"type": "keyUp", "value": key} for key in reversed(keys)]
        self.act([{"type": "key", "id": "keyboard", "actions": [*down, *up]}])

    def act(self, actions: list[dict[str, Any]]) -> None:
        raise NotImplementedError


class Firefox(Browser):
    """Firefox, controlled by WebDriver BiDi over a WebSocket."""

    def __init__(self, home: Path, address: str) -> None:
        super().__init__(home)
        self.runner = asyncio.Runner()
        self.number = 0
        self.socket = self.runner.run(self._connected(f"{address}/session"))
        self.send("session.new", capabilities={})
        self.visitor: dict[str, str] = {}
        self.page = ""

    async def _connected(self, address: str) -> Any:
        return await websocket_connect(address)

    def send(self, method: str, **parameters: Any) -> Any:
        self.number += 1
        command = {"id": self.number, "method": method, "params": parameters}
        answer = self.runner.run(asyncio.wait_for(self._answer(command), ANSWERED))
        if answer["type"] == "error":
            raise RuntimeError(f"{method}: {answer['message']}")
        return answer["result"]

    async def _answer(self, command: dict[str, Any]) -> Any:
        await self.socket.write_message(json.dumps(command))
        while message := await self.socket.read_message():
            answer = json.loads(message)
            if answer.get("id") == command["id"]:
                return answer
        raise ConnectionError("Firefox has closed the connection")

    def begin(self) -> None:
        if self.visitor:
            self.send("browser.removeUserContext", **self.visitor)
        self.visitor = self.send("browser.createUserContext")
        # Only in a new tab is the focus in the page, and not in the address bar.
        self.page = self.send("browsingContext.create", type="tab", **self.visitor)["context"]

    def open(self, address: str) -> None:
        self.send("browsingContext.navigate", context=self.page, url=address, wait="complete")

    def run(self, script: str) -> Any:
        found = self.send(
            "script.evaluate",
            expression=f"(async () => {{{script}}})().then(JSON.stringify)",
            target={"context": self.page},
            awaitPromise=True,
        )
        if found["type"] == "exception":
            raise RuntimeError(found["exceptionDetails"]["text"])
        return json.loads(found["result"].get("value", "null"))

    def act(self, actions: list[dict[str, Any]]) -> None:
        self.send("input.performActions", context=self.page, actions=actions)

    def close(self) -> None:
        self.send("browser.close")
        self.runner.close()


class WebKit(Browser):
    """WebKit's small browser, controlled by the classic WebDriver over HTTP."""

    def __init__(self, home: Path, display: str) -> None:
        super().__init__(home)
        # Without DMABUF, it draws twice as fast on a virtual screen.
        self.variables = {"DISPLAY": display, "WEBKIT_DISABLE_DMABUF_RENDERER": "1"}
        self.driver = contextlib.ExitStack()
        self.port = 0
        self.session = ""

    def send(
        self, command: str, method: str = "POST", timeout: float = ANSWERED, **parameters: Any
    ) -> Any:
        connection = HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        connection.request(method, f"{self.session or '/session'}{command}", json.dumps(parameters))
        answer = json.loads(connection.getresponse().read())["value"]
        connection.close()
        if isinstance(answer, dict) and "error" in answer:
            raise RuntimeError(f"{command}: {answer['message']}")
        return answer

    def begin(self) -> None:
        """Start a new browser. Once in some hundred times it hangs, and another one is started."""
        for _ in range(2):
            with contextlib.suppress(TimeoutError):
                self._start()
                break
        else:
            self._start()
        self.send("/timeouts", script=1e3 * ANSWERED)

    def _start(self) -> None:
        self.close()
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        command = ["WebKitWebDriver", f"--port={self.port}"]
        self.driver.enter_context(running(command, self.home, self.variables))
        until(lambda: is_open(self.port))
        self.session = f"/session/{self.send('', timeout=BEGUN, capabilities={})['sessionId']}"

    def open(self, address: str) -> None:
        self.send("/url", url=address)

    def run(self, script: str) -> Any:
        return self.send("/execute/sync", script=f"return (async () => {{{script}}})()", args=[])

    def act(self, actions: list[dict[str, Any]]) -> None:
        self.send("/actions", actions=actions)

    def close(self) -> None:
        if self.session:
            self.send("", method="DELETE")
        self.session = ""
        self.driver.close()


@contextmanager
def firefox(home: Path) -> Iterator[Firefox]:
    need("" if FIREFOX else "there is no Firefox; on Debian: apt-get install firefox-esr")
    profile, log = home / "profile", home / "firefox.log"
    profile.mkdir()
    # The list of downloads would take the focus from the page.
    settings = 'user_pref("browser.download.alwaysOpenPanel", false);\n'
    (profile / "user.js").write_text(settings, encoding="utf-8")
    command = [FIREFOX, "--headless", "--remote-debugging-port=0", "--profile", str(profile)]
    with log.open("w", encoding="utf-8") as file, running(command, home, stderr=file):
        began = until(
            lambda: re.search("BiDi listening on (ws:.*)", log.read_text(encoding="utf-8"))
        )
        browser = Firefox(home, began[1])
        yield browser
        browser.close()


@contextmanager
def webkit(home: Path) -> Iterator[WebKit]:
    for command, package in WEBKIT.items():
        found = shutil.which(command)
        need("" if found else f"there is no {command}; on Debian: apt-get install {package}")
    screen = ["Xvfb", "-displayfd", "1", "-screen", "0", "1280x900x24", "-nolisten", "tcp"]
    with running(screen, home, stdout=subprocess.PIPE) as xvfb:
        number = xvfb.stdout.readline().decode().strip()  # of a display that was free
        browser = WebKit(home, f":{number}")
        yield browser
        browser.close()


@contextmanager
def running(
    command: list[str], home: Path, variables: Mapping[str, str] = {}, **files: Any
) -> Iterator[subprocess.Popen[bytes]]:
    """Run a command with its own home folder. In the end, kill it with all that it has started."""
    # Nothing else is passed on, because a desktop's settings would come before the virtual screen.
    # Pages learn the language from LANG, even if the system lacks it.
    kept = {name: value for name, value in os.environ.items() if name in ("PATH", "TMPDIR")}
    process = subprocess.Popen(
        command,
        env={**kept, "HOME": str(home), "LANG": "en_US.UTF-8", **variables},
        start_new_session=True,
        **{"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL} | files,
    )
    try:
        yield process
    finally:
        process.terminate()
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(timeout=10.0)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def until(condition: Callable[[], Found | None]) -> Found:
    """Wait until a condition has a value, and return it."""
    end = time.monotonic() + STARTED
    while time.monotonic() < end:
        if found := condition():
            return found
        time.sleep(0.02)
    raise TimeoutError("what a test waits for does not happen")


def is_open(port: int) -> bool:
    """Return whether somebody listens on a port of this machine."""
    with socket.socket() as trial:
        return trial.connect_ex(("127.0.0.1", port)) == 0


BROWSERS = {"Firefox": firefox, "WebKit": webkit}
