"""Going further, G6.1 and G6.2: the ground as a spring, and a bridge held up by springs."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.penalty import PenaltyGround
from ch06_springs.probes import hung_bridge, loaded, places_on, settled_bridge
from draw import Triple, number, positive_number, vector
from expect import expect_between, expect_close, xyz
from unmoved import expect_all_kept

ZERO = Triple((0.0, 0.0, 0.0))
UP = Triple((0.0, 1.0, 0.0))
GROUND = "the docstring of PenaltyGround"
BOTH = "the docstrings of hang_bridge and load_bridge"
HANG = "the docstring of hang_bridge"
LOAD = "the docstring of load_bridge"
BRIDGE = "hang_bridge(registry, planks, height={}, stiffness={}, damping={})"
UPDATE = "; registry.update_forces(0.5)"


@pytest.mark.exercise("G6.1", asks="Push a particle upward if it is below the ground", read=GROUND)
def test_the_ground_pushes_a_particle_out(rng: Random) -> None:
    high, k, depth = positive_number(rng, 0.5, 9.5), positive_number(rng), positive_number(rng)
    f = vector(rng)
    for height in (-high, high):
        with calls("Add an upward push: the stiffness times the depth of p below self.height."):
            p = Particle(Vector3(3.0, height - depth, 5.0), Vector3(7.0, 0.0, 7.0), mass=2.0)
            p.add_force(Vector3(*f))
            PenaltyGround(height=height, stiffness=k).update_force(p, 0.5)
            got = p.force_accumulator
        push = k * depth * UP
        slips = {
            "Your force points down, farther into the ground.": f - push,
            "You measure the depth from a height of 0, but this ground is at self.height.":
                f + k * (depth - height) * UP,
            "You multiply the push by the mass.": f + 2.0 * push,
            "You multiply the push by the duration, which is 0.5 s here, or by a half.":
                f + 0.5 * push,
            "There is no push, although p is below the surface.": f,
        }  # fmt: skip
        expect_close(got, f + push, slips, tolerance=1e-12, unit="N")


@pytest.mark.exercise("G6.1", asks="if it is below the ground", read=GROUND)
def test_there_is_no_force_above_the_ground(rng: Random) -> None:
    high, k, c = number(rng), positive_number(rng), positive_number(rng)
    for height, y, speed, damping, push, cause in (
        (high, high + 0.5, 0.0, c, 0.0,
         "Your ground exerts a force on a particle that is above it. Add a force only if the "
         "particle is below the surface."),
        (high, high + 0.5, -9.0, c, 0.0,
         "The particle is still above the ground, so there must be no damping yet, however fast it "
         "falls. Check the depth before you compute any force."),
        (high, high, -9.0, c, 0.0,
         "You apply damping to a particle that only touches the ground. At a depth of 0, there "
         "must be no force at all."),
        (0.0, -1e-6, 0.0, 0.0, 1e-6 * k,
         "The particle is only slightly below the surface, but the ground must push it up with a "
         "small force. Any depth above 0 counts."),
        (high, high - 1.0, 0.0, c, k,
         "The particle is 1 m below the surface, so the ground must push it up. The depth is "
         "self.height minus the particle's y."),
    ):  # fmt: skip
        with calls(cause):
            p = Particle(Vector3(0.0, y, 0.0), Vector3(0.0, speed, 0.0))
            ground = PenaltyGround(height=height, stiffness=k, damping=damping)
            ground.update_force(p, 0.5)
            got = p.force_accumulator
        # A depth of 1 m is 1e-15 m off at such heights, the others are exact.
        tolerance = 1e-12 if push == k else 1e-13 * push
        expect_close(got, push * UP, tolerance=tolerance, unit="N")


@pytest.mark.exercise("G6.1", asks="Add the force only if it is positive.", read=GROUND)
def test_damping_of_the_ground_never_pulls(rng: Random) -> None:
    k, c, depth = positive_number(rng), positive_number(rng), positive_number(rng)
    push = k * depth
    force = "The force is k depth - c v_y, where k is the stiffness and c the damping."
    none = "You leave out the damping."
    rising = "Your damping has no effect while the particle rises."
    for share, cause in (  # at 1, nothing is left of the push
        (-0.5, "The particle is still sinking, so v_y is negative and the damping adds to the "
         f"push. {force}"),
        (0.5, "The particle is already rising, so v_y is positive and the damping reduces the "
         f"push. {force}"),
        (2.0, "The particle rises so fast that the damping is larger than the push. The ground "
         "can't pull it back, so the force must be 0."),
    ):  # fmt: skip
        v = share * push / c
        with calls(cause):
            p = Particle(Vector3(0.0, -depth, 0.0), Vector3(4.0, v, 4.0), mass=2.0)
            PenaltyGround(height=0.0, stiffness=k, damping=c).update_force(p, 0.5)
        x, y, z = xyz(p.force_accumulator)
        slips = {
            rising if share > 0.0 else none: push * UP,
            "Your damping uses the whole speed of the particle instead of v_y.":
                max(push - c * math.hypot(4.0, v, 4.0), 0.0) * UP,
            "Your damping reduces the push while the particle sinks. Either its sign is wrong, or "
            "you use the size of v_y. The force is k depth - c v_y.":
                max(push * (1.0 + share), 0.0) * UP,
            "Your force pulls the particle down.": push * (1.0 - share) * UP,
        }  # fmt: skip
        if x or z:
            cause = "Your damping also acts along x and z, like friction. Use only v_y."
        wanted = push * max(1.0 - share, 0.0) * UP
        expect_close((x, y, z), wanted, slips, then="; p.force_accumulator", unit="N", cause=cause,
                     tolerance=1e-11)  # fmt: skip


@pytest.mark.exercise(
    "G6.1", asks="that rests on it sinks in by m g / k", read=f"E-36, and {GROUND}"
)
def test_a_body_comes_to_rest_below_the_surface() -> None:
    with calls(
        "It comes to rest where the push equals its weight, at a depth of m g / k, or 5 cm.",
        "p of 2 kg that falls 0.5 m with g = 10 m/s^2 onto PenaltyGround(height=0, stiffness=400, "
        "damping=10); 20 s in steps of 1/240 s; p.position.y",
    ):
        places = places_on("PenaltyGround", (0.0, 400.0, 10.0), 0.5 * UP, 1.0 / 240.0, 4800,
                           mass=2.0, gravity=10.0, velocity_first=True)  # fmt: skip
    heights = [y for _, y, _ in places]
    # By then the swings have died out to e^-50.
    expect_close(heights[-1], -0.05, tolerance=1e-9, unit="m")
    cause = "It hits the ground at 3.2 m/s and must stop within 0.2 m. Check the damping's sign."
    deepest = -0.05 - math.sqrt(0.05**2 + 10.0 * 2.0 / 400.0)  # without damping
    then = ", at its lowest"
    expect_between(min(heights), deepest, 0.6 * deepest, then=then, unit="m", cause=cause)
    with calls("The force is 3 N - 0.5 * 2 N now. Read the attributes in every call."):
        p = Particle(velocity=Vector3(0.0, 2.0, 0.0))
        ground = PenaltyGround(height=0.0, stiffness=400.0)
        ground.height, ground.stiffness, ground.damping = 1.0, 3.0, 0.5
        ground.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, 2.0 * UP, unit="N")


def pull(offset: Triple, k: float, rest: float, c: float = 0.0, velocity: Triple = ZERO) -> Triple:
    """Return the force of a spring on an end, whose position and velocity are relative."""
    d = offset / abs(offset)
    return -(k * (abs(offset) - rest) + c * (velocity @ d)) * d


def draw_places(rng: Random) -> list[Triple]:
    y, z = number(rng), number(rng)
    return [Triple((1.5 * i, y + round(rng.uniform(-0.2, 0.2), 3), z)) for i in range(5)]


@pytest.mark.exercise("G6.2", asks="so it exerts no force at the start", read=HANG)
def test_a_new_bridge_is_at_rest(rng: Random) -> None:
    places = draw_places(rng)
    height, k, _ = numbers = positive_number(rng), positive_number(rng), positive_number(rng)
    cause = "A spring of your new bridge is stretched. As the rest length, use the height for a "
    cause += "hanger and the distance between two planks for the spring that joins them."
    with calls(cause, BRIDGE.format(*numbers)):
        after = settled_bridge(places, numbers)
    expect_all_kept("planks[{}].position", after, places)
    with calls(cause, BRIDGE.format(*numbers) + UPDATE):
        forces = hung_bridge(places, [(place, ZERO) for place in places], numbers)[:-1]
    for i, force in enumerate(forces):
        y = places[i][1]
        above_first = places[0] + height * UP
        slips = {
            "Your hangers have a rest length of 0.": k * height * UP,
            "You swapped the stiffness and the rest length of the hangers. AnchoredSpring takes "
            "the stiffness first.": height * (height - k) * UP,
            "Your anchors are at y = height. Put the anchor of each plank at its own y + height, "
            "straight above it.": k * (-y if height > y else 2.0 * height - y) * UP,
            "You put the anchors of all hangers above planks[0]. Put each anchor straight above "
            "its own plank.": pull(places[i] - above_first, k, height),
        }
        if i == 0:
            first = places[0] - places[1]
            slips |= {
                "The springs between your planks have a rest length of 0.": pull(first, k, 0.0),
                "The springs between your planks have the height as their rest length.":
                    pull(first, k, height),
            }  # fmt: skip
        then = f"; planks[{i}].force_accumulator"
        # Lengths of up to 20 m are 1e-14 m off, times a stiffness of up to 9 N/m.
        expect_close(force, ZERO, slips, then=then, tolerance=1e-12, unit="N")
    with calls(
        "The hanger must pull with 0.5 m times the stiffness. Add one for each plank.",
        BRIDGE.format(*numbers) + " with a single plank; the check lowers it by 0.5 m" + UPDATE,
    ):
        force, _ = hung_bridge(places[:1], [(places[0] - 0.5 * UP, ZERO)], numbers)
    slips = {
        "No hanger pulls on the lowered plank, although it is 0.5 m too low. Add an AnchoredSpring "
        "for each plank to the registry.": ZERO
    }
    then = "; planks[0].force_accumulator"
    expect_close(force, 0.5 * k * UP, slips, then=then, tolerance=1e-11, unit="N")


@pytest.mark.exercise("G6.2", asks="join neighboring planks with springs", read=HANG)
def test_springs_pull_a_moved_plank_back(rng: Random) -> None:
    places = draw_places(rng)
    height, k, c = positive_number(rng, 2.0, 9.0), positive_number(rng), positive_number(rng)
    after = [(place + 0.05 * vector(rng), vector(rng)) for place in places]
    scene = "; the check moves all planks a little and gives them velocities"
    with calls(
        "Hang each plank from an AnchoredSpring straight above it, and connect it to the next.",
        BRIDGE.format(height, k, c) + scene + UPDATE,
    ):
        *forces, alone = hung_bridge(places, after, (height, k, c))

    def joined(i: int, j: int) -> Triple:
        """Return the force on a plank that is joined to another one."""
        (p, v), (q, w) = after[i], after[j]
        return pull(p - q, k, math.dist(places[i], places[j]), c, v - w)

    for i in (0, 1, 3, 4):  # the force on planks[2] does not matter, because it is immovable
        p, v = after[i]
        offset = p - places[i]  # the anchor is straight above the place
        hanger = pull(offset - height * UP, k, height, c, v)
        ropes = sum((joined(i, j) for j in (i - 1, i + 1) if 0 <= j < len(places)), ZERO)
        wanted = hanger + ropes
        slips = {
            "Your hangers pull but never push. Use an AnchoredSpring for each plank instead of an "
            "AnchoredBungee.": ropes,
            "You also connect the last plank to the first one. Connect only planks that are next "
            "to each other.": wanted + (joined(0, -1) if i == 0 else ZERO),
            "Your anchors are below the planks.":
                ropes + pull(offset + height * UP, k, height, c, v),
            "Your hangers have no damping.": ropes + pull(offset - height * UP, k, height),
            "Only your hangers have an effect.": hanger,
            "Your springs between the planks act twice. A single call to connect already makes "
            "the spring act on both planks, so call connect only once per pair.": wanted + ropes,
        }  # fmt: skip
        then = f"; planks[{i}].force_accumulator"
        expect_close(forces[i], wanted, slips, then=then, tolerance=1e-11, unit="N")
    cause = "The other spring in the registry must keep acting. Don't clear the registry."
    then = "; the force of another spring that was in the registry before"
    expect_close(alone, -2.0 * UP, then=then, cause=cause, unit="N")


@pytest.mark.exercise("G6.2", asks="these two carry 1 - s and s of the weight", read=LOAD)
def test_a_walker_is_carried_by_the_planks_beside_him(rng: Random) -> None:
    places = [(-1.5, 0.0, 0.0), (-0.5, 0.5, 0.0), (1.5, 0.0, 1.0)]
    weight = positive_number(rng, 1.0, 900.0)
    clamp = "must carry the whole weight. Clamp x to the range from the first plank to the last."
    for x, shares, cause in (
        (-1.25, (0.75, 0.25, 0.0),
         "The two planks beside the person must carry the fractions 1 - s and s of the weight, so "
         "that the nearer plank carries more, and the other planks nothing."),
        (1.0, (0.0, 0.25, 0.75),
         "The fraction s must go from 0 at one plank to 1 at the next. Divide the person's "
         "distance from the first of these planks by the gap between them, which is 2 m here."),
        (-0.5, (0.0, 1.0, 0.0),
         "The person is exactly on a plank, so this plank must carry the whole weight."),
        (-7.0, (1.0, 0.0, 0.0),
         f"The person is before the first plank, so the first plank {clamp}"),
        (9.0, (0.0, 0.0, 1.0),
         f"The person is beyond the last plank, so the last plank {clamp}"),
        (-1.5, (1.0, 0.0, 0.0),
         "The person is exactly on the first plank, which must carry the whole weight. There is no "
         "plank before it."),
        (1.5, (0.0, 0.0, 1.0),
         "The person is exactly on the last plank, which must carry the whole weight. There is no "
         "plank after it."),
    ):  # fmt: skip
        with calls(
            cause, f"planks at x = -1.5, -0.5 and 1.5; load_bridge(planks, x={x}, weight={weight})"
        ):
            forces = loaded(places, x, weight)
        slips = {
            "You swapped the fractions s and 1 - s.": [(1.0 - u) * (u > 0.0) for u in shares],
            "You give all of the weight to the nearest plank.":
                [float(u == max(shares)) for u in shares],
            "Each of the two planks gets half of the weight.": [0.5 * (u > 0.0) for u in shares],
            "You divide the weight between all planks.": [1.0 / 3.0] * 3,
            "Each of the two planks gets the whole weight.": [float(u > 0.0) for u in shares],
            "Your weight pushes the planks up. Weight points down, so its y component must be "
            "negative.": [-u for u in shares],
            "You multiply the weight by 9.81. It is already a force in N and not a mass in kg, so "
            "use it unchanged.": [9.81 * u for u in shares],
        }  # fmt: skip
        if max(shares) == 1.0:
            slips = {
                "This plank carries the weight twice, once with each of its neighbors. Stop at the "
                "first pair of planks that the person is between.": [2.0 * u for u in shares]
            }
        slips = {slip: [-weight * u for u in wrong] for slip, wrong in slips.items()}
        got, wanted = [y - 2.0 for _, y, _ in forces], [-weight * u for u in shares]
        then = "; the y component of the force that it adds to each plank"
        expect_close(got, wanted, slips, then=then, unit="N", tolerance=1e-12 * weight)
        then = "; the x and z components of all forces in N, which must not change"
        expect_close([part for x, _, z in forces for part in (x, z)], [1.0, 3.0] * 3, then=then)
    with calls(
        "The only plank must carry the whole weight, wherever the person is.",
        f"a single plank at x = -1.5; load_bridge([plank], x=4.0, weight={weight}); the y "
        "component of the force that it adds",
    ):
        ((_, y, _),) = loaded(places[:1], 4.0, weight)
    expect_close(y - 2.0, -weight, tolerance=1e-12 * weight, unit="N")


@pytest.mark.exercise("G6.2", asks="Hang each plank of a bridge from its own spring", read=BOTH)
def test_a_loaded_bridge_sags_under_its_walker() -> None:
    places = [Triple((float(i), 0.0, 0.0)) for i in range(7)]
    with calls(
        "At rest, the total pull of the hangers must equal the weight of planks and person.",
        "7 planks of 2 kg on hang_bridge(registry, planks, height=3, stiffness=200, damping=20); "
        "load_bridge(planks, x=3, weight=100) in every step for 20 s",
    ):
        ends = settled_bridge(places, (3.0, 200.0, 20.0), 2.0, (3.0, 100.0), 1200)
    pulls = [
        pull(end - place - 3.0 * UP, 200.0, 3.0)
        for end, place in zip(map(Triple, ends), places, strict=True)
    ]
    # By then the swings have died out to e^-20 of some 100 N.
    then = "; the total pull of the hangers"
    up = math.fsum(y for _, y, _ in pulls)
    expect_close(up, 7.0 * 2.0 * 10.0 + 100.0, then=then, tolerance=1e-4, unit="N")
    cause = "The bridge must sag equally on both sides of the person. Connect all neighbors."
    sags = [-end[1] for end in ends]
    then = "; how far planks[0], planks[1] and planks[2] sag, compared with the last three planks"
    expect_close(sags[:3], sags[:3:-1], then=then, cause=cause, tolerance=1e-6, unit="m")
    # Without ropes between them 100 N over 200 N/m would be 0.5 m; the ropes share it out.
    cause = "The planks near the person must sag more than those at the ends. Check that "
    cause += "neighboring planks are connected."
    then = "; the sag of the middle plank minus that of the first plank"
    expect_between(sags[3] - sags[0], 0.2, 0.499, then=then, unit="m", cause=cause)
