"""What is told of likely mistakes in chapter 9: the first message names the mistake."""

from __future__ import annotations

from pathlib import Path

import pytest

from autograder.manifest import ROOT, load_chapters
from warm import run_checks_warm
from wrong import read_wrong, write_wrong

(CHAPTER,) = (chapter for chapter in load_chapters() if chapter.number == 9)
WRONG = {(wrong.edit, wrong.mistake): wrong for wrong in read_wrong(CHAPTER)}
# What is changed, the mistake as in wrong.toml, and words that name it.
TOLD = (
    ("plane.wrap_angle", "from 0 to 2 pi", "this is an angle from 0 to 2 pi"),
    ("plane.wrap_angle", "one turn is taken off at the most", "one turn taken off, and no more"),
    ("plane.angle_to_vector", "sine and cosine swapped", "this is sine and cosine swapped"),
    ("plane.angle_to_vector", "the angle taken for degrees", "this is the angle taken for degrees"),
    ("plane.rotate_point", "clockwise", "this is clockwise"),
    ("plane.rotate_point", "moved first, and then turned", "this is moved first, and then turned"),
    ("plane.rotate_point", "y from the new x", "y made from the new x"),
    ("plane.center_of_mass", "the mean of the places", "the mean of the places, whatever"),
    ("plane.center_of_mass", "divided by how many there are", "divided by how many there are"),
    ("plane.center_of_mass", "a dict by mass", "right only if no two masses are equal"),
    ("plane.center_of_mass", "masses are used up", "must not change its lists"),
    (
        "matrix.Matrix3.transform",
        "columns in place of rows: the transpose",
        "each column times the vector, so the transpose",
    ),
    (
        "matrix.Matrix3.transform",
        "the vector itself is changed, while it is read",
        "y and z made from the new x and y",
    ),
    ("matrix.Matrix3.product", "in the other order", "the product in the other order"),
    ("matrix.Matrix3.product", "number by number", "number times number"),
    ("matrix.Matrix3.determinant", "one sign is wrong", "but for one sign, which is - b (d i"),
    ("matrix.Matrix3.determinant", "the product of the diagonal", "of the diagonal alone"),
    ("matrix.Matrix3.inverse", "not divided by the determinant", "not divided by the determinant"),
    ("matrix.Matrix3.inverse", "transposed: the crosses as rows", "rows and columns swapped"),
    ("matrix.Matrix3.inverse", "a mirror is refused", "and not 0: it has an inverse"),
    ("matrix.Matrix3.is_rotation", "exactly", "never whether it is equal"),
    ("matrix.Matrix3.is_rotation", "a mirror is one too", "it is a mirror"),
    ("quaternion.Quaternion.magnitude", "without r", "alone, without r"),
    ("quaternion.Quaternion.magnitude", "the square of it", "without the root"),
    ("quaternion.Quaternion.is_unit", "a NaN is one", "NaN compares false with everything"),
    ("quaternion.Quaternion.normalize", "a new one is returned", "the quaternion as it was"),
    ("quaternion.Quaternion.conjugate", "r alone changes its sign", "the sign of r changed"),
    ("quaternion.Quaternion.__mul__", "in the other order", "the product in the other order"),
    (
        "quaternion.Quaternion.__mul__",
        "written into self while it is read",
        "must not change it",
    ),
    ("quaternion.Quaternion.from_axis_angle", "the whole angle", "made of the whole angle"),
    (
        "quaternion.Quaternion.from_axis_angle",
        "the axis is not normalised",
        "of an axis that is not normalised",
    ),
    (
        "quaternion.Quaternion.from_axis_angle",
        "the angle taken for degrees",
        "made of degrees",
    ),
    ("quaternion.Quaternion.to_axis_angle", "half the angle", "this is half the angle"),
    ("quaternion.Quaternion.to_axis_angle", "the angle up to 2 pi", "the longer way round"),
    ("quaternion.Quaternion.to_axis_angle", "the angle by asin", "asin loses half of the digits"),
    (
        "quaternion.Quaternion.rotate",
        "q* (0, v) q, which turns the other way",
        "this is q* (0, v) q, which turns the other way",
    ),
    ("quaternion.Quaternion.rotate", "q (0, v), from one side", "without q* on the right"),
    ("quaternion.Quaternion.rotate", "r by Pythagoras", "whose r has lost its sign"),
    (
        "quaternion.Quaternion.rotate_by",
        "the listing: q times (0, v) (E-12)",
        "this is the book's listing, q times (0, vector), which is no turn (E-12)",
    ),
    (
        "quaternion.Quaternion.rotate_by",
        "(0, vector) times q (E-12)",
        "this is (0, vector) times q, where (0, vector) is no turn (E-12)",
    ),
    (
        "quaternion.Quaternion.rotate_by",
        "Eq. 9.9, its first order, normalised",
        "only the first order of the turn (E-12)",
    ),
    ("quaternion.Quaternion.rotate_by", "about axes of its own", "the object's own"),
    ("quaternion.Quaternion.add_scaled", "without the half", "without the half of Eq. 9.5"),
    (
        "quaternion.Quaternion.add_scaled",
        "normalised at once (E-31)",
        "this is normalised, which Eq. 9.5 is not, and its length must show (E-31)",
    ),
    (
        "quaternion.Quaternion.add_scaled",
        "each component reads the ones that are changed",
        "read others which are changed already",
    ),
    (
        "matrix.Matrix3.from_quaternion",
        "as it is printed: the transpose (E-11)",
        "this is the matrix as the book prints it, which is the transpose (E-11)",
    ),
    ("matrix.Matrix3.from_quaternion", "one sign is wrong", "all is right but row 2, column 3:"),
    (
        "matrix.Matrix3.from_quaternion",
        "the doubles are missing beside the diagonal",
        "without the factor 2 beside the diagonal",
    ),
    (
        "matrix.Matrix3.to_quaternion",
        "the conjugate, of a transposed matrix",
        "right but for the sign of r, or for those of i, j and k",
    ),
    (
        "matrix.Matrix3.to_quaternion",
        "one branch has a wrong sign",
        "right but for the sign of r, or for those of i, j and k",
    ),
    (
        "matrix.Matrix3.to_quaternion",
        "sizes by four roots, signs lost",
        "the signs, which are lost",
    ),
    ("matrix.Matrix4.transform", "moved first, and then turned", "the point moved first"),
    ("matrix.Matrix4.product", "the translations are added", "where the translations are added"),
    (
        "matrix.Matrix4.determinant",
        "a plus for a minus (E-28)",
        "the book's, whose first product has a plus for a minus (E-28)",
    ),
    ("matrix.Matrix4.inverse", "entry 15 of twelve (E-13)", "reads entry 15 too (E-13)"),
    (
        "matrix.Matrix4.inverse",
        "divided by the determinant as it is printed (E-28)",
        "of the book's determinant, with a plus for a minus (E-28)",
    ),
    (
        "matrix.Matrix4.inverse",
        "the listing reads what it has written (E-30)",
        "where it reads what it has just written (E-30)",
    ),
    (
        "matrix.Matrix4.inverse",
        "the translation only with a minus",
        "what comes of a translation of -p",
    ),
    (
        "matrix.Matrix4.from_orientation_and_position",
        "the position is turned too",
        "where the position is turned too",
    ),
    (
        "matrix.Matrix4.transform_inverse",
        "turned back first, and then moved back",
        "this is turned back first, and then moved back",
    ),
    ("matrix.Matrix4.transform_direction", "moved as a point is", "turned on, and then moved"),
    ("matrix.change_basis", "the other way round: basis^-1 m basis", "this is basis^-1 m basis"),
    ("matrix.change_basis", "turned back by the transpose", "transpose of the basis in place of"),
    ("euler.euler_to_quaternion", "axes that turn with the object", "the product X Y Z"),
    ("euler.rate_map", "rows in place of columns", "the axes as rows"),
    ("euler.euler_rates", "the map itself, not its inverse", "the rate map itself times it"),
    ("euler.euler_rates", "refused a degree away already", "near gimbal lock, and not in it"),
    ("angular.velocity_of_point", "arm x w", "the other way round, (q - p) x w"),
    ("angular.velocity_of_point", "the object is taken to stand still", "without the velocity"),
    ("angular.velocity_of_point", "about the origin of the world", "about the world's origin"),
    ("angular.integrate_rotation", "the orientation first", "a turn by the old w"),
    ("angular.integrate_rotation", "by Eq. 9.5, normalised", "a step of Eq. 9.5, normalised"),
    (
        "angular.integrate_rotation",
        "a new angular velocity, which its owner never sees",
        "another vector may have been made and lost",
    ),
    (
        "angular.first_order_drift",
        "the growth of a step times the steps",
        "adding up the growth of the steps",
    ),
    (
        "angular.first_order_drift",
        "the whole angle in place of its half",
        "w h in place of w h / 2",
    ),
    ("exercises.two_other_turns", "a and b swapped", "this is a and b exchanged"),
    ("exercises.two_other_turns", "in radians", "this is in radians"),
    ("exercises.back_to_reference", "the way there", "the turn there, made once more"),
    ("exercises.back_to_reference", "in degrees", "an angle in degrees, not in radians"),
    ("exercises.product_without_j_and_k", "i i is taken for 1", "what comes of i i = 1"),
    (
        "exercises.product_without_j_and_k",
        "component by component",
        "component times component",
    ),
    ("exercises.turned_by_sense", "about the own X", "about the object's own X"),
    ("exercises.turned_by_sense", "the axis by rate, which may be 0", "a rate of 0 turns nothing"),
    ("exercises.turned_by_steps", "not normalised", "this is not normalised"),
    ("exercises.turned_by_steps", "by the exponential", "the exact turn, not that of Eq. 9.5"),
    ("exercises.read_off", "the transpose", "the transpose of the rotation"),
    ("exercises.read_off", "the position is the last row", "this is the last row"),
    ("exercises.easy_inverse", "-p is not turned back", "the last column, which is -p"),
    (
        "exercises.easy_inverse",
        "the rotation is left as it is",
        "but for the rotation, which is not transposed",
    ),
    ("exercises.center_of_stones", "x and y swapped", "this is x and y exchanged"),
    ("exercises.balance_offset", "to the right", "to the right, not to the left"),
    (
        "exercises.balance_offset",
        "halfway between equal masses, as if a cut left them equal (E-32)",
        "as equal as they come, which is no balance (E-32)",
    ),
    (
        "exercises.masses_beside",
        "equal, as the book has them (E-32)",
        "equal masses, as the book has them, which is wrong (E-32)",
    ),
)


@pytest.mark.parametrize(
    ("edit", "mistake", "words"), TOLD, ids=[f"{edit}: {mistake}" for edit, mistake, _ in TOLD]
)
def test_the_first_message_names_the_mistake(
    edit: str, mistake: str, words: str, tmp_path: Path
) -> None:
    (exercise,) = (e.id for e in CHAPTER.exercises if edit in e.edit)
    write_wrong(CHAPTER, [WRONG[edit, mistake]], tmp_path)
    engine = [tmp_path, ROOT / "solutions", ROOT / "chapters"]
    verdicts = run_checks_warm(CHAPTER, engine, seed="1", exercises=[exercise])
    first = next(v for v in verdicts if v.exercise == exercise and v.status != "passed")
    (likely,) = (line for line in first.message.splitlines() if line.startswith("likely"))
    assert words in likely
