"""Find out which functions a check's expression calls."""

from __future__ import annotations

import re

from autograder.definitions import own_name

OPERATORS = {  # the operator that calls each special method
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
    """Return whether ``expression`` calls a function. ``name`` is its name in the manifest."""
    short = own_name(name)
    pattern = rf"\b{short}\(|\.{short}\b(?! =)"  # a function, a method or a property
    if short in OPERATORS:
        pattern = re.escape(OPERATORS[short])
    elif short.endswith(".setter"):
        attribute = short.removesuffix(".setter")
        pattern = rf"\.{attribute} = |\b{attribute}="
    return re.search(pattern, expression) is not None


def names_class(expression: str, name: str) -> bool:
    """Return whether ``expression`` constructs an object of the class to which a method belongs.

    ``name`` is the name of the method in the manifest. For a plain function, return True.
    """
    _, *path = name.split(".")
    return len(path) == 1 or re.search(rf"\b{path[0]}\(", expression) is not None
