"""Steps: ways to move particles on by a frame. Those of several stages are tables here."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

ApplyForces = Callable[[float], None]
Integrator = Callable[[Sequence[Particle], ApplyForces, float], None]

Row = tuple[float, ...]


class _Stage(NamedTuple):
    """Where to ask for forces: at p + v c h + h^2 sum(p_i a_i), with a velocity v + h sum(v_i a_i).

    The a_i are the accelerations that the stages before it have found.
    """

    c: float
    place: Row
    velocity: Row


class _Table(NamedTuple):
    """A method of Runge, Kutta and Nyström: its stages, and the weights of the a_i at the end."""

    stages: tuple[_Stage, ...]
    place: Row
    velocity: Row


_VERLET = _Table(
    stages=(
        _Stage(0.0, (), ()),
        _Stage(1.0, (1 / 2,), (1.0,)),
    ),
    place=(1 / 2, 0.0),
    velocity=(1 / 2, 1 / 2),
)

# Kutta's table for x' = v, v' = a, with the velocities of the stages put into the places.
_KUTTA = _Table(
    stages=(
        _Stage(0.0, (), ()),
        _Stage(1 / 2, (0.0,), (1 / 2,)),
        _Stage(1 / 2, (1 / 4, 0.0), (0.0, 1 / 2)),
        _Stage(1.0, (0.0, 1 / 2, 0.0), (0.0, 0.0, 1.0)),
    ),
    place=(1 / 6, 1 / 6, 1 / 6, 0.0),
    velocity=(1 / 6, 1 / 3, 1 / 3, 1 / 6),
)


class _Traveller:
    """A particle on its way through a frame: where it began, and the forces met so far."""

    def __init__(self, particle: Particle) -> None:
        self.particle = particle
        self.by_hand = particle.force_accumulator
        self.place = particle.position.copy()
        self.velocity = particle.velocity.copy()
        self.forces: list[Vector3] = []

    def go(self, c: float, place: Row, velocity: Row, duration: float) -> None:
        """Put the particle where a row of a table has it; forget the forces of the last stage."""
        particle = self.particle
        particle.clear_forces()
        particle.add_force(self.by_hand)
        if not particle.inverse_mass:
            return
        new_place, new_velocity = self.place.copy(), self.velocity.copy()
        new_place.add_scaled(self.velocity, c * duration)
        new_place.add_scaled(self._acceleration(place), duration * duration)
        new_velocity.add_scaled(self._acceleration(velocity), duration)
        _set(particle.position, new_place)
        _set(particle.velocity, new_velocity)

    def note(self) -> None:
        """Remember the forces that the particle has been given at this stage."""
        self.forces.append(self.particle.force_accumulator)

    def arrive(self, table: _Table, duration: float) -> None:
        """End the frame: chapter 5's step, by the mean force; but the table says where."""
        self.go(1.0, table.place, (), duration)  # without weights: the velocity of the beginning
        end = self.particle.position.copy()
        self.particle.clear_forces()
        self.particle.add_force(_weighted(table.velocity, self.forces))
        self.particle.integrate(duration)
        _set(self.particle.position, end)

    def _acceleration(self, row: Row) -> Vector3:
        result = _weighted(row, self.forces) * self.particle.inverse_mass
        result.add_scaled(self.particle.acceleration, math.fsum(row))
        return result


def _set(target: Vector3, source: Vector3) -> None:
    target.x, target.y, target.z = source


def _weighted(row: Row, vectors: list[Vector3]) -> Vector3:
    result = Vector3()
    for weight, vector in zip(row, vectors, strict=False):
        result.add_scaled(vector, weight)
    return result


def _travel(
    table: _Table, particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make a step by a table: all go to a stage, and only then are the forces asked for."""
    positive("duration", duration)
    travellers = [_Traveller(particle) for particle in particles]
    for stage in table.stages:
        for one in travellers:
            one.go(*stage, duration)
        apply_forces(duration)
        for one in travellers:
            one.note()
    for one in travellers:
        one.arrive(table, duration)


def explicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        particle.integrate(duration)


def semi_implicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    starts: list[Vector3] = [particle.position.copy() for particle in particles]
    explicit_euler(particles, apply_forces, duration)
    for particle, start in zip(particles, starts, strict=True):
        if particle.inverse_mass:
            start.add_scaled(particle.velocity, duration)
            _set(particle.position, start)


def leapfrog(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    positive("duration", duration)
    middles: list[Vector3] = []
    for particle in particles:
        if particle.inverse_mass:
            particle.position.add_scaled(particle.velocity, 0.5 * duration)
        middles.append(particle.position.copy())
    explicit_euler(particles, apply_forces, duration)
    for particle, middle in zip(particles, middles, strict=True):
        if particle.inverse_mass:
            middle.add_scaled(particle.velocity, 0.5 * duration)
            _set(particle.position, middle)


def velocity_verlet(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    _travel(_VERLET, particles, apply_forces, duration)


def runge_kutta_4(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    _travel(_KUTTA, particles, apply_forces, duration)


def backward_euler(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    return _theta_step(1.0, x, v, stiffness, damping, mass, duration)


def trapezoidal(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    return _theta_step(0.5, x, v, stiffness, damping, mass, duration)


def _theta_step(
    theta: float,
    x: float,
    v: float,
    stiffness: float,
    damping: float,
    mass: float,
    duration: float,
) -> tuple[float, float]:
    """Solve y' = y + (1 - theta) h f(y) + theta h f(y') for the state y = (x, v), by Cramer's rule.

    The second line is multiplied by the mass: x' - q v' = a and q k x' + (m + q c) v' = b.
    """
    x, v = finite("x", x), finite("v", v)
    k, c = not_negative("stiffness", stiffness), not_negative("damping", damping)
    m, h = positive("mass", mass), positive("duration", duration)
    q, rest = theta * h, (1.0 - theta) * h
    a = x + rest * v
    b = m * v - rest * (k * x + c * v)
    heavy = m + q * c
    determinant = heavy + q * q * k
    return (heavy * a + q * b) / determinant, (b - q * k * a) / determinant


class SimulationDiverged(ArithmeticError):  # noqa: N818
    """A particle is faster than anything in its scene should be."""

    def __init__(self, particle: int, step: int, speed: float, limit: float) -> None:
        super().__init__(
            f"particle {particle} has {speed:.4g} m/s after step {step}, over the limit of "
            f"{limit:g} m/s: shorter frames, softer springs or another step would help"
        )
        self.particle, self.step, self.speed, self.limit = particle, step, speed, limit


class _Watch:
    """A step that looks at every speed after the integrator's."""

    def __init__(self, integrator: Integrator, limit: float) -> None:
        self.integrator = integrator
        self.limit = limit
        self.steps = 0

    def __call__(
        self, particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
    ) -> None:
        self.integrator(particles, apply_forces, duration)
        self.steps += 1
        for place, particle in enumerate(particles):
            speed = particle.velocity.magnitude()
            if math.isnan(speed) or speed > self.limit:
                raise SimulationDiverged(place, self.steps, speed, self.limit)


def watched(integrator: Integrator, speed_limit: float) -> Integrator:
    return _Watch(integrator, positive("speed_limit", speed_limit))
