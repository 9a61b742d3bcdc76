"""Cleo's fireworks: a ring of slots, as in the book's listing."""

from dataclasses import dataclass
from random import Random

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

GRAVITY = (0.0, -9.81, 0.0)


@dataclass
class Payload:
    type: int
    count: int


@dataclass
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
    share = random.random()
    velocity = Vector3()
    for axis, low, high in zip("xyz", rule.min_velocity, rule.max_velocity):
        setattr(velocity, axis, low + (high - low) * share)
    age = random.uniform(rule.min_age, rule.max_age)
    position = Vector3(random.choice([-5, 0, 5]), 0, 0)
    if parent:
        position = parent.position
        velocity += parent.velocity
    particle = Particle(position, velocity, Vector3(*GRAVITY), damping=rule.damping)
    return Firework(rule.type, age, particle)


class FireworksShow:
    def __init__(self, rules, capacity, seed, when_full="keep_old"):
        self.rules = {rule.type: rule for rule in rules}
        self.capacity = capacity
        self.random = Random(seed)
        self.fireworks = []
        self.dropped = 0

    def launch(self, type):
        self.light([(type, 1, None)])

    def light(self, births):
        for type, count, parent in births:
            for _ in range(min(count, self.capacity)):
                if len(self.fireworks) == self.capacity:
                    self.fireworks.pop(0)
                    self.dropped += 1
                rule = self.rules[type]
                self.fireworks.append(make_firework(rule, self.random, parent))

    def update(self, duration):
        for firework in self.fireworks:
            firework.particle.integrate(duration)
            firework.age -= duration
            if firework.age <= 0 or firework.particle.position.y < 0:
                self.fireworks.remove(firework)
                for payload in self.rules[firework.type].payloads:
                    parent = firework.particle
                    self.light([(payload.type, payload.count, parent)])
