"""Compute the numbers of chapter 8's lesson with the reference."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, explicit_euler, semi_implicit_euler
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.blob import Bond, spread
from ch08_mass_aggregate.bridge import Bridge, Deck, links_of
from ch08_mass_aggregate.bridge_plan import PLANK_MASS, make_rows
from ch08_mass_aggregate.cube import ITERATIONS, Cube, cube_rods, fewest_rods
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.friction import FrictionContact, FrictionGround
from ch08_mass_aggregate.planks import Planks, nearest_on_segment
from ch08_mass_aggregate.tilting_platform import TiltingPlatform, balancing_mass
from ch08_mass_aggregate.trebuchet import STEP, Trebuchet, my_design
from ch08_mass_aggregate.wheel import Wheel, spin
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy
from studies.models.equilibrium import equilibrium


def gained_in_free_fall(step: Integrator) -> float:
    """Return the energy in J that a step of 0.1 s adds to a ball of 2 kg."""
    ball = Particle(Vector3(0, 3), Vector3(4), Vector3(0, -9.81), mass=2)
    before = mechanical_energy([ball])
    step([ball], lambda _: None, 0.1)
    return mechanical_energy([ball]) - before


def energy() -> dict[str, float]:
    expected = 2 * 9.81**2 * 0.1**2 / 2
    assert abs(gained_in_free_fall(explicit_euler) - expected) < 1e-12
    assert abs(gained_in_free_fall(semi_implicit_euler) + expected) < 1e-12
    ball = Particle(Vector3(0, 3), Vector3(4), Vector3(0, -9.81), mass=2)
    total = mechanical_energy([ball])
    return {
        "16": ball.kinetic_energy(),
        "58.86": total - ball.kinetic_energy(),
        "74.86": total,
        "8.65": math.sqrt(2 * total / 2),
    }


def fixed_steps() -> dict[str, float]:
    clock = FixedStep(lambda _: None, 0.010)
    assert clock.advance(0.025) == 2
    left = clock.left
    assert clock.advance(0.025) == 3
    return {"5": 1000 * left, "30": 1000 * (left + 0.025)}


def bridge() -> dict[str, float]:
    ball = Particle(Vector3(0.5, 4.1))
    rows = make_rows()
    for end in rows[3]:
        end.position.y = 3.6
    deck = Deck(ball, 0.5, rows)
    found = deck.nearest()
    assert found
    assert found[0] == 3
    return {
        "28": len(Bridge().links),
        "12": 2 * len(rows),
        "10": 2 * (len(rows) - 1),
        "5": len(rows) - 1,
        "6": len(rows),
        "0.75": (0.5 + 1) / 2,
        "3.7": found[1],
        "0.1": deck.contacts()[0].penetration,
    }


def balance() -> dict[str, float]:
    assert balancing_mass([2, 1], [-3, 4], 2) == 1
    return {"6": 2 * 3}


def bonds() -> dict[str, float]:
    a, b = Particle(), Particle(Vector3(0.5))
    bond = Bond(a, b, 30, 0.5, 0.7, 0.25, 1.0)
    held = []
    for length in (0.5, 0.9, 1.1, 0.8, 0.5):
        b.position.x = length
        bond.update_force(a, 1 / 60)
        held.append(bond.holds)
    assert held == [True, True, False, False, True]
    return {"1.73": spread([Particle(mass=3), Particle(Vector3(4))])}


def rods() -> dict[str, float]:
    edges = [(i, j) for i, j in cube_rods() if (i ^ j) in (1, 2, 4)]
    return {"12": len(edges), "18": fewest_rods(8), "24": 3 * 8, "6": fewest_rods(4)}


def wheels() -> dict[str, float]:
    def spun(rate: int) -> float:
        wheel = Wheel(10.0)
        for _ in range(rate):
            wheel.step(1 / rate)
        return spin(wheel.hub, wheel.rim)

    middle, light, heavy = (
        Particle(mass=math.inf),
        Particle(Vector3(3)),
        Particle(Vector3(-1), mass=3),
    )
    inertia = 0.0
    for particle in (light, heavy):
        particle.velocity = Vector3(0, 2 * particle.position.x)
        inertia += particle.mass * particle.position.squared_magnitude()
    turning = spin(middle, [light, heavy]) * inertia
    light.position, heavy.position = Vector3(1.5), Vector3(-0.5)
    smaller = inertia / 4
    assert smaller == 1.5**2 + 3 * 0.5**2
    assert 0.115 < cube_loses() < 0.125  # "12 %"
    return {
        "8.41": spun(60),
        "9.87": spun(960),
        "6": light.velocity.y,
        "12": inertia,
        "24": turning,
        "8": turning / smaller,
    }


def cube_loses() -> float:
    """Return the fraction of its angular momentum that a free cube at 3 rad/s loses in 2 s."""
    cube = Cube()
    center = sum((p.position for p in cube.particles), Vector3()) / 8
    for particle in cube.particles:
        particle.acceleration, particle.damping = Vector3(), 1.0
        particle.velocity = Vector3(0, 0, 3).cross(particle.position - center)
    world = ParticleWorld(cube.particles, cube.rods, iterations=ITERATIONS)
    before = angular_momentum(cube.particles)
    for _ in range(120):
        world.step(1 / 60)
    return 1 - angular_momentum(cube.particles) / before


def angular_momentum(particles: list[Particle]) -> float:
    """Return the Z component of the angular momentum about the center of mass."""
    center = sum((p.position for p in particles), Vector3()) / len(particles)
    return sum((p.position - center).cross(p.velocity).z * p.mass for p in particles)


def planks() -> dict[str, float]:
    ball, a, b = Particle(Vector3(0.3, 4.4, 0.5)), Vector3(0, 4, -1), Vector3(0, 4, 1)
    found = Planks(ball, 0.6, [(Particle(a), Particle(b))]).contacts()
    normal = found[0].normal
    assert abs(normal.z) < 1e-12
    nearest = nearest_on_segment(ball.position, a, b)
    return {
        "0.75": (nearest.z + 1) / 2,
        "0.5": (ball.position - nearest).magnitude(),
        "0.1": found[0].penetration,
        "0.6": normal.x,
        "0.8": normal.y,
    }


def friction() -> dict[str, float]:
    h = 1 / 60
    body = Particle(velocity=Vector3(3), mass=2)
    contact = FrictionContact(body, None, Vector3(0, 1), friction=0.5)
    stop = contact.friction_impulse(1000).magnitude()
    pressed = 2 * 9.81 * h
    rubbed = contact.friction_impulse(pressed).magnitude()
    one, two, three = pushed(0.3, 1 / 60, 3)
    creep = 100 * (three - two)
    fine = pushed(0.3, 1 / 120, 3)
    assert abs(100 * (fine[2] - fine[1]) / creep - 0.5) < 0.05
    return {
        "0.327": pressed,
        "0.1635": rubbed,
        "6": stop,
        "0.08175": rubbed / 2,
        "0.61": 3 / (0.5 * 9.81),
        "26.6": math.degrees(math.atan(0.5)),
        "8.2": 100 * 9.81 * math.sin(math.radians(30)) * h,
        "3.60": pushed(0.0, 1 / 60, 2)[1],
        "0.65": one,
        "0.68": 2**2 / (2 * 0.3 * 9.81),
        "2.1": creep,
    }


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


def throws() -> dict[str, float]:
    machine = Trebuchet(my_design())
    stone, weight, tip = machine.projectile, machine.weight, machine.tip
    bodies = (weight, tip, stone)
    heights = {body: body.position.y for body in bodies}
    energies = {body: mechanical_energy([body]) for body in bodies}
    while not machine.flies:
        machine.step(STEP)
    gained = {body: mechanical_energy([body]) - energies[body] for body in bodies}
    fall, rise = heights[weight] - weight.position.y, stone.position.y - heights[stone]
    released = weight.mass * 9.81 * fall
    return {
        "400": machine.design.counterweight,
        "5": stone.mass,
        "27.6": stone.velocity.x,
        "14.0": stone.velocity.y,
        "30.9": stone.velocity.magnitude(),
        "2,394": stone.kinetic_energy(),
        "9.97": rise,
        "489": stone.mass * 9.81 * rise,
        "2,883": gained[stone],
        "1.432": fall,
        "5,617": released,
        "51": 100 * gained[stone] / released,
        "1,757": weight.kinetic_energy(),
        "841": gained[tip],
        "136": sum(gained.values()),
    }


def at_rest() -> dict[str, float]:
    rows = make_rows()
    links = links_of(rows)
    tensions = equilibrium(ParticleWorld([end for row in rows for end in row], links))
    return {"2.008": rows[2][0].position.y, "11.6": max(tensions), "9.81": PLANK_MASS * 9.81}


SECTIONS = {
    "Trust, but measure: energy": ("9.81", energy),
    "A fixed step": ("10 12 15 18 25 60", fixed_steps),
    "A rope bridge": ("0.4 0.5 3.6 4.1 50 1,000", bridge),
    "A platform that tips": ("", balance),
    "A blob that tears": ("0.5 0.8 0.9 1.1", bonds),
    "How many rods make a body rigid?": ("8", rods),
    "A wheel": ("10 60 960", wheels),
    "Project: a trebuchet": ("45 9.81", throws),
    "Going further: spheres and segments": ("0.3 0.4 1.5 4.4", planks),
    "Going further: friction": ("0.3 0.5 0.6 9.81 30 60 120", friction),
    "Going further: let sleeping balls lie": ("30", at_rest),
    "Summary": ("6 18", dict),
}
