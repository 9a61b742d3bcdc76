"""Exercises of the book's chapter 3. None of these functions changes its arguments."""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.vector import Vector3

GRAVITATIONAL_CONSTANT = 6.67428e-11  # N m^2/kg^2


def speed_ratio(first_mass: float, second_mass: float) -> float:
    """Compute the speed of the first particle divided by the speed of the second (exercise 3.1)."""
    raise NotImplementedError("Exercise 3.1: The same force on two masses")


def gravity_between(first_mass: float, second_mass: float, distance: float) -> float:
    """Compute the force in N with which two masses attract each other (exercise 3.2, Eq. 3.3).

    For the gravitational constant G, use the book's value, 6.67428e-11 N m^2/kg^2.
    """
    raise NotImplementedError("Exercise 3.2: Gravity between two people")


def position_by_equation(
    position: Vector3, velocity: Vector3, acceleration: Vector3, time: float
) -> Vector3:
    """Compute the exact position after ``time`` s in m, as a new vector (exercise 3.4a, Eq. 2.9).

    The result is p' = p + v t + a t^2 / 2.
    """
    raise NotImplementedError("Exercise 3.4a: A position by equation")


def state_by_steps(
    position: Vector3, velocity: Vector3, acceleration: Vector3, duration: float, steps: int
) -> tuple[Vector3, Vector3]:
    """Compute position and velocity after ``steps`` equal time steps (exercise 3.4b and c).

    Each step first moves the particle with its old velocity for ``duration`` s, and then updates
    the velocity, as ``Particle.integrate`` does when the damping is 1.
    """
    raise NotImplementedError("Exercise 3.4b: One step, then four more (b and c)")


def stepping_error(
    position: Vector3, velocity: Vector3, acceleration: Vector3, duration: float, steps: int
) -> Vector3:
    """Return the position after the steps minus the exact position, in m (exercise 3.4d)."""
    raise NotImplementedError("Exercise 3.4d: The error of the steps")


def random_frames(mean: float, jitter: float, total: float, seed: int) -> list[float]:
    """Draw random frame durations in s, which are the same for the same ``seed`` (exercise 3.5a).

    Each lies uniformly between mean * (1 - jitter) and mean * (1 + jitter). The last one is
    shortened so that the sum equals ``total``. A rest below 1e-12 of the total is a rounding error,
    so do not make a frame of it.
    """
    raise NotImplementedError("Exercise 3.5a: Frames of random duration")


def damping_difference(
    velocity: Vector3, acceleration: Vector3, damping: float, runs: Sequence[Sequence[float]]
) -> float:
    """Measure in m/s how far apart the book's two damping equations end (exercise 3.5b).

    Each run is a list of step durations in s, in which two particles start with ``velocity``. One
    keeps ``damping`` per second (Eq. 3.6), the other ``damping ** mean`` per step (Eq. 3.5), where
    ``mean`` is the mean duration of all steps of all runs. Return the mean over all runs of the
    length of the difference between their final velocities.
    """
    raise NotImplementedError("Exercise 3.5b: How far apart the two damping equations end")
