"""Ada's fireworks."""

from dataclasses import dataclass
from random import Random

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

GRAVITY = (0.0, -9.81, 0.0)
LAUNCH_PLACES = (-5.0, 0.0, 5.0)


@dataclass(frozen=True)
class Payload:
    type: int
    count: int


@dataclass(frozen=True)
class FireworkRule:
    type: int
    min_age: float
    max_age: float
    min_velocity: tuple
    max_velocity: tuple
    damping: float
    payloads: tuple = ()


class Firework:
    def __init__(self, type, age, particle):
        self.type, self.age, self.particle = type, age, particle


def make_firework(rule, random, parent=None):
    age = random.uniform(rule.min_age, rule.max_age)
    ranges = zip(rule.min_velocity, rule.max_velocity)
    velocity = Vector3(*[random.uniform(low, high) for low, high in ranges])
    place = Vector3(random.choice(LAUNCH_PLACES), 0, 0)
    if parent is not None:
        place = parent.position
        velocity = velocity + parent.velocity
    particle = Particle(place, velocity, Vector3(*GRAVITY), damping=rule.damping)
    return Firework(rule.type, age, particle)


def endless_types(rules):
    after = {rule.type: {p.type for p in rule.payloads} for rule in rules}
    for _ in after:  # as many rounds as there are types
        for type in after:
            for other in set(after[type]):
                after[type] |= after.get(other, set())
    return sorted(type for type in after if type in after[type])


class FireworksShow:
    def __init__(self, rules, capacity, seed, when_full="keep_old"):
        self.rules = {rule.type: rule for rule in rules}
        self.capacity = capacity
        self.when_full = when_full
        self.random = Random(seed)
        self.fireworks = []
        self.dropped = 0

    def launch(self, type):
        self.light([(type, 1, None)])

    def light(self, births):
        for type, count, _ in births:
            if type not in self.rules or count < 0:
                raise ValueError(f"cannot light {count!r} of type {type!r}")
        asked = sum(count for _, count, _ in births)
        burning = len(self.fireworks)
        room = self.capacity
        skip = 0
        if self.when_full == "keep_old":
            room -= burning
        else:
            skip = max(0, asked - room)  # these would be put out at once
        for type, count, parent in births:
            skipped = min(skip, count)
            skip -= skipped
            lit = min(count - skipped, room)
            room -= lit
            for _ in range(lit):
                self.fireworks.append(make_firework(self.rules[type], self.random, parent))
        self.fireworks = self.fireworks[-self.capacity :]
        self.dropped += burning + asked - len(self.fireworks)

    def update(self, duration):
        positive("duration", duration)
        for firework in self.fireworks:
            firework.particle.integrate(duration)
            firework.age -= duration
        dead = [f for f in self.fireworks if f.age < 0 or f.particle.position.y < 0]
        self.fireworks = [f for f in self.fireworks if f not in dead]
        self.light(
            [
                (payload.type, payload.count, firework.particle)
                for firework in dead
                for payload in self.rules[firework.type].payloads
            ]
        )
