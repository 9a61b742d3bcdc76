"""Functions that solve the exercises of the book's chapter 3.

The solution of exercise 3.3 is in particle.py, as the method ``Particle.kinetic_energy``. None of
these functions changes its arguments.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.vector import Vector3

GRAVITATIONAL_CONSTANT = 6.67428e-11  # N m^2/kg^2


def speed_ratio(first_mass: float, second_mass: float) -> float:
    """Compute the ratio of the speeds that the same force gives to two particles.

    Both particles start at rest, and then the same force acts on both for the same time. The result
    is the speed of the first particle divided by the speed of the second. The masses are in kg.

    Exercise 3.1.

    >>> speed_ratio(3.0, 1.5)
    0.5
    """
    raise NotImplementedError("Exercise 3.1: The same force on two masses")


def gravity_between(first_mass: float, second_mass: float, distance: float) -> float:
    """Compute the force in N with which two masses attract each other.

    The masses are in kg and the distance is in m. For the gravitational constant G, use the book's
    value, 6.67428e-11 N m^2/kg^2.

    Exercise 3.2, Eq. 3.3.

    >>> force = gravity_between(100.0, 100.0, 1.0)
    >>> f"{force:.6g}"
    '6.67428e-07'
    """
    raise NotImplementedError("Exercise 3.2: Gravity between two people")


def position_by_equation(
    position: Vector3, velocity: Vector3, acceleration: Vector3, time: float
) -> Vector3:
    """Compute a particle's position after ``time`` s of constant acceleration, without time steps.

    The result is p' = p + v t + a t^2 / 2 in m, as a new vector. It is exact, so you can use it to
    measure the error of a simulation that makes time steps. The examples for exercise 3.4 use a
    different start position and acceleration than the book.

    Exercise 3.4a, Eq. 2.9.

    >>> position_by_equation(Vector3(2, 5, -1), Vector3(1, -1, 2), Vector3(-2, 1, 0.5), 5)
    Vector3(-18.0, 12.5, 15.25)
    """
    raise NotImplementedError("Exercise 3.4a: A position by equation")


def state_by_steps(
    position: Vector3, velocity: Vector3, acceleration: Vector3, duration: float, steps: int
) -> tuple[Vector3, Vector3]:
    """Compute the position and the velocity of a particle after ``steps`` equal time steps.

    Each step first moves the particle with its old velocity (Eq. 2.7) and then updates the velocity
    (Eq. 2.8), as ``Particle.integrate`` does when the damping is 1. ``duration`` is the duration of
    one step in s. Both results are new vectors.

    Exercise 3.4b and c.

    >>> p, v, a = Vector3(2, 5, -1), Vector3(1, -1, 2), Vector3(-2, 1, 0.5)
    >>> state_by_steps(p, v, a, 1, steps=1)
    (Vector3(3.0, 4.0, 1.0), Vector3(-1.0, 0.0, 2.5))
    >>> state_by_steps(p, v, a, 1, steps=5)
    (Vector3(-13.0, 10.0, 14.0), Vector3(-9.0, 4.0, 4.5))
    """
    raise NotImplementedError("Exercise 3.4b: One step, then four more (b and c)")


def stepping_error(
    position: Vector3, velocity: Vector3, acceleration: Vector3, duration: float, steps: int
) -> Vector3:
    """Measure how far from the exact position a particle ends up when it moves in time steps.

    The result is the position after the steps minus the exact position, in m, as a new vector. The
    function takes the same arguments as ``state_by_steps``.

    Exercise 3.4d.

    >>> p, v, a = Vector3(2, 5, -1), Vector3(1, -1, 2), Vector3(-2, 1, 0.5)
    >>> stepping_error(p, v, a, 1, steps=5)
    Vector3(5.0, -2.5, -1.25)
    """
    raise NotImplementedError("Exercise 3.4d: The error of the steps")


def random_frames(mean: float, jitter: float, total: float, seed: int) -> list[float]:
    """Draw random frame durations in s, to imitate a game whose frame rate varies.

    Each duration is drawn uniformly between mean * (1 - jitter) and mean * (1 + jitter). The last
    duration is shortened so that the sum equals ``total``, except for rounding. A rest below 1e-12
    of the total is only a rounding error, so do not make a frame of it. The same ``seed`` gives the
    same durations.

    Exercise 3.5a.

    >>> random_frames(0.25, 0.0, 1.0, seed=7)
    [0.25, 0.25, 0.25, 0.25]
    """
    raise NotImplementedError("Exercise 3.5a: Frames of random duration")


def damping_difference(
    velocity: Vector3, acceleration: Vector3, damping: float, runs: Sequence[Sequence[float]]
) -> float:
    """Measure how much uneven frames separate the book's two damping equations, in m/s.

    Each run is a list of step durations in s. In each run, two particles start with the same
    ``velocity`` in m/s and make the same steps. The first one follows Eq. 3.6 and keeps the
    fraction ``damping`` of its velocity per second. The second one follows Eq. 3.5 and keeps the
    fraction ``damping ** mean`` in every step, where ``mean`` is the mean duration of all steps of
    all runs. So both lose equally much if all steps are equally long. The difference of a run is
    the length of the difference between the final velocities. Return the mean over all runs.

    Exercise 3.5b.

    >>> gravity = Vector3(0, -10, 0)
    >>> damping_difference(Vector3(), gravity, 0.25, [[0.5, 0.5]])
    0.0
    >>> damping_difference(Vector3(), gravity, 0.25, [[0.5, 1.5], [1.0, 1.0]])
    0.3125
    """
    raise NotImplementedError("Exercise 3.5b: How far apart the two damping equations end")
