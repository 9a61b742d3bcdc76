"""Going further: rods as forces, so that any integrator of chapter 6 can step a chain.

A resolver corrects a rod only after a step has changed its length. This module instead computes the
tensions that keep the lengths of the rods constant, and adds them as forces. Any integrator can
then step the chain. Runge-Kutta 4 reaches order 4 and velocity Verlet order 2, while a resolver has
order 1 and DirectChain has order 2. Leapfrog has order 1 here, because the tensions depend on the
velocities.

If a rod keeps its length, the relative acceleration of its ends along the rod is known. The tension
of a rod accelerates both of its ends. Each tension therefore appears in the equations of its own
rod and of the two neighboring rods. The equations are solved from the anchor to the tip and back.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from studies.models.forces import take_forces


class RodTensions:
    """The tensions in a chain of rods that starts at ``anchor`` and joins ``particles`` in order.

    Each rod keeps the length in m that it has when the chain is created. If there are several
    particles, the last one may be immovable, to hold the other end.

    Every integrator makes a small error in each step, so the rods slowly become too long or too
    short. ``correction``, in 1/s, is the rate at which a rod returns to its length. With a rate of
    0 the errors add up, and with a rate of 5 they stay small. A rate near the number of steps per
    second is too high, because it makes the chain stiff and lowers the order of the integrator.
    Source: J. Baumgarte, Computer Methods in Applied Mechanics and Engineering 1 (1972), pp. 1-16.

    Raises:
        ValueError: if the length of a rod is 0, if a particle other than the last is immovable, or
            if the correction is negative or not finite.
    """

    def __init__(
        self, particles: Sequence[Particle], anchor: Vector3, correction: float = 5.0
    ) -> None:
        self.particles = [*particles]
        self.anchor = finite_vector("anchor", anchor)
        self.correction = not_negative("correction", correction)
        self.lengths: list[float] = []
        ends = [self.anchor, *(particle.position for particle in self.particles)]
        for i, (start, end) in enumerate(pairwise(ends)):
            is_other_end = i and i == len(self.particles) - 1
            if not (self.particles[i].inverse_mass or is_other_end):
                raise ValueError(f"particles[{i}] must have a finite mass, got inf")
            self.lengths.append(positive(f"the length of rod {i}", (end - start).magnitude()))

    def update_forces(self, duration: float = 0.0) -> None:  # noqa: ARG002 - as integrators pass it
        """Add the tensions to the accumulators of the particles.

        Add all other forces before you call this method, because the tensions depend on them. If
        there are no other forces, pass the method to an integrator as ``apply_forces``. The
        argument ``duration`` is not used.

        Raises:
            ArithmeticError: if the tensions have no unique solution, as in a straight chain between
                two immovable ends. The accumulators are then empty.
        """
        # Row i: (m0 + m1) r.r T[i] - m0 r.q T[i-1] - m1 r.s T[i+1] = wanted. The rods i - 1, i and
        # i + 1 are q, r and s, m0 and m1 are the inverse masses at the ends of r, and T is the
        # tension per meter of rod. Elimination leaves T[i] = value + factor T[i+1] in each row.
        rate = self.correction
        rows = []
        place = self.anchor
        x0, y0, z0 = place.x, place.y, place.z
        u0 = v0 = w0 = a0 = b0 = c0 = 0.0  # velocity and acceleration of the inner end
        last_x = last_y = last_z = inner_mass = value = 0.0
        pivot = 1.0
        for particle, length in zip(self.particles, self.lengths, strict=True):
            place, velocity, mass = particle.position, particle.velocity, particle.inverse_mass
            force = fx, fy, fz = take_forces(particle)
            x1, y1, z1 = place.x, place.y, place.z
            u1 = v1 = w1 = a1 = b1 = c1 = 0.0
            if mass:  # an immovable end stays, whatever its velocity is
                u1, v1, w1 = velocity.x, velocity.y, velocity.z
                free = particle.acceleration
                a1, b1, c1 = free.x + fx * mass, free.y + fy * mass, free.z + fz * mass
            x, y, z, u, v, w = x1 - x0, y1 - y0, z1 - z0, u1 - u0, v1 - v0, w1 - w0
            square = x * x + y * y + z * z
            wanted = x * (a1 - a0) + y * (b1 - b0) + z * (c1 - c0) + u * u + v * v + w * w
            wanted += 2.0 * rate * (x * u + y * v + z * w)
            wanted += 0.5 * rate * rate * (square - length * length)
            below = inner_mass * (x * last_x + y * last_y + z * last_z)
            factor = below / pivot
            rows.append((particle, force, x, y, z, factor, value))
            pivot = (inner_mass + mass) * square - below * factor
            if not pivot > 1e-14 * square * (inner_mass + mass):  # NaN too
                raise ArithmeticError(f"the tension of rod {len(rows) - 1} has no unique solution")
            value = (wanted + below * value) / pivot
            x0, y0, z0, u0, v0, w0, a0, b0, c0 = x1, y1, z1, u1, v1, w1, a1, b1, c1
            last_x, last_y, last_z, inner_mass = x, y, z, mass

        # From the tip to the anchor: each rod pulls its outer end inwards, and its inner end out.
        total = Vector3()
        pull, outer_x, outer_y, outer_z = value, 0.0, 0.0, 0.0
        for particle, (fx, fy, fz), x, y, z, factor, value in reversed(rows):
            x *= pull
            y *= pull
            z *= pull
            total.x, total.y, total.z = fx + outer_x - x, fy + outer_y - y, fz + outer_z - z
            particle.add_force(total)
            outer_x, outer_y, outer_z = x, y, z
            pull = value + factor * pull
