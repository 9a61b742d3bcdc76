"""Translate a scene in the X-Y plane into pymunk, such as particles, springs, rods and ground."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring, Spring
from scenes.setup import Setup

if TYPE_CHECKING:
    import pymunk

WIDE = 1000.0  # m, half the width of the ground, and more than the length of any strut
THICK = 1.0  # m, half the thickness of the ground, so that no body is below it after a step
Pair = tuple[float, float]
ORIGIN = 0.0, 0.0
InSpace = tuple["pymunk.Space", list["pymunk.Body"]]


def twin_of(
    setup: Setup, ahead: float = 0.0, iterations: int = 10, *, corrects: bool = False
) -> InSpace:
    """Create a pymunk space with the same scene, and return it with its bodies.

    ``ahead`` is the length of a step in s. All bodies then start with their velocities half a step
    later, which makes pymunk as accurate as leapfrog. With ``corrects``, joints correct their whole
    error in each step. Raise ValueError if pymunk has no such scene.
    """
    import pymunk  # here, because a student's scenes do not need it

    space = pymunk.Space()
    space.iterations = iterations
    movable = [particle for particle in setup.particles if particle.inverse_mass]
    space.gravity = _common("acceleration", {(*p.acceleration,)[:2] for p in movable})
    space.damping = _common("damping", {p.damping for p in movable})
    bodies = {id(particle): _body(space, particle) for particle in setup.particles}
    if ahead:
        setup.registry().update_forces(ahead)
        for particle in movable:
            total = particle.acceleration + particle.force_accumulator * particle.inverse_mass
            particle.clear_forces()
            start = particle.velocity + 0.5 * ahead * total
            bodies[id(particle)].velocity = start.x, start.y
    for particle, generator in setup.forces:
        space.add(_spring(space, bodies, particle, generator))
    for contacts in setup.contacts:
        _add_contacts(space, bodies, contacts)
    if corrects:
        for joint in space.constraints:
            joint.error_bias = 0.0
    return space, [*bodies.values()]


def _common(name: str, values: set[Any]) -> Any:
    """Return the only one of the values, because pymunk has one for the whole space."""
    if len(values) != 1:
        raise ValueError(f"{name} must be the same for all particles in pymunk, got {values}")
    return values.pop()


def _body(space: pymunk.Space, particle: Particle) -> pymunk.Body:
    """Add a body that cannot rotate, or a static one for a particle of infinite mass."""
    import pymunk

    if particle.inverse_mass:
        body = pymunk.Body(particle.mass, math.inf)
        body.velocity = particle.velocity.x, particle.velocity.y
    else:
        body = pymunk.Body(body_type=pymunk.Body.STATIC)
    body.position = particle.position.x, particle.position.y
    space.add(body)
    return body


def _spring(
    space: pymunk.Space, bodies: dict[int, pymunk.Body], particle: Particle, generator: object
) -> pymunk.DampedSpring:
    import pymunk

    body = bodies[id(particle)]
    if isinstance(generator, AnchoredSpring):
        other, at = space.static_body, (generator.anchor.x, generator.anchor.y)
    elif isinstance(generator, Spring):
        other, at = bodies[id(generator.other)], ORIGIN
    else:
        raise ValueError(f"pymunk has no force like {generator!r}")
    values = generator.rest_length, generator.stiffness, generator.damping
    return pymunk.DampedSpring(body, other, ORIGIN, at, *values)


def _add_contacts(space: pymunk.Space, bodies: dict[int, pymunk.Body], generator: object) -> None:
    """Add the joint or the shapes that do the same as a contact generator."""
    import pymunk

    # A handout for chapter 6 does not have these.
    from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs
    from ch07_constraints.links import AnchoredCable, AnchoredRod, Cable, Limits, Rod
    from scenes.links import Strut

    def slide(a: pymunk.Body, b: pymunk.Body, low: float, high: float, at: Pair = ORIGIN) -> None:
        space.add(pymunk.SlideJoint(a, b, at, ORIGIN, low, high))

    match generator:
        case Detectors(detectors=parts):
            for part in parts:
                _add_contacts(space, bodies, part)
        case Rod(a=a, b=b):
            space.add(pymunk.PinJoint(bodies[id(a)], bodies[id(b)]))
        case AnchoredRod(particle=particle, anchor=anchor):
            at = anchor.x, anchor.y
            space.add(pymunk.PinJoint(space.static_body, bodies[id(particle)], at))
        case Cable(a=a, b=b, max_length=length):
            slide(bodies[id(a)], bodies[id(b)], 0.0, length)
        case AnchoredCable(particle=particle, anchor=anchor, max_length=length):
            at = anchor.x, anchor.y
            slide(space.static_body, bodies[id(particle)], 0.0, length, at)
        case Limits(a=a, b=b, min_length=low, max_length=high):
            slide(bodies[id(a)], bodies[id(b)], low, high)
        case Strut(a=a, b=b, min_length=length):
            slide(bodies[id(a)], bodies[id(b)], length, WIDE)
        case GroundPlane(particles=particles, height=height, radius=radius):
            low = height - THICK
            floor = pymunk.Segment(space.static_body, (-WIDE, low), (WIDE, low), THICK)
            floor.elasticity = 1.0
            space.add(floor)
            # The restitution of two shapes is the product of their elasticities.
            _add_spheres(space, bodies, particles, radius, generator.restitution)
        case ParticlePairs(particles=particles, radius=radius):
            _add_spheres(space, bodies, particles, radius, math.sqrt(generator.restitution))
        case _:
            raise ValueError(f"pymunk has no contacts like {generator!r}")


def _add_spheres(
    space: pymunk.Space,
    bodies: dict[int, pymunk.Body],
    particles: Iterable[Particle],
    radius: float,
    elasticity: float,
) -> None:
    """Add a sphere around each particle that does not have one yet."""
    import pymunk

    for particle in particles:
        body = bodies[id(particle)]
        if not body.shapes:
            sphere = pymunk.Circle(body, radius)
            sphere.elasticity = elasticity
            space.add(sphere)
