"""Contacts between two particles, or between a particle and the world, and their resolver.

A contact stores the direction in which two bodies touch and the depth of their overlap. It also
stores the restitution, which is the fraction of the speed that is left after a bounce. To resolve
the contact, the engine applies an impulse (a change of momentum in N s, erratum E-24) and moves the
two bodies apart. Impulses always conserve momentum, but they conserve kinetic energy only if the
restitution is 1 (erratum E-7).

Lengths are in m, velocities in m/s.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

UNIT_TOLERANCE = 1e-6  # how far from 1 the length of a normal may be
VELOCITY_TOLERANCE = 1e-12  # m/s: a slower closing speed is only rounding
DEPTH_TOLERANCE = 1e-9  # m: a smaller depth counts as touching


class Contact:
    """A contact between two particles, or with the immovable world if ``other`` is None.

    ``normal`` is a unit vector that points from ``other`` to ``particle``, and is copied. For two
    balls at pa and pb it has the direction of pa - pb, and on the ground it is (0, 1, 0) (book
    7.1.3). ``restitution`` is the separating speed after a bounce divided by the closing speed
    before it. ``penetration`` is the depth of the overlap, which is 0 if the bodies just touch, and
    negative if there is a gap. Later changes of the attributes are not checked.

    Raises:
        ValueError: if the length of the normal differs from 1 by more than 1e-6, the restitution is
            not from 0 to 1, the penetration is not finite, or both particles are the same.
        TypeError: if an argument has the wrong type.
    """

    __slots__ = ("normal", "other", "particle", "penetration", "restitution")

    def __init__(
        self,
        particle: Particle,
        other: Particle | None,
        normal: Vector3,
        restitution: float = 0.0,
        penetration: float = 0.0,
    ) -> None:
        # Speed matters here, so arguments.py is called only for a value that looks wrong.
        self.particle = instance_of("particle", particle, Particle)
        self.other = None if other is None else instance_of("other", other, Particle)
        if other is particle:
            wanted = "particle and other must be two different particles"
            raise ValueError(f"{wanted}, got {other!r} twice")
        if not (isinstance(normal, Vector3) and abs(normal.magnitude() - 1.0) <= UNIT_TOLERANCE):
            normal = finite_vector("normal", normal)
            if abs(normal.magnitude() - 1.0) > UNIT_TOLERANCE:
                wanted = f"normal must be a unit vector (within {UNIT_TOLERANCE:g})"
                raise ValueError(f"{wanted}, got {normal!r}")
        self.normal = normal.copy()
        if not (type(restitution) is float and 0.0 <= restitution <= 1.0):
            restitution = a_restitution("restitution", restitution)
        self.restitution = restitution
        if type(penetration) is not float or penetration * 0.0 != 0.0:  # infinity * 0 is NaN
            penetration = finite("penetration", penetration)
        self.penetration = penetration

    def separating_velocity(self) -> float:
        """Compute how fast the two bodies move apart, in m/s (Eq. 7.4).

        The result is (va - vb) . n, which is negative while the bodies approach. Here n is the
        normal, va is the velocity of ``particle``, and vb is that of ``other``, or 0 if it is None.
        This method changes nothing.
        """
        raise NotImplementedError("Exercise B7.1: Separating velocity")

    def velocity_after(self, duration: float = 0.0) -> float:
        """Compute the separating velocity in m/s that the contact must have after it is resolved.

        If the current separating velocity v_s is 0 or positive, the result is v_s. A closing
        contact (v_s < 0) bounces with the restitution c, so the result is -c v_s (book 7.1.2).

        A body at rest on the ground also has a closing contact, because gravity has just
        accelerated it for one time step. If this small velocity made it bounce, the body would
        jitter. Let a be (aa - ab) . n. If a is negative, leave out the velocity a h that it has
        built up. Return c (a h - v_s), but never less than 0. Here h is ``duration`` in s, and aa
        and ab are the ``last_acceleration`` of the particles, which includes forces. Use 0 for an
        immovable or missing particle. The book uses only the constant acceleration, so a body under
        a gravity generator would jitter (7.2.3, erratum E-26).

        Time division resolves each impact at the moment when it happens. No such velocity has built
        up by then, so pass a duration of 0. This method changes nothing.
        """
        raise NotImplementedError("Exercise B7.2: Bounces and resting contacts")

    def resolve_velocity(self, duration: float = 0.0) -> None:
        """Apply the impulse that changes the separating velocity to ``velocity_after(duration)``.

        The impulse g in N s acts on ``particle`` along the normal n, and on ``other`` in the
        opposite direction. The new velocities are va' = va + n g / ma and vb' = vb - n g / mb. Here
        ma and mb are the masses. This conserves momentum. Nothing changes if the contact is not
        closing, or if neither particle can move. Apart from the two velocities, change nothing.
        Book: sections 7.1.4 and 7.2.
        """
        raise NotImplementedError("Exercise B7.3: Impulses")

    def resolve_penetration(self) -> tuple[Vector3, Vector3]:
        """Move the two particles apart along the normal n until they touch.

        Each particle moves in proportion to its inverse mass, so the lighter one moves farther. If
        d is the penetration, ``particle`` moves by n d mb / (ma + mb), and ``other`` moves by -n d
        ma / (ma + mb). If one of them is immovable, the other moves by the whole depth d. Afterward
        the penetration is 0. If the penetration is 0 or negative, or neither particle can move,
        nothing changes. Book 7.2.2.

        Returns:
            The displacements of ``particle`` and ``other`` in m, as two new vectors. If a particle
            did not move, its displacement is zero, so that no displacement from an earlier contact
            is used again, as in the book's downloadable source (erratum E-27).
        """
        raise NotImplementedError("Exercise B7.4: Pushing particles apart")

    def resolve(self, duration: float) -> None:
        """Resolve the velocity of this contact and then its penetration. ``duration`` is in s.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
        """
        positive("duration", duration)
        self.resolve_velocity(duration)
        self.resolve_penetration()

    def _total_inverse_mass(self) -> float:
        """Return 1 / ma + 1 / mb, which is 0 if neither particle can move."""
        other = 0.0 if self.other is None else self.other.inverse_mass
        return self.particle.inverse_mass + other


class ContactGenerator(Protocol):
    """The interface of a contact generator, which is any object with a ``contacts`` method."""

    def contacts(self) -> Iterable[Contact]:
        """Find all contacts at the current positions and return them."""


class ContactResolver:
    """Resolves the contacts of a time step: first velocities, then penetrations (book 7.3.1).

    Each phase begins with the worst contact. For velocities this is the one that closes fastest,
    and for penetrations it is the deepest one. Resolving it can make other contacts better or
    worse, so the resolver then looks for the worst contact again. ``iterations`` limits the number
    of resolutions in each phase, and None means twice the number of contacts. ``iterations_used``
    counts the resolutions of both phases together in the last step.

    Raises:
        ValueError: if ``iterations`` is less than 1.
        TypeError: if ``iterations`` is not a whole number or None.
    """

    def __init__(self, iterations: int | None = None) -> None:
        if iterations is not None:
            if not isinstance(iterations, int) or isinstance(iterations, bool):
                raise TypeError(f"iterations must be a whole number or None, got {iterations!r}")
            if iterations < 1:
                raise ValueError(f"iterations must be 1 or more, got {iterations!r}")
        self.iterations = iterations
        self.iterations_used = 0

    def resolve_contacts(self, contacts: Iterable[Contact], duration: float) -> None:
        """Resolve the velocities of all contacts, and then their penetrations.

        ``duration`` is the time step in s. This method changes velocities, positions and
        penetrations. It ignores contacts in which neither particle can move, so they do not count
        toward ``iterations``.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
        """
        positive("duration", duration)
        movable = [contact for contact in contacts if contact._total_inverse_mass()]
        limit = self.iterations or 2 * len(movable)
        used = self.resolve_velocities(movable, limit, duration)
        self.iterations_used = used + self.resolve_penetrations(movable, limit)

    def resolve_velocities(self, contacts: list[Contact], limit: int, duration: float) -> int:
        """Repeatedly resolve the velocity of the contact that closes fastest.

        Stop after ``limit`` resolutions, or when no contact closes faster than
        ``VELOCITY_TOLERANCE``. If several contacts are equally fast, take the first. This phase
        ignores penetrations. Pass ``duration``, the time step in s, on to ``resolve_velocity``. Do
        not change the list, which may be empty. At least one particle of each contact can move.

        Returns:
            The number of resolutions.
        """
        raise NotImplementedError("Exercise B7.5: Fastest contact first")

    def resolve_penetrations(self, contacts: list[Contact], limit: int) -> int:
        """Repeatedly resolve the penetration of the deepest contact.

        Every resolution moves particles, which changes the penetrations of all their contacts. So
        update each of these contacts. Subtract the distance that its ``particle`` moved along the
        normal, and add the distance that its ``other`` moved along it. The book's listing omits
        this update (erratum E-8).

        Stop after ``limit`` resolutions, or when no contact is deeper than ``DEPTH_TOLERANCE``. If
        several contacts are equally deep, take the first. The list may be empty. You may assume
        that at least one particle of every contact can move.

        Returns:
            The number of resolutions.
        """
        raise NotImplementedError("Exercise B7.6: Deepest contact first")


def a_restitution(name: str, value: float) -> float:
    """Check that a restitution is a number from 0 to 1, and return it as a float."""
    if not_negative(name, value) > 1.0:
        raise ValueError(f"{name} must be from 0 to 1, got {value!r}")
    return float(value)


def direction_of(offset: Vector3) -> Vector3:
    """Return the unit vector along ``offset``, or +Y if ``offset`` is zero and has no direction."""
    direction = offset.normalized()
    return direction if direction.squared_magnitude() else Vector3(0.0, 1.0, 0.0)
