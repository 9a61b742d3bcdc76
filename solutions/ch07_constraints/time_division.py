"""Time division: a frame that stops at each impact, so that every one happens when it is due (7.3).

Between impacts every particle is where constant acceleration takes it, without an error of steps.
That is exact where bodies fly freely and bounce, as in billiards, and it takes the longer the more
impacts there are. What lies on something has impacts without an end: that is for resolvers.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import positive, whole
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import Detector


class TooManyImpacts(ArithmeticError):  # noqa: N818
    """A frame had more impacts than it may: something has come to rest, where they never end.

    ``impacts`` is how many were resolved, ``time`` when in the frame that was, in s, ``contact``
    the next one.
    """

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
    """Move particles on by a frame of a duration in s, from impact to impact (7.3).

    A particle's acceleration is the same throughout the frame: the constant one, and that of the
    forces which were added before it, f / m. They are used up by the frame, as by a step of
    Particle.integrate, and last_acceleration is this acceleration from the beginning of the frame
    on: detectors look ahead by it. Between impacts the motion is exact, p + v t + a t^2 / 2. At
    each impact that ``detector`` finds in what is left of the frame, the velocity of its contact is
    resolved, for a duration of 0: nothing there was built up by a frame. Depths are not looked at.
    Damping multiplies the velocities by d^h once, at the end. Immovable particles stay where they
    are.

    Impacts at the same time are resolved one after the other, in the order of the detector: a ball
    that hits a row of touching ones passes its motion on from one to the next. Where two balls hit
    a third from both sides at once, the order decides, as it does for resolvers.

    ``particles`` has all that the detector knows, each once. Raises ValueError where the duration
    is not positive and finite, or ``max_impacts`` is below 1, and TypeError where that is no whole
    number; all is as it was then. Raises TooManyImpacts where there is another impact after
    ``max_impacts`` of them: the particles are then where they are at its time, not yet damped.
    """
    positive("duration", duration)
    whole("max_impacts", max_impacts)
    for particle in particles:
        particle.kick(0.0)  # uses up the forces, and changes no velocity
    left, impacts = duration, 0
    while (impact := detector.next_impact(left)) is not None:
        time, contact = impact
        _fly(particles, time)
        left -= time
        if impacts == max_impacts:
            raise TooManyImpacts(impacts, duration - left, contact)
        contact.resolve_velocity()
        impacts += 1
    _fly(particles, left)
    for particle in particles:
        if particle.inverse_mass:
            particle.velocity *= particle.damping**duration


def _fly(particles: Sequence[Particle], time: float) -> None:
    """Move particles on by a time in s without an impact.

    The mean velocity moves them: half a drift before the acceleration and half of it afterwards.
    """
    for particle in particles:
        if particle.inverse_mass:
            particle.drift(0.5 * time)
            particle.velocity.add_scaled(particle.last_acceleration, time)
            particle.drift(0.5 * time)
