"""Ada's frames from impact to impact."""

from ch02_vectors.arguments import positive


class TooManyImpacts(ArithmeticError):
    """Something has come to rest, and impacts for ever."""

    def __init__(self, impacts, time, contact):
        super().__init__(
            f"more than {impacts} impacts by {time:.6g} s in the frame, and another one at "
            f"{contact.particle.position!r}: does something lie there? Then it needs a resolver"
        )
        self.impacts, self.time, self.contact = impacts, time, contact


def time_division_step(particles, detector, duration, max_impacts=1000):
    h = positive("duration", duration)
    if type(max_impacts) is not int:
        raise TypeError(f"max_impacts is no whole number: {max_impacts!r}")
    if max_impacts < 1:
        raise ValueError(f"max_impacts is below 1: {max_impacts}")

    for p in particles:
        use_forces(p, h)

    now, impacts = 0.0, 0
    while impact := detector.next_impact(max(h - now, 0)):
        time, contact = impact
        fly(particles, time)
        now += time
        if impacts == max_impacts:
            raise TooManyImpacts(impacts, now, contact)
        contact.resolve_velocity()
        impacts += 1
    fly(particles, max(h - now, 0))

    for p in particles:
        if p.has_finite_mass:
            p.velocity *= p.damping**h


def use_forces(particle, duration):
    # integrate knows how; where it went is forgotten
    place, velocity = particle.position.copy(), particle.velocity.copy()
    particle.integrate(duration)
    particle.position, particle.velocity = place, velocity


def fly(particles, time):
    for p in particles:
        if p.has_finite_mass:
            a = p.last_acceleration
            p.position += (p.velocity + a * (time / 2)) * time
            p.velocity += a * time
