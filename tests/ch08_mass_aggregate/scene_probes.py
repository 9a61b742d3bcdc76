"""Bridges, platforms, blobs, wheels and games, told as numbers, for the checks.

The autograder runs it beside the student, so nothing in here is secret, and nothing decides.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate import ball_game, blob, bridge, cube, tilting_platform, wheel
from ch08_mass_aggregate.probes import Components, xyz

Told = tuple[int, int, Components, float, float]


def told(contacts: Any, particles: Sequence[Particle]) -> list[Told]:
    """Return of each contact: particle and other by number, normal, restitution, penetration.

    The number of what is not there is -1, that of a stranger -2.
    """
    found = []
    for contact in contacts:
        a, b = number_of(contact.particle, particles), number_of(contact.other, particles)
        found.append((a, b, xyz(contact.normal), contact.restitution, contact.penetration))
    return found


def number_of(particle: Any, particles: Sequence[Particle]) -> int:
    if particle is None:
        return -1
    return next((i for i, other in enumerate(particles) if other is particle), -2)


def bridge_links(places: Sequence[Components]) -> list[Told]:
    """Return what contacts the links of a bridge have when its planks are at these places.

    A contact of two planks is told from the one with the lower number.
    """
    rows = bridge.make_rows()
    planks = [end for row in rows for end in row]
    links = bridge.links_of(rows)
    for plank, place in zip(planks, places, strict=True):
        plank.position = Vector3(*place)
    found = []
    for a, b, (x, y, z), c, depth in told([c for link in links for c in link.contacts()], planks):
        if 0 <= b < a:
            a, b, x, y, z = b, a, -x, -y, -z
        found.append((a, b, (x, y, z), c, depth))
    return found


def hung_bridge(frames: int, duration: float) -> list[Components]:
    """Let a bridge without a ball hang, by chapters 6 and 7 alone; return where its planks are."""
    rows = bridge.make_rows()
    planks = [end for row in rows for end in row]
    links = bridge.links_of(rows)
    resolver = ContactResolver()
    for _ in range(frames):
        semi_implicit_euler(planks, lambda _: None, duration)
        resolver.resolve_contacts([c for link in links for c in link.contacts()], duration)
    return [xyz(plank.position) for plank in planks]


def deck(
    ball: Components, rows: Sequence[tuple[Components, Components]], radius: float, c: float
) -> dict[str, Any]:
    """Return what a Deck says of a ball over rows of planks: nearest, and contacts.

    Particles are numbered: the ball is 0, and then come the ends of the rows.
    """
    particle = Particle(Vector3(*ball), Vector3(0.0, 3.0, 0.0))  # on its way up: it touches as well
    made = [(Particle(Vector3(*a)), Particle(Vector3(*b))) for a, b in rows]
    generator = bridge.Deck(particle, radius, made, c)
    nearest: Any = generator.nearest()
    numbered = [particle, *(end for row in made for end in row)]
    return {
        "nearest": None if nearest is None else tuple(nearest),
        "contacts": told(generator.contacts(), numbered),
    }


def rods(made: Any, particles: Sequence[Particle]) -> list[tuple[int, int, float]]:
    """Return of each rod the numbers of its ends, the lower first, and its length."""
    found = []
    for rod in made:
        i, j = sorted((number_of(rod.a, particles), number_of(rod.b, particles)))
        found.append((i, j, rod.length))
    return found


def platform_rods(places: Sequence[Components]) -> list[tuple[int, int, float]]:
    """Return the rods of a platform at these places, of which the first two are immovable."""
    particles = [
        Particle(Vector3(*place), mass=math.inf if i < 2 else 1.0) for i, place in enumerate(places)
    ]
    return rods(tilting_platform.rods_of(particles), particles)


def weighed(weights: Sequence[tuple[float, float]]) -> tuple[list[float], str]:
    """Put weights, mass and place, on a platform; return all masses, and the last one's error."""
    platform = tilting_platform.TiltingPlatform()
    error = "no error"
    for mass, x in weights:
        try:
            platform.put_weight(mass, x)
        except (ValueError, TypeError) as raised:
            error = type(raised).__name__
    return [particle.mass for particle in platform.particles], error


def tipped(mass: float, x: float, frames: int, duration: float) -> list[Components]:
    """Put a weight on a platform and wait; return where its particles are then."""
    platform = tilting_platform.TiltingPlatform()
    platform.put_weight(mass, x)
    for _ in range(frames):
        platform.step(duration)
    return [xyz(particle.position) for particle in platform.particles]


def freed(frames: int, duration: float, weight: float = 0.0) -> dict[str, Any]:
    """Free the pivot of a platform, with a weight on its right end, and wait.

    Return the masses, the rods between its particles, of the list and of the world, and where its
    particles were and are.
    """
    platform = tilting_platform.TiltingPlatform()
    for end in platform.particles[4:]:
        end.mass += 0.5 * weight
    platform.free_pivot()
    particles = platform.particles
    generators = platform.world.contact_generators
    in_world = [some for some in generators if hasattr(some, "length")]
    result: dict[str, Any] = {
        "masses": [particle.mass for particle in particles],
        "rods": rods(platform.rods, particles),
        "in world": rods(in_world, particles),
        "before": [xyz(particle.position) for particle in particles],
    }
    for _ in range(frames):
        platform.step(duration)
    return result | {"after": [xyz(particle.position) for particle in particles]}


def places_after(name: str, places: Sequence[Components]) -> list[Components]:
    """Return where particles at these places are after a call of the function of this name."""
    made = [Particle(Vector3(*place)) for place in places]
    first, second = made[:2]
    calls: dict[str, Any] = {
        "platform": lambda: tilting_platform.rods_of(made),
        "wheel": lambda: wheel.rods_of(first, made[1:]),
        "spin": lambda: wheel.spin(first, made[1:]),
        "deformation": lambda: wheel.deformation([wheel.Rod(first, second, 1.0)]),
        "bond": lambda: blob.Bond(first, second, 1.0, 1.0, 2.0, 0.5, 99.0).update_force(first, 0.1),
        "deck": lambda: bridge.Deck(Particle(), 0.5, [(first, second)], 0.0).nearest(),
    }
    calls[name]()
    return [xyz(particle.position) for particle in made]


def bonded(
    lengths: Sequence[float],
    stiffness: float,
    rest_length: float,
    limit: float,
    share: float,
    break_length: float,
    way: Components,
    swap: bool = False,
    origin: Components = (1.0, 2.0, 3.0),
) -> list[tuple[Components, Components, bool]]:
    """Pull the ends of a bond to these distances, one after the other.

    Return the force on a, that on b, and whether it holds, at each; with ``swap`` b is asked first.
    """
    a, b = Particle(Vector3(*origin)), Particle()
    bond = blob.Bond(a, b, stiffness, rest_length, limit, share, break_length)
    seen = []
    for length in lengths:
        b.position = a.position + Vector3(*way) * length
        for particle in (b, a) if swap else (a, b):
            particle.clear_forces()
            bond.update_force(particle, 0.1)
        seen.append((xyz(a.force_accumulator), xyz(b.force_accumulator), bool(bond.holds)))
    return seen


def spread_of(
    places: Sequence[Components], masses: Sequence[float]
) -> tuple[Any, list[Components]]:
    """Return the spread of particles, and where they are then."""
    made = [Particle(Vector3(*p), mass=m) for p, m in zip(places, masses, strict=True)]
    return blob.spread(made), [xyz(particle.position) for particle in made]


def settled_blob(frames: int, duration: float) -> tuple[list[Components], list[Components]]:
    """Let a blob's bonds hold its particles over the ground, by chapters 6 and 7 alone.

    Return where they were, and where they are.
    """
    made = [Particle(Vector3(0.0, 0.6), acceleration=blob.GRAVITY, mass=blob.MASS, damping=0.3)]
    for i in range(6):
        angle = math.tau * i / 6.0
        place = made[0].position + Vector3(math.cos(angle), math.sin(angle)) * blob.RADIUS
        made.append(Particle(place, acceleration=blob.GRAVITY, mass=blob.MASS, damping=0.3))
    bonds = []
    for i, a in enumerate(made):
        for b in made[:i]:
            rest = (b.position - a.position).magnitude()
            bonds.append(blob.Bond(a, b, blob.STIFFNESS, rest, 1.2 * rest, 0.25, 2.0 * rest))
    ground = GroundPlane(made)
    before = [xyz(particle.position) for particle in made]

    def apply_forces(time: float) -> None:
        for bond in bonds:
            bond.update_force(bond.a, time)
            bond.update_force(bond.b, time)

    for _ in range(frames):
        semi_implicit_euler(made, apply_forces, duration)
        for contact in ground.contacts():
            contact.resolve(duration)
    return before, [xyz(particle.position) for particle in made]


def cube_rods() -> Any:
    """Return the student's rods of a cube, as plain pairs."""
    return [tuple(rod) for rod in cube.cube_rods()]


def wheel_rods(hub: Components, rim: Sequence[Components]) -> list[tuple[int, int, float]]:
    """Return the rods of a wheel; the hub is number 0."""
    particles = [Particle(Vector3(*hub), mass=math.inf), *(Particle(Vector3(*p)) for p in rim)]
    return rods(wheel.rods_of(particles[0], particles[1:]), particles)


def driven(
    hub: Components, force: float, places: Sequence[Components], already: Components
) -> list[tuple[Components, Components]]:
    """Return the forces on particles of 2 kg at these places, and where they are then.

    They are those of one RimDrive, and one that was added already.
    """
    drive = wheel.RimDrive(Particle(Vector3(*hub), mass=math.inf), force)
    seen = []
    for place in places:
        particle = Particle(Vector3(*place), mass=2.0)
        particle.add_force(Vector3(*already))
        drive.update_force(particle, 0.1)
        seen.append((xyz(particle.force_accumulator), xyz(particle.position)))
    return seen


def spun(
    hub: tuple[Components, Components], rim: Sequence[tuple[Components, Components, float]]
) -> Any:
    """Return the spin of a rim: place, velocity and mass of each; of the hub place and velocity.

    It is asked for twice: to look at a wheel moves nothing.
    """
    middle = Particle(Vector3(*hub[0]), Vector3(*hub[1]), mass=math.inf)
    made = [Particle(Vector3(*p), Vector3(*v), mass=m) for p, v, m in rim]
    wheel.spin(middle, made)
    return wheel.spin(middle, made)


def deformed(rods_told: Sequence[tuple[float, float]], way: Components) -> Any:
    """Return the deformation of rods, each told by its length, and how far its ends are apart."""
    made = []
    for length, apart in rods_told:
        a = Particle(Vector3(1.0, 2.0, 3.0))
        b = Particle(a.position + Vector3(*way) * apart)
        made.append(wheel.Rod(a, b, length))
    wheel.deformation(made)  # to look at rods moves nothing: a second look finds the same
    return wheel.deformation(made)


def ruled(rows: int, events: Sequence[int]) -> list[tuple[int, int, list[int], bool, bool]]:
    """Tell rules what happened: a row landed on, or -1 for a fall.

    Return score, lives, visited rows, won and over after each.
    """
    rules = ball_game.Rules(rows)
    seen = []
    for event in events:
        if event < 0:
            rules.fell()
        else:
            rules.landed(event)
        visited = sorted(rules.visited)
        seen.append((rules.score, rules.lives, visited, bool(rules.won), bool(rules.over)))
    return seen


def landing(height: float, velocity: float, x: float) -> tuple[int, Any, Any]:
    """Ask Landings for contacts with a ball over the bridge; and again with it far above.

    Return how many contacts there were, and the row that was noted at first, and then.
    """
    game = ball_game.BallGame()
    game.landings.row = 0  # as of a frame before
    game.ball.position, game.ball.velocity = Vector3(x, height), Vector3(1.0, velocity)
    count = len([*game.landings.contacts()])
    first = game.landings.row
    game.ball.position.y += 10.0
    for _ in game.landings.contacts():
        pass
    return count, first, game.landings.row


def played(
    frames: int,
    duration: float,
    direction: int,
    place: Components,
    velocity: Components,
    lives: int = 3,
    visited: Sequence[int] = (),
    mass: float = 1.0,
) -> list[dict[str, Any]]:
    """Play a game from a place of the ball; return what there is after each frame."""
    game = ball_game.BallGame()
    game.ball.mass = mass
    game.direction = direction
    game.rules.lives = lives
    game.rules.visited = set(visited)
    game.ball.position, game.ball.velocity = Vector3(*place), Vector3(*velocity)
    seen = []
    for _ in range(frames):
        game.step(duration)
        seen.append(
            {
                "place": xyz(game.ball.position),
                "velocity": xyz(game.ball.velocity),
                "score": game.rules.score,
                "lives": game.rules.lives,
                "visited": sorted(game.rules.visited),
            }
        )
    return seen
