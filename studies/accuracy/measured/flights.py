"""Measure single bodies beside pymunk: a projectile, a fall, orbits and a floating block."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

from ch02_vectors.vector import Vector3
from ch04_particle_engine.closed_form import state_after
from ch05_forces.closed_form import quadratic_fall
from ch05_forces.forces import Drag, Gravity
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.integrators import explicit_euler
from ch06_springs.springs import AnchoredSpring, Buoyancy
from scenes.clock import RATE
from scenes.fall_in_air import G, falling
from scenes.flight import FLIGHT_TIME, PROJECTILE
from scenes.orbit import KeplerOrbit
from scenes.setup import Setup, alone
from scenes.twin import InSpace, twin_of
from studies.accuracy.in_plane import stepped
from studies.accuracy.in_pymunk import BEST, EXAMPLES, by_pymunk, from_two_runs, lone
from studies.accuracy.scene import Model, Place, Scene, by_formula, by_setup, exact_steps
from studies.models.exact_frames import fall_in_frames, oscillation_in_frames, places_in_frames


def projectile() -> Scene:
    """Create the scene of a projectile with linear drag, as damping or as a force."""
    frames = round(FLIGHT_TIME * RATE)
    k1 = -math.log(PROJECTILE.damping)
    gravity = complex(*PROJECTILE.acceleration[:2])

    def place_at(time: float) -> Place:
        place, _ = state_after(shot, time)
        return place.x, place.y

    def truth(time: float) -> Place:
        return PROJECTILE.exact(time).position[:2]

    def with_damping() -> Setup:
        return alone(PROJECTILE.particle(Particle))

    def with_drag() -> Setup:
        body = PROJECTILE.particle(Particle)
        body.damping = 1.0
        return alone(body, Drag(k1, 0.0))

    def ahead(duration: float) -> InSpace:
        space, (body,) = twin_of(with_damping())
        kept = PROJECTILE.damping ** (0.5 * duration)
        start = complex(*body.velocity) * kept + 0.5 * duration * (gravity * kept)
        space.gravity, body.velocity = (0.0, gravity.imag * kept), (start.real, start.imag)
        return space, [body]

    shot = PROJECTILE.particle(Particle)
    damped = by_setup(with_damping, explicit_euler, frames)
    best = by_pymunk(BEST, ahead, frames)
    models = [
        by_formula(place_at, frames),
        exact_steps(lambda: places_in_frames(shot, 1.0 / RATE, frames)),
        Model("damping in the particle", damped, by="the book"),
        *stepped(with_drag, lambda _, velocity: gravity - k1 * velocity, frames, is_damped=True),
        by_pymunk(EXAMPLES, lambda _: twin_of(with_damping()), frames),
        best,
        from_two_runs(best),
    ]
    return Scene("projectile with linear drag", frames, 30.0, truth, models)


def quadratic_drag() -> Scene:
    """Create the scene of a fall with quadratic drag, until almost the terminal speed."""
    frames, k2 = 180, 0.05

    def truth(time: float) -> Place:
        u = math.sqrt(G / k2)
        return 0.0, -u * u / G * math.log(math.cosh(G * time / u))

    def acceleration(_: complex, velocity: complex) -> complex:
        return -1j * G - k2 * abs(velocity) * velocity

    make = partial(falling, [(1.0, 0.0, k2)])
    models = [
        by_formula(lambda time: (0.0, -quadratic_fall(1.0, G, k2, time)[1]), frames),
        exact_steps(partial(fall_in_frames, G, k2, RATE, frames)),
        *stepped(make, acceleration, frames, is_damped=True),
        *lone(make, acceleration, frames),
    ]
    models.append(from_two_runs(models[-1]))
    return Scene("fall with quadratic drag", frames, 30.0, truth, models)


def orbit(e: float, turns: int, period: float) -> Scene:
    """Create the scene of an orbit with eccentricity ``e`` and a semi-major axis of 1 m."""
    frames = math.floor(turns * period * RATE)
    kepler = KeplerOrbit(e, mu=(math.tau / period) ** 2)

    def acceleration(position: complex, _: complex) -> complex:
        r = abs(position)
        return -kepler.mu / (r * r * r) * position

    models = [
        *stepped(kepler.setup, acceleration, frames, is_damped=False),
        *lone(kepler.setup, acceleration, frames),
    ]
    models.append(from_two_runs(models[-1]))
    return Scene(f"orbit of eccentricity {e:g}", frames, 1.0, kepler.exact, models)


def floating_block() -> Scene:
    """Create the scene of a block that bobs in water, partly submerged, as if on a spring."""
    frames, s, volume, mass, amplitude = 240, 0.05, 0.001, 0.5, 0.04
    stiffness = 1000.0 * volume * G / (2.0 * s)  # increase of the buoyancy per meter of depth
    low = s * (1.0 - 2.0 * mass / (1000.0 * volume))

    def place_at(time: float) -> Place:
        return 0.0, low + damped_spring_state(amplitude, 0.0, stiffness, 0.0, mass, time)[0]

    def truth(time: float) -> Place:
        return 0.0, low + amplitude * math.cos(math.sqrt(stiffness / mass) * time)

    def block() -> Particle:
        return Particle(Vector3(0.0, low + amplitude), mass=mass)

    def make() -> Setup:
        return alone(block(), Gravity(Vector3(0.0, -G, 0.0)), Buoyancy(s, volume, 0.0))

    def on_spring(duration: float) -> InSpace:
        spring = AnchoredSpring(Vector3(0.0, low), stiffness, 0.0)
        return twin_of(alone(block(), spring), ahead=duration, iterations=1)

    def acceleration(position: complex, _: complex) -> complex:
        share = min(max((s - position.imag) / (2.0 * s), 0.0), 1.0)
        return 1j * (1000.0 * volume * share / mass - 1.0) * G

    def in_equal_frames() -> list[Place]:
        heights = oscillation_in_frames(amplitude, stiffness / mass, 0.0, 1.0 / RATE, frames)
        return [(0.0, low + height) for height in heights]

    best = by_pymunk(f"{BEST}, as a spring", on_spring, frames)
    models = [
        by_formula(place_at, frames),
        exact_steps(in_equal_frames),
        *stepped(make, acceleration, frames, is_damped=False),
        *lone(make, acceleration, frames),
        best,
        from_two_runs(best),
    ]
    return Scene("floating block", frames, amplitude, truth, models)


# The first orbit resembles a planet's. The second resembles a comet's, and takes only 60 frames.
ORBITS = [partial(orbit, 0.5, 3, 2.0 * math.pi), partial(orbit, 0.9, 1, 1.0)]
FLIGHTS: list[Callable[[], Scene]] = [projectile, quadratic_drag, *ORBITS, floating_block]
