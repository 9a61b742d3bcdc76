"""Rewrite the body of a function as another student, or a student who hides a copy, would do.

The new body does the same as the old one, except that the last digit of a sum may change.
"""

from __future__ import annotations

import ast
import builtins
import textwrap
from collections.abc import Iterable
from random import Random

HABITS = """\
swap operands
halve
flip comparisons
expand +=
whole numbers
ternary
else
negate
name parts
name results
inline
hoist attributes
""".splitlines()
NAMES = (
    "a b c d e f g h i j k m n p q r s t u w val tmp res out num cur acc cnt idx item thing old "
    "new left right first second total diff amount part length vec pos speed step size factor"
)
REMARKS = ("# see the book", "# as in the lesson", "# careful here", "# TODO tidy up", "# works")
FLIPPED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.Gt,
    ast.Gt: ast.Lt,
    ast.LtE: ast.GtE,
    ast.GtE: ast.LtE,
}
Body = list[ast.stmt]


class Student(ast.NodeTransformer):
    """A student's habits: different ways to write an expression, and how often each is used."""

    def __init__(self, rng: Random) -> None:
        self.rng = rng
        self.habits = {habit: rng.choice([0.0, 0.1, 0.3, 0.6, 0.9]) for habit in HABITS}

    def does(self, habit: str) -> bool:
        return self.rng.random() < self.habits[habit]

    def write(self, source: str, parameters: Iterable[str] = ()) -> str:
        """Return a function's body in this student's style.

        ``parameters`` are those of the function.
        """
        body = parsed(source)
        if self.does("inline"):
            body = inlined(body)
        if self.does("hoist attributes"):
            body = hoisted(body)
        body = [self.visit(statement) for statement in self.parted(body)]
        return written(renamed(body, self.rng, parameters), self.rng)

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        self.generic_visit(node)
        if isinstance(node.op, (ast.Mult, ast.Add)) and self.does("swap operands"):
            node.left, node.right = node.right, node.left
        half = isinstance(node.op, ast.Mult) and ast.unparse(node.right) == "0.5"
        if half and self.does("halve"):
            return ast.BinOp(node.left, ast.Div(), ast.Constant(2))
        return node

    def visit_Compare(self, node: ast.Compare) -> ast.AST:
        self.generic_visit(node)
        flipped = FLIPPED.get(type(node.ops[0]))
        if len(node.ops) == 1 and flipped and self.does("flip comparisons"):
            return ast.Compare(node.comparators[0], [flipped()], [node.left])
        return node

    def visit_AugAssign(self, node: ast.AugAssign) -> ast.AST:
        self.generic_visit(node)
        if self.does("expand +="):
            read = ast.parse(ast.unparse(node.target), mode="eval").body
            return ast.Assign([node.target], ast.BinOp(read, node.op, node.value), lineno=1)
        return node

    def visit_Constant(self, node: ast.Constant) -> ast.AST:
        value = node.value
        whole = isinstance(value, float) and abs(value) < 1e9 and value == int(value)
        return ast.Constant(int(value)) if whole and self.does("whole numbers") else node

    def visit_JoinedStr(self, node: ast.JoinedStr) -> ast.AST:
        return node

    def parted(self, body: Body) -> Body:
        """Split the statements of a body into smaller ones, as this student would."""
        out: Body = []
        for i, statement in enumerate(body):
            for field in ("body", "orelse"):
                if isinstance(getattr(statement, field, None), list):
                    setattr(statement, field, self.parted(getattr(statement, field)))
            ended = self.ended(statement, body[i + 1 :])
            if ended is not None:
                return [*out, *ended]
            value = getattr(statement, "value", None)
            if isinstance(value, (ast.Call, ast.BinOp)):
                if self.does("name parts"):
                    out += self.named_parts(value)
                if isinstance(statement, ast.Return) and self.does("name results"):
                    name = self.rng.choice(["result", "answer", "value"])
                    out.append(assigned(name, value))
                    statement.value = ast.Name(name, ast.Load())
            out.append(statement)
        return out

    def ended(self, statement: ast.stmt, rest: Body) -> Body | None:
        """Return another form of a body's end in which an if returns, or None to keep the end."""
        match statement, rest:
            case ast.If(body=[ast.Return(value=ast.expr() as a)], orelse=[]), [
                ast.Return(value=ast.expr() as b)
            ] if self.does("ternary"):
                return [ast.Return(ast.IfExp(statement.test, a, b))]
            case ast.If(body=[*_, ast.Return()], orelse=[]), [_, *_] if self.does("else"):
                statement.orelse = self.parted(rest)
                if self.does("negate"):
                    statement.test = ast.UnaryOp(ast.Not(), statement.test)
                    statement.body, statement.orelse = statement.orelse, statement.body
                return [statement]
        return None

    def named_parts(self, value: ast.Call | ast.BinOp) -> Body:
        """Give names to the parts of an expression.

        Return the statements that must come before it.
        """
        before: Body = []

        def named(part: ast.expr) -> ast.expr:
            if isinstance(part, ast.Call) or len([*ast.walk(part)]) > 6:
                name = f"part{self.rng.randrange(1000)}"
                if not isinstance(part, (ast.Starred, ast.GeneratorExp, ast.Lambda)):
                    before.append(assigned(name, part))
                    return ast.Name(name, ast.Load())
            return part

        if isinstance(value, ast.Call):
            value.args = [named(argument) for argument in value.args]
        else:
            value.left, value.right = named(value.left), named(value.right)
        return before


def disguised(source: str, rng: Random, parameters: Iterable[str] = ()) -> str:
    """Return a body whose variables are renamed, whose statements are reordered, and so on.

    Comments are changed as well.
    """
    return written(renamed(reordered(parsed(source), rng), rng, parameters), rng)


def renamed(body: Body, rng: Random, parameters: Iterable[str]) -> Body:
    """Rename the local variables of a body, but not its parameters."""
    nodes = [node for statement in body for node in ast.walk(statement)]
    names = [node for node in nodes if isinstance(node, ast.Name)]
    used = {name.id for name in names} | {*dir(builtins)}
    free = [name for name in NAMES.split() if name not in used]
    rng.shuffle(free)
    stored = {name.id for name in names if isinstance(name.ctx, ast.Store)}
    local = sorted(stored - {*parameters})
    new = dict(zip(local, free, strict=False))
    for name in names:
        name.id = new.get(name.id, name.id)
    return body


def reordered(body: Body, rng: Random) -> Body:
    """Swap most pairs of neighboring statements that do not depend on each other."""
    body = [*body]
    for i in range(len(body) - 1):
        if independent(body[i], body[i + 1]) and rng.random() < 0.7:
            body[i], body[i + 1] = body[i + 1], body[i]
    for statement in body:
        for field in ("body", "orelse"):
            if isinstance(getattr(statement, field, None), list):
                setattr(statement, field, reordered(getattr(statement, field), rng))
    return body


def independent(one: ast.stmt, other: ast.stmt) -> bool:
    if not all(isinstance(statement, (ast.Assign, ast.AugAssign)) for statement in (one, other)):
        return False
    return not (targets(one) & names_in(other) or targets(other) & names_in(one))


def targets(statement: ast.stmt) -> set[str]:
    found = getattr(statement, "targets", None) or [getattr(statement, "target", None)]
    parts = [part for target in found for part in getattr(target, "elts", [target])]
    return {ast.unparse(part) for part in parts}


def names_in(statement: ast.stmt) -> set[str]:
    nodes = ast.walk(statement)
    return {ast.unparse(node) for node in nodes if isinstance(node, (ast.Name, ast.Attribute))}


def inlined(body: Body) -> Body:
    """Replace variables that are used once, in the next statement, by their values."""
    out = [*body]
    i = 0
    while i < len(out) - 1:
        match out[i]:
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                uses = [named(statement, name) for statement in out]
                if sum(uses) == 2 and uses[i + 1] == 1 and hasattr(out[i + 1], "value"):
                    out[i + 1] = Replaced({name: value}).visit(out[i + 1])
                    del out[i]
                    continue
        i += 1
    return out


def hoisted(body: Body) -> Body:
    """Store attributes of self that are read several times, and never set, in local variables."""
    nodes = [node for statement in body for node in ast.walk(statement)]
    own = [n for n in nodes if isinstance(n, ast.Attribute) and ast.unparse(n.value) == "self"]
    called = {id(node.func) for node in nodes if isinstance(node, ast.Call)}
    spoiled = {n.attr for n in own if not isinstance(n.ctx, ast.Load) or id(n) in called}
    counts = [node.attr for node in own]
    names = sorted({attr for attr in counts if counts.count(attr) > 1} - spoiled)
    head = [assigned(f"own_{name}", ast.parse(f"self.{name}", mode="eval").body) for name in names]
    new: dict[str, ast.expr] = {
        f"self.{name}": ast.Name(f"own_{name}", ast.Load()) for name in names
    }
    return [*head, *(Replaced(new).visit(statement) for statement in body)]


class Replaced(ast.NodeTransformer):
    """Replaces names, or attributes of self, by expressions."""

    def __init__(self, new: dict[str, ast.expr]) -> None:
        self.new = new

    def visit_Name(self, node: ast.Name) -> ast.AST:
        return self.new.get(node.id, node) if isinstance(node.ctx, ast.Load) else node

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        return self.new.get(ast.unparse(node)) or self.generic_visit(node)


def named(statement: ast.stmt, name: str) -> int:
    nodes = ast.walk(statement)
    return sum(isinstance(node, ast.Name) and node.id == name for node in nodes)


def assigned(name: str, value: ast.expr) -> ast.Assign:
    return ast.Assign([ast.Name(name, ast.Store())], value, lineno=1)


def parsed(source: str) -> Body:
    (function,) = ast.parse("def f():\n" + textwrap.indent(source, "    ")).body
    assert isinstance(function, ast.FunctionDef)
    return function.body


def written(body: Iterable[ast.stmt], rng: Random) -> str:
    """Return the source code of a body, with a few comments added."""
    lines: list[str] = []
    for statement in body:
        if rng.random() < 0.2:
            lines.append(rng.choice(REMARKS))
        lines.append(ast.unparse(ast.fix_missing_locations(statement)))
    return "\n".join(lines)
