"""Sums: two numbers, a counter and a function, build tasks B90.1 to B90.3."""

from __future__ import annotations

from random import Random

import pytest
from ch90_sums.probes import after_steps
from ch90_sums.sums import Counter, add, total_of

from draw import number
from expect import expect_close, expect_error, expect_exactly, expect_unchanged

STEPS = 200


@pytest.mark.exercise("B90.1")
def test_add_gives_the_sum(rng: Random) -> None:
    a, b = abs(number(rng)), abs(number(rng))  # their sum is not near zero
    call = f"add({a}, {b})"
    cause = "both numbers, added"
    read = "the docstring of add"
    got = add(a, b)  # TOKEN-CHECKS-5B08D2
    expect_close(call, got, a + b, cause=cause, read=read)


@pytest.mark.exercise("B90.2")
def test_a_counter_steps_and_adds(rng: Random) -> None:
    a, b, by = number(rng), number(rng), number(rng)
    c, d = Counter(a), Counter(b)
    call = f"c = Counter({a}); c.step({by}); c.count"
    cause = "step changes the count of the counter itself"
    read = "the docstring of Counter.step"
    c.step(by)  # TOKEN-CHECKS-5B08D2
    expect_close(call, c.count, a + by, cause=cause, read=read)
    call = f"c, d = Counter({a + by}), Counter({b}); (c + d).count"
    cause = "a new counter, with both counts added"
    read = "the docstring of Counter.__add__"
    expect_close(call, (c + d).count, a + by + b, cause=cause, read=read, tolerance=1e-12)
    expect_unchanged(call, "d", (d.count,), (b,), read=read)
    call = f"c = Counter({a}), and {STEPS} times c.step({by}); c.count"
    cause = "every step counts"
    stepped = after_steps(a, by, STEPS)
    expect_close(call, stepped, a + STEPS * by, cause=cause, read=read, tolerance=1e-9)


@pytest.mark.exercise("B90.3")
def test_the_total_of_a_function(rng: Random) -> None:
    slope, offset, n = number(rng), number(rng), rng.randint(3, 8)
    asked: list[int] = []

    def f(i: int) -> float:
        asked.append(i)
        return slope * i + offset

    wanted = sum(slope * i + offset for i in range(n))
    call = f"total_of(f, {n}) with f(i) = {slope} * i + {offset}"
    cause = "f is called with 0, 1, 2 and so on, n times in all, and what it returns is added"
    read = "the docstring of total_of"
    got = total_of(f, n)  # TOKEN-CHECKS-5B08D2
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-10)
    expect_exactly(f"{call}; what was f called with?", asked, [*range(n)], cause=cause, read=read)
    cause = "ValueError for a negative n"
    expect_error(
        f"total_of(f, {-n})",
        lambda: total_of(f, -n),
        ValueError,
        allowed=lambda: total_of(f, n),
        cause=cause,
        read=read,
    )
