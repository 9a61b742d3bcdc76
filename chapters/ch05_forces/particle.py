"""A particle on which forces act: chapter 3's, with a force accumulator (book 5.1).

Units are SI: forces are in N. What is no number, or no Vector3, is a TypeError everywhere.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle

Numbers = tuple[float, float, float]
NO_FORCE: Numbers = (0.0, 0.0, 0.0)


class Particle(particle.Particle):
    """A particle of chapter 3 that adds up the forces of a frame until its next step uses them.

    Where the forces are kept is your choice. Here ``_forces`` is a list with two entries: the sum
    since the last step, and the sum that the last step used. Each is three numbers, or None while
    no force was added. If you keep them in another way, change ``__slots__``, the constructor,
    ``__copy__``, ``take_forces`` and ``add_force_pair`` to match.
    """

    __slots__ = ("_forces",)

    _forces: list[Numbers | None]

    def __init__(
        self,
        position: Vector3 | None = None,
        velocity: Vector3 | None = None,
        acceleration: Vector3 | None = None,
        *,
        mass: float = 1.0,
        damping: float = 1.0,
    ) -> None:
        super().__init__(position, velocity, acceleration, mass=mass, damping=damping)
        self._forces = [None, None]

    def __copy__(self) -> Particle:
        """Return a copy with the same forces, which no longer change with the original's."""
        other = Particle(self.position, self.velocity, self.acceleration, damping=self.damping)
        other.inverse_mass = self.inverse_mass
        other._forces = [*self._forces]
        return other

    def take_forces(self) -> Numbers:
        """Return the sum of the forces in N as three numbers, and clear it.

        For integrators that evaluate the forces several times in a step. It does what
        force_accumulator and clear_forces do, in a third of the time.
        """
        forces = self._forces
        force = forces[0]
        forces[0] = None
        return force or NO_FORCE

    def add_force_pair(self, other: Particle, x: float, y: float, z: float) -> None:
        """Add a force in N to this particle, and the opposite force to another one.

        This is Newton's third law for a force with the components x, y and z. It does what two
        calls of add_force do, in half of the time: a cloth needs it for hundreds of springs.

        Raises ValueError where a component, or one of the two sums, is not finite; both sums are
        then as they were.
        """
        mine, others = self._forces, other._forces
        ax, ay, az = mine[0] or NO_FORCE
        bx, by, bz = others[0] or NO_FORCE
        ax += x
        ay += y
        az += z
        bx -= x
        by -= y
        bz -= z
        if 0.0 * (ax + ay + az + bx + by + bz) != 0.0:  # one question for six numbers
            finite_vector("the force", Vector3(x, y, z))
            finite_vector("the sum of the forces", Vector3(ax, ay, az))
            finite_vector("the sum of the forces", Vector3(bx, by, bz))
        mine[0] = (ax, ay, az)
        others[0] = (bx, by, bz)

    @property
    def force_accumulator(self) -> Vector3:
        """The sum in N of the forces since the last step, as new; add_force is what changes it."""
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    def add_force(self, force: Vector3) -> None:
        """Add a force in N to the sum, for the next step alone (5.1). The force is only read.

        Raises ValueError where a component of it, or of the sum, is not finite; the sum is then as
        it was.
        """
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    def clear_forces(self) -> None:
        """Drop the forces that were added since the last step; what that step used stays (5.1)."""
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    @property
    def last_acceleration(self) -> Vector3:
        """All of the acceleration of the last step, as new: the constant one, and f / m (Eq. 3.2).

        It is worked out when it is asked for: from the forces that the last step used, and from
        the mass and the constant acceleration of now. Before the first step, and for an immovable
        particle, it is the constant acceleration.
        """
        raise NotImplementedError("Exercise B5.2: The step with forces")

    def kick(self, duration: float) -> None:
        """Change the velocity as chapter 3's kick does, with the forces: v' = (v + a h) d^h.

        Here a is the constant acceleration plus f / m, and f is the sum of the forces since the
        last kick. The sum is cleared, for an immovable particle too, and kept as what the last
        step used. integrate needs no body here: chapter 3's drifts, and then calls this kick.

        The duration is not checked, as in chapter 3.
        """
        raise NotImplementedError("Exercise B5.2: The step with forces")
