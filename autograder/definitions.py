"""Find the functions that a module defines, by the names that manifests use."""

from __future__ import annotations

import ast


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


def own_name(edited: str) -> str:
    """Return what a manifest's name calls the function itself: without module and class."""
    return edited.split(".", 2)[-1]


def _name(node: ast.FunctionDef) -> str:
    setter = f"{node.name}.setter"
    return setter if setter in map(ast.unparse, node.decorator_list) else node.name
