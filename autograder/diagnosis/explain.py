"""Explain to a student why the code failed in a check, and suggest how to fix it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from autograder.checks.asked import about, short_numbers
from autograder.diagnosis.faults import Fault, fault_of, is_inside, short, text_of
from autograder.diagnosis.missing import file_of
from autograder.diagnosis.nearest import explain_unknown
from autograder.message import ExpectationError, Kind, Message, Place

NOT_IMPLEMENTED = (
    "Your code returned NotImplemented instead of raising an error. Only an operator such as "
    "__add__ should do that, because Python then raises the TypeError. Any other method must raise "
    "the error itself."
)
NOT_HANDED_IN = (
    "Your code imports a file that does not exist or is not handed in. Correct the name, or move "
    "the code of that file into a file that an exercise names. An import must include the folder: "
    "from ch02_vectors.vector import Vector3"
)
ONLY_COMPUTES = (
    "Your engine should only compute. Remove any code that writes files, reads files outside the "
    "engine, starts programs or threads, or uses the network. None of that works in the grader."
)
NO_KEYBOARD = (
    "Your code waits for keyboard input, but nobody can type anything during a check. Remove the "
    "call to input or breakpoint."
)
# Some mistakes in Python cause error messages that are hard to understand. We recognize each of
# them by a part of its message. Since the check itself can only suggest a mistake in the physics,
# we show our explanation instead.
SLIPS = (
    ("NotImplementedType", NOT_IMPLEMENTED),
    (
        "SystemExit",
        "Your code stops the Python interpreter, so the check cannot continue. Remove the call to "
        "sys.exit, exit or quit.",
    ),
    ("EOF when reading", NO_KEYBOARD),
    ("BdbQuit", NO_KEYBOARD),
    (
        "circular import",
        "Two files import each other, so neither can be loaded first. Remove one of the imports, "
        "and move the code that both files need into the one that is still imported.",
    ),
    ("No module named 'ch0", NOT_HANDED_IN),
    ("(unknown location)", NOT_HANDED_IN),
    (
        "No module named",
        "Your engine may import only Python's standard library and the files of the chapters. An "
        "import of such a file must include its folder: from ch02_vectors.vector import Vector3",
    ),
    (
        "No such file or directory",
        "Your code runs in a different folder, so a relative path doesn't find the file. Use "
        "Path(__file__).with_name(...) for a file next to your code, and read only files that an "
        "exercise names.",
    ),
    ("Permission denied", ONLY_COMPUTES),
    ("Operation not permitted", ONLY_COMPUTES),
    ("start new thread", ONLY_COMPUTES),
    (
        "must be a Vector3, got None",
        "You used the result of a method that works in place. Such a method changes its vector "
        "and returns None, so call it on its own line and don't use its result.",
    ),
    (
        "has no setter",
        "Your code assigns to a property that has no setter, so it can only be read.",
    ),
    ("for ^", "In Python, powers are written with **. The operator ^ is bitwise exclusive or."),
    (
        "is not defined",
        "Python doesn't know this name. Check its spelling, and make sure that the file imports "
        "it at the top.",
    ),
    (
        "local variable",
        "Your code reads this variable before assigning a value to it. Give it a value on every "
        "path that leads to this line.",
    ),
    (
        "unexpected keyword",
        "A parameter in your def line has a different name than in the docstring. Use the name in "
        "the docstring, because callers pass this argument by name.",
    ),
    (
        "and 'method'",
        "Your code uses a method as if it were the method's result. Add parentheses after the "
        "name to call it.",
    ),
    ("can't decode", "Save the file as UTF-8 in your editor."),
    ("null bytes", "Save the file as UTF-8 in your editor."),
)
# These errors may come from a mistake in Python, or they may follow from one in the physics. So we
# also show the mistake that the check suggests.
PERHAPS = (
    (
        "'tuple'",
        "A value on this line is a tuple, because a function with several results returns them "
        "as a tuple. Unpack the tuple into separate names before you use the results.",
    ),
    (
        "NoneType",
        "A value on this line is None. Perhaps a function that should return it has no return "
        "statement.",
    ),
    (
        "maximum recursion",
        "A function calls itself forever. Check whether an operator or method uses itself, or a "
        "setter assigns to its own name.",
    ),
    (
        "positional argument",
        "The number of arguments in the call doesn't match the def line. Perhaps the def line "
        "lacks self, or the call passes an argument too many.",
    ),
    (
        "is not callable",
        "Your code calls a value that isn't a function. Perhaps this value is a property, which "
        "needs no parentheses, or you used the same name for two things.",
    ),
    (
        "values to unpack",
        "The function returned more or fewer values than there are names on the left of the =. "
        "Check in its docstring what it returns.",
    ),
    (
        "cannot unpack",
        "The function returned more or fewer values than there are names on the left of the =. "
        "Check in its docstring what it returns.",
    ),
    (
        "has no attribute",
        "Perhaps you misspelled the name of the attribute, or the object has a different type than "
        "you expect.",
    ),
    ("unterminated", "A quotation mark is missing here or further up. A docstring needs three."),
    ("TabError", "The indentation mixes tabs and spaces. Use four spaces for each level."),
    ("unindent does not match", "Indent this line to match the block that it belongs to."),
    ("unexpected indent", "This line is indented too far. Use four spaces for each level."),
    ("expected an indented block", "Write the body of this block, and indent it by four spaces."),
    ("MemoryError", "Your code needs more memory than a check may use. Is a list too long?"),
    ("is not subscriptable", "A Vector3 has no index. Read v.x, v.y and v.z instead."),
    (
        "TypeError",
        "A value on this line has the wrong type. Check the type of each value on the line. "
        "Perhaps you forgot the parentheses after a method's name, so the method is never called.",
    ),
)
ESCAPED = re.compile(
    r"\\(?:x([0-9a-f]{2})|u([0-9a-f]{4})|U(000[0-9a-f]{5}|0010[0-9a-f]{4}))"
)  # an escape sequence in a stack trace
EXERCISE = re.compile(r"Exercise ([A-Z]?\d+\.\w+)")  # in the NotImplementedError of a stub
STACK_LINE = re.compile(r'File "([^"\n]{1,500})", line (\d{1,6}) in (\S{1,100})')


def explain_exception(
    error: BaseException, engine_folders: list[Path], complete: Sequence[str] = ()
) -> Message:
    """Build the message that explains to a student why an exception ended a check.

    If the student's code returned a wrong value, the exception already carries its message. For any
    other exception, the message shows the call that the check made, the exception, the student's
    line and a likely mistake. It explains Python's error if that is a common one. Otherwise it
    shows the mistake that the check suggests.

    ``complete`` lists modules that the student uses but did not write, such as
    ch02_vectors/arguments.py. An exception from a worker process has the attribute ``fault``.
    """
    fault = getattr(error, "fault", None) or fault_of(error, engine_folders)
    written = [frame for frame in fault.frames if not _is_given(frame, complete)]
    own = written or fault.frames
    if isinstance(error, AssertionError) and not own:
        return error.message if isinstance(error, ExpectationError) else Message(text_of(error))
    where = own[-1] if own else None
    if isinstance(error, NotImplementedError):
        says = fault.text.partition("\n")[0] or "a body raises NotImplementedError"
        named = EXERCISE.match(says)
        return Message(
            f"{Kind.UNWRITTEN.value}: {says}",
            where=where,
            kind=Kind.UNWRITTEN,
            exercise=named[1] if named else "",
        )
    # If there is no call yet, the cause was not set for this exception.
    cause, read = (about.cause, about.read) if about.call else ("", "")
    likely, other = _likely(fault.first_line, cause, fault)
    return Message(
        called=short_numbers(about.call),
        got=fault.first_line,
        where=where and _with_source(where, engine_folders),
        likely=likely,
        other=other,
        read=read,
    )


def explain_import(
    fault: Fault, module: str, engine_folders: list[Path], complete: Sequence[str] = ()
) -> Message:
    """Build the message that explains to a student why a module cannot be imported.

    ``complete`` lists the modules that the student did not write. The message points to a line in
    one of them only if no line of the student's own is involved.
    """
    file = file_of(module)
    if fault.missing_module == module:
        title = f"{file} is missing: it was not handed in, was renamed, or is in another folder"
        return Message(title, kind=Kind.BROKEN)
    text, where = fault.first_line, None
    if fault.syntax:
        text = fault.text
        source, line, words = fault.syntax
        where = Place(source or file, line, source=words)
        title = f"{file} cannot be read: {text}"
    else:
        title = f"{file} cannot be imported: {text}"
        written = [frame for frame in fault.frames if frame.file not in complete]
        if own := written or fault.frames:
            where = _with_source(own[-1], engine_folders)
    likely, _ = _likely(text, "", fault)
    return Message(title, where=where, likely=likely, kind=Kind.BROKEN)


def explain_hang(stack: str, time_limit: float, engine_folders: list[Path]) -> Message:
    """Build the message for a check that ran out of time, and point to the line that was running.

    ``stack`` is the stack trace that the process wrote to a file. It may contain anything, because
    the student's code can write to that file too.
    """
    hung = Message(
        f"{Kind.HUNG.value} within {time_limit:g} seconds. Is there an endless loop?",
        kind=Kind.HUNG,
    )
    folders = [folder.resolve() for folder in engine_folders]
    for file, line, name in STACK_LINE.findall(stack):
        for path in (file, _unescaped(file)):  # a Windows folder such as \xfaces looks escaped
            try:
                if is_inside(path, folders):
                    return replace(hung, where=Place(short(path), int(line), _unescaped(name)))
            except (ValueError, OSError):
                continue  # not a valid file name on any system
    return hung


def _unescaped(text: str) -> str:
    """Decode the escape sequences that Python writes for special characters in a stack trace."""
    return ESCAPED.sub(lambda escaped: chr(int(escaped[escaped.lastindex or 0], 16)), text)


def _likely(text: str, cause: str, fault: Fault) -> tuple[str, str]:
    """Guess which mistake caused an exception in a student's code.

    Return the most likely mistake and a second possibility. Either may be an empty string.
    ``cause`` is the mistake that the check suggests.
    """
    meant = explain_unknown(fault.unknown) if fault.unknown else ""
    if slip := meant or slip_of(text):
        return slip, ""
    perhaps = next((slip for sign, slip in PERHAPS if sign in text), "")
    return (perhaps, cause) if perhaps else (cause, "")


def slip_of(text: str) -> str:
    """Explain the common Python mistake that causes an exception with this text.

    For example, "circular import" means that two files import each other. If the text is not one
    that we recognize, return an empty string.
    """
    return next((slip for sign, slip in SLIPS if sign in text), "")


def _is_given(place: Place, complete: Sequence[str]) -> bool:
    """Return whether a line that raised an exception is in code that the student was given.

    The mistake is then in the code that called it. Constructors count as given, because students
    never write them.
    """
    return place.function in ("__init__", "__setattr__") or place.file in complete


def _with_source(place: Place, engine_folders: list[Path]) -> Place:
    """Add the text of the student's line to ``place``, so that the failure message can show it.

    The line comes from the first folder of the engine that contains the file.
    """
    for folder in engine_folders:
        file = folder / place.file
        if file.is_file():
            lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
            line = lines[place.line - 1].strip() if 0 < place.line <= len(lines) else ""
            return replace(place, source=line[:200])
    return place
