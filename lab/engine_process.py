"""Start and stop the processes that run a student's engine, and send messages to them."""

from __future__ import annotations

import asyncio
import contextlib
import json
import sys
import tempfile
from collections.abc import AsyncIterator
from pathlib import Path

from autograder.manifest import ROOT
from lab.broken_off import FIRST_LIMIT, TIME_LIMIT, why_it_broke_off

LONGEST_LINE = 4_000_000  # bytes in one answer
GRACE = 0.4  # s, in addition to the child's own time limit
TOO_MUCH = "The scene draws more than the lab can show. Does your code keep creating objects?"
START = 15.0  # s, extra time for a new process to import its modules
LONGEST_RECORDING = 120.0  # s


class EngineProcess:
    """The process that runs a student's engine for one page, from the page's first message on."""

    def __init__(self, engine: str, given: str = "") -> None:
        self.engine = engine
        self.given = given
        self.process: asyncio.subprocess.Process | None = None
        self.folder = tempfile.TemporaryDirectory(prefix="lab-", ignore_cleanup_errors=True)
        self.stack = Path(self.folder.name) / "stack.txt"

    async def ask(self, message: str) -> AsyncIterator[str]:
        """Send a message, and yield lines of JSON. If this fails, the last line says why."""
        limit, extra = TIME_LIMIT, GRACE
        if self.process is None:
            self.process = await self._start()
            limit, extra = FIRST_LIMIT, GRACE + START
        process = self.process
        assert process.stdin is not None
        assert process.stdout is not None
        try:
            process.stdin.write(message.encode() + b"\n")
            await process.stdin.drain()
            async with asyncio.timeout(limit + extra):
                while (line := await process.stdout.readline()) != b"\n":
                    if not line:
                        raise EOFError
                    yield line.decode().rstrip("\n")
        except (TimeoutError, EOFError, ConnectionError):
            await self.end()
            stack = self.stack.read_text(encoding="utf-8") if self.stack.exists() else ""
            why = why_it_broke_off(stack, [ROOT / self.engine], limit)
            yield json.dumps({"kind": "stopped", "why": why})
        except ValueError:  # a line is longer than LONGEST_LINE
            await self.end()
            yield json.dumps({"kind": "stopped", "why": TOO_MUCH})

    async def end(self) -> None:
        """Kill the process that runs the engine, if there is one."""
        process, self.process = self.process, None
        if process is not None:
            with contextlib.suppress(ProcessLookupError):
                process.kill()
            assert process.stdout is not None
            # The process does not count as ended until its output is read, and another coroutine
            # may already be reading it. A child of the process may keep the pipes open for long.
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(GRACE):
                    with contextlib.suppress(RuntimeError):
                        await process.stdout.read()
                    await process.wait()

    async def close(self) -> None:
        await self.end()
        self.folder.cleanup()

    async def _start(self) -> asyncio.subprocess.Process:
        return await asyncio.create_subprocess_exec(
            *(sys.executable, "-m", "lab.child", "--stack", self.stack),
            *("--engine", self.engine, "--given", self.given),
            cwd=ROOT,
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            limit=LONGEST_LINE,
        )


async def recording(engine: str, given: str, scene: str, values: dict[str, str]) -> bytes:
    """Record a scene in a separate process, and return the GIF, or raise ValueError with why."""
    settings = [f"--set={name}={value}" for name, value in values.items()]
    with tempfile.TemporaryDirectory(prefix="lab-") as folder:
        process = await asyncio.create_subprocess_exec(
            *(sys.executable, "-m", "lab", "record", scene, "--out", folder),
            *("--engine", engine, "--given", given, *settings),
            cwd=ROOT,
            stdout=asyncio.subprocess.PIPE,
            stderr=asyncio.subprocess.STDOUT,
        )
        try:
            words, _ = await asyncio.wait_for(process.communicate(), LONGEST_RECORDING)
        except TimeoutError:
            process.kill()
            await process.wait()
            raise ValueError(f"the recording took longer than {LONGEST_RECORDING:g} s") from None
        if process.returncode:
            lines = words.decode(errors="replace").strip().splitlines()
            raise ValueError(lines[-1] if lines else "the recording ended without an error message")
        return (Path(folder) / f"{scene}.gif").read_bytes()
