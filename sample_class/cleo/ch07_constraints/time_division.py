"""Time division."""

from ch02_vectors.arguments import positive
from ch07_constraints.contacts import Contact


class TooManyImpacts(ArithmeticError):
    def __init__(self, impacts: int, time: float, contact: Contact):
        super().__init__(
            f"more than {impacts} impacts by {time:.6g} s in the frame, and another one at "
            f"{contact.particle.position!r}: what rests impacts without an end, so give it a "
            "resolver, more restitution, or a larger max_impacts"
        )
        self.impacts, self.time, self.contact = impacts, time, contact


def time_division_step(particles, detector, duration, max_impacts=1000):
    positive("duration", duration)
    left = duration
    for _ in range(max_impacts):
        impact = detector.next_impact(left)
        if impact is None:
            break
        time, contact = impact
        _fly(particles, time)
        left -= time
        contact.resolve_velocity()
    _fly(particles, left)
    # TODO: TooManyImpacts, forces, damping


def _use_forces(particle, duration):
    raise NotImplementedError("Exercise B7.12: From impact to impact")


def _fly(particles, time):
    for particle in particles:
        if particle.has_finite_mass:
            a = particle.acceleration
            particle.position += particle.velocity * time + a * (time * time / 2)
            particle.velocity += a * time
