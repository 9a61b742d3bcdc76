"""Compute the numbers of chapter 7's lesson with the reference."""

from __future__ import annotations

import json

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.exercises import force_for_frame, restitution_of_drop, top_ball_speed
from ch07_constraints.going_further.small_steps import SmallSteps
from ch07_constraints.links import AnchoredCable, Cable, Rod, TwoSidedRod
from ch07_constraints.time_division import time_division_step
from lab.scenes.ch07_constraints.balls_and_ropes import Ropes
from lessons.lesson import Facts
from lessons.test_reference_pages import climb, wrong_by
from studies.contacts import scenes as measured

UP = Vector3(0, 1)
H = 1 / 60
facts = Facts()

facts.section("Why not a very stiff spring?", "60")

facts.section("How fast do they approach?", "5")

facts.section("Bounce or rest?", "5 60 0.6 9.81")
ball = Particle(acceleration=Vector3(0, -9.81))
ball.kick(H)
facts.says("0.1635", ball.velocity.y)
ball.velocity.y = -5
facts.says("2.9", Contact(ball, None, UP, 0.6).velocity_after(H))

facts.section("Impulses", "10 20 60 0.3 0.5 9.81")
a, b = Particle(velocity=Vector3(3), mass=2), Particle(Vector3(1))
before = a.kinetic_energy()
Contact(a, b, Vector3(-1), 0.5).resolve_velocity()
after = a.kinetic_energy() + b.kinetic_energy()
facts.says("1.5 6", a.velocity.x, (a.momentum() + b.momentum()).x)
facts.says("9 6.75 2.25", before, after, before - after)
moves = Contact(Particle(), Particle(mass=2), UP, penetration=0.3).resolve_penetration()
facts.says("0.2 0.1", moves[0].y, moves[1].y)
facts.says("2.75 2.13", climb(10), climb(9.81))
assert climb(9.81, 100) == climb(9.81)

facts.section("Many contacts at once")
a, b, c = (Particle(Vector3(x)) for x in (0, 0.8, 1.7))
contacts = [
    Contact(a, b, Vector3(-1), penetration=0.2),
    Contact(b, c, Vector3(-1), penetration=0.1),
]
ContactResolver().resolve_penetrations(contacts, 1)
facts.says("0.1 0.2", b.position.x - 0.8, contacts[1].penetration)

facts.section("Cables and rods", "8 60 0.6 2.5")
a, b = Particle(), Particle(Vector3(2.5))
[long] = Cable(a, b, 2).contacts()
facts.says("0.5", long.penetration)
long.resolve_penetration()
facts.says("0.25 2.25", a.position.x, b.position.x)
ropes = Ropes()
for _ in range(60):
    ropes.step(H)
facts.says("12 0.19", 100 * ropes.too_long(0), 100 * ropes.too_long(1))
assert abs(ropes.too_long(2)) < 1e-5

facts.section("Finding pairs of spheres", "8")
facts.says("499,500", 1000 * 999 / 2)

facts.section("The exact moment of an impact", "0.5 1.8 10")
ball = Particle(Vector3(0, 1.8), acceleration=Vector3(0, -10))
ground = GroundPlane([ball], restitution=1.0)
time, _ = ground.next_impact(1)
time_division_step([ball], ground, 1)
facts.says("0.6 6 0.4 1.6", time, 10 * time, 1 - time, ball.position.y)

facts.section("Going further: rods that pull and push", "10 60")
for number, link in (("14", Rod), ("1.3", TwoSidedRod)):
    facts.says(number, wrong_by(3, link))

facts.section("Going further: other contact solvers", "8 10 30 60 64 100 0.001 1,000")
stored = json.loads(measured.FILE.read_text(encoding="utf-8"))
within = {scene: ms for scene, tolerance, ms in stored["within"] if tolerance == 0.01}
stack, loaded, heavy = (within[measured.named(measured.STACK, r)] for r in (1, 100, 1000))
facts.says("9.9", stack[measured.BOOK] / stack[measured.IMPULSES])
facts.says("7.4", stack[measured.COLD] / stack[measured.IMPULSES])
facts.says("12", heavy[measured.IMPULSES] / stack[measured.IMPULSES])
facts.says("13", heavy[measured.SMALL] / stack[measured.SMALL])
facts.says("35", loaded[measured.BOOK] / loaded[measured.IMPULSES])
assert measured.BOOK not in {**heavy, **within[measured.named(measured.ROPE, 100)]}
rope = within[measured.named(measured.ROPE, 1000)]
facts.says("0.71", rope[measured.SMALL] / rope[measured.IMPULSES])
facts.says("75", rope[measured.SMALL] / rope[measured.NET])
swinging = within[f"{measured.SWING}, energy"]
facts.says("19", swinging[measured.SMALL] / swinging[measured.NET])
facts.says("18", swinging[measured.IMPULSES] / swinging[measured.NET])


def errors(solver: str, steps: range) -> list[float]:
    """Return the measured errors of a solver on the stack with a weight, in percent."""
    own = (measured.named(measured.STACK, 1000), solver)
    return [error for *key, _, n, error, _ in stored["points"] if (*key,) == own and n in steps]


assert min(errors(measured.BOOK, range(65))) > 0.5
assert min(errors(measured.SMALL, range(1, 5))) > 10
assert max(errors(measured.SMALL, range(8, 129))) < 0.2

weight = Particle(Vector3(0, -1), acceleration=Vector3(0, -10), mass=3)
soft = SmallSteps([weight], [AnchoredCable(weight, Vector3(), 1)], 0.001)
for _ in range(600):
    soft.step(H)
facts.says("0.167 1.67 0.03", 10 * H, 10 * 10 * H, -1 - weight.position.y)

facts.section("The book's exercises", "0.01 0.5 0.64 0.75 9 10 20 60")
speed, top = 20**0.5, top_ball_speed(1, 9, 1, 0.5, 0.75)
facts.says("0.8 0.6", restitution_of_drop(1, 0.64), force_for_frame(Vector3(1), 0.01, H).x)
facts.says("4.472 2.236 6.708", speed, 0.5 * speed, 1.5 * speed)
facts.says("5.031 11.739", 0.75 * 1.5 * speed, 1.75 * 1.5 * speed)
facts.says("10.565 6.093 1.86", 0.9 * 1.75 * 1.5 * speed, top, top**2 / 20)
