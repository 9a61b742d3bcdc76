"""Going further: a box that rotates freely, with its inertia tensor.

No torque acts on the box, so its angular momentum is constant, but its angular velocity is not.
Like every body, the box has three principal axes, and a moment of inertia about each of them. If
the three moments are different, a rotation about the axis of the largest or the smallest moment is
stable, but a rotation about the third axis is not. After the smallest disturbance the body flips
over again and again, like a book that you throw into the air.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector, positive
from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion

# The principal axes, in the box's own axes.
X, Y, Z = Vector3(1.0), Vector3(0.0, 1.0), Vector3(0.0, 0.0, 1.0)


class FreeBox:
    """A box that rotates about its center. Its sides are parallel to its own X, Y and Z axes.

    At the start the axes of the box are the axes of the world. ``mass`` is in kg, ``sides`` in m
    and ``angular_velocity`` in rad/s.

    The attribute ``orientation`` is a quaternion. ``inertia`` contains the moments of inertia about
    the three principal axes in kg m^2. ``angular_momentum`` is in kg m^2/s, in world axes.

    Raises:
        ValueError: if the mass or a side is not positive and finite, or a component is not finite.
        TypeError: if an argument has the wrong type.
    """

    def __init__(self, mass: float, sides: Vector3, angular_velocity: Vector3) -> None:
        twelfth = positive("mass", mass) / 12.0
        x, y, z = (positive("sides", side) ** 2 for side in finite_vector("sides", sides))
        self.orientation = Quaternion()
        self.inertia = Vector3(twelfth * (y + z), twelfth * (z + x), twelfth * (x + y))
        self.angular_momentum = self.inertia.component_product(
            finite_vector("angular_velocity", angular_velocity)
        )

    def own_velocity(self) -> Vector3:
        """Return the angular velocity in rad/s in the box's own axes.

        Each component is the angular momentum about an axis, divided by the moment of inertia about
        it.
        """
        own = self.orientation.conjugate().rotate(self.angular_momentum)
        moments = self.inertia
        return Vector3(own.x / moments.x, own.y / moments.y, own.z / moments.z)

    def energy(self) -> float:
        """Return the kinetic energy of the rotation in J."""
        spin = self.own_velocity()
        return 0.5 * spin.dot(self.inertia.component_product(spin))

    def step(self, duration: float) -> None:
        """Rotate the box by one time step of ``duration`` s.

        The rotation is split into five rotations, each about one principal axis. Each of the five
        can be computed exactly, because a rotation about a principal axis does not change the
        angular momentum along it. This symmetric splitting is of order 2, and its error in the
        energy stays bounded.

        Raises:
            ValueError: if the duration is not positive and finite.
        """
        half = 0.5 * positive("duration", duration)
        for axis, time in ((X, half), (Y, half), (Z, duration), (Y, half), (X, half)):
            angle = self.own_velocity().dot(axis) * time
            self.orientation *= Quaternion.from_axis_angle(axis, angle)
        self.orientation.normalize()
