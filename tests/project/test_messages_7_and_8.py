"""What likely mistakes are told in chapters 7 and 8: the first failure names the mistake."""

from __future__ import annotations

from pathlib import Path

import pytest

from autograder.manifest import ROOT, load_chapters
from warm import run_checks_warm
from wrong import read_wrong, write_wrong

CHAPTERS = {chapter.number: chapter for chapter in load_chapters()}
# By chapter and body: mistakes as wrong.toml has them, each with words that it must be told.
TOLD = {
    (7, "contacts.Contact.separating_velocity"): {
        "the sign is turned round": "the sign is turned round",
        "the velocity of the other is left out": "the velocity of b is left out",
        "the other is always there": "whose other is None",
    },
    (7, "contacts.Contact.velocity_after"): {
        "c v_s without the sign, as the text has it in one place (E-25)": "E-25",
        "the constant acceleration alone, as in the book (E-26)": "E-26",
        "rest is not looked at: it jitters": "makes a resting body jitter",
        "what is built up is taken off before the restitution": "taken off after the restitution",
        "the whole of the acceleration, not its part along the normal": "all of |a|",
    },
    (7, "contacts.Contact.resolve_velocity"): {
        "an impulse added to the velocity, as if it were no momentum (E-24)": "E-24",
        "shared by mass, not by inverse mass": "shared by mass",
        "the other gets it with the same sign": "with the same sign as a",
        "the change is what they part with, without what they close with": "v_s is left out",
    },
    (7, "contacts.Contact.resolve_penetration"): {
        "the penetration stays, as in the listing (E-8)": "E-8",
        "each moves by half": "each moves by half",
        "the normal is scaled in place": "the normal is only read",
        "nothing is returned where nothing is moved": "zero vectors then",
    },
    (7, "contacts.ContactResolver.resolve_velocities"): {
        "the first that closes, not the fastest": "the first that closes was taken",
        "the limit is not looked at": "the limit is 1",
        "what is deep is resolved as well, as in the listing": "the listing resolves what is deep",
    },
    (7, "contacts.ContactResolver.resolve_penetrations"): {
        "other contacts are not changed, as in the listing (E-8)": "E-8",
        "what moves out gets deeper": "the sign: the other contact",
        "the contact itself is changed twice": "changed once more",
        "the side of the other is left out": "the middle ball is its other",
    },
    (7, "links.Cable.contacts"): {
        "the normal leads away from the other end": "the normal is turned round",
        "the penetration is the whole length": "how far apart the ends are",
        "the place of an end is changed": "-= changes an end",
    },
    (7, "links.AnchoredCable.contacts"): {
        "the anchor is changed": "-= changes an end",
    },
    (7, "links.Rod.contacts"): {
        "two contacts, as the text has it (E-9)": "E-9",
        "a penetration that is negative where it is too short": "the sign is turned round",
        "normalized() of ends at one place": "direction_of gives it",
    },
    (7, "links.Limits.contacts"): {
        "the upper limit is left out": "too long it is a cable of max_length",
        "the normal does not push": "the normal is turned round",
        "restitution 0, as for a rod": "the restitution of its link",
    },
    (7, "detectors.GroundPlane.contacts"): {
        "the radius is left out": "the radius is left out",
        "the radius on the wrong side": "on the wrong side",
        "the normal points down": "the normal is turned round",
    },
    (7, "detectors.ParticlePairs.contacts"): {
        "each pair twice": "a pair is found twice",
        "distances are compared squared, depths too": "those are squares",
        "cells are cut off towards 0": "int cuts off towards 0",
    },
    (7, "detectors.time_to_close"): {
        "a t^2, without its half": "has a half",
        "the other solution of the equation": "the later one",
    },
    (7, "detectors.GroundPlane.next_impact"): {
        "the radius is left out": "the radius is left out",
        "the constant acceleration alone": "last_acceleration, forces and all",
    },
    (7, "detectors.ParticlePairs.next_impact"): {
        "one radius in place of two": "for one radius",
        "the later solution: where they part": "the second solution",
        "the normal leads to the second one": "the normal is turned round",
    },
    (7, "time_division.time_division_step"): {
        "one impact a frame": "ask again",
        "the frame begins anew after each impact": "the whole frame is asked for again",
        "the square of the time is left out": "the term with t^2 is left out",
        "the time that is left is told": "what is left of the frame",
    },
    (7, "exercises.restitution_of_drop"): {
        "without the root, as printed (E-10)": "the root is left out, as the book prints it (E-10)",
        "any bounce is taken": "higher than it was dropped from",
    },
    (7, "exercises.table_of_drops"): {
        "the standard deviation in place of the error": "that is s itself",
        "the root of the mean": "the root of the mean",
    },
    (7, "exercises.top_ball_speed"): {
        "masses the wrong way round": "the masses are exchanged",
        "the speed of falling is left out": "it falls with v before",
        "the gravity is always 10": "that is for 10 m/s^2",
    },
    (7, "exercises.force_for_frame"): {
        "the impulse, not the force": "that is the impulse, in N s",
        "upside down: a shorter push is a stronger one": "upside down",
        "the force is changed in place": "*= works in place",
    },
    (7, "links.TwoSidedRod.contacts"): {
        "both pull": "the normal is turned round",
        "both penetrations are positive": "the sign is turned round",
    },
    (8, "world.mechanical_energy"): {
        "the kinetic part alone": "kinetic energy alone",
        "the sign of the other part is turned round": "sign of the second part",
        "the half of the kinetic energy is left out": "the half of m v^2 / 2",
    },
    (8, "world.ParticleWorld.run_physics"): {
        "forces are added before the integrator asks for them": "count twice",
        "the accumulators are cleared first": "run_physics does not clear",
        "each particle steps by itself: the integrator is not used": "that is an explicit step",
    },
    (8, "world.ParticleWorld.contacts"): {
        "at most twenty contacts, as in the book's world": "the book's world has a maximum",
        "the generators from last to first": "in the order of contact_generators",
        "a list of lists": "one list of contacts, got lists in a list",
    },
    (8, "fixed_step.FixedStep.advance"): {
        "one step a call": "one step only",
        "what is left is forgotten": "what is left over is lost",
        "dropped is how many steps, not how much time": "a time in s, and not a number of steps",
    },
    (8, "bridge.links_of"): {
        "cables cross from side to side": "(1, 2) is no such link",
        "rods where cables should be": "they are cables, and no rods",
    },
    (8, "bridge.Deck.nearest"): {
        "only the near end of a row, not its middle": "from one end of each row",
        "the row before the ball, not the nearest": "the row before the ball",
        "beyond the rows the line goes on": "the deck is level",
    },
    (8, "bridge.Deck.contacts"): {
        "the plank is the particle": "they are exchanged",
        "the penetration is shared by the two ends": "the depth is not shared",
    },
    (8, "tilting_platform.rods_of"): {
        "the lengths of PLACES, wherever the particles are": "the distance in PLACES",
    },
    (8, "tilting_platform.balancing_mass"): {
        "the sign is left out": "the sign",
        "distances without a side": "places have a side",
    },
    (8, "tilting_platform.TiltingPlatform.put_weight"): {
        "the shares of the ends are exchanged": "the ends are exchanged",
        "each particle bears the whole share": "half of it for each",
    },
    (8, "tilting_platform.TiltingPlatform.free_pivot"): {
        "only one of them is free": "both of them",
        "the other rods are thrown away": "they allow this",
    },
    (8, "blob.Bond.update_force"): {
        "the two springs are exchanged": "no force at all",
        "it breaks a frame late": "in this very frame",
    },
    (8, "blob.spread"): {
        "without the root": "its root is left out",
        "from the origin": "from the origin",
        "the mean of the distances": "the mean of the distances",
    },
    (8, "cube.fewest_rods"): {
        "three for each particle": "a rigid body keeps six",
        "as many as for a flat figure": "a flat figure",
    },
    (8, "wheel.rods_of"): {
        "the rim is not closed": "(1, 3) is missing",
    },
    (8, "wheel.RimDrive.update_force"): {
        "along the spoke": "along the spoke",
        "larger further out": "grows with the distance",
    },
    (8, "wheel.spin"): {
        "clockwise is positive": "counter-clockwise is positive",
        "masses do not count": "the masses are left out",
    },
    (8, "wheel.deformation"): {
        "in m, not as a share": "that is in m",
        "too short is no deformation": "take abs()",
    },
    (8, "ball_game.Rules.landed"): {
        "a row counts each time": "look whether it is in visited",
        "the bonus once, not for each life": "for each life that is left, not once",
    },
    (8, "ball_game.BallGame.step"): {
        "PUSH is taken for a force": "PUSH is in m/s^2",
        "the push is forgotten: it comes before the frame starts": "after start_frame",
    },
    (8, "trebuchet.Trebuchet.lets_go"): {
        "radians against degrees": "math.atan2 gives radians",
    },
    (8, "trebuchet.Trebuchet.throw"): {
        "the range from where it was let go": "its x is left out",
        "the share without the kinetic energy": "the kinetic energy of the projectile is left out",
    },
    (8, "trebuchet.my_design"): {
        "a tuple": "my_design must return a Design",
    },
    (8, "sleeping.SleepingWorld.fall_asleep"): {
        "one slow frame is enough": "one slow frame is not enough",
    },
    (8, "sleeping.SleepingWorld.wake_moved"): {
        "a force is not seen": "another force wakes it",
    },
    (8, "sleeping.SleepingWorld.wake_pushed"): {
        "what wakes has its forces twice": "the forces count twice",
    },
}
ROWS = [(*body, mistake, words) for body, told in TOLD.items() for mistake, words in told.items()]


@pytest.mark.parametrize(
    ("number", "edit", "mistake", "words"), ROWS, ids=[f"{row[1]}: {row[2]}" for row in ROWS]
)
def test_the_first_failure_names_the_mistake(
    number: int, edit: str, mistake: str, words: str, tmp_path: Path
) -> None:
    chapter = CHAPTERS[number]
    (wrong,) = (w for w in read_wrong(chapter) if (w.edit, w.mistake) == (edit, mistake))
    write_wrong(chapter, [wrong], tmp_path)
    (exercise,) = (e.id for e in chapter.exercises if edit in e.edit)
    engine = [tmp_path, ROOT / "solutions", ROOT / "chapters"]
    verdicts = run_checks_warm(chapter, engine, seed="1", exercises=[exercise])
    first = next(v for v in verdicts if v.exercise == exercise and v.status == "failed")
    assert words in first.message
