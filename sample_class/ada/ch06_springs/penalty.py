"""Ada's soft ground."""

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3


class PenaltyGround:
    def __init__(self, height, stiffness, damping=0.0):
        self.height = finite("height", height)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle, duration):
        depth = self.height - particle.position.y
        if depth > 0:
            push = self.stiffness * depth - self.damping * particle.velocity.y
            particle.add_force(Vector3(0, max(push, 0), 0))  # never pulls
