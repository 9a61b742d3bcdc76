"""Remove from a stub the imports and constants that only the removed function bodies used."""

from __future__ import annotations

import ast
from collections.abc import Callable, Collection
from typing import Any

import libcst as cst

LINE = 100  # characters, as in pyproject.toml


def used_names(source: str) -> set[str]:
    """Return the names of all variables and attributes that some Python source code uses."""
    nodes = [*ast.walk(ast.parse(source))]
    names = {n.id for n in nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load)}
    return names | {node.attr for node in nodes if isinstance(node, ast.Attribute)}


def without_unused(module: cst.Module, gone: Collection[str]) -> cst.Module:
    """Remove the private constants in ``gone`` from the top of a module, then its unused imports.

    What remains stays separated by blank lines as before. An import such as ``from a import b as
    b`` stays, because other modules import b from this one.
    """
    module = _each(module, lambda one: None if _private_constant(one) in gone else one)
    used = used_names(module.code)
    return _each(module, lambda one: _with_used_imports(one, used))


def _each(module: cst.Module, left: Callable[[Any], Any]) -> cst.Module:
    """Replace each statement of a module by what ``left`` returns, or remove it for None."""
    body: list[Any] = []
    above: list[Any] = []  # the blank lines above the statements that were just removed
    for statement in module.body:
        new = left(statement)
        if new is None:
            above = above or [line for line in statement.leading_lines if not line.comment]
            continue
        if above and not new.leading_lines:
            new = new.with_changes(leading_lines=above)
        above = []
        body.append(new)
    return module.with_changes(body=body)


def _with_used_imports(statement: Any, used: Collection[str]) -> Any:
    """Return a statement without its unused imports, or None if nothing is left of it."""
    match statement:
        case cst.SimpleStatementLine(body=[cst.Import() | cst.ImportFrom() as node]):
            there: Any = node.names
            names = [alias for alias in there if _stays(node, alias, used)]
            if not names:
                return None
            if len(names) < len(there):
                return statement.with_changes(body=[_only(node, names)])
    return statement


def _stays(node: Any, alias: cst.ImportAlias, used: Collection[str]) -> bool:
    """Return whether an import of one name is used, exports the name or changes the language."""
    if isinstance(node, cst.ImportFrom) and node.module and node.module.value == "__future__":
        return True
    name, own = alias.evaluated_name, alias.evaluated_alias
    return own == name or (own or name.partition(".")[0]) in used


def _only(node: Any, names: list[Any]) -> Any:
    """Return a statement that imports only ``names``, on one line if they fit."""
    comma = cst.Comma(whitespace_after=cst.SimpleWhitespace(" "))
    commas = [comma] * (len(names) - 1) + [cst.MaybeSentinel.DEFAULT]
    in_line = [alias.with_changes(comma=c) for alias, c in zip(names, commas, strict=True)]
    brackets = {} if isinstance(node, cst.Import) else {"lpar": None, "rpar": None}
    short = node.with_changes(names=in_line, **brackets)
    if len(cst.Module([]).code_for_node(short)) <= LINE:
        return short
    return node.with_changes(
        names=[*names[:-1], names[-1].with_changes(comma=node.names[-1].comma)]
    )


def _private_constant(statement: cst.CSTNode) -> str | None:
    """Return the name of the private constant that a statement such as ``_NAME = 3`` defines.

    For any other statement, return None.
    """
    match statement:
        case cst.SimpleStatementLine(
            body=[cst.Assign(targets=[cst.AssignTarget(target=cst.Name(value=name))])]
        ) if name.startswith("_"):
            return str(name)
    return None
