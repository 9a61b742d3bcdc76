"""What the reference refuses in chapters 2 to 6: the message names the argument and its value.

Only one exercise of each chapter checks that students refuse bad arguments. The reference refuses
them everywhere, and this file tests where.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from ch02_vectors import arguments
from ch02_vectors.calculus import add_up_accelerations, difference_quotients
from ch02_vectors.exercises import position_after
from ch02_vectors.vector import Vector3, make_orthonormal_basis
from ch03_laws_of_motion import exercises as laws
from ch03_laws_of_motion.damping import damp_per_frame, damp_per_second
from ch04_particle_engine.ballistics import BallisticRange, aim
from ch04_particle_engine.catherine_wheel import CatherineWheel
from ch04_particle_engine.closed_form import burst_positions, drag_factors, state_after
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow, Payload
from ch04_particle_engine.scaling import muzzle_energy, slowed_gravity, slowed_mass
from ch04_particle_engine.screen_rotation import screen_angle, screen_corners
from ch04_particle_engine.targets import TargetBlock
from ch05_forces.closed_form import coasting_speed, drag_limits, quadratic_fall, terminal_speed
from ch05_forces.forces import (
    Airbrake,
    Drag,
    ForceRegistry,
    Gravity,
    InverseSquareGravity,
    PointGravity,
    Uplift,
)
from ch05_forces.particle import Particle
from ch05_forces.sniper import SniperRange, Wind
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.exercises import largest_stable_stiffness, swings_wider
from ch06_springs.going_further.adaptive import adaptive
from ch06_springs.going_further.camera import SpringCamera
from ch06_springs.integrators import (
    backward_euler,
    explicit_euler,
    leapfrog,
    runge_kutta_4,
    semi_implicit_euler,
    trapezoidal,
    velocity_verlet,
    watched,
)
from ch06_springs.spring_bridge import hang_bridge, load_bridge
from ch06_springs.springs import FakeStiffSpring, max_stable_stiffness
from refused import Refused, cases, ids, names_the_argument

NAN, INF = math.nan, math.inf
HUGE = 10**400  # no float is as large
UP, ONES, NOWHERE = Vector3(0.0, 1.0), Vector3(1.0, 1.0, 1.0), Vector3(NAN)
LIMITED = {"k1": 0.3, "k2": 0.05, "mass": 2.0, "speed": 5.0}
COASTING = LIMITED | {"time": 1.5}
A = Particle()
STEPS = (explicit_euler, semi_implicit_euler, leapfrog, velocity_verlet, runge_kutta_4)


def rule(**values: Any) -> FireworkRule:
    right = {"min_age": 0.5, "max_age": 1.0, "min_velocity": (0.0, 0.0, 0.0), "damping": 1.0}
    right |= {"max_velocity": (1.0, 1.0, 1.0), "payloads": ()}
    return FireworkRule(1, **(right | values))


def show() -> FireworksShow:
    return FireworksShow([rule()], 10, 1)


def wheel() -> CatherineWheel:
    return CatherineWheel(show(), 1, Vector3(), 1.0, 3.0, 9.0)


NUMBERS: dict[Callable[..., object], tuple[object, ...]] = {
    arguments.finite: (NAN, INF, -INF, HUGE),
    arguments.not_negative: (-5e-324, NAN, INF, HUGE),
    arguments.positive: (0.0, -0.0, -1, NAN, INF, HUGE),
    arguments.positive_or_infinite: (0.0, -1.0, NAN, -INF, HUGE),
}
VALUES: dict[str, list[Refused]] = {
    "ch02_vectors": [
        *(("mass", b, lambda x, f=f: f("mass", x)) for f, bad in NUMBERS.items() for b in bad),
        *(("count", bad, lambda x: arguments.whole("count", x)) for bad in (0, -1)),
        *(
            ("v", bad, lambda x: arguments.finite_vector("v", x))
            for bad in (NOWHERE, Vector3(0.0, INF), Vector3(0.0, 0.0, -INF))
        ),
        ("a and b", NOWHERE, lambda x: make_orthonormal_basis(x, UP)),
        ("duration", NAN, lambda x: position_after(UP, UP, x)),
        ("times", [0.0], lambda x: difference_quotients(x, [UP])),
        ("time", NAN, lambda x: difference_quotients([0.0, x], [UP, UP])),
        *(("times", x, lambda x: difference_quotients([1.0, x], [UP, UP])) for x in (0.5, 1.0)),
        ("values", "got 1", lambda _: difference_quotients([0.0, 1.0], [UP])),
        ("values", NOWHERE, lambda x: difference_quotients([0.0, 1.0], [UP, x])),
        ("times", [0.0], lambda x: add_up_accelerations(x, [], UP, UP)),
        ("time", INF, lambda x: add_up_accelerations([0.0, x], [UP], UP, UP)),
        ("accelerations", "got 2", lambda _: add_up_accelerations([0.0, 1.0], [UP, UP], UP, UP)),
        ("accelerations", NOWHERE, lambda x: add_up_accelerations([0.0, 1.0], [x], UP, UP)),
        ("position", NOWHERE, lambda x: add_up_accelerations([0.0, 1.0], [UP], x, UP)),
        ("velocity", NOWHERE, lambda x: add_up_accelerations([0.0, 1.0], [UP], UP, x)),
    ],
    "ch03_laws_of_motion": [
        ("position", NOWHERE, lambda x: Particle(x)),
        *(("duration", x, lambda x: Particle().integrate(x)) for x in (0.0, -0.5, INF, NAN)),
        ("duration", 0.0, lambda x: Particle(mass=INF).integrate(x)),
        *(
            row
            for damp in (damp_per_frame, damp_per_second)
            for row in (
                ("damping", -0.5, lambda x, damp=damp: damp(UP, UP, x, 0.5)),
                ("duration", 0.0, lambda x, damp=damp: damp(UP, UP, 0.5, x)),
            )
        ),
        ("first_mass", 0.0, lambda x: laws.speed_ratio(x, 1.0)),
        ("second_mass", INF, lambda x: laws.speed_ratio(1.0, x)),
        ("first_mass", NAN, lambda x: laws.gravity_between(x, 1.0, 1.0)),
        ("second_mass", -1.0, lambda x: laws.gravity_between(1.0, x, 1.0)),
        ("distance", 0.0, lambda x: laws.gravity_between(1.0, 1.0, x)),
        ("time", 0.0, lambda x: laws.position_by_equation(UP, UP, UP, x)),
        ("duration", NAN, lambda x: laws.state_by_steps(UP, UP, UP, x, 1)),
        ("steps", 0, lambda x: laws.state_by_steps(UP, UP, UP, 1.0, x)),
        ("duration", INF, lambda x: laws.stepping_error(UP, UP, UP, x, 1)),
        ("steps", -1, lambda x: laws.stepping_error(UP, UP, UP, 1.0, x)),
        ("mean", 0.0, lambda x: laws.random_frames(x, 0.5, 1.0, 3)),
        ("jitter", -0.1, lambda x: laws.random_frames(0.1, x, 1.0, 3)),
        ("total", INF, lambda x: laws.random_frames(0.1, 0.5, x, 3)),
        ("damping", -0.5, lambda x: laws.damping_difference(UP, UP, x, [[0.5]])),
        ("duration", 0.0, lambda x: laws.damping_difference(UP, UP, 0.5, [[0.5, x]])),
    ],
    "ch04_particle_engine": [
        ("count", 0, lambda x: Payload(1, x)),
        ("min_age", -0.1, lambda x: rule(min_age=x)),
        ("max_age", 0.25, lambda x: rule(max_age=x)),
        ("max_age", NAN, lambda x: rule(max_age=x)),
        ("max_velocity", (1.0, -1.0, 1.0), lambda x: rule(max_velocity=x)),
        ("max_velocity", INF, lambda x: rule(max_velocity=(x, 0.0, 0.0))),
        ("min_velocity", (0.0, 1.0), lambda x: rule(min_velocity=x)),
        ("damping", -0.5, lambda x: rule(damping=x)),
        ("types", 1, lambda _: FireworksShow([rule(), rule()], 5, 1)),
        ("payload", 7, lambda x: FireworksShow([rule(payloads=(Payload(x, 1),))], 5, 1)),
        ("capacity", 0, lambda x: FireworksShow([rule()], x, 1)),
        ("when_full", "wait", lambda x: FireworksShow([rule()], 5, 1, x)),
        ("spark_type", 2, lambda x: CatherineWheel(show(), x, Vector3(), 1.0, 3.0, 9.0)),
        ("radius", 0.0, lambda x: CatherineWheel(show(), 1, Vector3(), x, 3.0, 9.0)),
        ("start", NAN, lambda x: screen_angle(x, 1.0, 1.0)),
        ("size", -1.0, lambda x: screen_corners((0.0, 0.0), x, 1.0)),
        ("mass", 0.0, lambda x: muzzle_energy(x, 3.0)),
        ("speed", -3.0, lambda x: muzzle_energy(2.0, x)),
        ("factor", 0.0, lambda x: slowed_mass(2.0, x)),
        ("gravity", NAN, lambda x: slowed_gravity(x, 2.0)),
        ("speed", -3.0, lambda x: aim(x, 0.0, 0.0)),
        ("elevation", INF, lambda x: aim(1.0, 0.0, x)),
        ("azimuth", NAN, lambda x: BallisticRange().fire("pistol", x)),
        ("duration", 0.0, lambda x: BallisticRange().update(x)),
        ("duration", NAN, lambda x: show().update(x)),
        ("duration", -0.5, lambda x: wheel().update(x)),
        ("damping", INF, lambda x: drag_factors(x, 1.0)),
        ("time", -0.5, lambda x: drag_factors(0.5, x)),
        ("time", NAN, lambda x: state_after(Particle(mass=INF), x)),
        ("start", NAN, lambda x: burst_positions(x, [], -10.0, 0.5, 1.0)),
        ("size", 0.0, lambda x: TargetBlock(Vector3(), (1.0, x, 1.0), mass=1.0)),
    ],
    "ch05_forces": [
        ("acceleration", NOWHERE, lambda x: Gravity(x)),
        ("k1", -1.0, lambda x: Drag(x, 0.0)),
        ("k2", NAN, lambda x: Drag(0.0, x)),
        ("radius", -1.0, lambda x: Uplift(UP, x, UP)),
        ("force", NOWHERE, lambda x: Uplift(UP, 1.0, x)),
        ("k must", INF, lambda x: Airbrake(x)),
        ("strength", NAN, lambda x: PointGravity(UP, x)),
        ("center", NOWHERE, lambda x: PointGravity(x, 1.0)),
        ("mu", INF, lambda x: InverseSquareGravity(UP, x)),
        ("k2", -1.0, lambda x: Wind(1.0, x)),
        ("force must", Vector3(INF), lambda x: Particle().add_force(x)),
        ("duration", 0.0, lambda x: ForceRegistry().update_forces(x)),
        ("duration", NAN, lambda x: Airbrake(1.0).update_force(Particle(), x)),
        ("weight", 0.0, lambda x: terminal_speed(x, 0.3, 0.05)),
        ("k1", -0.3, lambda x: terminal_speed(9.81, x, 0.05)),
        ("k2", INF, lambda x: terminal_speed(9.81, 0.3, x)),
        ("mass", -2.0, lambda x: quadratic_fall(x, 9.81, 0.05, 3.0)),
        ("gravity", 0.0, lambda x: quadratic_fall(2.0, x, 0.05, 3.0)),
        ("k2", 0.0, lambda x: quadratic_fall(2.0, 9.81, x, 3.0)),
        ("time", -3.0, lambda x: quadratic_fall(2.0, 9.81, 0.05, x)),
        *(
            (name, bad, lambda x, name=name: coasting_speed(**(COASTING | {name: x})))
            for name, bad in (("speed", -20.0), ("k1", NAN), ("k2", -0.05), ("mass", 0.0))
        ),
        ("time", INF, lambda x: coasting_speed(**(COASTING | {"time": x}))),
        *(
            (name, bad, lambda x, name=name: drag_limits(**(LIMITED | {name: x})))
            for name, bad in (("k1", -0.3), ("k2", INF), ("mass", 0.0), ("speed", NAN))
        ),
        ("azimuth", NAN, lambda x: SniperRange(1).shoot(x, 0.0)),
        ("elevation", INF, lambda x: SniperRange(1).shoot(0.0, x)),
        ("duration", 0.0, lambda x: SniperRange(1).update(x)),
    ],
    "ch06_springs": [
        ("tolerance", 0.0, adaptive),
        ("tolerance", INF, adaptive),
        ("position", NOWHERE, SpringCamera),
        ("target", NOWHERE, lambda x: SpringCamera(UP).follow(x, 1.0)),
        *(("omega", x, lambda x: SpringCamera(UP, x)) for x in (0.0, NAN, INF)),
        *(("duration", x, lambda x, f=f: f([A], print, x)) for f in STEPS for x in (0.0, NAN)),
        *(
            (name, bad, lambda x, f=f, i=i: f(*[1.0] * i, x, *[1.0] * (5 - i)))
            for f in (backward_euler, trapezoidal, damped_spring_state)
            for i, name, bad in (
                (0, "x", NAN),
                (1, "v", INF),
                (2, "stiffness", -1.0),
                (3, "damping", NAN),
                (4, "mass", 0.0),
                (5, "time" if f is damped_spring_state else "duration", -1.0),
            )
        ),
        ("angle", INF, lambda _: damped_spring_state(1.0, 0.0, 1e300, 0.0, 1.0, 1e200)),
        *(("speed_limit", x, lambda x: watched(print, x)) for x in (0.0, NAN, INF)),
        *(
            ("duration", 0.0, lambda x, p=p: FakeStiffSpring(UP, 1.0, 1.0).update_force(p, x))
            for p in (A, Particle(mass=INF))
        ),
        ("stiffness", -1.0, lambda x: swings_wider(print, x, 0.5, 0.25)),
        ("damping", NAN, lambda x: swings_wider(print, 1.0, x, 0.25)),
        ("duration", 0.0, lambda x: swings_wider(print, 1.0, 0.5, x)),
        ("damping", -0.5, lambda x: largest_stable_stiffness(print, x, 0.25)),
        ("duration", INF, lambda x: largest_stable_stiffness(print, 0.5, x)),
        ("damping", -0.5, lambda x: max_stable_stiffness(x, 0.25)),
        ("duration", 0.0, lambda x: max_stable_stiffness(0.0, x)),
        ("mass", 0.0, lambda x: max_stable_stiffness(0.0, 0.25, x)),
        ("height", 0.0, lambda x: hang_bridge(ForceRegistry(), [], x, 1.0, 1.0)),
        ("stiffness", -1.0, lambda x: hang_bridge(ForceRegistry(), [], 1.0, x, 1.0)),
        ("damping", NAN, lambda x: hang_bridge(ForceRegistry(), [], 1.0, 1.0, x)),
        ("x must", INF, lambda x: load_bridge([A], x, 1.0)),
        ("weight", -1.0, lambda x: load_bridge([A], 0.0, x)),
    ],
}
TYPES: dict[str, list[Refused]] = {
    "ch02_vectors": [
        *(
            ("mass", b, lambda x, f=f: f("mass", x))
            for f in NUMBERS
            for b in ("1", None, [1.0], 1j)
        ),
        *(("count", b, lambda x: arguments.whole("count", x)) for b in (2.0, True, "3", None)),
        *(("v", bad, lambda x: arguments.finite_vector("v", x)) for bad in (3.0, (1, 2, 3), None)),
        ("v", 3, lambda x: arguments.instance_of("v", x, Vector3)),
    ],
    "ch03_laws_of_motion": [
        ("duration", "0.5", lambda x: Particle().integrate(x)),
        ("damping", "0.5", lambda x: damp_per_frame(UP, UP, x, 0.5)),
        ("duration", "0.5", lambda x: damp_per_second(UP, UP, 0.5, x)),
        ("first_mass", "2", lambda x: laws.gravity_between(x, 1.0, 1.0)),
    ],
    "ch04_particle_engine": [("mass", "2", lambda x: muzzle_energy(x, 3.0))],
    "ch05_forces": [("origin", None, lambda x: Uplift(x, 1.0, UP))],
}
CASES = cases({ValueError: VALUES, TypeError: TYPES})


@pytest.mark.parametrize(("chapter", "error", "name", "bad", "call"), CASES, ids=ids(CASES))
def test_a_refusal_names_the_argument_and_shows_its_value(
    chapter: str,  # noqa: ARG001, for make test CH=6
    error: type[Exception],
    name: str,
    bad: Any,
    call: Callable[[Any], object],
) -> None:
    names_the_argument(error, name, bad, call)


def test_valid_arguments_come_back_as_floats_and_copies() -> None:
    for check in NUMBERS:
        assert isinstance(check("a", 3), float)
    assert arguments.not_negative("a", 0) == 0.0
    assert arguments.positive("a", 5e-324) == 5e-324
    assert arguments.positive_or_infinite("a", INF) == INF
    assert arguments.finite("a", -1.7976931348623157e308) == -1.7976931348623157e308
    assert arguments.whole("a", 1) == 1
    v = arguments.finite_vector("v", ONES)
    assert v == ONES
    assert v is not ONES
    assert arguments.instance_of("v", ONES, Vector3) is ONES
