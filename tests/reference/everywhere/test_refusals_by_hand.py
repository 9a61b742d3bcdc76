"""What the reference refuses beside single numbers and vectors, which test_refusals.py tests."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from ch02_vectors import arguments
from ch02_vectors.calculus import add_up_accelerations, difference_quotients
from ch02_vectors.exercises import position_after
from ch02_vectors.vector import Vector3, make_orthonormal_basis
from ch03_laws_of_motion.exercises import damping_difference
from ch04_particle_engine.catherine_wheel import CatherineWheel
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow, Payload
from ch04_particle_engine.targets import TargetBlock
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.springs import FakeStiffSpring
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.going_further.angle_pendulum import DoublePendulum
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import Cable, Limits, Rod
from ch08_mass_aggregate.blob import Blob, spread
from ch08_mass_aggregate.bridge import Bridge, Deck
from ch08_mass_aggregate.cube import Cube
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.tilting_platform import balancing_mass
from ch08_mass_aggregate.trebuchet import PIVOT_HEIGHT, START, Design
from ch08_mass_aggregate.wheel import Wheel
from ch08_mass_aggregate.world import ParticleWorld
from ch09_rotations import exercises as rotation_exercises
from ch09_rotations.angular import integrate_rotation
from ch09_rotations.euler import euler_to_quaternion
from ch09_rotations.going_further.free_box import FreeBox
from ch09_rotations.matrix import Matrix3, Matrix4, change_basis
from ch09_rotations.plane import center_of_mass, rotate_point
from ch09_rotations.quaternion import Quaternion
from studies.models.angle_chain import AngleChain
from studies.models.angle_rope import AngleRope
from studies.models.direct_net import DirectNet
from studies.models.rod_tensions import RodTensions
from studies.models.smooth_net import SmoothNet

NAN, INF, HUGE = math.nan, math.inf, 10**400  # no float is as large as the last one
UP, NOWHERE = Vector3(0.0, 1.0), Vector3(NAN)
A, B = Particle(), Particle(Vector3(2.0))
NINE, TWELVE = Matrix3(*range(9)), Matrix4(*range(12))
LOWEST = PIVOT_HEIGHT + 4.0 * math.sin(START)  # m, initial height of the tip of a long arm of 4 m
Row = tuple[str, Any, Callable[[Any], object]]  # name, bad value or text, function of the value


def rule(**values: Any) -> FireworkRule:
    right = {"min_age": 0.5, "max_age": 1.0, "min_velocity": (0.0, 0.0, 0.0), "damping": 1.0}
    return FireworkRule(1, **(right | {"max_velocity": (1.0, 1.0, 1.0)} | values))


SHOW = FireworksShow([rule()], 5, 1)


def masses(*values: float) -> list[Particle]:
    """Return particles along X, the last of which is immovable if its mass is infinite."""
    return [Particle(Vector3(float(i)), mass=mass) for i, mass in enumerate(values, 1)]


def walked(pace: float) -> None:
    bridge = Bridge()
    bridge.pace = pace
    bridge.step(0.1)


NUMBERS: dict[Callable[..., object], tuple[object, ...]] = {
    arguments.finite: (NAN, INF, -INF, HUGE),
    arguments.not_negative: (-5e-324, NAN, INF, HUGE),
    arguments.positive: (0.0, -0.0, -1, NAN, INF, HUGE),
    arguments.positive_or_infinite: (0.0, -1.0, NAN, -INF, HUGE),
    arguments.whole: (0, -1),
}
WRONG_VALUES: dict[str, list[Row]] = {
    "ch02_vectors": [
        *(("mass", b, lambda x, f=f: f("mass", x)) for f, bad in NUMBERS.items() for b in bad),
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
        ("'a'", "'a'", Vector3),
    ],
    "ch03_laws_of_motion": [
        ("1 / mass", INF, lambda _: Particle(mass=5e-324)),
        ("duration", 0.0, lambda x: damping_difference(UP, UP, 0.5, [[0.5, x]])),
    ],
    "ch04_particle_engine": [
        ("max_age", 0.25, lambda x: rule(max_age=x)),
        ("max_velocity", (1.0, -1.0, 1.0), lambda x: rule(max_velocity=x)),
        ("max_velocity", INF, lambda x: rule(max_velocity=(x, 0.0, 0.0))),
        ("min_velocity", (0.0, 1.0), lambda x: rule(min_velocity=x)),
        ("types", 1, lambda _: FireworksShow([rule(), rule()], 5, 1)),
        ("capacity", 0, lambda x: FireworksShow([rule()], x, 1)),
        ("payload", 7, lambda x: FireworksShow([rule(payloads=(Payload(x, 1),))], 5, 1)),
        ("when_full", "wait", lambda x: FireworksShow([rule()], 5, 1, x)),
        ("spark_type", 2, lambda x: CatherineWheel(SHOW, x, UP, 1.0, 3.0, 9.0)),
        ("size", 0.0, lambda x: TargetBlock(Vector3(), (1.0, x, 1.0), mass=1.0)),
    ],
    "ch06_springs": [
        ("angle", INF, lambda _: damped_spring_state(1.0, 0.0, 1e300, 0.0, 1.0, 1e200)),
        ("duration", 0.0, lambda x: FakeStiffSpring(UP, 1.0, 1.0).update_force(*masses(INF), x)),
    ],
    "ch07_constraints": [
        ("a and b", A, lambda x: Cable(x, x, 1.0)),
        ("min_length", 2.0, lambda x: Limits(A, B, x, 1.0)),
        *(("normal", Vector3(1.0 + x), lambda x: Contact(A, None, x)) for x in (-1.1e-6, 1.1e-6)),
        ("particle and other", A, lambda x: Contact(x, x, UP)),
        ("particles[0]", INF, lambda x: DirectChain(masses(x, 1.0), Vector3())),
        ("particles[0]", INF, lambda x: DirectChain(masses(x), Vector3())),
        ("particles[1]", INF, lambda x: DirectChain(masses(1.0, x, 1.0), Vector3())),
        ("length of rod 1", 0.0, lambda _: DirectChain([*masses(1.0), *masses(1.0)], Vector3())),
        ("particles", "none", lambda _: DirectChain([], Vector3())),
        *(("link", "none", lambda _, kind=kind: kind([])) for kind in (DirectNet, SmoothNet)),
        ("damping of particle 0", 0.0, lambda x: SmoothNet([Rod(Particle(damping=x), B, 1.0)])),
        ("length", 0.0, lambda _: RodTensions([Particle()], Vector3())),
        ("mass", INF, lambda x: RodTensions(masses(x), Vector3())),
        ("mass", INF, lambda x: RodTensions(masses(1.0, x, 1.0), Vector3())),
        *(
            (name, bad, lambda _, kind=kind, given=given: kind(*given))
            for kind in (AngleChain, DoublePendulum)
            for name, bad, given in (
                ("mass", 0.0, ([1.0, 1.0], [1.0, 0.0], [0.0, 0.0])),
                ("length", INF, ([1.0, INF], [1.0, 1.0], [0.0, 0.0])),
                ("angle", NAN, ([1.0, 1.0], [1.0, 1.0], [0.0, NAN])),
                ("angular_velocity", INF, ([1.0, 1.0], [1.0, 1.0], [0.0, 0.0], [0.0, INF])),
                ("gravity", 0.0, ([1.0, 1.0], [1.0, 1.0], [0.0, 0.0], [0.0, 0.0], 0.0)),
            )
        ),
        ("lists", [1, 2], lambda _: AngleChain([1.0], [1.0, 1.0], [0.0, 0.0])),
        ("lists", [0], lambda _: AngleChain([], [], [])),
        ("lengths", [1.0], lambda x: DoublePendulum(x, [1.0, 1.0], [0.0, 0.0])),
        ("lists", 0, lambda _: AngleRope(1.0, 1.0, [])),
    ],
    "ch08_mass_aggregate": [
        ("rows", "none", lambda _: Deck(A, 0.5, [])),
        ("height", 0.49, lambda x: Blob(x)),
        ("pace", NAN, walked),
        *(("driven", x, lambda x: Wheel(driven=x)) for x in (-1, 9, 2.0)),
        ("masses[0]", -1.0, lambda x: balancing_mass([x], [1.0], -1.0)),
        ("places[0]", NAN, lambda x: balancing_mass([1.0], [x], -1.0)),
        ("x must", INF, lambda x: balancing_mass([], [], x)),
        ("balancing mass", INF, lambda _: balancing_mass([1e308], [-1e10], 1.0)),
        ("mass", INF, lambda x: spread(masses(1.0, x))),
        ("sling", LOWEST, lambda x: Design(400.0, 1.0, 4.0, x, 40.0)),
        ("particles", "twice", lambda _: ParticleWorld([A, A])),
    ],
    "ch09_rotations": [
        ("angle", INF, lambda x: euler_to_quaternion(0.0, x, 0.0)),
        ("point[0]", NAN, lambda x: rotate_point((x, 0.0), 1.0, (0.0, 0.0))),
        ("origin[1]", NAN, lambda x: rotate_point((0.0, 0.0), 1.0, (0.0, x))),
        ("masses", 0.0, lambda x: center_of_mass([x], [(0.0, 0.0)])),
        ("positions", INF, lambda x: center_of_mass([1.0], [(0.0, x)])),
        *(("sides", x, lambda x: FreeBox(1.0, Vector3(1, x, 1), UP)) for x in (0.0, -1.0)),
        ("'a'", "'a'", Quaternion),
        ("'a'", "'a'", lambda x: Matrix3(*[x] * 9)),
    ],
}
WRONG_TYPES: dict[str, list[Row]] = {
    "ch02_vectors": [
        *(("mass", b, lambda x, f=f: f("mass", x)) for f in NUMBERS for b in ("1", None, [1.0])),
        *(("mass", b, lambda x: arguments.whole("mass", x)) for b in (2.0, True)),
        *(("v", bad, lambda x: arguments.finite_vector("v", x)) for bad in (3.0, (1, 2, 3), None)),
        ("v", 3, lambda x: arguments.instance_of("v", x, Vector3)),
    ],
    "ch07_constraints": [
        ("particles", A, lambda x: GroundPlane(x)),
        ("particles[0]", None, lambda x: GroundPlane([x])),
        ("a must", None, lambda x: Rod(x, B, 1.0)),
        ("b must", None, lambda x: Cable(A, x, 1.0)),
        ("particle", None, lambda x: Contact(x, None, UP)),
        ("other", UP, lambda x: Contact(A, x, UP)),
        *(("link", A, lambda x, kind=kind: kind([x])) for kind in (DirectNet, SmoothNet)),
    ],
    "ch08_mass_aggregate": [
        ("contact_generators[0]", A, lambda x: ParticleWorld([A], [x])),
        ("integrator", None, lambda x: ParticleWorld([A], integrator=x)),
        ("step", None, lambda x: FixedStep(x, 0.25)),
    ],
    "ch09_rotations": [
        *(("nine numbers", n, lambda n: Matrix3(*range(n))) for n in (8, 12)),
        *(("twelve numbers", n, lambda n: Matrix4(*range(n))) for n in (9, 16)),
        *(
            ("v", (1, 2, 3), call)
            for call in (NINE.transform, TWELVE.transform, Quaternion().rotate)
        ),
        ("q", 2.0, lambda x: Quaternion() * x),
        ("q", (1, 0, 0, 0), Matrix3.from_quaternion),
        ("p", None, lambda x: Matrix4.from_orientation_and_position(Quaternion(), x)),
        ("m", UP, lambda x: change_basis(x, NINE)),
        ("orientation", UP, lambda x: integrate_rotation(x, UP, UP, 1.0)),
        ("orientation", None, rotation_exercises.back_to_reference),
        ("a must", 1.0, lambda x: rotation_exercises.product_without_j_and_k(x, Quaternion())),
        ("matrix", UP, rotation_exercises.read_off),
        ("matrix", NINE, rotation_exercises.easy_inverse),
        ("'Matrix3' and", "int", lambda _: NINE @ 2),
        ("'Matrix3' and", "Matrix4", lambda _: NINE @ TWELVE),
        ("'Matrix4' and", "Matrix3", lambda _: TWELVE @ NINE),
    ],
}
WRONG_PLACES: dict[str, list[Row]] = {
    "ch08_mass_aggregate": [("rods", x, lambda x: Cube(rods=[x])) for x in ((0, -1), (8, 0))],
    "ch09_rotations": [
        *(("row", place, lambda x: NINE[x]) for place in ((3, 0), (0, -1))),
        *(("row", place, lambda x: TWELVE[x]) for place in ((0, 4), (3, 3))),
    ],
}
CASES = [
    pytest.param(chapter, error, *row, id=f"{chapter}-{row[0]}")
    for error, table in (
        (ValueError, WRONG_VALUES),
        (TypeError, WRONG_TYPES),
        (IndexError, WRONG_PLACES),
    )
    for chapter, rows in table.items()
    for row in rows
]


@pytest.mark.parametrize(("chapter", "error", "name", "bad", "call"), CASES)
def test_a_refusal_names_the_argument_and_shows_its_value(
    chapter: str,  # noqa: ARG001, for make test CH=6
    error: type[Exception],
    name: str,
    bad: Any,
    call: Callable[[Any], object],
) -> None:
    """A text stands for the shown value itself."""
    with pytest.raises(error) as refusal:
        call(bad)
    assert name in str(refusal.value)
    assert (bad if isinstance(bad, str) else repr(bad)) in str(refusal.value)


def test_valid_arguments_come_back_as_floats_and_copies() -> None:
    for check in list(NUMBERS)[:4]:
        assert isinstance(check("a", 3), float)
    assert arguments.not_negative("a", 0) == 0.0
    assert arguments.positive("a", 5e-324) == 5e-324
    assert arguments.positive_or_infinite("a", INF) == INF
    assert arguments.finite("a", -1.7976931348623157e308) == -1.7976931348623157e308
    assert arguments.whole("a", 1) == 1
    v = arguments.finite_vector("v", UP)
    assert v == UP
    assert v is not UP
    assert arguments.instance_of("v", UP, Vector3) is UP
