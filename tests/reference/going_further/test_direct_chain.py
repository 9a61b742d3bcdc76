"""A chain compared with the same equations in matrices, and a rope with its closed forms."""

from __future__ import annotations

import math
import random

import numpy
import pytest
from numpy.typing import NDArray

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.going_further.direct_chain import DirectChain
from scenes.hanging_rope import catenary, hang_by_direct_chain, polygon_sag

Array = NDArray[numpy.float64]
H = 1.0 / 240.0  # s


class MatrixChain:
    """The frames of a DirectChain in NumPy, with all pulls from one dense system of equations.

    Row i of ``ends`` is the far end of rod i minus its near end. The anchor is at the origin.
    """

    def __init__(self, bodies: list[Particle]) -> None:
        count = len(bodies)
        self.inverse = numpy.array([[body.inverse_mass] for body in bodies])
        self.damping = numpy.array([[body.damping] for body in bodies])
        self.gravity = numpy.array([[*body.acceleration] for body in bodies])
        self.places = numpy.array([[*body.position] for body in bodies])
        self.velocities = numpy.array([[*body.velocity] for body in bodies])
        self.ends = numpy.eye(count) - numpy.eye(count, k=-1)
        self.lengths = numpy.linalg.norm(self.ends @ self.places, axis=1)
        self.pulls = numpy.zeros(count)

    def step(self, forces: Array, time: float) -> None:
        """Make a frame of H with acceleration for the given time."""
        moving = (self.gravity + forces * self.inverse) * (self.inverse > 0.0)
        kicked = (self.velocities + moving * time) * self.damping**time
        rods = self.ends @ self.places

        def pulled(pulls: Array) -> Array:
            return -time * self.inverse * (self.ends.T @ (pulls[:, None] * rods))

        guess = rods + H * (self.ends @ (kicked + pulled(self.pulls)))
        excess = 0.5 * ((guess**2).sum(axis=1) - self.lengths**2)
        columns = [
            (guess * (H * (self.ends @ pulled(unit)))).sum(axis=1)
            for unit in numpy.eye(len(excess))
        ]
        self.pulls = self.pulls - numpy.linalg.solve(numpy.array(columns).T, excess)
        self.velocities = kicked + pulled(self.pulls)
        self.places = self.places + H * self.velocities


@pytest.mark.parametrize(
    ("count", "held"),
    [(1, False), (3, False), (12, False), (2, True), (12, True)],
)
def test_frames_solve_the_equations_as_numpy_solves_them(count: int, held: bool) -> None:
    draw = random.Random(74)

    def vector(size: float) -> Vector3:
        return Vector3(*(draw.uniform(-size, size) for _ in range(3)))

    bodies, place = [], Vector3()
    for _ in range(count):
        place = place + vector(1.0)
        mass, damping = draw.uniform(0.5, 2.0), draw.uniform(0.5, 1.0)
        bodies.append(Particle(place, vector(0.3), vector(10.0), mass=mass, damping=damping))
    if held:
        bodies[-1].mass, bodies[-1].velocity = math.inf, Vector3()
    chain, matrices = DirectChain(bodies, Vector3()), MatrixChain(bodies)
    for time in (0.5 * H, H, H):
        forces = [vector(5.0) for _ in bodies]
        for body, force in zip(bodies, forces, strict=True):
            body.add_force(force)
        chain.step(H)
        matrices.step(numpy.array([[*force] for force in forces]), time)
        # Roundings of 10 m over H are 4e-13 m/s, and over H^2 they are 1e-10 N/m. Solving for 12
        # rods multiplies them by some tens.
        places = [[*body.position] for body in bodies]
        assert numpy.abs(numpy.array(places) - matrices.places).max() < 1e-12
        velocities = [[*body.velocity] for body in bodies]
        assert numpy.abs(numpy.array(velocities) - matrices.velocities).max() < 1e-10
        wanted = matrices.pulls * matrices.lengths
        assert numpy.abs(numpy.array(chain.tensions) - wanted).max() < 1e-8


def test_an_immovable_end_is_at_rest_whatever_its_velocity_is() -> None:
    """Immovable particles do not move, so the rods must not depend on their velocities."""
    found = []
    for velocity in (Vector3(), Vector3(50.0, 20.0, -10.0)):
        middle = Particle(Vector3(1.0, -1.0), acceleration=Vector3(0.0, -10.0))
        nail = Particle(Vector3(2.0), velocity, mass=math.inf)
        chain = DirectChain([middle, nail], Vector3())
        for _ in range(10):
            chain.step(H)
        assert nail.position == Vector3(2.0)
        assert nail.velocity == velocity
        found.append(([*middle.position], chain.tensions))
    assert found[0] == found[1]


# A rope between two nails


@pytest.mark.parametrize(("span", "sag"), [(2.0, 1.00526652), (2.9, 0.33372648)])
def test_a_catenary_sags_as_the_closed_form_says(span: float, sag: float) -> None:
    """SciPy's brentq solves 2 a sinh(span / 2 a) = 3 m for a."""
    assert -catenary(span, 3.0)(0.5 * span) == pytest.approx(sag, abs=6e-9)  # all known digits
    assert polygon_sag(1000, span, 3.0) == pytest.approx(sag, abs=1e-5)


@pytest.mark.parametrize(
    ("links", "span", "sag", "digits"),
    [  # from SciPy, SLSQP on the angles of the links, accurate to about 1e-7
        (10, 2.0, 1.01189186, 6e-9),
        (100, 2.0, 1.00533125, 6e-9),
        (4, 2.0, 1.0486392289690087, 1e-7),
        (10, 2.9, 0.33538402473344747, 1e-7),
        (2, 2.0, math.sqrt(1.25), 4e-16),  # 1.5^2 - 1
    ],
)
def test_a_polygon_sags_to_the_minimum_of_energy(
    links: int, span: float, sag: float, digits: float
) -> None:
    assert polygon_sag(links, span, 3.0) == pytest.approx(sag, abs=digits)


def test_a_direct_chain_on_two_nails_hangs_as_the_polygon() -> None:
    rope = hang_by_direct_chain(10, 60, 20.0, from_v=True)
    assert rope.sag == pytest.approx(1.01189186, abs=6e-9)  # all known digits
    assert rope.stretch == pytest.approx(0.0, abs=1e-14)  # some roundings of 3 m
