"""Find the expression that was None, from the position of the instruction that failed."""

from __future__ import annotations

import ast
import linecache
from types import FrameType

from autograder.diagnosis.misspelled import innermost

LONGEST = 60  # characters of an expression
# Python's words for what cannot be done with None, which is a part of the failed expression.
NOT_OF_NONE = ("has no attribute", "subscriptable", "item assignment", "callable", "unary")


def none_in(error: BaseException, says: str) -> str:
    """Return the expression that was None, or "", for an error with the text ``says``."""
    last = innermost(error.__traceback__)
    if "NoneType" not in says or last is None:
        return ""
    try:
        code = last.tb_frame.f_code
        line, end_line, start, end = [*code.co_positions()][last.tb_lasti // 2]
        if line is None or line != end_line:
            return ""
        failed = linecache.getline(code.co_filename, line).encode()[start:end].decode()
        found = _none_part(ast.parse(failed).body[0], says)
        if isinstance(found, ast.Name):
            found = _assigned_call(found.id, last.tb_frame, last.tb_lineno) or found
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


def _none_part(node: ast.AST, says: str) -> ast.expr | None:
    """Return the part of a failed expression or assignment that was None, by Python's message."""
    match node:
        case ast.Expr(value=value):
            return _none_part(value, says)
        case ast.Name() | ast.Call() | ast.Attribute() | ast.Subscript() if "not iterable" in says:
            return node
        case (
            ast.BinOp(left=left, right=right)
            | ast.AugAssign(target=left, value=right)
            | ast.Compare(left=left, comparators=[right])
        ):
            return left if "'NoneType' and" in says else right
        case (
            ast.Attribute(value=value)
            | ast.Subscript(value=value)
            | ast.Call(func=value)
            | ast.UnaryOp(operand=value)
        ) if any(words in says for words in NOT_OF_NONE):
            return value
    return None


def _assigned_call(name: str, frame: FrameType, line: int) -> ast.Call | None:
    """Return the call whose result a variable got last, if it got the result of a call."""
    code = frame.f_code
    values = {
        node.lineno: node.value
        for node in ast.walk(ast.parse("".join(linecache.getlines(code.co_filename))))
        if isinstance(node, ast.Assign)
        and code.co_firstlineno <= node.lineno < line
        and any(isinstance(target, ast.Name) and target.id == name for target in node.targets)
    }
    value = values[max(values)] if values else None
    return value if isinstance(value, ast.Call) else None
