"""Going further, complete: a box that turns freely, by its inertia tensor.

Nothing acts on it, so its angular momentum stays as it is; its angular velocity does not. A body
has three principal axes, about each of which it has a moment of inertia of its own. Spun about the
axis of the largest or of the smallest it goes on doing so; spun about the one between, it turns
over again and again as soon as anything disturbs it, as a book does that is thrown up.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector, positive
from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion

X, Y, Z = Vector3(1.0), Vector3(0.0, 1.0), Vector3(0.0, 0.0, 1.0)  # its principal axes, to itself


class FreeBox:
    """A box with sides along X, Y and Z of its own, that turns about its middle.

    mass in kg, sides in m, angular_velocity in rad/s. Its axes start as the world's, so that the
    velocity has the same components in both. Attributes: ``orientation``; ``inertia``, the moments
    about the three principal axes in kg m^2; ``angular_momentum`` in kg m^2/s, in axes of the
    world.

    Raises ValueError where a mass or side is not positive and finite, or a component not finite;
    TypeError for what is no number or no Vector3.
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
        """Return the angular velocity in rad/s, in the box's own axes: momentum / moment."""
        own = self.orientation.conjugate().rotate(self.angular_momentum)
        moments = self.inertia
        return Vector3(own.x / moments.x, own.y / moments.y, own.z / moments.z)

    def energy(self) -> float:
        """Return the kinetic energy of the turning, in J."""
        spin = self.own_velocity()
        return 0.5 * spin.dot(self.inertia.component_product(spin))

    def step(self, duration: float) -> None:
        """Turn on by a duration in s. Raises ValueError where it is not positive and finite.

        The turn is split into five about one principal axis each, there and back: a turn about its
        own axis leaves the momentum along that axis as it is, so each of the five is exact. Such a
        splitting is of the second order, and its error in the energy stays small for ever.
        """
        half = 0.5 * positive("duration", duration)
        for axis, time in ((X, half), (Y, half), (Z, duration), (Y, half), (X, half)):
            angle = self.own_velocity().dot(axis) * time
            self.orientation *= Quaternion.from_axis_angle(axis, angle)
        self.orientation.normalize()
