"""The expectations of the checks. Each compares plain numbers and explains a difference.

A message shows what was called, what came back, what was wanted and how closely, the likely cause,
and where to read about it. A check passes the call, the cause and the reading to ``about`` before
it calls the student's code. Every expectation uses these words, and so does the report of an
exception in that code. An expectation accepts other words as keywords: call, then (which is put
after the call), cause and read.

The autograder runs the student's code in another process and gets only plain numbers from it, so no
function here compares objects of the engine.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Unpack

from autograder.checks.asked import Words, about, scoped, short_numbers, written
from autograder.diagnosis.slips import NOT_IMPLEMENTED
from autograder.message import ExpectationError, Message
from compared import difference

# Correct answers that were computed in another order differ by a few rounding errors, each about
# 1e-16 of the numbers involved. A limit a thousand times as large still catches a wrong formula.
ROUNDING = 1e-13
EXACT = 1e-9  # of a likely mistake, relative to its largest number
LONGEST_LIST = 12  # such as a Matrix4; of a longer list, only a part is shown
NAN = (
    "Your code accepted NaN. Every comparison with NaN is False, so x < 0.0 does not find it. "
    "Check instead that the number is valid: math.isfinite(x), or 0.0 < x < math.inf."
)
UNCHANGED = (
    "The call changed a value that it should only read. Work on a copy, or on plain numbers."
)
LOST = (
    "Your method computes a new vector but leaves v unchanged. Assign its components to self.x, "
    "self.y and self.z."
)


class NoVector:
    """A result that is not a vector. It holds no numbers, so no expectation accepts it."""

    def __init__(self, value: Any, wanted: str = "Vector3") -> None:
        self.value = value
        self.wanted = wanted

    def __repr__(self) -> str:
        if self.value is None:
            return "None"
        return f"{_shown(self.value)}, which is a {type(self.value).__name__}, not a {self.wanted}"


def xyz(v: Any) -> Any:
    """Return the components of a vector as a tuple."""
    if is_plain(v):
        return NoVector(v)
    together = getattr(type(v), "get_together", None)  # a handle asks its process only once
    return together(v, ["x", "y", "z"]) if together else (v.x, v.y, v.z)


def is_plain(value: Any) -> bool:
    """Return whether a value is None, a number, a text or a collection, not an engine's object."""
    return value is None or isinstance(value, (bool, int, float, str, tuple, list, dict))


@scoped
def expect_vector(v: Any, **words: Unpack[Words]) -> tuple[float, float, float]:
    """Expect a vector of plain numbers, and return its components."""
    __tracebackhide__ = True
    call, cause, read = about.but(words)
    about(call, cause=cause, read=read)  # reading the components runs the student's code
    got = xyz(v)
    if isinstance(got, NoVector) or not _are_numbers(got, 3):
        _complain(_shown(got), "a Vector3")
    x, y, z = got
    return x, y, z


def expect_close(
    got: Any,
    wanted: float | Sequence[float],
    slips: Mapping[str, float | Sequence[float]] | None = None,
    *,
    tolerance: float | None = None,
    **words: Unpack[Words],
) -> None:
    """Expect a number, or a sequence of numbers, each within the tolerance of the wanted one.

    The default tolerance is ROUNDING times the largest wanted number. ``slips`` lists likely
    mistakes, as in ``named``.
    """
    __tracebackhide__ = True
    wanted_numbers = _as_tuple(wanted)
    if len(wanted_numbers) == 3 and not isinstance(got, (tuple, list, NoVector)):
        got = xyz(got)
    if tolerance is None:
        tolerance = ROUNDING * max(abs(number) for number in wanted_numbers)
    got_numbers = _as_tuple(got)
    if not _are_numbers(got_numbers, len(wanted_numbers)) or not all(
        abs(g - w) <= tolerance for g, w in zip(got_numbers, wanted_numbers, strict=True)
    ):
        note = ""
        if slips:
            words["cause"] = named(got, about.but(words)[1], slips)
        if _are_numbers(got_numbers, len(wanted_numbers)) and len(wanted_numbers) <= LONGEST_LIST:
            note = difference(got_numbers, wanted_numbers, tolerance)
        _complain(*_compared(got, wanted, tolerance), words, tolerance, note)


def expect_between(
    got: Any, least: float, most: float, *, tolerance: float = 0.0, **words: Unpack[Words]
) -> None:
    """Expect a number from least to most; an infinite bound is none."""
    __tracebackhide__ = True
    if _are_numbers((got,), 1) and least - tolerance <= got <= most + tolerance:
        return
    shown, low, high = _told(got, least, most)
    wanted = f"a number from {low} to {high}"
    if least == -most:
        wanted = f"a number from -{high} to {high}"
    elif math.isinf(least):
        wanted = f"at most {high}"
    elif math.isinf(most):
        wanted = f"at least {low}"
    _complain(shown, wanted, words)


def expect_exactly(got: Any, wanted: Any, **words: Unpack[Words]) -> None:
    """Expect exactly this value of exactly this type, such as a word or True."""
    __tracebackhide__ = True
    if type(got) is type(wanted) and got == wanted:
        return
    if is_plain(got) and got == wanted:  # such as 1 and 1.0, which print alike
        came, right = (f"{value!r}, of type {type(value).__name__}" for value in (got, wanted))
        _complain(came, right, words)
    _complain(*_compared(got, wanted), words)


def expect_that(holds: bool, got: str, wanted: str, **words: Unpack[Words]) -> None:
    """Expect a condition to hold. The message says in words what came and what was wanted."""
    __tracebackhide__ = True
    if not holds:
        _complain(got, wanted, words)


def expect_nan(got: Any, **words: Unpack[Words]) -> None:
    """Expect NaN. A NaN in the input must not turn into a number that looks like a result."""
    __tracebackhide__ = True
    if not (type(got) is float and math.isnan(got)):
        _complain(_shown(got), "nan", words)


def expect_unchanged(name: str, now: Any, before: Sequence[float], **words: Unpack[Words]) -> None:
    """Expect that a call did not change a vector that it should only read."""
    __tracebackhide__ = True
    now = now if isinstance(now, (tuple, list)) else xyz(now)
    if tuple(now) != tuple(before):
        after, kept = _told(now, before)
        _complain(f"{name} is {after} after the call", f"{name} is still {kept}", words)


@scoped
def expect_error(
    attempt: Callable[[], Any],
    error: type[Exception],
    *,
    allowed: Callable[[], Any],
    valid: str = "",
    **words: Unpack[Words],
) -> None:
    """Expect attempt() to raise this error, and allowed(), which ``valid`` shows, to raise none.

    The second condition catches code that refuses every argument. If the call contains a NaN, the
    message explains how NaN gets past comparisons, unless the cause already mentions NaN.
    """
    __tracebackhide__ = True
    given, cause, read = about.but(words)
    call = written(given)
    about(
        valid or f"like {call}, but with valid arguments",
        cause="These arguments are valid, so the call must not raise an error.",
        read=read,
    )
    allowed()
    about(call, cause=NAN if "nan" in call and "NaN" not in cause else cause)
    try:
        got = attempt()
    except error:
        return
    except NotImplementedError:
        raise
    except Exception as other:
        came = f"{type(other).__name__}: {other}"
    else:
        came = "no error"
        if isinstance(got, (int, float, str, tuple, list)) or _is_not_implemented(got):
            came += f"; the call returned {_shown(got)}"
        elif _kind_of(got).endswith("Error"):
            came += f"; the call returned a {_kind_of(got)}"
            about.cause = "Your code returns the error. Write raise instead of return."
    _complain(came, error.__name__)


@scoped
def expect_same_object(made: str, step: str, v: Any, before: Any) -> None:
    """Expect v to be the same object as before, so that a change of one shows in the other."""
    before.x = 99.0
    about(
        f"{made}; w = v; {step}; w.x = 99.0; v.x",
        cause="Your method creates a new vector, so v and w are no longer the same vector. Change "
        "self.x, self.y and self.z instead, and return self.",
    )
    expect_close(v.x, 99.0)


def named(got: Any, cause: str, slips: Mapping[str, float | Sequence[float]]) -> str:
    """Return the slip that gives exactly the numbers in got, or the cause if there is none.

    A slip is a phrase that "This is" completes, or one sentence or more. The cause follows a single
    sentence. Two sentences already say what to do. "Exactly" means within EXACT, relative to the
    largest number. Rounding errors are far smaller, and two slips almost never come that close.
    """
    seen = _as_tuple(got.value if isinstance(got, NoVector) else got)
    for slip, gives in slips.items():
        numbers = _as_tuple(gives)
        near = EXACT * (max(map(abs, numbers)) or 1.0)
        if _are_numbers(seen, len(numbers)) and all(
            abs(one - other) <= near for one, other in zip(seen, numbers, strict=True)
        ):
            words = slip if slip.endswith(".") else f"This is {slip}."
            is_one = not re.search(r"\. [A-Z]", words)
            about.recognized = f"{words} {cause}" if is_one else words
            return about.recognized
    return cause


def _as_tuple(value: Any) -> tuple[Any, ...]:
    return tuple(value) if isinstance(value, (tuple, list)) else (value,)


def _are_numbers(values: tuple[Any, ...], count: int) -> bool:
    return len(values) == count and all(type(value) in (int, float) for value in values)


def _compared(got: Any, wanted: Any, tolerance: float = 0.0) -> list[str]:
    """Return two values as texts. Long lists are replaced by the first elements that differ."""
    lists = [value for value in (got, wanted) if isinstance(value, (tuple, list))]
    if len(lists) < 2 or max(map(len, lists)) <= LONGEST_LIST:
        return _told(got, wanted)
    texts = [f"{len(value)} elements" for value in lists]
    for place, pair in enumerate(zip(got, wanted, strict=False)):
        if _differ(*pair, tolerance):
            items = _told(*pair)
            return [f"{t}, where [{place}] is {i}" for t, i in zip(texts, items, strict=True)]
    return texts


def _differ(got: Any, wanted: Any, tolerance: float) -> bool:
    if _are_numbers((got, wanted), 2):
        return not abs(got - wanted) <= tolerance
    return not (is_plain(got) and got == wanted)


def _told(*values: Any) -> list[str]:
    """Return the first value and others as texts, with enough digits to tell it from the others."""
    for digits in (6, 9, 12, 15):
        first, *others = texts = [_shown(value, digits) for value in values]
        if first not in others:
            break
    return texts


def _shown(value: Any, digits: int = 6) -> str:
    if isinstance(value, (tuple, list)):
        items = ", ".join(_shown(item, digits) for item in value)
        return f"({items},)" if len(value) == 1 else f"({items})"
    if isinstance(value, float) and type(value) is not float:
        return f"{value!r}, which is a {type(value).__name__}, not a plain float"
    if type(value) is float:
        digits = max(digits, 9) if 1e6 <= abs(value) < 1e9 else digits  # 1234567, not 1.23457e+06
        return f"{value + 0.0:.{digits}g}"  # -0.0 + 0.0 is 0.0
    return repr(value)


def _with_unit(text: str, unit: str) -> str:
    if not unit or ", which is " in text or not text.endswith((*"0123456789", ")")):
        return text  # such as None
    one = text == "1" and unit.isalpha() and len(unit) > 1
    return f"{text} {unit.removesuffix('s') if one else unit}"


def _is_not_implemented(value: Any) -> bool:
    return _kind_of(value) == "NotImplementedType"


def _kind_of(value: Any) -> str:
    """Return the name of a value's type, here or in the student's process."""
    name = type(value).__name__
    return str(value._type_name) if name == "ObjectHandle" else name


def _complain(
    got: str,
    wanted: str,
    words: Words | None = None,
    tolerance: float | None = None,
    note: str = "",
) -> None:
    __tracebackhide__ = True
    words = words or {}
    given, cause, read = about.but(words)
    call = written(given)
    unit, other = words.get("unit", ""), ""
    if got == "None":
        nothing = (
            "The call returned None. Either a return statement is missing, or it returns the "
            "result of a call that works in place and gives None, such as normalize() or sort()."
        )
        cause, other = nothing, cause
    if re.search(r"\bNotImplemented\b(?!Error)", got):
        cause, other = NOT_IMPLEMENTED, ""
    if "bound method" in got:
        cause = "This is the method itself, not its result. Add parentheses after its name."
        other = ""
    raise ExpectationError(
        Message(
            called=short_numbers(call),
            got=_with_unit(got, unit),
            wanted=_with_unit(wanted, unit),
            tolerance=tolerance,
            note="" if cause == about.recognized else note,
            likely=cause,
            other=other,
            read=read,
        )
    )
