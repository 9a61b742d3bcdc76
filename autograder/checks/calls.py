"""Find out which of a student's functions the expression of a check calls."""

from __future__ import annotations

import re

from autograder.definitions import own_name

OPERATORS = {  # as checks write them in their calls
    "__neg__": "; -v",
    "__mul__": " * ",
    "__imul__": " *= ",
    "__truediv__": " / ",
    "__itruediv__": " /= ",
    "__add__": " + ",
    "__iadd__": " += ",
    "__sub__": " - ",
    "__isub__": " -= ",
    "__matmul__": " @ ",
}


def calls(expression: str, name: str) -> bool:
    """Return whether the expression of a check calls the function with this manifest name."""
    short = own_name(name)
    pattern = rf"\b{short}\(|\.{short}\b(?! =)"  # a function, a method or a property
    if short in OPERATORS:
        pattern = re.escape(OPERATORS[short])
    elif short.endswith(".setter"):
        attribute = short.removesuffix(".setter")
        pattern = rf"\.{attribute} = |\b{attribute}="
    return re.search(pattern, expression) is not None


def names_class(expression: str, name: str) -> bool:
    """Return whether the expression constructs the class of a method. A function counts as True."""
    _, *path = name.split(".")
    return len(path) == 1 or re.search(rf"\b{path[0]}\(", expression) is not None
