"""Define five scenes with a single body, in which our engine is compared with pymunk.

They are a projectile, a fall with drag, two orbits, and a block that floats in water.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

from ch02_vectors.vector import Vector3
from ch04_particle_engine.closed_form import state_after
from ch05_forces.closed_form import quadratic_fall
from ch05_forces.forces import Drag, Gravity, InverseSquareGravity
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.integrators import explicit_euler
from ch06_springs.springs import Buoyancy
from scenes.clock import RATE
from scenes.drag_flight import PROJECTILE, make_particle, make_space
from scenes.setup import Setup, alone
from scenes.twin import InSpace
from studies.accuracy.in_plane import in_plane, on_all
from studies.accuracy.in_pymunk import (
    BEST,
    EXAMPLES,
    by_pymunk,
    from_two_runs,
    lone,
    space_with,
)
from studies.accuracy.scene import (
    Model,
    Outcome,
    Place,
    Scene,
    by_formula,
    by_integrators,
    by_setup,
)
from studies.models.exact_frames import oscillation_in_frames, places_in_frames

G = 9.81  # m/s^2


def projectile() -> Scene:
    """Create the scene of a projectile with linear drag.

    Some of its models evaluate a closed form. The others simulate the flight in time steps, and
    treat the drag either as damping or as a force.
    """
    frames = round(PROJECTILE.duration * RATE)
    k1 = -math.log(PROJECTILE.damping)

    def place_at(time: float) -> Place:
        place, _ = state_after(shot, time)
        return place.x, place.y

    def truth(time: float) -> Place:
        return PROJECTILE.exact(time).position[:2]

    def thrown(damping: float) -> Particle:
        start = PROJECTILE.start
        vectors = (start.position, start.velocity, PROJECTILE.acceleration)
        return Particle(*(Vector3(*vector) for vector in vectors), damping=damping)

    def with_damping() -> Setup:
        return alone(thrown(PROJECTILE.damping))

    def with_drag() -> Setup:
        return alone(thrown(1.0), Drag(k1, 0.0))

    def in_space(_: float) -> InSpace:
        return make_space(PROJECTILE)

    def ahead(duration: float) -> InSpace:
        space, (body,) = make_space(PROJECTILE)
        kept = PROJECTILE.damping ** (0.5 * duration)
        gravity = complex(*PROJECTILE.acceleration[:2]) * kept
        start = complex(*body.velocity) * kept + 0.5 * duration * gravity
        space.gravity, body.velocity = (gravity.real, gravity.imag), (start.real, start.imag)
        return space, [body]

    def acceleration(_: complex, velocity: complex) -> complex:
        return complex(*PROJECTILE.acceleration[:2]) - k1 * velocity

    shot = make_particle(PROJECTILE)
    damped = Model(
        "damping in the particle", by_setup(with_damping, explicit_euler, frames), by="the book"
    )

    def in_equal_frames(_: int) -> Outcome:
        return Outcome([*places_in_frames(shot, 1.0 / RATE, frames)], frames)

    start = PROJECTILE.start
    best = by_pymunk(BEST, ahead, frames)
    models = [
        by_formula(place_at, frames),
        Model("exact steps", in_equal_frames, (1,), is_formula=True),
        damped,
        *by_integrators(with_drag, frames),
        *in_plane(
            [complex(*start.position[:2])],
            [complex(*start.velocity[:2])],
            on_all(acceleration),
            frames,
            is_damped=True,
        ),
        by_pymunk(EXAMPLES, in_space, frames),
        best,
        from_two_runs(best),
    ]
    return Scene("projectile with linear drag", frames, 30.0, truth, models)


def quadratic_drag() -> Scene:
    """Create the scene of a body that falls from rest until it almost reaches terminal speed.

    The drag is proportional to the square of the speed. The motion has a closed form.
    """
    frames, k2 = 180, 0.05

    def place_at(time: float) -> Place:
        return 0.0, -quadratic_fall(1.0, G, k2, time)[1]

    def truth(time: float) -> Place:
        u = math.sqrt(G / k2)
        return 0.0, -u * u / G * math.log(math.cosh(G * time / u))

    def in_equal_frames(_: int) -> Outcome:
        """Compute cosh and sinh of each frame from those of the frame before, by addition."""
        turn = math.sqrt(k2 * G) / RATE
        c, s, cosh, sinh = math.cosh(turn), math.sinh(turn), 1.0, 0.0
        places: list[Place] = []
        for _ in range(frames):
            cosh, sinh = cosh * c + sinh * s, sinh * c + cosh * s
            places.append((0.0, -math.log(cosh) / k2))
        return Outcome(places, frames)

    def make() -> Setup:
        return alone(Particle(), Gravity(Vector3(0.0, -G, 0.0)), Drag(0.0, k2))

    def acceleration(_: complex, velocity: complex) -> complex:
        return -1j * G - k2 * abs(velocity) * velocity

    in_space = lone((0.0, 0.0), (0.0, 0.0), acceleration, frames)
    models = [
        by_formula(place_at, frames),
        Model("exact steps", in_equal_frames, (1,), is_formula=True),
        *by_integrators(make, frames),
        *in_plane([0j], [0j], on_all(acceleration), frames, is_damped=True),
        *in_space,
        from_two_runs(in_space[-1]),
    ]
    return Scene("fall with quadratic drag", frames, 30.0, truth, models)


def orbit(e: float, turns: int, period: float) -> Scene:
    """Create the scene of a body on an elliptical orbit with eccentricity ``e``.

    The semi-major axis is 1 m. The body starts at the point nearest to the center of attraction,
    and makes ``turns`` revolutions of ``period`` s each.
    """
    frames = math.floor(turns * period * RATE)
    rate = 2.0 * math.pi / period
    mu, speed = rate * rate, rate * math.sqrt((1.0 + e) / (1.0 - e))

    def truth(time: float) -> Place:
        mean = rate * time  # Kepler's equation M = E - e sin E, by Newton's method
        anomaly = mean + math.copysign(0.85 * e, math.sin(mean))  # Danby's start always converges
        for _ in range(60):
            anomaly -= (anomaly - e * math.sin(anomaly) - mean) / (1.0 - e * math.cos(anomaly))
        return math.cos(anomaly) - e, math.sqrt(1.0 - e * e) * math.sin(anomaly)

    def make() -> Setup:
        start = Particle(Vector3(1.0 - e), Vector3(0.0, speed))
        return alone(start, InverseSquareGravity(Vector3(), mu))

    def acceleration(position: complex, _: complex) -> complex:
        r = abs(position)
        return -mu / (r * r * r) * position

    in_space = lone((1.0 - e, 0.0), (0.0, speed), acceleration, frames)
    models = [
        *by_integrators(make, frames),
        *in_plane([1.0 - e], [1j * speed], on_all(acceleration), frames, is_damped=False),
        *in_space,
        from_two_runs(in_space[-1]),
    ]
    return Scene(f"orbit of eccentricity {e:g}", frames, 1.0, truth, models)


def floating_block() -> Scene:
    """Create the scene of a block that bobs up and down in water.

    The block is always partly submerged, so its buoyancy is proportional to the depth of its lower
    side. It therefore moves like a body on a spring.
    """
    frames, s, volume, mass = 240, 0.05, 0.001, 0.5
    stiffness = 1000.0 * volume * G / (2.0 * s)  # increase of the buoyancy per meter of depth
    low, amplitude = s * (1.0 - 2.0 * mass / (1000.0 * volume)), 0.04

    def place_at(time: float) -> Place:
        return 0.0, low + damped_spring_state(amplitude, 0.0, stiffness, 0.0, mass, time)[0]

    def truth(time: float) -> Place:
        return 0.0, low + amplitude * math.cos(math.sqrt(stiffness / mass) * time)

    def make() -> Setup:
        block = Particle(Vector3(0.0, low + amplitude), mass=mass)
        return alone(block, Gravity(Vector3(0.0, -G, 0.0)), Buoyancy(s, volume, 0.0))

    def acceleration(position: complex, _: complex) -> complex:
        share = min(max((s - position.imag) / (2.0 * s), 0.0), 1.0)
        return 1j * (1000.0 * volume * share / mass - 1.0) * G

    def on_spring(duration: float) -> InSpace:
        """Replace the weight and the buoyancy by a spring, as the block stays partly submerged."""
        import pymunk  # here, because a chapter's plots do not need it

        start = -0.5 * duration * amplitude * stiffness / mass
        space, (body,) = space_with((0.0, low + amplitude), (0.0, start))
        anchor = (0.0, low)
        body.mass = mass
        space.add(
            pymunk.DampedSpring(body, space.static_body, (0.0, 0.0), anchor, 0.0, stiffness, 0.0)
        )
        return space, [body]

    def in_equal_frames(_: int) -> Outcome:
        heights = oscillation_in_frames(amplitude, stiffness / mass, 0.0, 1.0 / RATE, frames)
        return Outcome([(0.0, low + height) for height in heights], frames)

    best = by_pymunk(f"{BEST}, as a spring", on_spring, frames)
    models = [
        by_formula(place_at, frames),
        Model("exact steps", in_equal_frames, (1,), is_formula=True),
        *by_integrators(make, frames),
        *in_plane([1j * (low + amplitude)], [0j], on_all(acceleration), frames, is_damped=False),
        *lone((0.0, low + amplitude), (0.0, 0.0), acceleration, frames),
        best,
        from_two_runs(best),
    ]
    return Scene("floating block", frames, amplitude, truth, models)


# The first orbit resembles a planet's. The second resembles a comet's, and takes only 60 frames.
ORBITS = [partial(orbit, 0.5, 3, 2.0 * math.pi), partial(orbit, 0.9, 1, 1.0)]
FLIGHTS: list[Callable[[], Scene]] = [projectile, quadratic_drag, *ORBITS, floating_block]
