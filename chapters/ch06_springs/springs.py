"""Springs: force generators that pull or push on a particle, depending on the spring's length.

A spring pulls if it is longer than its rest length, and pushes if it is shorter (Eq. 6.1, 6.2). If
both ends are at the same position, it has no direction, so its force is zero.

Lengths are in m, stiffness in N/m and damping in N s/m. Constructors check their arguments and copy
vectors. They raise ValueError for a number that is negative or not finite, and TypeError for an
argument of the wrong type. You may change the attributes later, but these changes are not checked.
``update_force`` uses their current values. It adds to the forces that the particle already has, and
changes nothing else.
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
    """Compute the force in N that a spring exerts on one of its ends, as a new vector.

    ``offset`` and ``velocity`` are the position in m and the velocity in m/s of this end, both
    relative to the other end. The force is -(k (l - l0) + c l') d^. Here l is the length of
    ``offset``, d^ is its direction, k is ``stiffness``, l0 is ``rest_length`` and c is ``damping``.
    The rate at which the spring gets longer is l', the component of ``velocity`` along d^. A zero
    offset has no direction, so the force is then zero. The arguments are neither checked nor
    changed.

    A spring that is shorter than its rest length pushes. In the book's listing it pulls, because
    the listing takes the absolute value of the extension (erratum E-3). Book: Eq. 6.1, 6.2.
    """
    raise NotImplementedError("Exercise B6.1: Springs")


class Spring:
    """A spring that acts on one particle only (book 6.2.1).

    The particle at the other end, ``other``, feels no force. Use ``connect`` to act on both ends.
    """

    def __init__(
        self, other: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.other = instance_of("other", other, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Compute the spring force on ``particle``, and add it to the particle's other forces."""
        raise NotImplementedError("Exercise B6.1: Springs")


class AnchoredSpring:
    """A spring between a particle and an anchor, which is a fixed position.

    You may move ``anchor``, for example to let a camera follow a player. The damping treats even a
    moving anchor as if it were at rest. Book: section 6.2.2.
    """

    def __init__(
        self, anchor: Vector3, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring force to ``particle``, as if the anchor were at rest."""
        raise NotImplementedError("Exercise B6.1: Springs")


class Bungee(Spring):
    """An elastic rope to the particle ``other``: a spring that pulls but never pushes (book 6.2.3).

    The rope is slack, and exerts no force, unless it is longer than its rest length. The book's
    listing subtracts the lengths in the wrong order, so its rope pushes (erratum E-4).
    """

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring force if the rope is stretched, and no force if it is slack.

        While a stretched rope gets shorter, damping reduces its pull, but the rope must never push.
        """
        raise NotImplementedError("Exercise B6.2: Bungees")


class AnchoredBungee(AnchoredSpring):
    """An elastic rope to an anchor: a spring that pulls but never pushes (book 6.2.3)."""

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring force if the rope is stretched, and no force if it is slack."""
        raise NotImplementedError("Exercise B6.2: Bungees")


class Connection:
    """A spring that acts on both of its ends, ``a`` and ``b``. Create it with ``connect``."""

    def __init__(
        self, a: Particle, b: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.a = instance_of("a", a, Particle)
        self.b = instance_of("b", b, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Compute the spring force on ``a``. Add it to ``a``, and add the exact opposite to ``b``.

        Because the two forces are opposite, the total momentum of both particles stays constant.
        You may register the connection for either particle. A force that is too large for a float
        is a ValueError, as in ``add_force``.
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
    """Join the particles ``a`` and ``b`` by one spring that acts on both, and return the spring.

    The registry skips immovable particles, so the spring is registered for ``a``, or for ``b`` if
    ``a`` is immovable. If you want to make an end immovable, do so before you connect it. A spring
    between two immovable ends has no effect. If ``Connection`` raises an error for one of the
    numbers, pass the error on and register nothing.
    """
    raise NotImplementedError("Exercise B6.3: One spring for both ends")


class FakeStiffSpring:
    """A substitute for a spring that is too stiff for the time steps (book 6.3.2).

    The substitute calls ``damped_spring_state`` to find out where a real spring would move the
    particle in one step. Then it adds the constant force that takes the particle there. Its rest
    length is 0, and its other end is ``anchor``.

    The force is meant for semi-implicit Euler, p' = p + v' h. With it, the particle reaches the
    computed position if its damping is 1 and nothing else accelerates it. With explicit Euler
    (``Particle.integrate``) it arrives one step late, because p' = p + v h does not include the new
    force. Its oscillations therefore grow unless they are damped enough (erratum E-22). The book's
    formulas fit no integrator (erratum E-6).

    After the step, the particle has the mean velocity of the step, not the velocity on a real
    spring. With short steps the force is therefore half that of a real spring, and the oscillation
    is slower by a factor of 1.41 (erratum E-42). Without damping, most oscillations die out. They
    grow, by up to 13 % per step, only if h sqrt(k / m) is from pi to 4.06, from 3 pi to 3.13 pi,
    and so on. A twentieth of the critical damping prevents this.
    """

    def __init__(self, anchor: Vector3, stiffness: float, damping: float) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force that moves the particle to where a real spring would take it in this step.

        On each axis the force is m ((T - x) / h^2 - v / h). Here h is ``duration``, x and v are the
        current position and velocity, and T is the position to which a real spring would take the
        particle. Measure positions from the anchor. Add no force to an immovable particle.
        """
        raise NotImplementedError("Exercise B6.11: The faked stiff spring")


class ElasticLimitSpring:
    """Exercise 6.1: a spring that gets weaker when it is stretched beyond its elastic limit.

    Up to a length of ``limit`` it behaves like a Spring. Beyond this length, each additional meter
    increases the pull by only ``share`` times the stiffness. Unlike a real spring, it recovers. It
    has no damping, and exerts no force on the particle ``other`` at its other end. The limit must
    not be below the rest length.
    """

    def __init__(
        self, other: Particle, stiffness: float, rest_length: float, limit: float, share: float
    ) -> None:
        self.other = instance_of("other", other, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.limit = not_negative("limit", limit)
        if self.limit < self.rest_length:
            raise ValueError(f"limit must be at least rest_length ({rest_length!r}), got {limit!r}")
        self.share = not_negative("share", share)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.1: add the spring force. It must be continuous at the elastic limit."""
        raise NotImplementedError("Exercise 6.1: A spring with an elastic limit")


def max_stable_stiffness(damping: float, duration: float, mass: float = 1.0) -> float:
    """Exercise 6.6b: compute the stiffness in N/m above which a spring makes a simulation explode.

    For steps of ``Particle.integrate``, the limit is m (d^-h - 1) / h^2. Here h is ``duration`` in
    s, d is the particle's ``damping``, and m is ``mass`` in kg. The formula is for an
    AnchoredSpring without damping. If d is 1 or more, no spring is stable, so the result is 0. If d
    is 0, or d^-h is too large for a float, the result is ``math.inf``.
    """
    raise NotImplementedError("Exercise 6.6b: How stiff may a spring be? Worked out")
