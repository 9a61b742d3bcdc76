"""What chapters 2 to 4 say to a student who has made a mistake: they name that mistake.

That every wrong submission loses its checks is in test_proofs.py.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from autograder.manifest import ROOT, load_chapters
from warm import run_checks_warm
from wrong import read_wrong, write_wrong

CHAPTERS = {chapter.number: chapter for chapter in load_chapters()}

LISTINGS_RING = "the listing's ring: new ones overwrite from the front, whatever the policy (E-20)"
# The words of the message, by chapter, by the body and by the mistake of it as in wrong.toml.
NAMED: dict[int, dict[str, dict[str, str]]] = {
    2: {
        "vector.Vector3.copy": {"copy returns the vector itself": "one and the same vector"},
        "vector.Vector3.clear": {
            "only the name self gets another vector": "self = Vector3() does not reach v"
        },
        "vector.Vector3.invert": {
            "the listing as printed: x is set from z (E-14)": "the book's listing is wrong here",
            "the inverted vector is returned, and v stays": "v is as it was",
        },
        "vector.Vector3.__neg__": {
            "minus v turns v itself round": "invert is the one that changes v"
        },
        "vector.Vector3.magnitude": {
            "the root is forgotten": "its root is missing",
            "z is forgotten in the length": "the length without z",
        },
        "vector.Vector3.squared_magnitude": {
            "the squared length is the length": "that is the length itself"
        },
        "vector.Vector3.__mul__": {"v * 2 changes v": "*= is the one that changes v"},
        "vector.Vector3.__imul__": {
            "v *= 2 makes a new vector": "are two now",
            "v *= w is let through": "it could be dot, cross or component_product",
        },
        "vector.Vector3.normalize": {
            "the length changes while it is divided by": "worked out again after x had changed",
            "short vectors are taken for zero": "taken for zero",
        },
        "vector.Vector3.normalized": {
            "normalized changes v itself": "normalize is the one that changes v"
        },
        "vector.Vector3.__iadd__": {"v += w makes a new vector": "a new vector leaves w behind"},
        "vector.Vector3.__isub__": {"a plus is left in -=": "that is v + other"},
        "vector.Vector3.__sub__": {"the difference the wrong way round": "that is w - v"},
        "vector.Vector3.add_scaled": {
            "the vector itself is scaled, not the argument": "v was multiplied, and w was not",
            "the number is forgotten": "without the number",
        },
        "vector.Vector3.component_product": {
            "the component product returns the scalar product": "that is the scalar product",
            "the components are added": "that is v + w",
        },
        "vector.Vector3.dot": {
            "the cosine of the angle in place of the product": "that is the cosine",
            "z is forgotten in the scalar product": "of the z components is missing",
        },
        "vector.Vector3.cross": {
            "the sign of the middle component": "the two terms of y",
            "b x a in place of a x b": "that is b x a",
        },
        "vector.Vector3.cross_update": {
            "the update reads what it has written": "made from the new x"
        },
        "vector.make_orthonormal_basis": {
            "b stays as it is, so nothing is at right angles to it but c": "vector 2 is b itself",
            "the third is as long as the sine of the angle": "as long as the sine",
            "the limit for parallel vectors is far too wide": "these are not parallel",
        },
        "exercises.split": {
            "the pair is the other way round": "the other way round",
            "the vector itself in place of its direction": "that is v itself",
        },
        "exercises.scalar_product_and_angle": {
            "the cosine in place of the product": "that is the cosine"
        },
        "exercises.make_perpendicular": {
            "the sign is lost when the equation is solved": "the sign was lost",
            "nothing is divided by a.z": "divide by a.z",
        },
        "exercises.angle_by_scalar_product": {
            "in degrees": "that is in degrees",
            "the sign of the product is lost": "the sign of a . b is lost",
        },
        "exercises.angles_by_vector_product": {
            "the printed form for unit vectors, used for any vectors (E-15)": "(E-15)",
            "the lengths are not divided out of the vector product": "not yet the sine",
        },
        "exercises.remove_projection": {
            "the projection in place of what is left": "the projection itself",
            "the angle in degrees": "that is in degrees",
            "unit vectors must be exact, which rounding never allows": "not with ==",
        },
        "exercises.position_after": {
            "the velocity is added once, whatever the time": "as if one second had passed",
            "the way alone, without the position": "add it to p",
        },
    },
    3: {
        "particle.Particle.mass.setter": {
            "the mass is kept as it is, and taken for its inverse": "that is the mass"
        },
        "particle.Particle.inverse_mass.setter": {
            "the inverse mass is inverted once more": "that is 1 / inverse mass"
        },
        "particle.Particle.damping": {
            "the damping that is asked for is what is lost": "the share that is lost"
        },
        "particle.Particle.momentum": {
            "the velocity is divided by the mass": "divided by the mass",
            "the length of the momentum, which is a number": "that is its length",
        },
        "damping.damp_per_frame": {
            "the frame's share is raised to the duration as well": "that is Eq. 3.6",
            "a damping of 0 is taken for none": "0 counts as false",
        },
        "damping.damp_per_second": {
            "the share per second is taken in every frame": "that is Eq. 3.5",
            "the acceleration is damped too, as in the listing (E-16)": "(E-16)",
        },
        "particle.Particle.integrate": {
            "the velocity first: semi-implicit Euler (E-17)": "semi-implicit Euler",
            "the velocity is added once a frame, however long that is": "added once a frame",
            "the equation's form: the acceleration is added undamped (E-16)": "that is Eq. 3.6",
            "damping per frame, as in Eq. 3.5": "as in Eq. 3.5",
            "what damping keeps is worked out once and for ever": "d^h of the first frame",
        },
        "exercises.speed_ratio": {
            "acceleration in proportion to the mass, as printed (E-1)": "is wrong (E-1)",
            "the ratio is rounded down": "// rounds down",
        },
        "exercises.gravity_between": {
            "the distance is not squared": "the distance is not squared",
            "the masses are added": "the masses were added",
        },
        "particle.Particle.kinetic_energy": {
            "the half is forgotten": "the half is missing",
            "the inverse mass is taken for the mass": "the inverse mass was taken",
        },
        "exercises.position_by_equation": {
            "the half is forgotten": "the half is missing",
            "the time is not squared": "the time is not squared",
        },
        "exercises.state_by_steps": {
            "one step too few": "a step is missing",
            "the velocity is changed first (E-17)": "with the old one (E-17)",
        },
        "exercises.stepping_error": {
            "exact minus stepped": "that is exact minus stepped",
            "the exact position after one step only": "duration x steps",
        },
        "exercises.random_frames": {
            "two draws are averaged, and crowd about the mean": "too many are near the mean"
        },
        "exercises.damping_difference": {
            "the sum over the runs, not the mean": "the sum over the runs",
            "the difference of the speeds, not of the velocities": "the difference of the speeds",
        },
    },
    4: {
        "scaling.muzzle_energy": {
            "the printed energy, without the half (E-18)": "leaves out the half (E-18)"
        },
        "scaling.slowed_mass": {
            "the mass grows by the factor, which keeps the momentum and not the energy": "momentum",
            "the factor divides the other way, as in the book's footnote (E-19)": "(E-19)",
        },
        "scaling.slowed_gravity": {
            "the printed gravity, divided by the factor once (E-2)": "divides once (E-2)",
            "a gravity that points down is refused": "a gravity may be negative",
        },
        "ballistics.aim": {
            "the azimuth is measured from X": "measured from Z, not from X",
            "the angles are taken for degrees": "in radians already",
        },
        "ballistics.BallisticRange.fire": {
            "the speed is the velocity along Z": "not its Z alone",
            "without an elevation the shot is level": "the shot is not level",
        },
        "ballistics.is_spent": {
            "the range ends at 100 m, as in the book's text (E-34)": "not at 100 m (E-34)"
        },
        "ballistics.BallisticRange.update": {"the age counts frames": "the number of frames"},
        "grenade.bounce": {
            "nothing slides": "SLIDE is 0.8",
            "it still falls after the bounce": "it still falls",
        },
        "grenade.fragments": {
            "the fragments forget the velocity of the grenade": "the velocity of the grenade"
        },
        "targets.hit_fraction": {"the sizes are taken for halves": "whole sides"},
        "targets.strike_first": {
            "the velocity is replaced": "the velocity was replaced",
            "the block gets the velocity of the shot, whatever the masses": "the shot's whole",
        },
        "fireworks.FireworksShow.light": {LISTINGS_RING: "as in the book's listing"},
        "fireworks.FireworksShow.update": {"payloads have no parent": "as without a parent"},
        "catherine_wheel.CatherineWheel.nozzle": {
            "the speed of the rim is the rate": "that is the rate"
        },
        "catherine_wheel.CatherineWheel.update": {"one spark a frame": "one spark a frame"},
        "closed_form.drag_factors": {
            "the drag is 1 - d": "k was taken for 1 - d",
            "a damping near 1 counts as 1": "near 1 was taken for 1",
        },
        "closed_form.state_after": {
            "the particle itself is moved": "has moved the particle itself"
        },
        "closed_form.burst_positions": {"damping is left out": "damping was left out"},
        "screen_rotation.screen_angle": {"from 0 to a whole turn": "from 0 to 2 pi"},
        "screen_rotation.screen_corners": {
            "the size is taken for half a side": "the size is a whole side"
        },
        "display.click": {"the fuse is looked at after it is set to 0": "before it is set to 0"},
    },
}
ROWS = [
    pytest.param(number, edit, mistake, words, id=f"{edit}: {mistake}")
    for number, edits in NAMED.items()
    for edit, mistakes in edits.items()
    for mistake, words in mistakes.items()
]


@pytest.mark.parametrize(("number", "edit", "mistake", "words"), ROWS)
def test_the_first_failure_names_the_mistake(
    number: int, edit: str, mistake: str, words: str, tmp_path: Path
) -> None:
    chapter = CHAPTERS[number]
    (wrong,) = (w for w in read_wrong(chapter) if (w.edit, w.mistake) == (edit, mistake))
    (exercise,) = (e for e in chapter.exercises if edit in e.edit)
    write_wrong(chapter, [wrong], tmp_path)
    engine = [tmp_path, ROOT / "solutions", ROOT / "chapters"]
    verdicts = run_checks_warm(chapter, engine, seed="1", exercises=[exercise.id])
    first = next(verdict for verdict in verdicts if verdict.status != "passed")
    likely = next(line for line in first.message.splitlines() if line.startswith("likely"))
    assert words in likely
