"""Remove from a stub the private helpers, constants and imports that only the answers used."""

from __future__ import annotations

import ast
import re
from collections.abc import Collection

from autograder.definitions import defined_name, scopes

LINE = 100  # characters, as in pyproject.toml
PRIVATE = re.compile(r"_(?!.*__$)")  # but no method of Python's own, such as __init__


def without_unused(stub: str, source: str) -> str:
    """Remove private definitions that only ``source`` uses, and then imports that are not used.

    An import such as ``from a import b as b`` stays, because other modules import b from this one.
    """
    tree = ast.parse(stub)
    unused = {defined_name(node) for node in _unreached(ast.parse(source))}
    gone = {node: "" for node in _unreached(tree) if defined_name(node) not in unused}
    stub = _changed(stub, tree, gone)
    tree = ast.parse(stub)
    used = _used(tree)
    texts: dict[ast.stmt, str] = {}
    for node in tree.body:
        if isinstance(node, ast.Import | ast.ImportFrom):
            names = [one for one in node.names if _stays(node, one, used)]
            if names != node.names:
                texts[node] = _import(node, names)
    return _changed(stub, tree, texts)


def _unreached(tree: ast.Module) -> list[ast.stmt]:
    """Return the private functions, methods, classes and constants that no other code reaches."""
    every = [node for owner, _ in scopes(tree).values() for node in owner.body]
    left = [node for node in every if PRIVATE.match(defined_name(node))]
    reached = _used(tree, left)
    while found := [node for node in left if defined_name(node) in reached]:
        left = [node for node in left if node not in found]
        reached = reached.union(*(_used(node, left) for node in found))
    return left


def _used(node: ast.AST, but: Collection[ast.AST] = ()) -> set[str]:
    """Return the names of the variables and attributes that code uses, outside of some nodes."""
    names = set()
    match node:
        case ast.Name(id=name, ctx=ast.Load()) | ast.Attribute(attr=name):
            names.add(name)
    below = (child for child in ast.iter_child_nodes(node) if child not in but)
    return names.union(*(_used(child, but) for child in below))


def _stays(node: ast.Import | ast.ImportFrom, one: ast.alias, used: Collection[str]) -> bool:
    """Return True if an import of a name is used, exports the name or changes the language."""
    is_future = isinstance(node, ast.ImportFrom) and node.module == "__future__"
    bound = one.asname or one.name.partition(".")[0]
    return is_future or one.asname == one.name or bound in used


def _import(node: ast.Import | ast.ImportFrom, names: list[ast.alias]) -> str:
    """Return an import of only these names, on one line if they fit."""
    if not names:
        return ""
    node.names = names
    text = ast.unparse(node)
    if len(text) <= LINE:
        return text
    start, _, rest = text.partition(" import ")
    return f"{start} import (\n    {rest.replace(', ', f',{chr(10)}    ')},\n)"


def _changed(source: str, tree: ast.Module, texts: dict[ast.stmt, str]) -> str:
    """Replace statements by other texts, or remove them, with the comments above, if it is ""."""
    lines = source.split("\n")
    owners = {node: owner for owner, _ in scopes(tree).values() for node in owner.body}
    for node, text in sorted(texts.items(), key=lambda item: -item[0].lineno):
        top, end = node.lineno - 1, node.end_lineno or 0
        if not text:
            above = [other.end_lineno or 0 for other in owners[node].body if other.lineno <= top]
            decorators = getattr(node, "decorator_list", [])
            top = max(above, default=min([top, *(part.lineno - 1 for part in decorators)]))
            while lines[end].strip() and not lines[top].strip():  # keep a blank line
                top += 1
        lines[top:end] = [text] if text else []
    return "\n".join(lines)
