"""Restore functions that a student has deleted, each in its original position in the file."""

from __future__ import annotations

import ast
from collections.abc import Collection, Sequence
from typing import Any

import libcst as cst

from autograder.definitions import functions


def put_back(module: cst.Module, stub: cst.Module, names: Collection[str]) -> cst.Module:
    """Return a student's module with its deleted functions restored as stubs.

    ``names`` are the functions to restore, such as Vector3.dot. If the student has deleted a whole
    class, all of it is restored.

    Raises:
        ValueError: The stub does not define one of the functions in ``names``.
    """
    prefixed = {name.partition(".")[0] for name in names if "." in name}
    body = [*module.body]
    for node in stub.body:
        name = _name(node)
        if not isinstance(node, cst.ClassDef):
            if name in names:
                _insert(body, node, stub.body)
        elif name in prefixed:
            there = [i for i, other in enumerate(body) if _name(other) == name]
            if there:
                own = [
                    wanted.partition(".")[2] for wanted in names if wanted.startswith(f"{name}.")
                ]
                body[there[0]] = _with_members(body[there[0]], node, own)
            else:
                _insert(body, node, stub.body)
    changed = module.with_changes(body=body)
    if body[-1:] != [*module.body][-1:] and not any(line.comment for line in module.footer):
        changed = changed.with_changes(footer=[])  # drop blank lines at the end of the file
    if missing := set(names) - functions(ast.parse(changed.bytes)).keys():
        raise ValueError(f"its stub does not define {', '.join(sorted(missing))}")
    return changed


def _with_members(node: Any, stub: cst.ClassDef, names: Collection[str]) -> Any:
    """Return the syntax tree of a student's class, with stubs for the deleted methods."""
    members = [*node.body.body]
    if not isinstance(node.body, cst.IndentedBlock):  # the whole class is on one line
        members = [cst.SimpleStatementLine(members)]
    for member in stub.body.body:
        if _name(member) in names:
            _insert(members, member, stub.body.body)
    if isinstance(node.body, cst.IndentedBlock):
        return node.with_changes(body=node.body.with_changes(body=members))
    return node.with_changes(body=cst.IndentedBlock(members))


def _insert(body: list[Any], node: Any, order: Sequence[Any]) -> None:
    """Insert a deleted function or class into a student's code, in its original position.

    The function goes below its nearest predecessor in the original file that the student has kept.
    If there is none, it goes above its nearest successor.
    """
    names = [_name(other) for other in body]
    at = [*order].index(node)
    for other in reversed(order[:at]):
        if (name := _name(other)) and name in names:
            last = max(i for i, there in enumerate(names) if there == name)  # overload
            body.insert(last + 1, node)
            return
    for other in order[at + 1 :]:
        if (name := _name(other)) and name in names:
            body.insert(names.index(name), node)
            return
    body.append(node)


def _name(node: Any) -> str:
    """Return the name that a manifest uses for a function or class, such as dot or mass.setter.

    For any other statement, return "".
    """
    if isinstance(node, cst.ClassDef):
        return str(node.name.value)
    if isinstance(node, cst.FunctionDef):
        return next(iter(functions(ast.parse(cst.Module([node]).code))), "")
    return ""
