"""Use a student's objects on behalf of the checks, which run in another process.

This module runs in the worker, beside the student's code, which can change anything here. The other
end therefore trusts no answer.
"""

from __future__ import annotations

import base64
import builtins
import contextlib
import importlib
import marshal
import operator
import os
import socket
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

from autograder.checks.printed import CappedText
from autograder.diagnosis.faults import fault_of
from autograder.diagnosis.undefined import MissingNameError, answer_for_missing, broken_module
from autograder.isolation.wire import (
    KNOWN_ERRORS,
    LONGEST_LINE,
    LONGEST_TEXT,
    UnsendableError,
    Wire,
    pack,
    unpack,
)
from autograder.message import Message, with_texts
from autograder.records import to_json

_KNOWN = {getattr(builtins, name): name for name in KNOWN_ERRORS}


class StudentSide:
    """Carries out the checks' requests in the process that runs the student's code.

    The checks refer to the student's objects by their positions in a list, which also keeps the
    objects alive, because Python could otherwise reuse the id of one for another.
    """

    def __init__(self, wire: Wire, engine: list[Path]) -> None:
        self.wire = wire
        self.engine = engine
        self.objects: list[Any] = []
        self.numbers: dict[int, int] = {}

    def serve(self) -> None:
        """Carry out requests from the checks until the connection is closed."""
        with contextlib.suppress(EOFError, BrokenPipeError):
            while True:
                self.answer(self.wire.receive())

    def answer(self, request: dict[str, Any]) -> None:
        """Carry out one request, and send back the result or a description of an exception."""
        reply: dict[str, Any] = {"id": request["id"]}
        try:
            operands = [unpack(operand, self.find) for operand in request["with"]]
            reply["value"] = pack(getattr(self, "do_" + request["do"])(*operands), self.refer)
        except MissingNameError as error:
            reply["missing"] = vars(error.missing)
        except UnsendableError as error:
            reply["unsendable"] = str(error)
        except BaseException as error:
            if isinstance(error, MemoryError):
                traceback.clear_frames(error.__traceback__)  # what the student's code has filled
            # We compare classes and not names, since a student's class may be called ValueError.
            known = (_KNOWN.get(base) for base in type(error).__mro__)
            reply["raised"] = next(filter(None, known), "BaseException")
            fault = with_texts(fault_of(error, self.engine), lambda text: text[:LONGEST_TEXT])
            reply["fault"] = to_json(fault)
        self.wire.send(reply)

    def refer(self, value: Any) -> dict[str, Any]:
        """Return a reference to one of the student's objects, such as {"object": 3, ...}."""
        number = self.numbers.setdefault(id(value), len(self.objects))
        if number == len(self.objects):
            self.objects.append(value)
        return {"object": number, "type": type(value).__name__[:100]}

    def find(self, data: dict[str, Any]) -> Any:
        """Return the student's object, or the proxy for a check's function, that is meant."""
        if "object" in data:
            return self.objects[data["object"]]
        if "callback" in data:
            return self.callback(data["callback"])
        return self.do_name(*data["name"])

    def callback(self, number: int) -> Callable[..., Any]:
        """Create a function that calls a function of the check, which runs in the other process."""

        def call(*arguments: Any) -> Any:
            packed = [pack(argument, self.refer) for argument in arguments]
            self.wire.send({"callback": number, "with": packed})
            while True:
                message = self.wire.receive()
                if "id" in message:  # the check's function makes a request itself
                    self.answer(message)
                elif "error" in message:
                    name, text = message["error"]
                    kind = getattr(builtins, name) if name in KNOWN_ERRORS else Exception
                    raise kind(text)
                else:
                    return unpack(message["value"], self.find)

        return call

    # The requests. Each method's name is "do_" and the name of its request.

    do_get, do_set = staticmethod(getattr), staticmethod(setattr)
    do_length, do_iterate = staticmethod(len), staticmethod(iter)

    def do_begin(self, broken: list[str]) -> None:
        """Put placeholders in the place of broken modules. The check process explains them."""
        for module in broken:
            sys.modules[module] = broken_module(module, Message())

    def do_compile(self, file: str) -> str | None:
        """Return a file's bytecode as base64, or None if it is not valid or too long to send."""
        try:
            code = marshal.dumps(compile(Path(file).read_bytes(), file, "exec", dont_inherit=True))
        except (SyntaxError, ValueError, OSError, MemoryError, RecursionError):
            return None  # the import will raise the error
        return base64.b64encode(code).decode() if len(code) < LONGEST_LINE // 2 else None

    def do_import(self, module: str) -> None:
        """Import a student's module, and discard what it prints outside of a check."""
        nowhere = CappedText(lambda _: None)
        with contextlib.redirect_stdout(nowhere), contextlib.redirect_stderr(nowhere):
            importlib.import_module(module)

    def do_name(self, module: str, name: str) -> Any:
        if module not in sys.modules:
            self.do_import(module)
        imported = sys.modules[module]
        imported.__dict__.setdefault("__getattr__", answer_for_missing(imported))
        return getattr(imported, name)

    def do_get_together(self, value: Any, names: list[str]) -> tuple[Any, ...]:
        return tuple([getattr(value, name) for name in names])

    def do_call(self, function: Any, arguments: list[Any], keywords: dict[str, Any]) -> Any:
        return function(*arguments, **keywords)

    def do_operate(self, name: str, operands: list[Any]) -> Any:
        return getattr(operator, name)(*operands)

    def do_next(self, iterator: Any) -> list[Any]:
        """Return the next item in a list, because the end must differ from an item like None."""
        for item in iterator:
            return [item]
        return []

    def do_is_instance(self, value: Any, kind: Any) -> bool:
        return isinstance(value, kind) is True

    def do_show(self, value: Any) -> str:
        return str(repr(value))[:1000]

    def do_test_walls(self, what: list[str], forbidden: str) -> list[str]:
        """Try forbidden operations in a worker without student code, and list the successful."""
        through = []
        for name in what:
            with contextlib.suppress(OSError):
                ATTEMPTS[name](forbidden)
                through.append(name)
        return through


def _reach_out(_: str) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as outside:
        outside.connect(("192.0.2.1", 9))  # an address reserved for documentation


ATTEMPTS: dict[str, Callable[[str], Any]] = {
    "reading a file": lambda path: os.open(path, os.O_RDONLY),
    "writing a file": lambda path: os.open(path + ".new", os.O_WRONLY | os.O_CREAT),
    "reaching the network": _reach_out,
    "starting a process": lambda _: os.fork() or os._exit(0),
    "sending a signal": lambda _: os.kill(os.getpid(), 0),
}
