"""Provide handles, through which a check uses a student's objects in another process.

If ``v`` is a handle, ``v.x`` sends a request to the worker and waits for the answer. A check cannot
compare a handle, convert it or use it as a truth value, because the student's code would then
decide the outcome: an object's ``__eq__`` may always return True. Instead the check must read plain
numbers and compare them itself.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any, NoReturn

from autograder.diagnosis.faults import CheckEnded
from autograder.diagnosis.slips import NOT_IMPLEMENTED
from autograder.diagnosis.undefined import MissingName
from autograder.isolation.exceptions import exception_of, read
from autograder.isolation.wire import KNOWN_ERRORS, BrokenProtocolError, Wire, pack, unpack
from autograder.message import Kind, Message
from autograder.text.clean import clean

BROKEN = "the code broke the protocol between its process and the checks"
ENOUGH = 0.5  # a worker that had this part of the time limit on a processor gets no more


class WorkerFailure(CheckEnded):
    """Raised when the process that runs the student's code has died or sent something invalid."""


def extra_time(process: int, seconds: float) -> float:
    """Return how many more seconds a process gets after a time limit of ``seconds``.

    The limit is in real time, because code that only waits must be stopped too. On a busy machine
    even correct code would then sometimes seem too slow. A process that had a processor for less
    than half of the limit therefore gets the rest. It gets none if its ID, ``process``, is unknown.
    """
    try:
        text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace")
        user, system = text.rpartition(")")[2].split()[11:13]  # its name may contain anything
    except (OSError, ValueError):
        return 0.0
    used = (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")
    return seconds - used if used < ENOUGH * seconds else 0.0


class Session:
    """A session between a check and the worker process that runs the student's code.

    The worker, whose process ID is ``process``, has ``seconds`` for all answers of a check.
    ``broken`` maps each student module that cannot be imported to the reason.
    """

    def __init__(
        self,
        wire: Wire,
        seconds: float,
        on_hang: Callable[[], NoReturn],
        how_it_ended: Callable[[], str],
        broken: Mapping[str, Message] | None = None,
        process: int = 0,
    ) -> None:
        self.wire = wire
        self.seconds = seconds
        self.on_hang = on_hang
        self.how_it_ended = how_it_ended
        self.broken = broken or {}
        self.process = process
        self.dead = Message()  # once the worker is gone, this message says why
        self._last = 0
        self._callbacks: list[Callable[..., Any]] = []
        self.restart_clock()

    def restart_clock(self) -> None:
        self.deadline = time.monotonic() + self.seconds

    def end(self) -> None:
        """Refuse all further requests, because the worker is gone."""
        if not self.dead:
            self.dead = Message("the process of the student's code has ended", kind=Kind.LEFT)

    def ask(self, what: str, *operands: Any) -> Any:
        """Send a request to the worker. Return its answer, or raise the exception of its code."""
        if self.dead:
            raise WorkerFailure(self.dead)
        self._last += 1
        packed = [pack(operand, self._refer) for operand in operands]
        message = {"id": self._last, "do": what, "with": packed}
        try:
            return self._answer(self._exchange(message))
        except BrokenProtocolError as error:
            self._fail(Message(f"{BROKEN}: {error}"))

    def _exchange(self, message: dict[str, Any]) -> dict[str, Any]:
        """Send a request, and answer calls to the check's functions until the reply arrives."""
        try:
            self.wire.send(message, self.deadline)
            while "callback" in (reply := self._receive()):
                self.wire.send(self._call_back(reply), self.deadline)
        except TimeoutError:
            self.on_hang()
        except (EOFError, OSError):
            self.end()
            self._fail(Message(self.how_it_ended(), kind=Kind.LEFT))
        if reply.get("id") != message["id"]:
            raise BrokenProtocolError("an answer to another request")
        return reply

    def _receive(self) -> dict[str, Any]:
        try:
            return self.wire.receive(self.deadline)
        except TimeoutError:
            process, self.process = self.process, 0  # no process gets extra time twice
            if not (more := extra_time(process, self.seconds)):
                raise
            self.deadline = time.monotonic() + more
            return self.wire.receive(self.deadline)

    def _answer(self, reply: dict[str, Any]) -> Any:
        if "value" in reply:
            return unpack(reply["value"], self._find)
        if "missing" in reply:
            missing = read(reply["missing"], MissingName)
            raise WorkerFailure(self.broken.get(missing.module) or missing.explain())
        if "unsendable" in reply:
            what = read(reply["unsendable"], str)
            raise WorkerFailure(Message(f"the returned value cannot be used: {what}"))
        raise exception_of(reply.get("raised"), reply.get("fault"))

    def _call_back(self, message: dict[str, Any]) -> dict[str, Any]:
        """Call a function that the check has passed to the student's code, such as a force.

        An Exception is raised again in the student's code. Anything else, such as a failure of the
        check, ends the session, so that the code cannot catch it.
        """
        number = message["callback"]
        if type(number) is not int or not 0 <= number < len(self._callbacks):
            raise BrokenProtocolError("an unknown callback")
        arguments = unpack({"list": message.get("with")}, self._find)
        if type(arguments) is not list:
            raise BrokenProtocolError("a callback without arguments")
        try:
            return {"value": pack(self._callbacks[number](*arguments), self._refer)}
        except Exception as error:
            text = str(error.args[0]) if len(error.args) == 1 else str(error)
            names = [base.__name__ for base in type(error).__mro__]
            return {"error": [next(name for name in names if name in KNOWN_ERRORS), text]}
        except BaseException:
            self.dead = Message("a callback of the check failed")
            raise

    def _refer(self, value: Any) -> dict[str, Any]:
        if isinstance(value, ObjectHandle):
            if value._session() is not self:
                why = "an object of another check is used after its process has ended"
                raise WorkerFailure(Message(why))
            return value._reference
        if callable(value):
            self._callbacks.append(value)
            return {"callback": len(self._callbacks) - 1}
        if isinstance(value, tuple):  # a check's own kind of tuple
            return {"tuple": [pack(item, self._refer) for item in value]}
        raise TypeError(
            f"only plain data, handles and functions can be sent to a worker, not {value!r}"
        )

    def _find(self, data: dict[str, Any]) -> ObjectHandle:
        number = data.get("object")
        if type(number) is not int:
            raise BrokenProtocolError("a value of an unknown kind")
        return ObjectHandle(lambda: self, {"object": number}, read(data.get("type"), str))

    def _fail(self, why: Message) -> NoReturn:
        self.dead = why
        raise WorkerFailure(why) from None


class ObjectHandle:
    """Represents one of the student's objects, which is in the worker, in a check.

    ``session`` returns the session with that worker, in which ``reference`` stands for the object.
    """

    __slots__ = ("_reference", "_session", "_type_name")
    _reference: dict[str, Any]
    _session: Callable[[], Session]
    _type_name: str

    def __init__(
        self, session: Callable[[], Session], reference: dict[str, Any], type_name: str = ""
    ) -> None:
        object.__setattr__(self, "_session", session)
        object.__setattr__(self, "_reference", reference)
        object.__setattr__(self, "_type_name", type_name)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return self._session().ask("get", self, name)

    def get_together(self, names: list[str]) -> tuple[Any, ...]:
        """Read several attributes with a single request, which is faster than one for each."""
        values = self._session().ask("get_together", self, names)
        if type(values) is not tuple or len(values) != len(names):
            raise WorkerFailure(Message(f"{BROKEN}: attributes that are not valid"))
        return values

    def __setattr__(self, name: str, value: Any) -> None:
        self._session().ask("set", self, name, value)

    def __call__(self, *arguments: Any, **keywords: Any) -> Any:
        return self._session().ask("call", self, list(arguments), keywords)

    def __len__(self) -> int:
        length = self._session().ask("length", self)
        if type(length) is not int or not 0 <= length < 1 << 31:
            raise WorkerFailure(Message(f"{BROKEN}: a length that is not valid"))
        return length

    def __iter__(self) -> Iterator[Any]:
        iterator = self._session().ask("iterate", self)
        while item := self._session().ask("next", iterator):
            yield item[0]

    def __instancecheck__(self, value: Any) -> bool:
        return self._session().ask("is_instance", value, self) is True

    def __repr__(self) -> str:
        shown = self._session().ask("show", self)
        return clean(shown) if type(shown) is str else "an object whose repr is not a string"


def _operation(name: str, *, reflected: bool = False) -> Callable[..., Any]:
    def operate(self: ObjectHandle, *others: Any) -> Any:
        operands = [*others, self] if reflected else [self, *others]
        return self._session().ask("operate", name, operands)

    return operate


def _refused(name: str) -> Callable[..., Any]:
    def refuse(self: ObjectHandle, *_: Any) -> NoReturn:
        if self._type_name == "NotImplementedType":
            raise WorkerFailure(Message(got="NotImplemented", likely=NOT_IMPLEMENTED))
        why = f"the code returned an object where a plain value is expected: {self!r} (checks "
        why += f"compare numbers that they read from an object, and never call its {name})"
        raise WorkerFailure(Message(why))

    return refuse


UNARY = "neg pos abs invert getitem setitem delitem"
BINARY = "add sub mul truediv floordiv mod pow matmul and or xor"
REFUSED = "eq ne lt le gt ge bool float int complex index contains"
for _name in UNARY.split():
    setattr(ObjectHandle, f"__{_name}__", _operation(_name))
for _name in BINARY.split():
    _function = f"__{_name}__"  # the module operator has it under this name, too
    setattr(ObjectHandle, _function, _operation(_function))
    setattr(ObjectHandle, f"__r{_name}__", _operation(_function, reflected=True))
    setattr(ObjectHandle, f"__i{_name}__", _operation("i" + _name))
for _name in REFUSED.split():
    setattr(ObjectHandle, f"__{_name}__", _refused(f"__{_name}__"))
setattr(ObjectHandle, "__hash__", object.__hash__)  # noqa: B010
