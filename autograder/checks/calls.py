"""Find out from a check's failure message whether it calls one of the student's functions."""

from __future__ import annotations

import re

from autograder.definitions import own_name

OPERATORS = {  # for each special method, the operator that calls it
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
    """Return True if an expression such as "v.dot(w)" calls a function.

    ``name`` is the function's full name in the manifest, such as vector.Vector3.dot.
    """
    short = own_name(name)
    pattern = rf"\b{short}\(|\.{short}\b(?! =)"  # a function, a method or a property
    if short in OPERATORS:
        pattern = re.escape(OPERATORS[short])
    elif short.endswith(".setter"):
        attribute = short.removesuffix(".setter")
        pattern = rf"\.{attribute} = |\b{attribute}="
    return re.search(pattern, expression) is not None


def names_class(expression: str, name: str) -> bool:
    """Return True if an expression creates an object of the class that contains a method."""
    _, *path = name.split(".")
    return len(path) == 1 or re.search(rf"\b{path[0]}\(", expression) is not None
