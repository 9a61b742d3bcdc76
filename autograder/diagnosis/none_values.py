"""Find the expression that was None when Python raised an error.

Python's error only says that something on the line is None. The position of the instruction that
failed says which expression it was.
"""

from __future__ import annotations

import ast
import inspect
import linecache
import re
import textwrap
from itertools import islice
from types import TracebackType

from autograder.diagnosis.misspelled import innermost

LONGEST = 60  # characters of an expression


def none_in(error: BaseException, says: str) -> str:
    """Return the expression in the student's code whose value was None, such as "self.other".

    ``says`` is the text of the error. If it has another cause, or if the expression is long or
    cannot be found, return an empty string.
    """
    try:
        if "NoneType" not in says:
            return ""
        failed = _failed_code(error.__traceback__)
        found = _none_part(ast.parse(failed).body[0], says)
        if isinstance(found, ast.Name):
            found = _assigned_call(found.id, error.__traceback__) or found
        source = ast.unparse(found) if found else ""
    except Exception:  # the source may be missing or have changed
        return ""
    return source if len(source) <= LONGEST else ""


def explain_none(expression: str) -> str:
    """Explain what it can mean that this expression is None."""
    if isinstance(ast.parse(expression, mode="eval").body, ast.Call):
        return (
            f"{expression} returns None. Perhaps the function has no return statement, or it works "
            "in place, so that it has no result."
        )
    return (
        f"{expression} is None when this line runs. If it may be None, test for that first. If "
        "not, find out where it gets its value."
    )


def _failed_code(traceback: TracebackType | None) -> str:
    """Return the source of the innermost instruction of a traceback, if it is on one line."""
    traceback = innermost(traceback)
    if traceback is None:
        return ""
    code = traceback.tb_frame.f_code
    place = next(islice(code.co_positions(), traceback.tb_lasti // 2, None))
    line, last, start, end = place
    if line is None or line != last or start is None or end is None:
        return ""
    text = linecache.getline(code.co_filename, line).encode()
    return text[start:end].decode()


def _assigned_call(name: str, traceback: TracebackType | None) -> ast.Call | None:
    """Return the call whose result a variable got last, if it got the result of a call."""
    traceback = innermost(traceback)
    if traceback is None:
        return None
    frame, last = traceback.tb_frame, traceback.tb_lineno
    tree = ast.parse(textwrap.dedent(inspect.getsource(frame.f_code)))
    ast.increment_lineno(tree, frame.f_code.co_firstlineno - 1)
    values = [
        (node.lineno, node.value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign)
        and node.lineno < last
        and any(isinstance(target, ast.Name) and target.id == name for target in node.targets)
    ]
    _, value = max(values, key=lambda found: found[0], default=(0, None))
    return value if isinstance(value, ast.Call) else None


def _none_part(node: ast.stmt | ast.expr, says: str) -> ast.expr | None:
    """Return the part of an expression or assignment that must be None, by Python's message."""
    match node:
        case ast.Expr(value=value):
            return _none_part(value, says)
        case ast.BinOp(left=left, right=right) | ast.AugAssign(target=left, value=right):
            return left if re.search(r": 'NoneType' and", says) else right
        case ast.Compare(left=left, comparators=[right]):
            return left if "of 'NoneType'" in says else right
        case ast.UnaryOp(operand=value) if "unary" in says:
            return value
        case ast.Attribute(value=value) if "has no attribute" in says:
            return value
        case ast.Subscript(value=value) if "subscriptable" in says or "item assignment" in says:
            return value
        case ast.Call(func=value) if "callable" in says:
            return value
        case ast.Call(args=[*_, ast.Starred(value=value)]) if "after *" in says:
            return value
        case ast.ListComp(generators=[first, *_]) if "iterable" in says:
            return first.iter
        case ast.Name() | ast.Call() | ast.Attribute() | ast.Subscript() if "iterable" in says:
            return node
    return None
