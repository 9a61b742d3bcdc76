"""Compute the numbers of chapter 8's lesson with the reference."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.blob import spread
from ch08_mass_aggregate.bridge import Bridge, Deck, links_of
from ch08_mass_aggregate.bridge_plan import PLANK_MASS, make_rows
from ch08_mass_aggregate.cube import ITERATIONS, Cube, cube_rods, fewest_rods
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.friction import FrictionContact, FrictionGround
from ch08_mass_aggregate.planks import Planks, nearest_on_segment
from ch08_mass_aggregate.tilting_platform import TiltingPlatform
from ch08_mass_aggregate.trebuchet import STEP, Trebuchet, my_design
from ch08_mass_aggregate.wheel import Wheel, spin
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy
from lessons.lesson import Facts
from studies.models.equilibrium import equilibrium

facts = Facts()

facts.section("Trust, but measure: energy", "9.81")
ball = Particle(Vector3(0, 3), Vector3(4), Vector3(0, -9.81), mass=2)
total, kinetic = mechanical_energy([ball]), ball.kinetic_energy()
facts.says("16 58.86 74.86", kinetic, total - kinetic, total)
facts.says("8.65", math.sqrt(2 * total / 2))

facts.section("A fixed step", "10 12 15 18 25 60")
clock = FixedStep(lambda _: None, 0.010)
clock.advance(0.025)
facts.says("5 30", 1000 * clock.left, 1000 * (clock.left + 0.025))

facts.section("A rope bridge", "0.4 0.5 3.6 4.1 50 1,000")
rows = make_rows()
facts.says("28 12 10", len(Bridge().links), 2 * len(rows), 2 * (len(rows) - 1))
facts.says("5 6 0.75", len(rows) - 1, len(rows), (0.5 + 1) / 2)
for end in rows[3]:
    end.position.y = 3.6
deck = Deck(Particle(Vector3(0.5, 4.1)), 0.5, rows)
facts.says("3.7 0.1", deck.nearest()[1], deck.contacts()[0].penetration)

facts.section("A platform that tips")
facts.says("6", 2 * 3)

facts.section("A blob that tears", "0.5 0.8 0.9 1.1")
facts.says("1.73", spread([Particle(mass=3), Particle(Vector3(4))]))

facts.section("How many rods make a body rigid?", "8")
edges = [(i, j) for i, j in cube_rods() if (i ^ j) in (1, 2, 4)]
facts.says("12 18 24 6", len(edges), fewest_rods(8), 3 * 8, fewest_rods(4))

facts.section("A wheel", "10 60 960")
for number, rate in (("8.41", 60), ("9.87", 960)):
    wheel = Wheel(10.0)
    for _ in range(rate):
        wheel.step(1 / rate)
    facts.says(number, spin(wheel.hub, wheel.rim))
middle, light = Particle(mass=math.inf), Particle(Vector3(3), Vector3(0, 6))
heavy = Particle(Vector3(-1), Vector3(0, -2), mass=3)
inertia = sum(p.mass * p.position.squared_magnitude() for p in (light, heavy))
turning = spin(middle, [light, heavy]) * inertia
facts.says("6 12 24 8", light.velocity.y, inertia, turning, turning / (inertia / 4))


def angular_momentum(particles: list[Particle]) -> float:
    """Return the Z component of the angular momentum about the center of mass."""
    center = sum((p.position for p in particles), Vector3()) / len(particles)
    return sum((p.position - center).cross(p.velocity).z * p.mass for p in particles)


cube = Cube()
center = sum((p.position for p in cube.particles), Vector3()) / 8
for particle in cube.particles:
    particle.acceleration, particle.damping = Vector3(), 1.0
    particle.velocity = Vector3(0, 0, 3).cross(particle.position - center)
world = ParticleWorld(cube.particles, cube.rods, iterations=ITERATIONS)
before = angular_momentum(cube.particles)
for _ in range(120):
    world.step(1 / 60)
assert 0.115 < 1 - angular_momentum(cube.particles) / before < 0.125  # "12 %"

facts.section("Going further: spheres and segments", "0.3 0.4 1.5 4.4")
ball, a, b = Particle(Vector3(0.3, 4.4, 0.5)), Vector3(0, 4, -1), Vector3(0, 4, 1)
[found] = Planks(ball, 0.6, [(Particle(a), Particle(b))]).contacts()
nearest = nearest_on_segment(ball.position, a, b)
facts.says("0.75 0.5", (nearest.z + 1) / 2, (ball.position - nearest).magnitude())
facts.says("0.1 0.6 0.8", found.penetration, found.normal.x, found.normal.y)

facts.section("Going further: friction", "0.3 0.5 0.6 9.81 30 60 120")
body = Particle(velocity=Vector3(3), mass=2)
contact = FrictionContact(body, None, Vector3(0, 1), friction=0.5)
pressed = 2 * 9.81 / 60
rubbed = contact.friction_impulse(pressed).magnitude()
facts.says("0.327 0.1635 0.08175", pressed, rubbed, rubbed / 2)
facts.says("6 0.61", contact.friction_impulse(1000).magnitude(), 3 / (0.5 * 9.81))
facts.says("26.6", math.degrees(math.atan(0.5)))
facts.says("8.2", 100 * 9.81 * math.sin(math.radians(30)) / 60)


def pushed(coefficient: float, step: float, seconds: int) -> list[float]:
    """Push a freed platform; return how far its center of mass slid after each second."""
    platform = TiltingPlatform()
    platform.put_weight(4, -3)
    for _ in range(round(2 / step)):
        platform.step(step)
    platform.free_pivot()
    particles = platform.particles
    generators = platform.world.contact_generators
    for i, generator in enumerate(generators):
        if isinstance(generator, GroundPlane):
            generators[i] = FrictionGround(particles, coefficient)
    for particle in particles:
        particle.velocity = Vector3(2)

    def center() -> float:
        return sum(p.mass * p.position.x for p in particles) / sum(p.mass for p in particles)

    start, slid = center(), []
    for _ in range(seconds):
        for _ in range(round(1 / step)):
            platform.step(step)
        slid.append(center() - start)
    return slid


one, two = pushed(0.3, 1 / 60, 2)
facts.says("3.60 0.65 0.68", pushed(0.0, 1 / 60, 2)[1], one, 2**2 / (2 * 0.3 * 9.81))
facts.says("2.1", 100 * (two - one))
fine = pushed(0.3, 1 / 120, 2)
assert abs((fine[1] - fine[0]) / (two - one) - 0.5) < 0.05  # half as much

facts.section("Project: a trebuchet", "45 9.81")
machine = Trebuchet(my_design())
stone, weight, tip = bodies = machine.projectile, machine.weight, machine.tip
heights = [body.position.y for body in bodies]
energies = [mechanical_energy([body]) for body in bodies]
while not machine.flies:
    machine.step(STEP)
gained = [mechanical_energy([body]) - old for body, old in zip(bodies, energies, strict=True)]
fall, rise = heights[1] - weight.position.y, stone.position.y - heights[0]
released = weight.mass * 9.81 * fall
facts.says("400 5", machine.design.counterweight, stone.mass)
facts.says("27.6 14.0 30.9", stone.velocity.x, stone.velocity.y, stone.velocity.magnitude())
facts.says("2,394 9.97 489", stone.kinetic_energy(), rise, stone.mass * 9.81 * rise)
facts.says("1.432 5,617 1,757", fall, released, weight.kinetic_energy())
facts.says("2,883 51", gained[0], 100 * gained[0] / released)
facts.says("841 136", gained[2], sum(gained))

facts.section("Going further: let sleeping balls lie", "30")
rows = make_rows()
links = links_of(rows)
tensions = equilibrium(ParticleWorld([end for row in rows for end in row], links))
facts.says("2.008 11.6 9.81", rows[2][0].position.y, max(tensions), PLANK_MASS * 9.81)

facts.section("Summary", "6 18")
