"""List what a Python file defines, under the names of manifests, such as Vector3.dot.

The file is parsed but never executed.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable
from pathlib import Path

Scope = ast.Module | ast.ClassDef
Definition = ast.FunctionDef | ast.ClassDef


def scopes(tree: ast.Module) -> dict[str, tuple[Scope, dict[str, Definition]]]:
    """Find the functions and classes of a module (keyed by ""), and the methods of each class."""
    owners = {"": tree} | {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    return {
        name: (owner, {_name(node): node for node in owner.body if isinstance(node, Definition)})
        for name, owner in owners.items()
    }


def functions(tree: ast.Module) -> dict[str, ast.FunctionDef]:
    """Find the functions and methods of a module, keyed by names such as Vector3.dot."""
    found = {
        f"{scope}.{name}" if scope else name: node
        for scope, (_, members) in scopes(tree).items()
        for name, node in members.items()
        if isinstance(node, ast.FunctionDef)
    }
    return dict(sorted(found.items(), key=lambda item: item[1].lineno))


def read_module(file: Path) -> ast.Module | None:
    """Parse a student's file. Return None if it is missing or not valid Python."""
    try:
        return ast.parse(file.read_bytes())
    except (OSError, SyntaxError, ValueError, MemoryError, RecursionError):
        return None


def module_that_defines(name: str, file: str, folders: Iterable[Path]) -> str:
    """Find the latest module from which ``file`` can import ``name``, up to its chapter, or ""."""
    chapter = file.partition("/")[0]
    found = ""
    for folder in folders:
        for path in sorted(folder.glob("ch[0-9][0-9]_*/*.py")):
            module = f"{path.parent.name}.{path.stem}"
            is_earlier = found.partition(".")[0] < path.parent.name <= chapter
            if is_earlier and f"{path.parent.name}/{path.name}" != file:
                tree = read_module(path)
                found = module if tree and name in map(defined_name, tree.body) else found
    return found


def defined_name(node: ast.stmt) -> str:
    """Return the name that a statement defines, or "" if it is not a definition of one name."""
    match node:
        case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
            return name
        case ast.Assign(targets=[ast.Name(id=name)]) | ast.AnnAssign(target=ast.Name(id=name)):
            return name
    return ""


def own_name(edited: str) -> str:
    """Return a function's name without its module and class, such as dot for vector.Vector3.dot."""
    return edited.split(".", 2)[-1]


def _name(node: Definition) -> str:
    setter = f"{node.name}.setter"
    return setter if setter in map(ast.unparse, node.decorator_list) else node.name
