"""What the reference refuses in chapters 7 to 9: the message names the argument and its value."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.exercises import (
    force_for_frame,
    restitution_of_drop,
    table_of_drops,
    top_ball_speed,
)
from ch07_constraints.going_further.angle_pendulum import DoublePendulum
from ch07_constraints.going_further.bouncing_ball import heights_in_frames
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.going_further.reaction import ReactionForce
from ch07_constraints.going_further.sequential_impulses import SequentialImpulses
from ch07_constraints.going_further.small_steps import SmallSteps
from ch07_constraints.links import AnchoredCable, AnchoredRod, Cable, Limits, Rod
from ch08_mass_aggregate.ball_game import BallGame, Rules
from ch08_mass_aggregate.blob import Blob, spread
from ch08_mass_aggregate.bridge import Bridge, Deck
from ch08_mass_aggregate.bridge_plan import make_rows
from ch08_mass_aggregate.cube import Cube, fewest_rods
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.friction import FrictionContact
from ch08_mass_aggregate.planks import nearest_on_segment
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.tilting_platform import TiltingPlatform, balancing_mass
from ch08_mass_aggregate.trebuchet import PIVOT_HEIGHT, START, Design
from ch08_mass_aggregate.wheel import Wheel
from ch08_mass_aggregate.world import ParticleWorld
from ch09_rotations import exercises as rotation_exercises
from ch09_rotations.angular import first_order_drift, integrate_rotation, velocity_of_point
from ch09_rotations.euler import euler_rates, rate_map
from ch09_rotations.going_further.free_box import FreeBox
from ch09_rotations.matrix import Matrix3, Matrix4, change_basis
from ch09_rotations.plane import angle_to_vector, center_of_mass, rotate_point, wrap_angle
from ch09_rotations.quaternion import Quaternion
from refused import Refused, cases, ids, names_the_argument
from studies.models.angle_chain import AngleChain
from studies.models.angle_rope import AngleRope
from studies.models.direct_net import DirectNet
from studies.models.exact_frames import places_in_frames
from studies.models.rod_tensions import RodTensions
from studies.models.smooth_net import SmoothNet

NAN, INF = math.nan, math.inf
UP, ONES, NOWHERE = Vector3(0.0, 1.0), Vector3(1.0, 1.0, 1.0), Vector3(NAN)
A, B = Particle(), Particle(Vector3(2.0))
LOWEST = PIVOT_HEIGHT + 4.0 * math.sin(START)  # m, initial height of the tip of a long arm of 4 m


def damped(damping: float) -> Particle:
    return Particle(damping=damping)


def chain(*values: float) -> list[Particle]:
    """Return particles along X, the last of which is immovable if its mass is infinite."""
    return [Particle(Vector3(float(i)), mass=mass) for i, mass in enumerate(values, 1)]


VALUES: dict[str, list[Refused]] = {
    "ch07_constraints": [
        *(("duration", x, lambda x: Contact(A, None, UP).velocity_after(x)) for x in (-1.0, INF)),
        *(("duration", x, lambda x: Contact(A, None, UP).resolve_velocity(x)) for x in (-1.0, NAN)),
        *(("duration", x, lambda x: GroundPlane([]).next_impact(x)) for x in (-1.0, NAN)),
        *(("duration", x, lambda x: ParticlePairs([], 1.0).next_impact(x)) for x in (-1.0, INF)),
        ("initial_height", 0.0, lambda x: restitution_of_drop(x, 0.0)),
        ("bounce_height", -0.1, lambda x: restitution_of_drop(1.0, x)),
        ("bounce_height", NAN, lambda x: table_of_drops([("oak", 1.0, x)])),
        ("height", -1.0, lambda x: top_ball_speed(x, 1.0, 1.0, 0.5, 0.5)),
        ("lower_mass", 0.0, lambda x: top_ball_speed(1.0, x, 1.0, 0.5, 0.5)),
        ("upper_mass", INF, lambda x: top_ball_speed(1.0, 1.0, x, 0.5, 0.5)),
        ("ground_restitution", 1.5, lambda x: top_ball_speed(1.0, 1.0, 1.0, x, 0.5)),
        ("pair_restitution", -0.5, lambda x: top_ball_speed(1.0, 1.0, 1.0, 0.5, x)),
        ("gravity", -1.0, lambda x: top_ball_speed(1.0, 1.0, 1.0, 0.5, 0.5, x)),
        ("contact_time", -0.5, lambda x: force_for_frame(UP, x, 1.0)),
        ("frame", 0.0, lambda x: force_for_frame(UP, 0.0, x)),
        ("force", NOWHERE, lambda x: force_for_frame(x, 0.0, 1.0)),
        ("height", NAN, lambda x: GroundPlane([], x)),
        ("radius", -0.1, lambda x: GroundPlane([], 0.0, x)),
        ("radius", 0.0, lambda x: ParticlePairs([], x)),
        ("a and b", A, lambda x: Cable(x, x, 1.0)),
        ("max_length", 0.0, lambda x: Cable(A, B, x)),
        ("max_length", -1.0, lambda x: AnchoredCable(A, UP, x)),
        ("length", NAN, lambda x: Rod(A, B, x)),
        ("length", 0.0, lambda x: AnchoredRod(A, UP, x)),
        ("min_length", -0.1, lambda x: Limits(A, B, x, 1.0)),
        ("min_length", 2.0, lambda x: Limits(A, B, x, 1.0)),
        ("max_length", 0.0, lambda x: Limits(A, B, 0.0, x)),
        ("normal", Vector3(1.0 + 1.1e-6), lambda x: Contact(A, None, x)),
        ("normal", Vector3(1.0 - 1.1e-6), lambda x: Contact(A, None, x)),
        ("penetration", NAN, lambda x: Contact(A, None, UP, 0.5, x)),
        ("particle and other", A, lambda x: Contact(x, x, UP)),
        ("iterations", 0, lambda x: ContactResolver(x)),
        ("duration", 0.0, lambda x: Contact(A, None, UP).resolve(x)),
        ("iterations", 0, lambda x: SequentialImpulses([], [], x)),
        ("height", NAN, ReactionForce),
        *(("radius", x, lambda x: ReactionForce(0.0, x)) for x in (-1.0, INF)),
        ("compliance", -1.0, lambda x: SmallSteps([], [], x)),
        ("compliance", INF, lambda x: SmallSteps([], [], x)),
        ("particles[0]", INF, lambda x: DirectChain(chain(x, 1.0), Vector3())),
        ("particles[0]", INF, lambda x: DirectChain(chain(x), Vector3())),
        ("particles[1]", INF, lambda x: DirectChain(chain(1.0, x, 1.0), Vector3())),
        ("length of rod 1", 0.0, lambda _: DirectChain([*chain(1.0), *chain(1.0)], Vector3())),
        ("anchor", Vector3(INF), lambda x: DirectChain(chain(1.0), x)),
        ("particles", "none", lambda _: DirectChain([], Vector3())),
        *(("link", "none", lambda _, kind=kind: kind([])) for kind in (DirectNet, SmoothNet)),
        ("damping of particle 0", 0.0, lambda x: SmoothNet([AnchoredCable(damped(x), UP, 1.0)])),
        ("length", 0.0, lambda _: RodTensions([Particle()], Vector3())),
        ("mass", INF, lambda x: RodTensions(chain(x), Vector3())),
        ("mass", INF, lambda x: RodTensions(chain(1.0, x, 1.0), Vector3())),
        *(("correction", x, lambda x: RodTensions([B], UP, x)) for x in (-1.0, NAN, INF)),
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
        ("length", 0.0, lambda x: AngleRope(x, 1.0, [0.0])),
        ("mass", INF, lambda x: AngleRope(1.0, x, [0.0])),
        ("lists", 0, lambda _: AngleRope(1.0, 1.0, [])),
        ("height", -1.0, lambda x: heights_in_frames(x, 0.0, 0.5, 0.1, 3)),
        ("speed", INF, lambda x: heights_in_frames(1.0, x, 0.5, 0.1, 3)),
        ("restitution", 1.1, lambda x: heights_in_frames(1.0, 0.0, x, 0.1, 3)),
        ("restitution", -0.1, lambda x: heights_in_frames(1.0, 0.0, x, 0.1, 3)),
        ("frame", 0.0, lambda x: heights_in_frames(1.0, 0.0, 0.5, x, 3)),
        ("frames", 0, lambda x: heights_in_frames(1.0, 0.0, 0.5, 0.1, x)),
        ("frame", 0.0, lambda x: places_in_frames(A, x, 3)),
        ("frames", 0, lambda x: places_in_frames(A, 0.1, x)),
        ("gravity", -9.81, lambda x: heights_in_frames(1.0, 0.0, 0.5, 0.1, 3, x)),
    ],
    "ch08_mass_aggregate": [
        ("radius", 0.0, lambda x: Deck(A, x, make_rows())),
        ("rows", "none", lambda _: Deck(A, 0.5, [])),
        ("ball_mass", 0.0, lambda x: Bridge(x)),
        ("x must", INF, lambda x: Bridge(5.0, x)),
        ("height", 0.49, lambda x: Blob(x)),
        ("height", NAN, lambda x: Blob(x)),
        ("height", 0.0, lambda x: Cube(x)),
        *(("driven", x, lambda x: Wheel(driven=x)) for x in (-1, 9, 2.0)),
        ("force", INF, lambda x: Wheel(x)),
        ("rows", 0, lambda x: Rules(x)),
        ("count", 0, fewest_rods),
        ("masses[0]", -1.0, lambda x: balancing_mass([x], [1.0], -1.0)),
        ("places[0]", NAN, lambda x: balancing_mass([1.0], [x], -1.0)),
        ("x must", INF, lambda x: balancing_mass([], [], x)),
        *(("mass", x, lambda x: TiltingPlatform().put_weight(x, 1.0)) for x in (-1.0, INF)),
        ("x must", NAN, lambda x: TiltingPlatform().put_weight(1.0, x)),
        ("mass", INF, lambda x: spread(chain(1.0, x))),
        *(("duration", x, lambda x: ParticleWorld([A]).run_physics(x)) for x in (0.0, INF)),
        *(("duration", x, lambda x: ParticleWorld([A]).step(x)) for x in (-1.0, NAN)),
        *(("duration", x, lambda x: SleepingWorld([A]).run_physics(x)) for x in (0.0, NAN)),
        ("duration", 0.0, lambda x: BallGame().step(x)),
        ("elapsed", -0.1, lambda x: FixedStep(print, 0.25).advance(x)),
        ("point", NOWHERE, lambda x: nearest_on_segment(x, UP, ONES)),
        ("a must", NOWHERE, lambda x: nearest_on_segment(UP, x, ONES)),
        ("b must", NOWHERE, lambda x: nearest_on_segment(UP, ONES, x)),
        *(
            ("normal_impulse", x, lambda x: FrictionContact(A, None, UP).friction_impulse(x))
            for x in (-1.0, INF)
        ),
        ("balancing mass", INF, lambda _: balancing_mass([1e308], [-1e10], 1.0)),
        ("sling", LOWEST, lambda x: Design(400.0, 1.0, 4.0, x, 40.0)),
        ("particles", "twice", lambda _: ParticleWorld([A, A])),
        ("duration", 0.0, lambda x: FixedStep(print, x)),
        ("max_steps", 0, lambda x: FixedStep(print, 0.25, x)),
    ],
    "ch09_rotations": [
        ("y", NAN, lambda x: rate_map(0, x, 0)),
        ("z", NAN, lambda x: rate_map(0, 0, x)),
        *(("angle", INF, call) for call in (wrap_angle, angle_to_vector)),
        ("point[0]", NAN, lambda x: rotate_point((x, 0.0), 1.0, (0.0, 0.0))),
        ("origin[1]", NAN, lambda x: rotate_point((0.0, 0.0), 1.0, (0.0, x))),
        ("masses", 0.0, lambda x: center_of_mass([x], [(0.0, 0.0)])),
        ("positions", INF, lambda x: center_of_mass([1.0], [(0.0, x)])),
        ("vector", NOWHERE, lambda x: Quaternion().rotate_by(x)),
        ("scale", INF, lambda x: Quaternion().add_scaled(UP, x)),
        ("angular_velocity", NOWHERE, lambda x: euler_rates(0.0, 0.0, 0.0, x)),
        ("point", NOWHERE, lambda x: velocity_of_point(x, UP, UP, UP)),
        ("duration", 0.0, lambda x: integrate_rotation(Quaternion(), UP, UP, x)),
        ("angular_acceleration", NOWHERE, lambda x: integrate_rotation(Quaternion(), UP, x, 1.0)),
        ("angular_speed", INF, lambda x: first_order_drift(x, 1.0, 1)),
        ("steps", 0, lambda x: first_order_drift(1.0, 1.0, x)),
        ("rate", NAN, lambda x: rotation_exercises.turned_by_sense(Quaternion(), x, 1.0)),
        ("steps", 0, lambda x: rotation_exercises.turned_by_steps(Quaternion(), 1.0, 1.0, x)),
        ("mass", 0.0, lambda x: FreeBox(x, ONES, ONES)),
        ("mass", INF, lambda x: FreeBox(x, ONES, ONES)),
        *(("sides", x, lambda x: FreeBox(1.0, Vector3(1, x, 1), ONES)) for x in (0.0, -1.0, NAN)),
        ("angular_velocity", NOWHERE, lambda x: FreeBox(1.0, ONES, x)),
    ],
}
TYPES: dict[str, list[Refused]] = {
    "ch07_constraints": [
        ("force", (0, 1, 0), lambda x: force_for_frame(x, 0.0, 0.1)),
        ("particles", A, lambda x: GroundPlane(x)),
        ("particles[0]", None, lambda x: GroundPlane([x])),
        ("a must", None, lambda x: Rod(x, B, 1.0)),
        ("b must", None, lambda x: Cable(A, x, 1.0)),
        ("anchor", None, lambda x: AnchoredCable(A, x, 1.0)),
        ("anchor", (0, 0, 0), lambda x: AnchoredRod(A, x, 1.0)),
        ("particle", None, lambda x: Contact(x, None, UP)),
        ("other", UP, lambda x: Contact(A, x, UP)),
        ("normal", (0.0, 1.0, 0.0), lambda x: Contact(A, None, x)),
        ("iterations", True, lambda x: ContactResolver(x)),
        *(("link", A, lambda x, kind=kind: kind([x])) for kind in (DirectNet, SmoothNet)),
    ],
    "ch08_mass_aggregate": [
        ("contact_generators[0]", A, lambda x: ParticleWorld([A], [x])),
        ("integrator", None, lambda x: ParticleWorld([A], integrator=x)),
        ("step", None, lambda x: FixedStep(x, 0.25)),
        ("max_steps", 2.0, lambda x: FixedStep(print, 0.25, x)),
        *(("count", x, fewest_rods) for x in (2.5, True)),
        ("point", 3.0, lambda x: nearest_on_segment(x, UP, ONES)),
    ],
    "ch09_rotations": [
        *(("nine numbers", n, lambda n: Matrix3(*range(n))) for n in (8, 12)),
        *(("twelve numbers", n, lambda n: Matrix4(*range(n))) for n in (9, 16)),
        ("sides", (1, 1, 1), lambda x: FreeBox(1.0, x, ONES)),
        *(
            ("v", (1, 2, 3), call)
            for matrix in (Matrix3(*range(9)), Matrix4(*range(12)))
            for call in (matrix.transform, Quaternion().rotate)
        ),
        ("q", 2.0, lambda x: Quaternion() * x),
        ("q", (1, 0, 0, 0), Matrix3.from_quaternion),
        ("p", None, lambda x: Matrix4.from_orientation_and_position(Quaternion(), x)),
        ("m", UP, lambda x: change_basis(x, Matrix3(*range(9)))),
        ("orientation", UP, lambda x: integrate_rotation(x, UP, UP, 1.0)),
        ("orientation", None, rotation_exercises.back_to_reference),
        ("a must", 1.0, lambda x: rotation_exercises.product_without_j_and_k(x, Quaternion())),
        ("matrix", UP, rotation_exercises.read_off),
        ("matrix", Matrix3(*range(9)), rotation_exercises.easy_inverse),
        ("'Matrix3' and", "int", lambda _: Matrix3(*range(9)) @ 2),
        ("'Matrix3' and", "Matrix4", lambda _: Matrix3(*range(9)) @ Matrix4(*range(12))),
        ("'Matrix4' and", "Matrix3", lambda _: Matrix4(*range(12)) @ Matrix3(*range(9))),
    ],
}
PLACES: dict[str, list[Refused]] = {
    "ch08_mass_aggregate": [("rods", x, lambda x: Cube(rods=[x])) for x in ((0, -1), (8, 0))],
    "ch09_rotations": [
        *(("row", place, lambda x: Matrix3(*range(9))[x]) for place in ((3, 0), (0, -1))),
        *(("row", place, lambda x: Matrix4(*range(12))[x]) for place in ((0, 4), (3, 3))),
    ],
}
CASES = cases({ValueError: VALUES, TypeError: TYPES, IndexError: PLACES})


@pytest.mark.parametrize(("chapter", "error", "name", "bad", "call"), CASES, ids=ids(CASES))
def test_a_refusal_names_the_argument_and_shows_its_value(
    chapter: str,  # noqa: ARG001, for make test CH=6
    error: type[Exception],
    name: str,
    bad: Any,
    call: Callable[[Any], object],
) -> None:
    names_the_argument(error, name, bad, call)


@pytest.mark.parametrize("kind", [Vector3, Quaternion, lambda x: Matrix3(*[x] * 9)])
def test_components_are_numbers(kind: Callable[[Any], object]) -> None:
    with pytest.raises(TypeError):
        kind(None)
    with pytest.raises(ValueError, match="'a'"):
        kind("a")
