"""Find the functions that a module defines, by the names that manifests use."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path


def functions(tree: ast.Module) -> dict[str, ast.FunctionDef]:
    """Return every top-level function and every method, by its dotted name.

    A property is called Particle.mass, and what sets it Particle.mass.setter.
    """
    found = {}
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            found[_name(node)] = node
        elif isinstance(node, ast.ClassDef):
            members = (member for member in node.body if isinstance(member, ast.FunctionDef))
            found |= {f"{node.name}.{_name(member)}": member for member in members}
    return found


def read_definitions(file: Path) -> set[str] | None:
    """Return what a module defines; None where it is missing, empty or cannot be read."""
    try:
        return bound_names(ast.parse(file.read_bytes())) or None
    except (OSError, SyntaxError, ValueError, MemoryError, RecursionError):
        return None


def bound_names(tree: ast.Module) -> set[str]:
    """Return all that a module and its classes define in any way: by def, class, = or import.

    The names are those of functions; what sets a property that is made by = counts as defined.
    """
    found = set(_bound(tree))
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            found |= {f"{node.name}.{name}" for name in _bound(node)}
    return found


def _bound(scope: ast.AST) -> Iterator[str]:
    """Yield what is bound in a module or a class itself, and not in what they define."""
    for node in ast.iter_child_nodes(scope):
        match node:
            case ast.FunctionDef():
                yield _name(node)
            case ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                yield name
            case ast.Name(id=name, ctx=ast.Store()):
                yield from (name, f"{name}.setter")
            case ast.alias(name=name, asname=other):
                yield other or name
            case _:
                yield from _bound(node)


def own_name(edited: str) -> str:
    """Return what a manifest's name calls the function itself: without module and class."""
    return edited.split(".", 2)[-1]


def _name(node: ast.FunctionDef) -> str:
    setter = f"{node.name}.setter"
    return setter if setter in map(ast.unparse, node.decorator_list) else node.name
