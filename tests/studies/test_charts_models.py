"""Methods of high order and scenes at rest, against closed forms."""

from __future__ import annotations

import math

import pytest

from plots.drawing import slope
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import BATCH, BEST, reading
from studies.models.multistep import LoneMultistep
from studies.models.order_8 import Order8

SCENES = {scene.name: scene for scene in scenes_with("")}
SPRING = "spring, k = 100 N/m, c = 2 N s/m"
RESTING = [f"stack of ten spheres, mass ratio {ratio}" for ratio in (1, 1000)]
RESTING.append("pile of 45 spheres")


@pytest.mark.parametrize(
    ("scene", "order"), [("elastic pendulum", 4), (SPRING, 6), ("double pendulum", 8)]
)
def test_the_error_of_a_multistep_method_falls_by_its_order(scene: str, order: int) -> None:
    """With and without forces that depend on the velocity, for one body and for two."""
    name = f"multistep, order {order}"
    model = next(model for model in SCENES[scene].models if model.name == name)
    assert model.per == 12
    steps = (24, 36, 48)
    errors = [SCENES[scene].error(model.run(count)) for count in steps]
    # Above the order is allowed, because the error of the next order may cancel a part of it.
    assert order - 0.3 < slope([1.0 / count for count in steps], errors) < order + 2.5


@pytest.mark.parametrize(
    ("scene", "finer"),
    [("elastic pendulum", 4.0), (SPRING, 3.0)],
)
def test_two_runs_of_pymunk_cancel_the_error_of_order_2(scene: str, finer: float) -> None:
    """Leapfrog has only even orders. A force that depends on the velocity adds odd ones."""
    one, two = (
        next(model for model in SCENES[scene].models if model.name == name)
        for name in (BEST, f"{BEST}, from two runs")
    )
    steps = (4, 8, 16)
    for model, order in ((one, 2.0), (two, finer)):
        errors = [SCENES[scene].error(model.run(count)) for count in steps]
        # The next order of the error is still visible with such long steps.
        assert slope([1.0 / count for count in steps], errors) == pytest.approx(order, abs=0.3)
    assert two.run(4).work == one.run(4).work + one.run(8).work


@pytest.mark.parametrize("name", ["rope bridge at rest", *RESTING])
def test_bodies_that_sleep_stay_where_they_are(name: str) -> None:
    scene = SCENES[name]
    asleep = [model for model in scene.models if "asleep" in model.name]
    assert {model.by for model in asleep} == {"ours", "pymunk"}
    # The ends of the planks hang 3e-8 m lower, so that all cables are taut.
    assert all(scene.error(model.run(1)) < 1e-7 for model in asleep)


def test_a_multistep_method_refuses_steps_that_are_too_long_to_start() -> None:
    def accelerations(positions: list[complex], velocities: list[complex]) -> list[complex]:
        return [-1e6 * positions[0] - 200.0 * velocities[0]]

    with pytest.raises(ArithmeticError, match="order 8 has made 50 steps"):
        LoneMultistep([1.0], [0.0], accelerations, 0.1, 8, is_damped=True)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-7, 1e-10])
def test_order_8_keeps_its_tolerance_between_its_steps(tolerance: float) -> None:
    oscillator = Order8([1.0], [1j], lambda positions, _: [-z for z in positions])
    found = oscillator.positions_at(0.1, 100, tolerance)
    errors = [
        abs(place - complex(math.cos(0.1 * i), math.sin(0.1 * i)))
        for i, (place,) in enumerate(found, 1)
    ]
    # The errors of the steps add up. In 10 s there are about 30 steps for 1e-10.
    assert tolerance / 1e4 < max(errors) < 20.0 * tolerance
    assert oscillator.evaluations < 40 * 16
    assert oscillator.state[0][0] == pytest.approx(complex(math.cos(10), math.sin(10)), abs=1e-3)


@pytest.mark.parametrize("count", [1, BATCH - 1, BATCH, 20])
def test_all_ways_to_read_pymunk_s_bodies_give_the_same(count: int) -> None:
    import pymunk

    space = pymunk.Space()
    bodies = [pymunk.Body(1.0, 1.0) for _ in range(count)]
    for i, body in enumerate(bodies):
        body.position = (0.5 * i, -float(i))
        space.add(body, pymunk.PinJoint(space.static_body, body, (i, 1.0)))
    space.step(0.01)
    wanted = [part for body in bodies for part in body.position]
    assert [*reading(space, bodies)()] == wanted


def test_spheres_at_rest_touch_and_weigh_on_each_other() -> None:
    for name in RESTING:
        truth = SCENES[name].truth(0.0)
        assert truth == SCENES[name].truth(1.0)
        places = [complex(x, y) for x, y in zip(truth[::2], truth[1::2], strict=True)]
        apart = [abs(a - b) for i, a in enumerate(places) for b in places[:i]]
        assert min(apart) == pytest.approx(1.0, abs=1e-12)  # the diameter
        lowest = min(place.imag for place in places)
        # The lowest sphere stands on the ground, or in the gaps of a row of fixed spheres.
        height = 0.5 if name.startswith("stack") else math.sqrt(0.75)
        assert lowest == pytest.approx(height, abs=1e-12)


def test_a_thousand_bodies_follow_their_parabolas_in_each_model() -> None:
    scene = SCENES["a thousand bodies in free fall"]
    errors = {model.name: scene.error(model.run(1)) for model in scene.models}
    as_in_examples = errors.pop("pymunk, as in its examples")
    # Its velocity is half a step late: 5 s * g / 120, of the scale of 2 m.
    assert as_in_examples == pytest.approx(5.0 * 10.0 / 120.0 / 2.0, rel=1e-6)
    assert max(errors.values()) < 1e-11  # 300 roundings of up to 100 m
