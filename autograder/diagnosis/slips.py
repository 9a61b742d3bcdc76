"""Explain Python's error messages, each recognized by a part of its text."""

from __future__ import annotations

import re


def _table(text: str) -> dict[str, str]:
    """Read rows such as "sign|other sign: explanation", whose further lines are indented."""
    rows = (" ".join(row.split()) for row in re.split(r"\n(?! )", text.strip()))
    return dict(row.split(": ", 1) for row in rows)


# These are mistakes in the use of Python, so what the check suggests about the physics is left out.
SLIPS = _table("""
NotImplementedType: Your code returned NotImplemented instead of raising an error. Only an operator
  such as __add__ should do that, because Python then raises the TypeError. Any other method must
  raise the error itself.
MemoryError: Your code needs more memory than a check may use. Does a loop never end, while a list
  in it gets longer and longer?
SystemExit: Your code stops the Python interpreter, so the check cannot continue. Remove the call
  to sys.exit, exit or quit.
EOF when reading: Your code waits for keyboard input, but nobody can type anything during a check.
  Remove the call to input.
BdbQuit: A check does not stop at breakpoint(). To stop there, debug the exercise instead of
  checking it, as in make debug EX=B2.3 (without make: python -m autograder debug B2.3).
circular import: Two files import each other, so neither can be loaded first. Remove one of the
  imports, and move the code that both files need into the one that is still imported.
No module named 'ch0|(unknown location): Your code imports a file that does not exist or is not
  handed in. Correct the name, or move the code of that file into a file that an exercise names. An
  import must include the folder: from ch02_vectors.vector import Vector3
No module named: Your engine may import only Python's standard library and the files of the
  chapters. An import of such a file must include its folder:
  from ch02_vectors.vector import Vector3
No such file or directory: Your code runs in a different folder, so a relative path doesn't find
  the file. Use Path(__file__).with_name(...) for a file next to your code, and read only files
  that an exercise names.
Permission denied|Operation not permitted|start new thread: Your engine should only compute. Remove
  any code that writes files, reads files outside the engine, starts programs or threads, or uses
  the network. None of that works in the grader.
must be a Vector3, got None: You used the result of a method that works in place. Such a method
  changes its vector and returns None, so call it on its own line and don't use its result.
has no setter: Your code assigns to a property that has no setter, so it can only be read.
for ^: In Python, powers are written with **. The operator ^ is bitwise exclusive or.
is not defined: Python doesn't know this name. Check its spelling, and make sure that the file
  imports it at the top.
local variable: Your code reads this variable before assigning a value to it. Give it a value on
  every path that leads to this line.
unexpected keyword: A parameter in your def line has a different name than in the docstring. Use
  the name in the docstring, because callers pass this argument by name.
maximum recursion: A function calls itself too many times. Perhaps an operator or method uses
  itself, or a property reads or assigns its own name.
method'|method object: Your code uses a method as if it were the method's result. Add parentheses
  after the name to call it.
""")
# What led to these errors may be a mistake in the physics, so the check's suggestion comes second.
FACTS = _table("""
real number, not ': A number is needed here. Vector3 takes three numbers, so write
  Vector3(*numbers) for a list or a tuple of them.
'tuple': A value on this line is a tuple, because a function with several results returns them as a
  tuple. Unpack the tuple into separate names before you use the results.
NoneType: A value on this line is None. Either nothing was assigned to it yet, or it comes from a
  function without a return statement, or from a method that works in place, such as clear.
values to unpack|cannot unpack: There are more or fewer values than names to store them in. Print
  the value that this line unpacks, and check in the docstring what it should be.
'Vector3' object is not subscriptable: A Vector3 has no index. Read v.x, v.y and v.z.
object is not iterable: A list or a tuple is needed here. If there is only one element, put it in
  brackets, as in [contact].
index out of range: The index is past the end. The last of n elements has the index n - 1, so a
  loop that reads the elements i and i + 1 must stop one earlier.
for //: The operator // divides into whole numbers. Write / to divide.
non-integer arg: random.randint draws whole numbers. Use random.uniform for others.
'float' object has no attribute: A number is used here as if it were a vector. Perhaps the line
  that calls passes a number, or a term of its sum lacks its vector.
must be a number, got| must be a Vector3, got: The error names an argument that has the wrong type.
  Look at what your line passes for it.
is not callable: Your code calls a value that isn't a function. Perhaps this value is a property,
  which needs no parentheses, or you used the same name for two things.
""")
# These explanations are only guesses, so the mistake that the check suggests comes first.
PERHAPS = _table("""
math domain error|expected a number in range|expected a nonnegative input: A function of math got a
  number for which it has no result, such as sqrt of a negative number. Check the signs on this
  line.
has no attribute: Perhaps you misspelled the name of the attribute, or the object has a different
  type than you expect.
unterminated: A quotation mark is missing here or further up. A docstring needs three.
TabError: The indentation mixes tabs and spaces. Use four spaces for each level.
unindent does not match: Indent this line to match the block that it belongs to.
unexpected indent: This line is indented too far. Use four spaces for each level.
expected an indented block: Write the body of this block, and indent it by four spaces.
TypeError: A value on this line has the wrong type. Check the type of each value on the line.
""")
NOT_IMPLEMENTED, POWER = SLIPS["NotImplementedType"], SLIPS["for ^"]
LACKING = re.compile(r"missing (\d+) required (positional|keyword-only) arguments?: (.+)")
TOO_MANY = re.compile(r"takes (?:from \d+ to )?(\d+) positional arguments? but (\d+) w")


def fact_of(text: str) -> str:
    """Explain what an exception's text proves, or return an empty string."""
    if lacking := LACKING.search(text):
        names = lacking[3].replace("'", "")
        what = f"The call passes no value for {names}."
        if lacking[2] == "keyword-only":
            return f"{what} Pass it by name."
        return (
            f"{what} Add it to the call. If you call a method through its class, as in "
            "Spring.update_force(...), pass self first."
        )
    if many := TOO_MANY.search(text):
        takes, given = int(many[1]), int(many[2])
        lacks = " Perhaps the def line lacks self." if given == takes + 1 else ""
        return f"The call passes {given} arguments, but the def line takes {takes}.{lacks}"
    return _first(FACTS, text)


def slip_of(text: str) -> str:
    """Explain the common Python mistake that an exception's text reveals, or return ""."""
    return _first(SLIPS, text)


def guess_of(text: str) -> str:
    """Return a mistake that may have led to an exception, or "" if its text suggests none."""
    return _first(PERHAPS, text)


def _first(table: dict[str, str], text: str) -> str:
    """Return the explanation of the first row that has a sign, separated by |, in the text."""
    for signs, words in table.items():
        if any(sign in text for sign in signs.split("|")):
            return words
    return ""
