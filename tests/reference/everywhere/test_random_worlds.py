"""Laws of physics in worlds drawn at random, with up to 50 particles.

WORLDS=2000 in the environment draws so many for each law, in place of 40.
"""

from __future__ import annotations

import ast
import math
import os
import shutil
import subprocess
from collections.abc import Iterable
from itertools import pairwise
from random import Random

import pytest

from autograder.manifest import ROOT
from ch02_vectors.vector import Vector3
from ch06_springs.integrators import leapfrog, velocity_verlet
from random_worlds import STEP, Triple, draw, places_after, some_ends, triple

QUICK = 5  # worlds for each law
SEEDS = [
    pytest.param(seed, marks=[pytest.mark.slow] if seed >= QUICK else [])
    for seed in range(int(os.environ.get("WORLDS", "40")))
]
STEPS = 20


def total(vectors: Iterable[Vector3]) -> Triple:
    return triple(sum(vectors, Vector3()))


@pytest.mark.parametrize("seed", SEEDS)
def test_momentum_is_kept_and_the_center_of_mass_goes_straight(seed: int) -> None:
    plan = draw(seed, springs=True, contacts=True)
    world = plan.build()
    mass = math.fsum(plan.masses)
    before = total(p.momentum() for p in world.particles)
    start = total(p.position * (p.mass / mass) for p in world.particles)
    for _ in range(STEPS):
        world.step(STEP)
    # Rounding of 50 particles in 20 steps, with speeds of about 3 m/s and at most 10 kg.
    assert total(p.momentum() for p in world.particles) == pytest.approx(before, abs=1e-10)
    straight = [x + p / mass * STEPS * STEP for x, p in zip(start, before, strict=True)]
    center = total(p.position * (p.mass / mass) for p in world.particles)
    assert center == pytest.approx(straight, abs=1e-11)


@pytest.mark.parametrize("seed", SEEDS)
def test_springs_keep_angular_momentum(seed: int) -> None:
    """Central forces have no torque, and semi-implicit Euler keeps that exactly."""
    world, spins = draw(seed, springs=True).build(), []
    for _ in range(STEPS + 1):
        spins.append(total(p.position.cross(p.momentum()) for p in world.particles))
        world.step(STEP)
    assert spins[-1] == pytest.approx(spins[0], abs=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_contacts_rods_and_cables_never_add_kinetic_energy(seed: int) -> None:
    world, energies = draw(seed, contacts=True).build(), []
    for _ in range(STEPS + 1):
        energies.append(math.fsum(p.kinetic_energy() for p in world.particles))
        world.step(STEP)
    assert all(after <= energy * (1.0 + 1e-12) for energy, after in pairwise(energies))


@pytest.mark.parametrize("axis", ["x", "z"])
@pytest.mark.parametrize("seed", SEEDS[::2])
def test_a_mirrored_world_has_the_mirrored_course(seed: int, axis: str) -> None:
    """Mirroring changes signs only, so even the rounding is the same."""

    def mirrored(v: Triple) -> Triple:
        return (-v[0], v[1], v[2]) if axis == "x" else (v[0], v[1], -v[2])

    plan = draw(seed, springs=True, contacts=True, falls=True)
    expected = [mirrored(place) for place in places_after(plan.build(), STEPS)]
    assert places_after(plan.moved(mirrored).build(), STEPS) == expected


@pytest.mark.parametrize("seed", SEEDS)
def test_a_rotated_world_has_the_rotated_course(seed: int) -> None:
    rng = Random(seed)
    axis = Vector3(rng.gauss(0, 1), rng.gauss(0, 1), rng.gauss(0, 1)).normalized()
    angle = rng.uniform(0.0, math.tau)

    def rotated(v: Triple) -> Triple:
        """Rotate by Rodrigues' formula."""
        vector = Vector3(*v)
        along = axis * axis.dot(vector)
        across = (vector - along) * math.cos(angle) + axis.cross(vector) * math.sin(angle)
        return triple(along + across)

    plan = draw(seed, springs=True)
    expected = [rotated(place) for place in places_after(plan.build(), STEPS)]
    got = places_after(plan.moved(rotated).build(), STEPS)
    for one, other in zip(got, expected, strict=True):
        assert one == pytest.approx(other, abs=1e-9)


@pytest.mark.parametrize("integrator", [leapfrog, velocity_verlet])
@pytest.mark.parametrize("seed", SEEDS[::2])
def test_a_symmetric_step_can_be_run_backward(seed: int, integrator: object) -> None:
    plan = draw(seed, springs=True)
    world = plan.build(integrator)
    for _ in range(STEPS):
        world.step(STEP)
    for particle in world.particles:
        particle.velocity = particle.velocity * -1.0
    for got, start in zip(places_after(world, STEPS), plan.places, strict=True):
        assert got == pytest.approx(start, abs=1e-9)


@pytest.mark.parametrize("version", ["3.12", "3.13"])
def test_other_versions_of_python_have_the_same_numbers(version: str) -> None:
    python = shutil.which(f"python{version}")
    if (
        python is None
        or subprocess.run([python, "-V"], capture_output=True, check=False).returncode
    ):
        pytest.skip(f"Python {version} is not installed here")
    count = 10
    paths = os.pathsep.join(str(ROOT / name) for name in ("solutions", "chapters"))
    done = subprocess.run(
        [python, str(ROOT / "tests/helpers/random_worlds.py"), str(count)],
        env={**os.environ, "PYTHONPATH": paths},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 0, done.stderr
    for one, other in zip(ast.literal_eval(done.stdout), some_ends(count), strict=True):
        for place, wanted in zip(one, other, strict=True):
            assert place == pytest.approx(wanted, abs=1e-9)
