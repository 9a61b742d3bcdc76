"""Compute the numbers of chapter 7's lesson with the reference."""

from __future__ import annotations

import json

from lab.scenes.ch07_constraints.balls_and_ropes import Ropes

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import explicit_euler
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.exercises import force_for_frame, restitution_of_drop, top_ball_speed
from ch07_constraints.going_further.small_steps import SmallSteps
from ch07_constraints.links import AnchoredCable, Cable, Rod, TwoSidedRod
from ch07_constraints.time_division import time_division_step
from plots.ch07_constraints.rods import stretch
from scenes.chain import Chain, Link
from studies.contacts.scenes import (
    BOOK,
    COLD,
    FILE,
    IMPULSES,
    NET,
    ROPE,
    SMALL,
    STACK,
    SWING,
    named,
)

UP = Vector3(0, 1)
H = 1 / 60


def closing() -> dict[str, float]:
    ball = Particle(velocity=Vector3(3, -4))
    fast, slow = Particle(velocity=Vector3(5)), Particle(velocity=Vector3(2))
    assert Contact(ball, None, UP).separating_velocity() == -4
    assert Contact(fast, slow, Vector3(-1)).separating_velocity() == -3
    return {}


def bounces() -> dict[str, float]:
    ball = Particle(acceleration=Vector3(0, -9.81))
    ball.kick(H)
    rest = Contact(ball, None, UP, 0.6)
    assert rest.velocity_after(H) == 0
    gained = ball.velocity.y
    ball.velocity.y = -5
    return {"0.1635": gained, "2.9": rest.velocity_after(H)}


def climbs(gravity: float, seconds: float) -> float:
    """Return how high a ball bounces with the book's step, dropped from 2 m with restitution 1."""
    ball = Particle(Vector3(0, 2), acceleration=Vector3(0, -gravity))
    ground, heights = GroundPlane([ball], restitution=1.0), []
    for _ in range(round(seconds / H)):
        explicit_euler([ball], lambda _: None, H)
        if contacts := ground.contacts():
            ContactResolver().resolve_contacts(contacts, H)
        heights.append(ball.position.y)
    return max(heights)


def meetings() -> dict[str, float]:
    rising = Particle(acceleration=Vector3(0, -9.81))
    rising.kick(H)
    rising.velocity.y = 5
    assert Contact(rising, None, Vector3(0, -1), 1.0).velocity_after(H) == 5
    return bounces()


def impulses() -> dict[str, float]:
    a, b = Particle(velocity=Vector3(3), mass=2), Particle(Vector3(1))
    before = a.kinetic_energy()
    Contact(a, b, Vector3(-1), 0.5).resolve_velocity()
    assert b.velocity == Vector3(3)
    after = a.kinetic_energy() + b.kinetic_energy()
    light, heavy = Particle(), Particle(mass=2)
    moves = Contact(light, heavy, UP, penetration=0.3).resolve_penetration()
    assert climbs(9.81, 100) == climbs(9.81, 20)
    return {
        "1.5": a.velocity.x,
        "6": (a.momentum() + b.momentum()).x,
        "9": before,
        "6.75": after,
        "2.25": before - after,
        "0.2": moves[0].y,
        "0.1": moves[1].y,
        "2.75": climbs(10, 20),
        "2.13": climbs(9.81, 20),
    }


def rows() -> dict[str, float]:
    a, b, c = (Particle(Vector3(x)) for x in (0, 0.8, 1.7))
    contacts = [
        Contact(a, b, Vector3(-1), penetration=0.2),
        Contact(b, c, Vector3(-1), penetration=0.1),
    ]
    ContactResolver().resolve_penetrations(contacts, 1)
    return {"0.1": b.position.x - 0.8, "0.2": contacts[1].penetration}


def links() -> dict[str, float]:
    a, b = Particle(), Particle(Vector3(2.5))
    [short] = Rod(a, b, 3).contacts()
    assert short.normal == Vector3(-1)
    [long] = Cable(a, b, 2).contacts()
    excess = long.penetration
    assert short.penetration == excess
    long.resolve_penetration()
    return {"0.5": excess, "0.25": a.position.x, "2.25": b.position.x}


def ropes() -> dict[str, float]:
    scene = Ropes()
    for _ in range(60):
        scene.step(H)
    assert abs(scene.too_long(2)) < 1e-5
    return links() | {"12": 100 * scene.too_long(0), "0.19": 100 * scene.too_long(1)}


def wrong_by(count: int, link: Link) -> float:
    """Return the worst error in mm of a hanging chain's rods within two seconds."""
    return 1000 * max(stretch(Chain([1.0] * count, 0.1), link, 120)[1].values)


def two_sided() -> dict[str, float]:
    assert 4.5 < wrong_by(10, Rod) / wrong_by(10, TwoSidedRod) < 5.5
    return {"14": wrong_by(3, Rod), "1.3": wrong_by(3, TwoSidedRod)}


def moments() -> dict[str, float]:
    ball = Particle(Vector3(0, 1.8), acceleration=Vector3(0, -10))
    ground = GroundPlane([ball], restitution=1.0)
    impact = ground.next_impact(1)
    assert impact
    time_division_step([ball], ground, 1)
    return {"0.6": impact[0], "6": 10 * impact[0], "0.4": 1 - impact[0], "1.6": ball.position.y}


def exercises() -> dict[str, float]:
    speed = 20**0.5
    top = top_ball_speed(1, 9, 1, 0.5, 0.75)
    closed = 1.5 * speed
    return {
        "0.8": restitution_of_drop(1, 0.64),
        "4.472": speed,
        "2.236": 0.5 * speed,
        "6.708": closed,
        "5.031": 0.75 * closed,
        "11.739": 1.75 * closed,
        "10.565": 0.9 * 1.75 * closed,
        "6.093": top,
        "1.86": top**2 / 20,
        "0.6": force_for_frame(Vector3(1), 0.01, H).x,
    }


def solvers() -> dict[str, float]:
    stored = json.loads(FILE.read_text(encoding="utf-8"))
    within = {scene: ms for scene, tolerance, ms in stored["within"] if tolerance == 0.01}
    swinging = within[f"{SWING}, energy"]

    def time(scene: str, ratio: int, solver: str) -> float:
        return within[named(scene, ratio)][solver]

    def errors(solver: str, steps: range) -> list[float]:
        own = (named(STACK, 1000), solver)
        points = stored["points"]
        return [error for *key, _, n, error, _ in points if (*key,) == own and n in steps]

    assert min(errors(BOOK, range(65))) > 0.5
    assert min(errors(SMALL, range(1, 5))) > 10
    assert max(errors(SMALL, range(8, 129))) < 0.2
    assert BOOK not in within[named(STACK, 100)]
    assert BOOK not in within[named(ROPE, 100)]
    equal = time(STACK, 1, IMPULSES)
    cable = Particle(Vector3(0, -1), acceleration=Vector3(0, -10), mass=3)
    soft = SmallSteps([cable], [AnchoredCable(cable, Vector3(), 1)], 0.001)
    for _ in range(600):
        soft.step(H)
    return {
        "0.167": 10 * H,
        "1.67": 10 * 10 * H,
        "0.03": -1 - cable.position.y,
        "7.5": time(STACK, 1, BOOK) / equal,
        "7.7": time(STACK, 1, COLD) / equal,
        "9.5": time(STACK, 1000, IMPULSES) / equal,
        "11": time(STACK, 1000, SMALL) / time(STACK, 1, SMALL),
        "0.76": time(ROPE, 1000, SMALL) / time(ROPE, 1000, IMPULSES),
        "80": time(ROPE, 1000, SMALL) / time(ROPE, 1000, NET),
        "21": swinging[SMALL] / swinging[NET],
        "18": swinging[IMPULSES] / swinging[NET],
    }


SECTIONS = {
    "Why not a very stiff spring?": ("60", dict),
    "How fast do they approach?": ("5", closing),
    "Bounce or rest?": ("5 60 0.6 9.81", meetings),
    "Impulses": ("10 20 60 0.3 0.5 9.81", impulses),
    "Many contacts at once": ("", rows),
    "Cables and rods": ("8 60 0.6 2.5", ropes),
    "Finding pairs of spheres": ("8", lambda: {"499,500": 1000 * 999 / 2}),
    "The exact moment of an impact": ("0.5 1.8 10", moments),
    "Going further: rods that pull and push": ("10 60", two_sided),
    "Going further: other contact solvers": ("8 10 30 60 64 0.001 1,000", solvers),
    "The book's exercises": ("0.01 0.5 0.64 0.75 9 10 20 60", exercises),
}
