"""Force generators, and the registry that applies them in each time step (book 5.2 and 5.3).

A generator adds one force to a particle, and does not have to know about the other forces on it.
The constructors are complete. They check their arguments and copy vectors. You may change the
attributes of a generator later, and it uses the new values from its next call on.
"""

from __future__ import annotations

from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class ForceGenerator(Protocol):
    """A force generator, which is any object with an ``update_force`` method.

    This class only describes the interface, so a generator does not have to inherit from it.
    """

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force of this generator, such as gravity or drag, to ``particle``.

        Keep the forces that were added before, and change nothing else, neither in the particle nor
        in the generator. ``duration`` is the length of the time step in s. Book 5.2.2.
        """


class ForceRegistry:
    """A list that says which force generators act on which particles in every time step.

    The attribute ``_pairs`` is a list that is empty at first. It holds tuples (particle, generator)
    in the order in which they were added. You may store the pairs in another way, but then change
    ``pairs`` to match.
    """

    def __init__(self) -> None:
        self._pairs: list[tuple[Particle, ForceGenerator]] = []

    def pairs(self) -> list[tuple[Particle, ForceGenerator]]:
        """Return a new list of the (particle, generator) pairs, in the order they were added."""
        return [*self._pairs]

    def add(self, particle: Particle, generator: ForceGenerator) -> None:
        """Let ``generator`` act on ``particle`` in every later time step.

        One generator may act on several particles, and several generators on one particle. You
        may add the same pair more than once. A pair that was added twice acts with twice the force.
        Book 5.2.2.
        """
        raise NotImplementedError("Exercise B5.3: The force registry")

    def remove(self, particle: Particle, generator: ForceGenerator) -> None:
        """Remove one (particle, generator) pair from the registry, to undo one call of ``add``.

        Compare with ``is``, because two different objects can be equal. If there is no such pair,
        do nothing.
        """
        raise NotImplementedError("Exercise B5.3: The force registry")

    def clear(self) -> None:
        """Remove all pairs from the registry, without changing the particles and generators."""
        raise NotImplementedError("Exercise B5.3: The force registry")

    def update_forces(self, duration: float) -> None:
        """Let every registered generator add its force to its particle, once per time step.

        Go through the pairs in the order in which they were added. ``duration`` is the length of
        the step in s. Skip immovable particles, because no force can move them, but keep their
        pairs, because their mass may change later. A generator may add or remove pairs while this
        method runs, but the change takes effect only in the next call.
        """
        raise NotImplementedError("Exercise B5.3: The force registry")


class Gravity:
    """A force generator for the weight of a particle, m g.

    ``acceleration`` is g, a vector in m/s^2. You do not need this generator if g is the same
    everywhere and at all times. Setting ``Particle.acceleration`` then has the same effect at a
    lower cost. Book 5.3, Eq. 3.4.
    """

    def __init__(self, acceleration: Vector3) -> None:
        self.acceleration = finite_vector("acceleration", acceleration)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the weight m g to the forces on ``particle``.

        Skip an immovable particle, whose weight would be infinite. Book 5.2.3.
        """
        raise NotImplementedError("Exercise B5.4: Gravity as a force")


class Drag:
    """A force generator for drag, a force that opposes the motion and grows with the speed.

    The air is at rest. The magnitude of the force is the sum of two terms, ``k1`` times the speed
    and ``k2`` times the speed squared. ``k1`` is in N s/m, and ``k2`` is in N s^2/m^2.

    Raises:
        ValueError: if a coefficient is negative or not finite.

    Book Eq. 5.1.
    """

    def __init__(self, k1: float, k2: float) -> None:
        self.k1 = not_negative("k1", k1)
        self.k2 = not_negative("k2", k2)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Compute the drag with ``drag_force``, and add it to the particle's other forces."""
        raise NotImplementedError("Exercise B5.5: Drag")


def drag_force(velocity: Vector3, k1: float, k2: float) -> Vector3:
    """Compute the drag in N on a body that moves at ``velocity`` in m/s, as a new vector.

    The drag is -v^ (k1 |v| + k2 |v|^2), where v^ is the unit vector along the velocity. If the
    velocity is zero, so is the drag. The vector ``velocity`` itself does not change. ``k1`` is in
    N s/m and ``k2`` in N s^2/m^2. Book Eq. 5.1.
    """
    raise NotImplementedError("Exercise B5.5: Drag")


class Uplift:
    """A vertical column of rising air that pushes the particles inside it.

    ``force`` is the force in N on every particle inside the column. The axis of the column passes
    through ``origin``, and its ``radius`` is in m. The column has no upper or lower end.

    Raises:
        ValueError: if the radius is negative or not finite.

    Exercise 5.1.
    """

    def __init__(self, origin: Vector3, radius: float, force: Vector3) -> None:
        self.origin = finite_vector("origin", origin)
        self.radius = not_negative("radius", radius)
        self.force = finite_vector("force", force)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force of the rising air to the particle if it is inside the column.

        It is inside if its horizontal distance (in X and Z) from the origin is at most the radius.
        The height does not matter. Exercise 5.1.
        """
        raise NotImplementedError("Exercise 5.1: An uplift column")


class Airbrake:
    """An airbrake: a strong drag force that can be switched on and off.

    Its force is -k v, where v is the velocity of the particle and ``k`` is in N s/m. Set the
    attribute ``on`` to True or False to switch the brake. It is off at first.

    Raises:
        ValueError: if k is negative or not finite.

    Exercise 5.2.
    """

    # The share of a full stop that the brake takes at most: rounding cannot make it more than all.
    FULL = 1.0 - 1e-12

    def __init__(self, k: float) -> None:
        self.k = not_negative("k", k)
        self.on = False

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force -k v if the brake is on, but never so much that the motion reverses.

        In a time step of h s, a force f changes the velocity by f h / m. If k or h is large, a
        force of -k v would therefore push the particle backward. A brake cannot do this, so limit
        the force: on its own, the brake may remove at most the fraction ``FULL`` of the velocity in
        one step. An immovable particle must not cause an error. Exercise 5.2.
        """
        raise NotImplementedError("Exercise 5.2: An airbrake")


class PointGravity:
    """Gravity toward a point, with the same strength at every distance.

    ``strength`` is the acceleration toward the point in m/s^2. If it is negative, the point pushes
    particles away.

    Raises:
        ValueError: if the strength is not finite.

    Exercise 5.3.
    """

    def __init__(self, center: Vector3, strength: float) -> None:
        self.center = finite_vector("center", center)
        self.strength = finite("strength", strength)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Pull the particle toward the center with a force of m times ``strength``.

        At the center the force would have no direction, so it is zero there. Everywhere else, even
        very close to the center, it has its full strength. Skip an immovable particle, because its
        force would be infinite. Exercise 5.3.
        """
        raise NotImplementedError("Exercise 5.3: Gravity toward a point")


class InverseSquareGravity:
    """Inverse-square gravity: an attraction toward ``center`` that is proportional to 1 / r^2.

    Here r is the distance from the center. Use this generator for orbits, for example for a planet
    that orbits the sun. ``mu`` is G times the attracting mass, in m^3/s^2. If ``mu`` is negative,
    the center pushes particles away.

    Raises:
        ValueError: if ``mu`` is not finite.

    Exercise 5.4, Eq. 3.3.
    """

    def __init__(self, center: Vector3, mu: float) -> None:
        self.center = finite_vector("center", center)
        self.mu = finite("mu", mu)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Pull the particle toward the center with the force m mu / r^2.

        Here r is the distance of the particle from the center in m. If the force is finite, it must
        be correct at any distance, even if r^2 or r^3 does not fit in a float. Skip an immovable
        particle, because its force would be infinite.

        Raises:
            ArithmeticError: if the particle is at the center, or so close to it that the force is
                not finite. In that case no force is added.

        Exercise 5.4.
        """
        raise NotImplementedError("Exercise 5.4: Gravity that decreases with the distance")
