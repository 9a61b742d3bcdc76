"""Exercise B2.11: check an argument before you use it, and refuse what makes no sense."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors import exercises
from expect import about, expect_close, expect_error, expect_exactly, expect_that, scoped

READ = "the docstring of checked_duration"


@scoped
def expect_refusal(value: Any, error: type[Exception], cause: str) -> None:
    """Expect checked_duration to refuse a value with this error, and to accept half a second."""
    about.cause = cause
    __tracebackhide__ = True
    about.call = f"checked_duration({value!r})"
    expect_error(
        lambda: exercises.checked_duration(value),
        error,
        allowed=lambda: exercises.checked_duration(0.5),
        read=READ,
    )


@pytest.mark.exercise("B2.11", asks="the duration of a time step as a float")
def test_a_good_duration_comes_back_as_a_float(rng: Random) -> None:
    about.read = READ
    for duration in (round(rng.uniform(0.1, 5.0), 3), 1e-300, 1e300, rng.randint(1, 9)):
        about.call = f"checked_duration({duration!r})"
        about.cause = (
            f"You reject {duration!r}, which is a valid duration. Accept every positive, finite "
            "number, whether it is an int or a float."
        )
        got = exercises.checked_duration(duration)
        about.cause = "You change a valid duration. Return float(duration)."
        expect_close(got, float(duration), tolerance=0.0)
        about.cause = "You return the duration as an int. Convert it, and return float(duration)."
        expect_exactly(got, float(duration))


@pytest.mark.exercise("B2.11", asks="for zero, a negative number, an infinity or NaN")
def test_zero_and_negative_durations_are_refused(rng: Random) -> None:
    for value in (0.0, -round(rng.uniform(0.1, 5.0), 3), -1e-300, 0):
        about.cause = (
            f"The duration is {value}, so raise ValueError. Only a duration above 0 is valid, "
            "because time must pass in a step."
        )
        expect_refusal(value, ValueError, about.cause)


@pytest.mark.exercise("B2.11", asks="for zero, a negative number, an infinity or NaN")
def test_infinite_durations_and_nan_are_refused() -> None:
    infinite = (
        "You accept an infinite duration, which moves every particle to infinity. Reject it with a "
        "ValueError."
    )
    nan = (
        "You accept NaN. Every comparison with NaN is False, so reject a duration unless it is in "
        "the valid range, 0.0 < duration < math.inf."
    )
    expect_refusal(math.inf, ValueError, infinite)
    expect_refusal(-math.inf, ValueError, infinite)
    expect_refusal(math.nan, ValueError, nan)


@pytest.mark.exercise("B2.11", asks="for anything that is not a number")
@pytest.mark.parametrize("value", ["0.5", None, [0.5]], ids=["text", "none", "list"])
def test_a_duration_that_is_not_a_number_is_refused(value: Any) -> None:
    about.cause = (
        f"{value!r} is not a number, so raise TypeError. Check isinstance(duration, (int, float)), "
        "because float() accepts a string such as '0.5'."
    )
    expect_refusal(value, TypeError, about.cause)


@pytest.mark.exercise("B2.11", asks="names the argument, says what it must be")
@pytest.mark.parametrize("value", [-1.5, "soon"], ids=["number", "text"])
def test_the_message_names_the_argument_and_shows_the_value(value: Any) -> None:
    about(
        "checked_duration(0.5)",
        cause="You reject a valid duration. Raise no error for a positive, finite number.",
    )
    about.read = READ
    exercises.checked_duration(0.5)
    message = "no error"
    try:
        exercises.checked_duration(value)
    except (ValueError, TypeError) as error:
        message = str(error)
    about.call = f"the error message of checked_duration({value!r})"
    parts = {"duration": "name the argument", str(value): "show the value of the argument"}
    missing = " or ".join(lack for word, lack in parts.items() if word not in message)
    about.cause = (
        f"Your error message doesn't {missing}. Write a message such as "
        'f"duration must be positive and finite, got {duration!r}".'
    )
    if message == "no error":
        about.cause = f"You accept {value!r}, so there is no error message. Raise an error."
    wanted = f"a message that contains 'duration' and {str(value)!r}"
    expect_that(not missing, repr(message), wanted)
