"""The bench measures what it says. No test asserts a speed: machines are shared."""

from __future__ import annotations

import io
import math
import timeit
from itertools import chain
from typing import Any

import pytest
from rich.console import Console

from studies import timing
from studies.benchmarks import constraints, forces, particles, rotations, sparks, springs, vectors
from studies.scenes import PROJECTILE, make_particle


def test_a_ratio_is_the_median_of_the_rounds_and_its_spread_their_quartiles() -> None:
    first = iter([2.0, 4.0, 6.0, 100.0, 4.0])
    ratio, low, high = timing.ratio(lambda: next(first), lambda: 2.0, 5, "made up")
    assert ratio == 2.0  # of 1, 2, 2, 3 and 50: one slow round does not count
    assert (low, high) == (2.0, 3.0)


@pytest.mark.parametrize("subject", [vectors, rotations])
def test_a_peer_that_is_not_there_is_named(subject: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(timing.importlib.util, "find_spec", lambda _: None)
    monkeypatch.setattr(timing, "TIMES", 1)
    screen = io.StringIO()
    lines = subject.lines(Console(file=screen))
    assert [line.what for line in lines if "geometric mean" in line.what] == []
    assert "pyglet is not installed: .venv/bin/python -m pip install -r" in screen.getvalue()


@pytest.mark.parametrize("subject", [vectors, rotations])
@pytest.mark.parametrize("library", ["ours", "numpy"])
def test_every_statement_of_the_libraries_at_hand_can_be_timed(subject: Any, library: str) -> None:
    statements = subject.STATEMENTS[library]
    assert set(statements) <= set(subject.STATEMENTS["ours"])
    for code in statements.values():
        assert timeit.Timer(code, statements["setup"]).timeit(1) > 0.0


def names_of(setup: str) -> dict[str, Any]:
    names: dict[str, Any] = {}
    exec(setup, names)
    return names


@pytest.mark.parametrize(("first", "second"), [pair[:2] for pair in rotations.RIVALS[:2]])
def test_two_ways_to_undo_a_matrix_end_at_the_same(first: str, second: str) -> None:
    names = names_of(rotations.SETUP)
    # A dozen roundings of numbers up to 4.
    assert [*eval(first, names)] == pytest.approx([*eval(second, names)], abs=1e-14)


def test_matrices_turn_as_their_quaternions_and_as_numpys_do() -> None:
    names = names_of(rotations.SETUP)
    # A dozen roundings of numbers up to 4, as below.
    assert [*eval("m @ v", names)] == pytest.approx([*eval("q.rotate(v)", names)], abs=1e-14)
    of_product = [*eval("M3.from_quaternion(q * p)", names)]
    assert [*eval("m @ n", names)] == pytest.approx(of_product, abs=1e-14)
    ours, theirs = rotations.STATEMENTS["ours"], rotations.STATEMENTS["numpy"]
    others = names_of(theirs["setup"])
    for operation in ("product", "transform", "transpose", "inverse"):
        wanted = eval(theirs[operation], others).ravel()
        assert [*eval(ours[operation], names)] == pytest.approx([*wanted], abs=1e-14)


def test_what_is_compared_with_the_step_is_the_same_step() -> None:
    """Operators, methods in place and local variables end where Particle.integrate does."""
    frames = [0.02, 0.01, 0.02, 0.02] * 250
    stepped, by_operators, in_place = (make_particle(PROJECTILE) for _ in range(3))
    particles.steps(stepped, frames)
    particles.operator_steps(by_operators, frames)
    particles.in_place_steps(in_place, frames)
    # 1000 roundings of numbers up to 200.
    wanted = pytest.approx(tuple(stepped.position), rel=1e-11)
    assert tuple(by_operators.position) == wanted
    assert tuple(in_place.position) == wanted
    assert particles.arithmetic(frames) == wanted


def test_what_forces_are_compared_with_goes_the_same_way() -> None:
    frames = [0.02, 0.01, 0.02, 0.02] * 250
    # 1000 roundings of numbers up to 200.
    wanted = pytest.approx(forces.forced_steps(frames), rel=1e-11)
    assert forces.forced_arithmetic(frames) == wanted
    free = forces.make_particle_with_forces()
    particles.steps(free, frames)
    assert forces.generator_steps(frames) == pytest.approx(tuple(free.position), rel=1e-11)


def test_the_closed_form_of_the_sparks_is_where_the_steps_go(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(sparks, "SPARKS", 5)
    errors = []
    for frames in (500, 1000):
        monkeypatch.setattr(sparks, "FRAME", 2.0 / frames)
        show = sparks.burst()
        speeds = sparks.speeds_of(show)
        stepped = sparks.step(show, frames, "xyz")
        closed = sparks.positions(speeds, 2.0, "xyz")
        pairs = zip(chain(*stepped), chain(*closed), strict=True)
        errors.append(max(abs(a - b) for a, b in pairs))
    # Of first order, and the next order is less than a hundredth of it.
    assert errors[0] / errors[1] == pytest.approx(2.0, abs=0.02)
    # At most g t h / 2 of the acceleration and k v t h / 2 of the drag, for 5 m/s and h = 0.002 s.
    assert errors[1] < 0.0196 + 0.0070


def test_what_a_cloth_is_compared_with_falls_in_the_same_way() -> None:
    # The order of the sums differs: some 1e-16 of the heights a frame.
    wanted = pytest.approx(springs.steps(*springs.make_cloth(springs.DAMPING)), rel=1e-11)
    assert springs.cloth_arithmetic() == wanted
    assert springs.steps(*springs.make_cloth_of_ends()) == wanted


def test_what_a_chain_is_compared_with_hangs_from_the_same_place() -> None:
    """pymunk's tip comes to where ours is with its frames: a quarter, a quarter as far."""
    ours = constraints.by_direct_solve(constraints.RATE)
    off = [math.dist(constraints.by_pymunk(rate), ours) for rate in (960, 3840)]
    assert off[1] == pytest.approx(0.25 * off[0], rel=0.3)  # of order 1, less our own error
    assert off[1] < 2e-3
