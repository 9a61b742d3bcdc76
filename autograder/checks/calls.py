"""Find out whether a check calls one of the student's functions.

The answer is based on the expression in the check's failure message, such as "v.dot(w)".
"""

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
    """Return True if a check's expression, such as "v.dot(w)", calls the function ``name``.

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
    """Return True if a check's expression creates an object of the class that contains a method.

    ``name`` is the full name of the method. For vector.Vector3.dot, the result is True if the
    expression contains a call such as "Vector3(1, 2, 3)". For a function outside any class, the
    result is always True.
    """
    _, *path = name.split(".")
    return len(path) == 1 or re.search(rf"\b{path[0]}\(", expression) is not None
