"""Interactive scenes for chapter 7: a bouncing ball, a stack of spheres, and three equal ropes."""

from __future__ import annotations

import math
from collections.abc import Iterable

from ch02_vectors.vector import Vector3
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.going_further.bouncing_ball import heights_in_frames
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import Rod
from ch07_constraints.time_division import TooManyImpacts, time_division_step
from lab.drawing.contact_view import ContactView
from lab.drawing.pen import Pen
from lab.scene import Pair, Question, Scene
from scenes.chain import Chain
from scenes.clock import FRAME
from scenes.dropped_balls import DroppedBalls
from scenes.integrators import INTEGRATORS
from scenes.parameters import Choice, Slider
from scenes.resolving import by_resolver, no_forces, resolving
from scenes.spheres import RADIUS, overlap, stack
from scenes.twin import twin_of

G = 9.81  # m/s^2
LENGTH = 3.0  # m, of a whole rope
METHODS = ["semi-implicit Euler", "explicit Euler", "time division"]
ROPES = {"one step": "red", "substeps": "blue", "DirectChain": "green"}
RATES = [30, 60, 120, 240, 480]


class OneContact(ContactResolver):
    """A resolver for a scene with a single contact. It needs only exercises B7.1 to B7.4."""

    def resolve_contacts(self, contacts: Iterable[Contact], duration: float) -> None:
        for contact in contacts:
            contact.resolve(duration)


class Bounce(Scene):
    """A ball that bounces on the ground and keeps some or all of its speed."""

    title = "A ball that bounces"
    question = "Does the ball come back to the height from which it fell?"
    view = (-2.6, 2.6, -0.4, 4.4)
    seconds = 8.0
    exact_from = "the exact flight between impacts"
    predict = Question(
        "The ball falls from 2 m. How high are its bounces after ten seconds?",
        ["As high as at first, within 2 %.", "Higher.", "Lower."],
        lambda scene: scene.rises(),
        "With restitution 1 an exact bounce loses no energy. Explicit Euler gains energy in every "
        "flight. Semi-implicit Euler loses some at each impact, mostly because the rule for "
        "resting contacts takes away the velocity that gravity adds in one step. Time division "
        "finds the time of the impact.",
        10.0,
    )
    method = Choice(METHODS[0], "method", METHODS)
    rate = Choice(60, "steps per second", RATES, "Hz")
    restitution = Slider(1.0, "restitution", "", 0.0, 1.0, step=0.05)
    HEIGHT, RADIUS = 2.0, 0.15  # m
    LONGEST = 1800  # frames for which the exact heights are calculated

    def build(self) -> None:
        self.balls = DroppedBalls([self.HEIGHT], self.restitution, gravity=G)
        self.setup = self.balls.setup()
        (self.ball,) = self.setup.particles
        (self.ground,) = self.balls.detectors([self.ball])
        self.view_of_contacts = ContactView(OneContact())
        rest = heights_in_frames(self.HEIGHT, 0.0, self.restitution, FRAME, self.LONGEST, G)
        self.heights = [self.HEIGHT, *rest]
        self.ended = ""
        self.path = [self.HEIGHT]

    def advance(self, duration: float = FRAME) -> None:
        super().advance(duration)
        self.path = [*self.path[-240:], self.ball.position.y]

    def step(self, duration: float) -> None:
        if self.ended:
            return
        if self.method == "time division":
            try:
                time_division_step([self.ball], self.ground, duration)
            except TooManyImpacts:
                self.ended = "The bounces become ever shorter: the ball has come to rest."
            return
        INTEGRATORS[self.method]([self.ball], no_forces, duration)
        self.view_of_contacts.forget()
        if contacts := self.ground.contacts():
            self.view_of_contacts.resolve_contacts(contacts, duration)

    def rises(self) -> int:
        """Return 1 if the last bounces are over 2 % higher than the drop, 2 if lower, or else 0."""
        share = max(self.path) / self.HEIGHT
        return 1 if share > 1.02 else 2 if share < 0.98 else 0

    def draw(self, pen: Pen) -> None:
        pen.ground()
        last, top = len(self.path) - 1, self.HEIGHT + self.RADIUS
        xs = [0.25 + 2.3 * (i - last) / 240.0 + 2.2 for i in range(last + 1)]
        pen.line([(x, self.RADIUS + y) for x, y in zip(xs, self.path, strict=True)], "blue", 1.0)
        pen.segments([((-2.6, top), (2.6, top))], "gray")
        if (pair := self.beside_exact()) is not None:
            pen.circle((0.0, pair[1][0] + self.RADIUS), self.RADIUS, "gray", fill=False)
        center = (0.0, self.ball.position.y + self.RADIUS)
        pen.circle(center, self.RADIUS, "orange")
        pen.arrow(center, (0.0, 0.1 * self.ball.velocity.y), "green", "velocity")
        self.view_of_contacts.draw(pen, 0.1)
        pen.text((0.0, 4.1), self.ended, "red")

    def chart(self) -> dict[str, float]:
        energy = self.ball.kinetic_energy() + G * self.ball.position.y
        return {"energy, J": energy, "height, m": self.ball.position.y}

    def beside_exact(self) -> Pair | None:
        if (frame := round(self.simulated / FRAME)) >= len(self.heights):
            return None
        return [self.ball.position.y], [self.heights[frame]]

    def facts(self) -> str:
        if self.restitution == 1.0:
            return f"each flight takes {2.0 * self.balls.fall_time():.3f} s"
        return f"in theory the bounces end after {self.balls.end():.3f} s"

    def say(self) -> str:
        return self.ended or f"The ball is {self.ball.position.y:.2f} m high."


class PymunkBounce(Bounce):
    def build(self) -> None:
        super().build()
        self.space, (self.body,) = twin_of(self.setup)

    def step(self, duration: float) -> None:
        self.space.step(duration)
        self.ball.position.y, self.ball.velocity.y = self.body.position.y, self.body.velocity.y


Bounce.peers = {"pymunk": PymunkBounce}


class Stack(Scene):
    """A stack of spheres that the resolver has to carry, and whose top sphere can be dragged."""

    title = "A stack of spheres"
    question = "How many iterations keep a tall stack from sinking?"
    view = (-4.0, 4.0, -0.5, 10.5)
    seconds = 5.0
    predict = Question(
        "The resolver may resolve each contact only a few times per step. Does the stack stand?",
        ["Yes.", "No, spheres sink into each other by more than 10 % of their diameter."],
        lambda scene: int(scene.overlap() > 10.0),
        "Resolving a contact lifts a sphere out of the sphere below and pushes it into the sphere "
        "above. A tall stack needs more iterations or shorter steps to carry its weight.",
        4.0,
    )
    count = Choice(10, "spheres", [2, 3, 5, 8, 10])
    per_contact = Choice(2, "iterations per contact", [1, 2, 4, 8, 16], live=True)
    substeps = Choice(1, "substeps per frame", [1, 2, 4, 8], live=True)

    def build(self) -> None:
        self.setup = stack(self.count, gravity=G)
        self.spheres = self.setup.particles
        self.view_of_contacts = ContactView(ContactResolver())

    def step(self, duration: float) -> None:
        part = duration / self.substeps
        for _ in range(self.substeps):
            semi_implicit_euler(self.spheres, no_forces, part)
            self.view_of_contacts.forget()
            if contacts := [one for touching in self.setup.contacts for one in touching.contacts()]:
                self.view_of_contacts.iterations = self.per_contact * len(contacts)
                self.view_of_contacts.resolve_contacts(contacts, part)

    def draw(self, pen: Pen) -> None:
        pen.ground()
        for i, sphere in enumerate(self.spheres):
            top = i == self.count - 1
            pen.circle(sphere.position, RADIUS, "sky" if i % 2 else "blue", grab="top" * top)
            pen.arrow(sphere.position, sphere.velocity * 0.3, "green", "velocity")
        self.view_of_contacts.draw(pen, 1.0)

    def overlap(self) -> float:
        """Return the largest overlap of spheres and the ground, in % of a diameter."""
        return 100.0 * max(0.0, overlap(sphere.position.y for sphere in self.spheres))

    def chart(self) -> dict[str, float]:
        used = float(self.view_of_contacts.iterations_used)
        return {"largest overlap, % of a diameter": self.overlap(), "iterations used": used}

    def facts(self) -> str:
        return f"{self.count} contacts; at most {2 * self.per_contact * self.count} iterations"

    def say(self) -> str:
        return f"The largest overlap is {self.overlap():.1f} % of a diameter."

    def drag(self, name: str, x: float, y: float) -> None:
        top = self.spheres[-1]
        top.position.x, top.position.y = x, max(RADIUS, y)
        top.velocity.clear()


class PymunkStack(Stack):
    def build(self) -> None:
        super().build()
        self.space, self.bodies = twin_of(self.setup)

    def step(self, duration: float) -> None:
        self.space.iterations = 10 * self.per_contact
        for _ in range(self.substeps):
            self.space.step(duration / self.substeps)
        for sphere, body in zip(self.spheres, self.bodies, strict=True):
            sphere.position.x, sphere.position.y = body.position.x, body.position.y

    def drag(self, name: str, x: float, y: float) -> None:
        self.bodies[-1].position, self.bodies[-1].velocity = (x, max(RADIUS, y)), (0.0, 0.0)


Stack.peers = {"pymunk": PymunkStack}


class Ropes(Scene):
    """Three copies of a rope that should not stretch, each simulated with another method."""

    title = "One rope, three methods"
    question = "Which method keeps the rods at their true length?"
    view = (-9.5, 9.5, -4.2, 2.2)
    exact_from = "the length of the rods"
    predict = Question(
        "Which rope stretches the most?",
        ["One step per frame.", "Substeps.", "The direct solve."],
        lambda _: 0,
        "Each iteration of the resolver fixes one rod and disturbs its neighbors. With substeps "
        "there is less to fix in each step. The direct solve finds the pulls of all rods at once.",
        3.0,
    )
    count = Choice(5, "rods", [1, 2, 3, 5, 10, 15, 20])
    angle = Slider(60.0, "angle at the start", "degrees", 0.0, 90.0, step=5.0)
    substeps = Choice(8, "substeps of the blue rope", [1, 2, 4, 8, 16], live=True)

    def build(self) -> None:
        rod = LENGTH / self.count
        self.rope = Chain([1.0] * self.count, rod, math.radians(self.angle), 9.81)
        self.setups = [self.rope.setup(Rod) for _ in ROPES]
        self.chain = DirectChain(self.setups[2].particles, Vector3())

    def step(self, duration: float) -> None:
        for setup, substeps in zip(self.setups, (1, self.substeps), strict=False):
            bodies, rods = setup.particles, setup.contacts
            resolving(semi_implicit_euler, bodies, rods, by_resolver(), substeps=substeps)(duration)
        self.chain.step(duration)

    def too_long(self, i: int) -> float:
        """Add up the excess lengths of all rods of rope ``i``, in m."""
        return math.fsum(self.rope.excess(self.setups[i].particles))

    def draw(self, pen: Pen) -> None:
        for i, (name, color) in enumerate(ROPES.items()):
            x = 6.4 * (i - 1)
            positions = [Vector3(), *(body.position for body in self.setups[i].particles)]
            places = [(x + position.x, position.y) for position in positions]
            pen.line(places, color)
            pen.dots(places, color, 4.0)
            pen.segments([((x - 0.2, 0.0), (x + 0.2, 0.0))], "black", 4.0)
            pen.text((x, 1.5), name, color)
            pen.text((x, 0.8), f"{100.0 * self.too_long(i):.2f} cm too long", color, 12.0)

    def chart(self) -> dict[str, float]:
        return {f"{name}, cm": 100.0 * self.too_long(i) for i, name in enumerate(ROPES)}

    def beside_exact(self) -> Pair:
        return [self.too_long(i) for i in range(3)], [0.0, 0.0, 0.0]

    def facts(self) -> str:
        return f"{self.count} rods of {self.rope.length:.2g} m"

    def say(self) -> str:
        return f"With one step per frame the rope is {100.0 * self.too_long(0):.1f} cm too long."
