"""Sums: two numbers, a counter and a function, build tasks B90.1 to B90.3."""

from __future__ import annotations

from random import Random

import pytest
from ch90_sums.probes import after_steps
from ch90_sums.sums import Counter, add, total_of

from draw import number
from expect import UNCHANGED, about, expect_close, expect_error, expect_exactly, expect_unchanged

STEPS = 200


@pytest.mark.exercise("B90.1")
def test_add_gives_the_sum(rng: Random) -> None:
    a, b = abs(number(rng)), abs(number(rng))  # their sum is not near zero
    about(f"add({a}, {b})", cause="both numbers, added", read="the docstring of add")
    got = add(a, b)  # TOKEN-CHECKS-5B08D2
    expect_close(got, a + b)


@pytest.mark.exercise("B90.2")
def test_a_counter_steps_and_adds(rng: Random) -> None:
    a, b, by = number(rng), number(rng), number(rng)
    c, d = Counter(a), Counter(b)
    about.call = f"c = Counter({a}); c.step({by}); c.count"
    about.cause = "step changes the count of the counter itself"
    about.read = "the docstring of Counter.step"
    c.step(by)  # TOKEN-CHECKS-5B08D2
    expect_close(c.count, a + by)
    about.call = f"c, d = Counter({a + by}), Counter({b}); (c + d).count"
    about(cause="a new counter, with both counts added", read="the docstring of Counter.__add__")
    expect_close((c + d).count, a + by + b, tolerance=1e-12)
    expect_unchanged("d", (d.count,), (b,), cause=UNCHANGED)
    about(f"c = Counter({a}), and {STEPS} times c.step({by}); c.count", cause="every step counts")
    stepped = after_steps(a, by, STEPS)
    expect_close(stepped, a + STEPS * by, tolerance=1e-9)


@pytest.mark.exercise("B90.3")
def test_the_total_of_a_function(rng: Random) -> None:
    slope, offset, n = number(rng), number(rng), rng.randint(3, 8)
    asked: list[int] = []

    def f(i: int) -> float:
        asked.append(i)
        return slope * i + offset

    wanted = sum(slope * i + offset for i in range(n))
    about.call = f"total_of(f, {n}) with f(i) = {slope} * i + {offset}"
    about.cause = "f is called with 0, 1, 2 and so on, n times in all, and what it returns is added"
    about.read = "the docstring of total_of"
    got = total_of(f, n)  # TOKEN-CHECKS-5B08D2
    expect_close(got, wanted, tolerance=1e-10)
    expect_exactly(asked, [*range(n)], then="; what was f called with?")
    about.cause = "ValueError for a negative n"
    about.call = f"total_of(f, {-n})"
    expect_error(lambda: total_of(f, -n), ValueError, allowed=lambda: total_of(f, n))
