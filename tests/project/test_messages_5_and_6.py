"""Messages of chapters 5 and 6 that name the mistake, where its numbers tell which one it was."""

from __future__ import annotations

from pathlib import Path

import pytest

from autograder.manifest import ROOT, load_chapters
from warm import run_checks_warm
from wrong import read_wrong, write_wrong

CHAPTERS = {chapter.name: chapter for chapter in load_chapters()}
# The body and the mistake as in wrong.toml, and words of the message.
FORCES = (
    (
        "particle.Particle.add_force",
        "the newest force takes the place of the others",
        "the newest force alone",
    ),
    (
        "particle.Particle.add_force",
        "the force is divided by the mass at once",
        "the sum divided by the mass",
    ),
    ("particle.Particle.force_accumulator", "the tuple comes back", "a tuple and not a Vector3"),
    (
        "particle.Particle.integrate",
        "the force is multiplied by the mass",
        "the mass and not its inverse",
    ),
    (
        "particle.Particle.integrate",
        "the velocity moves first, and then the position (E-17)",
        "the velocity from after the step",
    ),
    (
        "particle.Particle.integrate",
        "Eq. 3.6: damped before the acceleration is added (E-16)",
        "which the book's own listing does not do (E-16)",
    ),
    (
        "particle.Particle.last_acceleration",
        "the force is not divided by the mass",
        "a + f, without the mass",
    ),
    (
        "forces.ForceRegistry.add",
        "a list that is searched with ==",
        "looks for an equal one with ==",
    ),
    ("forces.ForceRegistry.add", "what is refused is in it already", "look first, and then append"),
    (
        "forces.ForceRegistry.update_forces",
        "an immovable particle ends the frame",
        "skip it, and go on",
    ),
    (
        "forces.Gravity.update_force",
        "the acceleration is taken as a force",
        "an acceleration and no force yet",
    ),
    (
        "forces.Gravity.update_force",
        "the force is multiplied by the duration, as an impulse",
        "m g times the duration",
    ),
    ("forces.drag_force", "the drag points along the motion", "with the minus forgotten"),
    (
        "forces.drag_force",
        "the direction is not normalised: a power too much",
        "v in the place of its direction",
    ),
    ("forces.Drag.update_force", "the drag is divided by the mass", "the drag divided by the mass"),
    (
        "forces.Uplift.update_force",
        "the column is round the point (0, 0)",
        "the column about (0, 0)",
    ),
    (
        "forces.Uplift.update_force",
        "the distance is not squared back",
        "the square of the distance, compared with the radius",
    ),
    (
        "forces.Airbrake.update_force",
        "linear drag, without a limit",
        "turned round by -k v without a limit",
    ),
    (
        "forces.Airbrake.update_force",
        "the limit is an acceleration",
        "cut off at -v / h, without the mass",
    ),
    (
        "forces.PointGravity.update_force",
        "the direction is not normalised",
        "which is no unit vector",
    ),
    (
        "forces.PointGravity.update_force",
        "towards the origin",
        "towards (0, 0, 0), not towards the center",
    ),
    (
        "forces.InverseSquareGravity.update_force",
        "it weakens with the distance, and not with its square",
        "r for r^2",
    ),
    ("forces.InverseSquareGravity.update_force", "it pushes away", "a push away from the center"),
    ("closed_form.terminal_speed", "the negative root", "the other root"),
    (
        "closed_form.terminal_speed",
        "the 4 below the root is forgotten",
        "below the root, without the 4",
    ),
    ("closed_form.quadratic_fall", "tan for tanh", "a speed with tan"),
    ("closed_form.quadratic_fall", "a logarithm to base 10", "the logarithm to base 10"),
    ("closed_form.coasting_speed", "the linear part alone", "what k1 alone leaves"),
    ("closed_form.drag_limits", "the mass is left out", "without the mass"),
    (
        "closed_form.drag_limits",
        "the derivative of the drag in place of the drag",
        "the slope of the drag",
    ),
    ("sniper.Wind.update_force", "the air is still", "as in still air"),
    (
        "sniper.Wind.update_force",
        "the velocity relative to the particle",
        "w - v, the other way round",
    ),
    (
        "sniper.SniperRange.shoot",
        "azimuth and elevation are exchanged",
        "azimuth and elevation exchanged",
    ),
    (
        "sniper.SniperRange.shoot",
        "the angles are taken for degrees",
        "angles are taken for degrees, and not for radians",
    ),
    (
        "sniper.SniperRange.update",
        "the wind changes in every frame",
        "the wind changes when the shot has landed, and not before",
    ),
    ("sniper.hit_on_the_way", "the factor is left out", "without the target's factor"),
)
SPRINGS = (
    (
        "springs.spring_force",
        "an absolute value, as in the printed listing: a compressed spring pulls (E-3)",
        "the listing's abs(l - l0), with which a compressed spring pulls (E-3)",
    ),
    ("springs.spring_force", "the rest length is left out", "without the rest length"),
    ("springs.spring_force", "damping takes all of the velocity", "damping of all of the velocity"),
    ("springs.Spring.update_force", "the velocity is the particle's own", "p's velocity alone"),
    (
        "springs.Bungee.update_force",
        "pushes what it should pull, as printed (E-4)",
        "as of the printed k (l0 - l) (E-4)",
    ),
    ("springs.Bungee.update_force", "damping may push", "a push by the damping"),
    ("springs.Connection.update_force", "both ends get the same force", "the same force as a's"),
    (
        "springs.Connection.update_force",
        "an absolute value, as in the printed listing (E-3)",
        "with which it pulls (E-3)",
    ),
    ("springs.connect", "it is registered under both ends", "registered under both ends"),
    (
        "springs.Buoyancy.update_force",
        "the sign of the printed formula (E-5)",
        "no lift, as with the printed signs",
    ),
    (
        "springs.Buoyancy.update_force",
        "the printed listing: its signs, no brackets, no g (E-5)",
        "the printed listing, with its signs, / 2 * s and without g (E-5)",
    ),
    (
        "springs.Buoyancy.update_force",
        "the brackets of 2 s are lost (E-5)",
        "as the listing has it without brackets (E-5)",
    ),
    (
        "springs.Buoyancy.update_force",
        "no g, as in the printed listing (E-5)",
        "the listing's lift, which has no g (E-5)",
    ),
    (
        "springs.ElasticLimitSpring.update_force",
        "the share takes all of the extension",
        "the share of all that it is longer than at rest",
    ),
    (
        "springs.ElasticLimitSpring.update_force",
        "a compressed one pulls (E-3)",
        "with which it pulls (E-3)",
    ),
    (
        "springs.LighterThanAir.update_force",
        "the height is not divided by the scale",
        "the height not divided by H",
    ),
    (
        "springs.Overcrowding.update_force",
        "only the first who is too near counts",
        "the search ends at p itself",
    ),
    (
        "springs.HomingBullet.update_force",
        "it forgets that it moves itself",
        "forgets its own velocity",
    ),
    (
        "closed_form.damped_spring_state",
        "only the under-damped case, as printed (E-23)",
        "which the book leaves out (E-23)",
    ),
    ("closed_form.damped_spring_state", "the damping is not halved", "half of it is right"),
    (
        "closed_form.damped_spring_state",
        "the mass does not divide the damping",
        "damping is not divided by the mass",
    ),
    (
        "integrators.explicit_euler",
        "it is the semi-implicit step",
        "a step of semi_implicit_euler",
    ),
    ("integrators.semi_implicit_euler", "it is the book's step", "a step of explicit_euler"),
    (
        "integrators.velocity_verlet",
        "the second evaluation has the old velocity",
        "asks for b with the old velocity",
    ),
    ("integrators.velocity_verlet", "the sum and not the mean", "the sum of the forces"),
    ("integrators.runge_kutta_4", "all weights are one", "whose four rates count the same"),
    ("integrators.backward_euler", "it is explicit Euler", "explicit Euler's step"),
    ("integrators.trapezoidal", "it is backward Euler", "what backward_euler gives"),
    ("integrators.watched", "the first step has the number 0", "the number of the step before"),
    (
        "springs.FakeStiffSpring.update_force",
        "the printed listing: 1 / h * h and v h (E-6)",
        "whose 1 / h * h does not divide by h^2 (E-6)",
    ),
    (
        "springs.FakeStiffSpring.update_force",
        "the printed equation: v and not v / h (E-6)",
        "with v for v / h (E-6)",
    ),
    ("exercises.swings_wider", "the damping is left out", "a particle without damping"),
    ("exercises.largest_stable_stiffness", "the halves are exchanged", "where the search began"),
    (
        "springs.max_stable_stiffness",
        "the equation's form of damping, 1 - d^h (E-16)",
        "right for Eq. 3.6, not for the step (E-16)",
    ),
    ("springs.max_stable_stiffness", "h and not h^2", "with h for h^2"),
    ("penalty.PenaltyGround.update_force", "the ground is always at 0", "a ground at height 0"),
    ("spring_bridge.hang_bridge", "each rope twice", "each spring between two planks twice"),
    ("spring_bridge.load_bridge", "the shares are exchanged", "the shares s and 1 - s exchanged"),
)
ROWS = [("ch05_forces", *row) for row in FORCES] + [("ch06_springs", *row) for row in SPRINGS]


@pytest.mark.parametrize(
    ("name", "edit", "mistake", "words"), ROWS, ids=[f"{row[1]}: {row[2]}" for row in ROWS]
)
def test_a_message_names_the_mistake(
    name: str, edit: str, mistake: str, words: str, tmp_path: Path
) -> None:
    chapter = CHAPTERS[name]
    (wrong,) = (w for w in read_wrong(chapter) if (w.edit, w.mistake) == (edit, mistake))
    (exercise,) = (e.id for e in chapter.exercises if edit in e.edit)
    write_wrong(chapter, [wrong], tmp_path)
    engine = [tmp_path, ROOT / "solutions", ROOT / "chapters"]
    verdicts = run_checks_warm(chapter, engine, seed="1", exercises=[exercise])
    first = next(v for v in verdicts if v.exercise == exercise and v.status == "failed")
    assert words in first.message
