"""Springs: force generators that push and pull by how far away something is.

A spring pulls its ends together when it is longer than at rest, and pushes them apart when it is
shorter (Eq. 6.1, 6.2). Where two ends are at one place there is no direction, and so no force.

Lengths are in m, stiffness is in N/m, damping in N s/m. What a generator is made with is looked at
and, where it is a vector, copied: ValueError names what is negative or not finite, TypeError what
is no number, no Vector3 or no Particle. Its attributes may be changed later, and are then yours to
keep finite.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector, instance_of, not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.other_forces import Buoyancy as Buoyancy
from ch06_springs.other_forces import HomingBullet as HomingBullet
from ch06_springs.other_forces import LighterThanAir as LighterThanAir
from ch06_springs.other_forces import Overcrowding as Overcrowding


def spring_force(
    offset: Vector3, velocity: Vector3, stiffness: float, rest_length: float, damping: float = 0.0
) -> Vector3:
    """Return the force in N of a spring on one of its ends, as new (Eq. 6.1, 6.2).

    It is -(k (l - l0) + c l') d^. ``offset`` is where this end is, seen from the other one, in m;
    l is its length, d^ its direction, and l' how fast the spring grows longer: the part along d^ of
    ``velocity``, that of this end seen from the other one, in m/s. Without an offset there is no
    direction, and no force. The arguments are not checked; the constructors of the springs do that.

    A spring that is shorter than at rest pushes. The book's listing has an absolute value there,
    with which it would pull (E-3).
    """
    raise NotImplementedError("Exercise B6.1: Springs")


class Spring:
    """A spring from the particle it acts on to another one, which it leaves alone (6.2.1).

    For a force on both ends, one spring an end is registered; ``connect`` does it with one object.
    """

    def __init__(
        self, other: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.other = instance_of("other", other, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring_force on the particle, seen from the other one."""
        raise NotImplementedError("Exercise B6.1: Springs")


class AnchoredSpring:
    """A spring from a particle to an anchor: a place that nothing pulls away (6.2.2).

    ``anchor`` may be moved, as for a camera on a spring. It counts as standing still all the same.
    """

    def __init__(
        self, anchor: Vector3, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring_force on the particle, seen from the anchor."""
        raise NotImplementedError("Exercise B6.1: Springs")


class Bungee(Spring):
    """An elastic rope to another particle: a spring that only pulls (6.2.3).

    At its rest length or shorter it is slack, and does nothing. The book's listing has the
    difference of the lengths the wrong way round, and pushes what it should pull (E-4).
    """

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force of the spring where that pulls, and nothing where the rope is slack.

        Damping makes a stretched rope pull less while it shortens, but never push.
        """
        raise NotImplementedError("Exercise B6.2: Bungees")


class AnchoredBungee(AnchoredSpring):
    """An elastic rope to an anchor, which only pulls (6.2.3)."""

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force of the spring where that pulls, as a Bungee does."""
        raise NotImplementedError("Exercise B6.2: Bungees")


class Connection:
    """A spring between two particles, a and b, that serves both ends at once: see ``connect``."""

    def __init__(
        self, a: Particle, b: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.a = instance_of("a", a, Particle)
        self.b = instance_of("b", b, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring_force on a to a, and exactly its opposite to b.

        So the momentum of the two stays what it was. Which of the two is asked for does not matter.
        """
        raise NotImplementedError("Exercise B6.3: One spring for both ends")


def connect(
    registry: ForceRegistry,
    a: Particle,
    b: Particle,
    stiffness: float,
    rest_length: float,
    damping: float = 0.0,
) -> Connection:
    """Join two particles by one spring that acts on both, and return it.

    The registry keeps it under a, or under b where a is immovable, since it asks for no immovable
    particle: fix an end in its place before it is connected, not after.
    """
    raise NotImplementedError("Exercise B6.3: One spring for both ends")


class FakeStiffSpring:
    """A spring too stiff for the steps, by the force that brings its end where it would be (6.3.2).

    Its rest length is 0, and its other end is an anchor. Where a true spring would be at the end of
    the frame is known (damped_spring_state), and one constant force through the frame leads there.

    It is built for semi-implicit Euler, p' = p + v' h: that lands where the formula says, for a
    particle of damping 1, without an acceleration of its own and without other forces. Explicit
    Euler, Particle.integrate, does not: its p' = p + v h has no force in it, so the particle is
    where it should be one frame too late, and swings ever wider (E-22). The printed forms of the
    force fit no step (E-6).

    The velocity after the frame is the mean one of the frame, and not that of a true spring. So it
    swings more slowly while its frames are short, 1.41 times as long: the force is half a true
    spring's. And without damping the swings of most die out all the same; only where chi h, with
    chi the root of k / m, is a little more than pi, 3 pi, 5 pi and so on (up to 4.06 after pi) they
    grow, by up to 13 % a frame. A twentieth of the critical damping prevents that.
    """

    def __init__(self, anchor: Vector3, stiffness: float, damping: float) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add m ((T - x) / h^2 - v / h) on each axis, T being where the spring has it after h.

        x is the place seen from the anchor, and v the velocity. An immovable particle is left
        alone. Raises ValueError where the duration is not positive and finite, for such a one too.
        """
        raise NotImplementedError("Exercise B6.11: The faked stiff spring")


class ElasticLimitSpring:
    """Exercise 6.1: a spring that is weaker once it is stretched beyond its limit of elasticity.

    Up to a length of ``limit`` it is a Spring; what it is longer than that counts with ``share``
    times the stiffness. It has no damping, and leaves the other particle alone.

    Raises ValueError where the limit is below the rest length, a number is negative, or one is not
    finite.
    """

    def __init__(
        self, other: Particle, stiffness: float, rest_length: float, limit: float, share: float
    ) -> None:
        self.other = instance_of("other", other, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.limit = not_negative("limit", limit)
        if self.limit < self.rest_length:
            raise ValueError(f"limit must be rest_length, {rest_length!r}, or more, got {limit!r}")
        self.share = not_negative("share", share)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.1: add the force; at the limit itself there is no jump in it."""
        raise NotImplementedError("Exercise 6.1: A spring with an elastic limit")


def max_stable_stiffness(damping: float, duration: float, mass: float = 1.0) -> float:
    """Exercise 6.6b: return the stiffness in N/m above which a spring explodes: m (d^-h - 1) / h^2.

    It is a spring to an anchor that has no damping of its own, under Particle.integrate in frames
    of a duration h in s; ``damping`` is the particle's d, and ``mass`` is in kg. At d = 1 and above
    it is 0: no spring is safe. At d = 0, and where d^-h is too large for a float, it is math.inf.

    Raises ValueError where the damping is negative, duration or mass is not positive, or one of
    them is not finite.
    """
    raise NotImplementedError("Exercise 6.6b: How stiff may a spring be? Worked out")
