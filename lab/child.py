"""Run a student's engine in a separate process that exchanges messages with the lab's server.

Each message is one line of JSON. If the engine takes longer than its time limit, the process writes
a stack trace to the file given by ``--stack`` and exits, so that the server can explain where.
"""

from __future__ import annotations

import argparse
import contextlib
import faulthandler
import json
import os
import sys
from pathlib import Path

from lab.broken_off import FIRST_LIMIT, TIME_LIMIT
from lab.host import Host, Message
from scenes.engine import add_engine_options, use_engine
from scenes.reason import reason


def main() -> None:
    """Read the server's messages from standard input and answer them, until the input ends."""
    parser = argparse.ArgumentParser(prog="python -m lab.child", description=__doc__)
    add_engine_options(parser)
    parser.add_argument("--stack", type=Path, required=True)
    options = parser.parse_args()
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # the student's own prints must not mix with the answers
    use_engine(parser, options.engine, options.given)
    host, limit = Host(reason), FIRST_LIMIT
    with options.stack.open("w", encoding="utf-8") as stack:
        for line in sys.stdin.buffer:
            faulthandler.dump_traceback_later(limit, exit=True, file=stack)
            # An empty line ends the answers to one message.
            answers.write("".join(f"{answer}\n" for answer in answered(host, line)) + "\n")
            answers.flush()
            faulthandler.cancel_dump_traceback_later()
            limit = TIME_LIMIT
    # The server is gone and may not have cleaned up. Only a regular file is removed, because
    # ``--stack`` may also name /dev/null.
    if options.stack.is_file():
        with contextlib.suppress(OSError):
            options.stack.unlink()
            options.stack.parent.rmdir()


def answered(host: Host, line: bytes) -> list[str]:
    """Answer one message from the lab's server, and return the answers as lines of JSON."""
    try:
        message = json.loads(line)
    except (ValueError, RecursionError):
        return [as_json({"kind": "refused", "why": "The lab could not read a message."})]
    try:
        return [as_json(answer) for answer in host.receive(message)]
    except (ValueError, TypeError) as error:  # something that JSON does not have, such as NaN
        return [as_json({"kind": "stopped", "why": host.explain(error)})]


def as_json(answer: Message) -> str:
    """Encode a message as one line. A value that JSON lacks raises ValueError or TypeError."""
    return json.dumps(answer, separators=(",", ":"), allow_nan=False)


if __name__ == "__main__":
    with contextlib.suppress(BrokenPipeError, KeyboardInterrupt):  # the server has stopped
        main()
