"""Time division: a frame that stops at each impact, so that every one happens when it is due."""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import Detector


class TooManyImpacts(ArithmeticError):  # noqa: N818
    """A frame had more impacts than it may: something has come to rest, where they never end."""

    def __init__(self, impacts: int, time: float, contact: Contact) -> None:
        super().__init__(
            f"more than {impacts} impacts by {time:.6g} s in the frame, and another one at "
            f"{contact.particle.position!r}: what rests impacts without an end, so give it a "
            "resolver, more restitution, or a larger max_impacts"
        )
        self.impacts, self.time, self.contact = impacts, time, contact


def time_division_step(
    particles: Sequence[Particle], detector: Detector, duration: float, max_impacts: int = 1000
) -> None:
    positive("duration", duration)
    if isinstance(max_impacts, bool) or not isinstance(max_impacts, int):
        raise TypeError(f"max_impacts must be a whole number, got {max_impacts!r}")
    if max_impacts < 1:
        raise ValueError(f"max_impacts must be 1 or more, got {max_impacts!r}")
    flights = [_Flight(one, duration) for one in particles]
    for flight in flights:
        flight.use_forces(duration)
    left = _impacts(flights, detector, duration, max_impacts)
    for flight in flights:
        flight.on(left)
        flight.end()


class _Flight:
    """A particle in a frame: its acceleration, and the share of its velocity that it keeps."""

    def __init__(self, particle: Particle, duration: float) -> None:
        self.particle = particle
        self.moves = particle.inverse_mass > 0.0
        self.kept = particle.damping**duration
        self.acceleration = Vector3()

    def use_forces(self, duration: float) -> None:
        """Let the particle's kick use up the forces, and put its velocity back."""
        before = (*self.particle.velocity,)
        self.particle.kick(duration)
        velocity = self.particle.velocity
        velocity.x, velocity.y, velocity.z = before
        self.acceleration = self.particle.last_acceleration

    def on(self, time: float) -> None:
        """Fly for a time in s: the mean of the velocities before and after says how far."""
        if self.moves and time > 0.0:
            half = 0.5 * time
            velocity = self.particle.velocity
            velocity.add_scaled(self.acceleration, half)
            self.particle.position.add_scaled(velocity, time)
            velocity.add_scaled(self.acceleration, half)

    def end(self) -> None:
        """Damp the velocity, in place."""
        if self.moves:
            velocity = self.particle.velocity
            velocity *= self.kept


def _impacts(
    flights: list[_Flight], detector: Detector, duration: float, max_impacts: int
) -> float:
    """Fly from impact to impact, resolve each, and return how much of the frame is left in s."""
    impacts, left = 0, float(duration)
    while (impact := detector.next_impact(left)) is not None:
        time, contact = impact
        for flight in flights:
            flight.on(time)
        left = max(0.0, left - time)
        if impacts == max_impacts:
            raise TooManyImpacts(impacts, duration - left, contact)
        contact.resolve_velocity(0.0)
        impacts += 1
    return left
