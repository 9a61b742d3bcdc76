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
InSpace = tuple["pymunk.Space", list["pymunk.Body"]]


def twin_of(
    setup: Setup, ahead: float = 0.0, iterations: int = 10, *, corrects: bool = False
) -> InSpace:
    """Create a pymunk space with the same scene, and return it with its bodies.

    ``ahead`` is the length of a step in s. All bodies then start with their velocities half a step
    later, which makes pymunk as accurate as leapfrog. With ``corrects``, joints correct their whole
    error in each step. Raise ValueError if pymunk has no such scene.
    """
    twin = _Twin(setup)
    space, bodies = twin.space, twin.bodies
    space.iterations = iterations
    movable = [particle for particle in setup.particles if particle.inverse_mass]
    space.gravity = _common("acceleration", {(*p.acceleration,)[:2] for p in movable})
    space.damping = _common("damping", {p.damping for p in movable})
    if ahead:
        setup.registry().update_forces(ahead)
        for particle in movable:
            total = particle.acceleration + particle.force_accumulator * particle.inverse_mass
            particle.clear_forces()
            start = particle.velocity + 0.5 * ahead * total
            bodies[id(particle)].velocity = start.x, start.y
    for particle, generator in setup.forces:
        twin.add_spring(particle, generator)
    for contacts in setup.contacts:
        twin.add_contacts(contacts)
    if corrects:
        for joint in space.constraints:
            joint.error_bias = 0.0
    return space, [*bodies.values()]


def _common(name: str, values: set[Any]) -> Any:
    """Return the only one of the values, because pymunk has one for the whole space."""
    if len(values) != 1:
        raise ValueError(f"{name} must be the same for all particles in pymunk, got {values}")
    return values.pop()


class _Twin:
    """A pymunk space with a body for each particle, to which joints and shapes can be added."""

    def __init__(self, setup: Setup) -> None:
        import pymunk  # here, because a student's scenes do not need it

        self.pymunk, self.space = pymunk, pymunk.Space()
        self.bodies = {id(particle): self.body(particle) for particle in setup.particles}

    def body(self, particle: Particle) -> pymunk.Body:
        """Add a body that cannot rotate, or a static one for a particle of infinite mass."""
        if particle.inverse_mass:
            body = self.pymunk.Body(particle.mass, math.inf)
            body.velocity = particle.velocity.x, particle.velocity.y
        else:
            body = self.pymunk.Body(body_type=self.pymunk.Body.STATIC)
        body.position = particle.position.x, particle.position.y
        self.space.add(body)
        return body

    def join(self, kind: Any, a: Any, b: Any, *values: float) -> None:
        """Add a joint between two particles, or between a particle and a fixed point."""
        joined = [self.bodies.get(id(end), self.space.static_body) for end in (a, b)]
        places = [(0.0, 0.0) if id(end) in self.bodies else (end.x, end.y) for end in (a, b)]
        self.space.add(kind(*joined, *places, *values))

    def add_spring(self, particle: Particle, generator: object) -> None:
        match generator:
            case AnchoredSpring(anchor=end) | Spring(other=end):
                values = generator.rest_length, generator.stiffness, generator.damping
                self.join(self.pymunk.DampedSpring, particle, end, *values)
            case _:
                raise ValueError(f"pymunk has no force like {generator!r}")

    def add_contacts(self, generator: object) -> None:
        """Add the joint or the shapes that do the same as a contact generator."""
        # A handout for chapter 6 does not have these.
        from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs
        from ch07_constraints.links import AnchoredCable, AnchoredRod, Cable, Limits, Rod
        from scenes.links import Strut

        pin, slide = self.pymunk.PinJoint, self.pymunk.SlideJoint
        match generator:
            case Detectors(detectors=parts):
                for part in parts:
                    self.add_contacts(part)
            case Rod(a=a, b=b) | AnchoredRod(anchor=a, particle=b):
                self.join(pin, a, b)
            case Cable(a=a, b=b) | AnchoredCable(anchor=a, particle=b):
                self.join(slide, a, b, 0.0, generator.max_length)
            case Limits(a=a, b=b, min_length=low, max_length=high):
                self.join(slide, a, b, low, high)
            case Strut(a=a, b=b, min_length=length):
                self.join(slide, a, b, length, WIDE)
            case GroundPlane(particles=particles, height=height, radius=radius):
                low = height - THICK
                ends = (-WIDE, low), (WIDE, low)
                floor = self.pymunk.Segment(self.space.static_body, *ends, THICK)
                floor.elasticity = 1.0
                self.space.add(floor)
                # The restitution of two shapes is the product of their elasticities.
                self.add_spheres(particles, radius, generator.restitution)
            case ParticlePairs(particles=particles, radius=radius):
                self.add_spheres(particles, radius, math.sqrt(generator.restitution))
            case _:
                raise ValueError(f"pymunk has no contacts like {generator!r}")

    def add_spheres(self, particles: Iterable[Particle], radius: float, elasticity: float) -> None:
        """Add a sphere around each particle that does not have one yet."""
        for body in (self.bodies[id(particle)] for particle in particles):
            if not body.shapes:
                sphere = self.pymunk.Circle(body, radius)
                sphere.elasticity = elasticity
                self.space.add(sphere)
