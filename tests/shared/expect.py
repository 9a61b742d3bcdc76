"""What checks say. Each function compares plain numbers and, where they differ, teaches.

A message says what was called, what came back, what was wanted and how closely, the likely cause
and where to read. A check tells ``about`` the call, the cause and the reading before it calls the
student's code: every expectation is told in these words, and so is an exception of that code. An
expectation takes other words by name: call, then (what follows the call), cause and read.

Under the autograder only plain numbers cross from the student's process, so nothing here compares
objects of the engine.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Unpack

from autograder.checks.asked import Words, about, scoped
from autograder.checks.explain import NOT_IMPLEMENTED
from autograder.message import ExpectationError, Message

# Right answers worked out in another order differ by a few roundings, some 1e-16 of the numbers
# involved. A thousand times that still leaves no room for a wrong formula.
ROUNDING = 1e-13
NAN = (
    "NaN compares false with everything, so it gets through a test such as x <= 0. Ask for what "
    "you want, such as 0.0 < x < math.inf, or use the functions of arguments.py."
)
UNCHANGED = "the call must not change it: work on a copy, or on numbers"
LOST = "v is as it was: assign to self.x, self.y and self.z, for a new vector is lost"


class NoVector:
    """Stands for what came back where a vector was wanted: no number, so no expectation holds."""

    def __init__(self, value: Any, wanted: str = "Vector3") -> None:
        self.value = value
        self.wanted = wanted

    def __repr__(self) -> str:
        if self.value is None:
            return "None"
        return f"{_shown(self.value)}, a {type(self.value).__name__} and not a {self.wanted}"


def xyz(v: Any) -> Any:
    """Return the components of a vector as a tuple."""
    return NoVector(v) if is_plain(v) else (v.x, v.y, v.z)


def is_plain(value: Any) -> bool:
    """Say whether a value is None, a number, a text or a collection, and no object of an engine."""
    return value is None or isinstance(value, (bool, int, float, str, tuple, list, dict))


@scoped
def expect_vector(v: Any, **words: Unpack[Words]) -> tuple[float, float, float]:
    """Expect a vector of plain numbers; return its components."""
    __tracebackhide__ = True
    call, cause, read = about.but(words)
    about(call, cause=cause, read=read)  # to ask for its components runs the student's code
    got = xyz(v)
    if isinstance(got, NoVector) or not _are_numbers(got, 3):
        _complain(_shown(got), "a Vector3")
    x, y, z = got
    return x, y, z


def expect_close(
    got: Any,
    wanted: float | Sequence[float],
    *,
    tolerance: float | None = None,
    **words: Unpack[Words],
) -> None:
    """Expect a number, or as many as wanted, each within tolerance.

    Without a tolerance: within ROUNDING of the largest number wanted.
    """
    __tracebackhide__ = True
    wanted_numbers = _as_tuple(wanted)
    if tolerance is None:
        tolerance = ROUNDING * max(abs(number) for number in wanted_numbers)
    got_numbers = _as_tuple(got)
    if not _are_numbers(got_numbers, len(wanted_numbers)) or not all(
        abs(g - w) <= tolerance for g, w in zip(got_numbers, wanted_numbers, strict=True)
    ):
        _complain(_shown(got), _shown(wanted), words, tolerance)


def expect_exactly(got: Any, wanted: Any, **words: Unpack[Words]) -> None:
    """Expect exactly this value of exactly this type, such as a word or True."""
    __tracebackhide__ = True
    if type(got) is type(wanted) and got == wanted:
        return
    if is_plain(got) and got == wanted:  # such as 1 and 1.0, which look alike
        came, right = (f"{value!r}, of type {type(value).__name__}" for value in (got, wanted))
        _complain(came, right, words)
    _complain(_shown(got), _shown(wanted), words)


def expect_nan(got: Any, **words: Unpack[Words]) -> None:
    """Expect the number NaN: what came of a NaN must not look like a result."""
    __tracebackhide__ = True
    if not (type(got) is float and math.isnan(got)):
        _complain(_shown(got), "nan", words)


def expect_unchanged(
    name: str, now: Sequence[float], before: Sequence[float], **words: Unpack[Words]
) -> None:
    """Expect a vector that a call only reads to be what it was before."""
    __tracebackhide__ = True
    if tuple(now) != tuple(before):
        got = f"afterwards {name} is {_shown(now)}"
        _complain(got, f"{name} as it was, {_shown(before)}", words)


@scoped
def expect_error(
    attempt: Callable[[], Any],
    error: type[Exception],
    *,
    allowed: Callable[[], Any],
    **words: Unpack[Words],
) -> None:
    """Expect attempt() to raise this error, and allowed() to raise none.

    Code that refuses everything has not found out what to refuse. A NaN that gets through has a
    cause of its own.
    """
    __tracebackhide__ = True
    call, cause, read = about.but(words)
    about(
        f"as in {call}, but with arguments that are right",
        cause="what is right must not be refused",
        read=read,
    )
    allowed()
    about(call, cause=NAN if "nan" in call else cause)
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
            came += f", but {_shown(got)}"
    _complain(came, error.__name__)


def expect_finite_numbers(
    name: str,
    function: Callable[..., Any],
    good: Sequence[int],
    bad: Sequence[tuple[int, float]],
    **words: Unpack[Words],
) -> None:
    """Expect a function of numbers to refuse NaN, infinities and texts in each of its places.

    And the pairs of ``bad``, a place and a number. ``good`` is whole numbers that it must take.
    """
    __tracebackhide__ = True
    cause = "refuse it with ValueError: the functions of arguments.py do, one for each argument"
    numbers = [(i, n) for i in range(len(good)) for n in (math.nan, math.inf, -math.inf)]
    refused = [(place, n, ValueError) for place, n in (*numbers, *bad)]
    refused += [(place, "1.0", TypeError) for place in range(len(good))]
    for place, value, error in refused:
        if error is TypeError:
            cause = "a text is no number, whatever stands in it: TypeError, as arguments.py has it"
        arguments = [*good]
        arguments[place] = value
        expect_error(
            lambda arguments=arguments: function(*arguments),
            error,
            allowed=lambda: function(*good),
            call=f"{name}({', '.join(map(repr, arguments))})",
            cause=cause,
            read=about.but(words)[2],
        )


@scoped
def expect_same_object(made: str, step: str, v: Any, before: Any) -> None:
    """Expect v to be the object that it was before, by what can be seen: they change together."""
    before.x = 99.0
    about(
        f"{made}; w = v; {step}; w.x = 99.0; v.x",
        cause="v and w were one vector, and are two now: change self.x, self.y and self.z, and "
        "end with return self; a new vector leaves w behind",
    )
    expect_close(v.x, 99.0)


def blame(
    got: Any,
    mistakes: Sequence[tuple[float | Sequence[float], str]] | Mapping[str, float | Sequence[float]],
    tolerance: float = 1e-9,
) -> None:
    """Make the mistake that gives the very numbers of got the likely cause, where one does.

    ``mistakes`` are as in cause_of, or slips by name as in named.
    """
    if isinstance(mistakes, Mapping):
        about.cause = named(got, about.cause, mistakes)
    else:
        about.cause = cause_of(got, mistakes, about.cause, tolerance)


def cause_of(
    got: Any,
    mistakes: Sequence[tuple[float | Sequence[float], str]],
    otherwise: str,
    tolerance: float = 1e-9,
) -> str:
    """Return the cause of the first mistake that gives the very numbers of got, or the other one.

    ``mistakes`` have what they give, and their causes. Roundings in any order agree to more than
    the tolerance, relative to the largest number; two mistakes hardly ever do.
    """
    seen = _as_tuple(got.value if isinstance(got, NoVector) else got)
    for gives, cause in mistakes:
        numbers = _as_tuple(gives)
        near = tolerance * (max(map(abs, numbers)) or 1.0)
        if _are_numbers(seen, len(numbers)) and all(
            abs(one - other) <= near for one, other in zip(seen, numbers, strict=True)
        ):
            return cause
    return otherwise


def named(got: Any, cause: str, slips: Mapping[str, float | Sequence[float]]) -> str:
    """Return the cause, and before it the name of the slip that gives the very numbers of got."""
    mistakes = [(gives, f"this is {name}: {cause}") for name, gives in slips.items()]
    return cause_of(got, mistakes, cause)


def _as_tuple(value: Any) -> tuple[Any, ...]:
    return tuple(value) if isinstance(value, (tuple, list)) else (value,)


def _are_numbers(values: tuple[Any, ...], count: int) -> bool:
    return len(values) == count and all(type(value) in (int, float) for value in values)


def _shown(value: Any) -> str:
    if type(value) in (tuple, list):
        return "(" + ", ".join(_shown(item) for item in value) + (",)" if len(value) == 1 else ")")
    if isinstance(value, float) and type(value) is not float:
        return f"{value!r}, a {type(value).__name__} and not a plain float"
    if type(value) is float:
        return f"{value:.15g}"
    return repr(value)


def _is_not_implemented(value: Any) -> bool:
    """Say whether a value is NotImplemented, here or in the student's process."""
    if type(value).__name__ == "ObjectHandle":
        return bool(value._type_name == "NotImplementedType")
    return value is NotImplemented


def _complain(
    got: str, wanted: str, words: Words | None = None, tolerance: float | None = None
) -> None:
    __tracebackhide__ = True
    call, cause, read = about.but(words or {})
    other = ""
    if got == "None":
        nothing = "Nothing came back. Is a return missing, or does this method work in place?"
        cause, other = nothing, cause
    if re.search(r"\bNotImplemented\b(?!Error)", got):
        cause, other = NOT_IMPLEMENTED, ""
    if "bound method" in got:
        cause, other = "A method is named but not called. Add its brackets.", ""
    raise ExpectationError(
        Message(
            called=call,
            got=got,
            wanted=wanted,
            tolerance=tolerance,
            likely=cause,
            other=other,
            read=read,
        )
    )
