"""An engine with only the book's formulas: the reference without its argument checks."""

from __future__ import annotations

import ast
import shutil
from pathlib import Path

from autograder.handouts.stubs import with_bodies
from autograder.manifest import ROOT, load_chapters

# Replaces arguments.py. Every function returns its argument without checking it.
ARGUMENTS = """
def finite(name, value):
    return float(value)


not_negative = positive = positive_or_infinite = finite


def whole(name, value):
    return value


def finite_vector(name, v):
    return v.copy()


def instance_of(name, value, kind):
    return value
"""

# Simple versions of functions that handle NaN, or huge and tiny numbers, with special care.
BODIES = {
    "ch05_forces": {
        "forces.InverseSquareGravity.update_force": """
if particle.has_finite_mass:
    way = self.center - particle.position
    particle.add_force(way * (particle.mass * self.mu / way.magnitude() ** 3))
""",
        "closed_form.quadratic_fall": """
u = terminal_speed(mass * gravity, 0.0, k2)
x = gravity * time / u
ln_cosh = math.log(math.cosh(x)) if x > 1.0 else math.log1p(2.0 * math.sinh(x / 2.0) ** 2)
return u * math.tanh(x), u * u / gravity * ln_cosh
""",
        "closed_form.coasting_speed": """
s = k1 * time / mass
gained = math.expm1(s) / k1 if s else time / mass
return speed / (math.exp(s) + k2 * speed * gained)
""",
    },
    "ch06_springs": {
        "closed_form.damped_spring_state": """
half, chi = damping / (2.0 * mass), math.sqrt(stiffness / mass)
gamma = math.sqrt(abs(half - chi)) * math.sqrt(half + chi)
fade = math.exp(-half * time)
stay, swing = fade, fade * time
if half < chi:
    stay, swing = fade * math.cos(gamma * time), fade * math.sin(gamma * time) / gamma
elif half > chi:
    stay, swing = fade * math.cosh(gamma * time), fade * math.sinh(gamma * time) / gamma
x, v = x0 * (stay + half * swing) + v0 * swing, v0 * (stay - half * swing) - x0 * chi**2 * swing
return x, v
""",
        "integrators.watched": """
steps = 0

def step(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    nonlocal steps
    integrator(particles, apply_forces, duration)
    steps += 1
    for i, particle in enumerate(particles):
        speed = particle.velocity.magnitude()
        if speed > speed_limit:
            raise SimulationDiverged(i, steps, speed, speed_limit)

return step
""",
        "springs.max_stable_stiffness": """
if damping == 0.0:
    return math.inf
return max(0.0, mass * math.expm1(-duration * math.log(damping)) / duration**2)
""",
    },
    "ch09_rotations": {
        "matrix3.Matrix3.is_rotation": """
identity = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
for got, wanted in zip(self.product(self.transpose()), identity, strict=True):
    if abs(got - wanted) > ROTATION_TOLERANCE:
        return False
return not self.determinant() < 0.0
"""
    },
}


class _Unguarded(ast.NodeTransformer):
    """Removes the argument checks from a module, and the protection of lengths against overflow."""

    def visit_If(self, node: ast.If) -> ast.AST:
        """Remove an "if" that only raises ValueError or TypeError, or returns NotImplemented."""
        self.generic_visit(node)
        if not node.orelse and len(node.body) == 1 and _refuses(node.body[0]):
            return ast.Pass()
        return node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Replace math.hypot(x, y) by the square root of x * x + y * y."""
        self.generic_visit(node)
        if ast.unparse(node.func) != "math.hypot":
            return node
        squares = " + ".join(f"({part}) * ({part})" for part in map(ast.unparse, node.args))
        return ast.parse(f"math.sqrt({squares})", mode="eval").body


def _refuses(statement: ast.stmt) -> bool:
    if isinstance(statement, ast.Raise) and isinstance(statement.exc, ast.Call):
        return ast.unparse(statement.exc.func) in ("ValueError", "TypeError")
    return ast.unparse(statement) == "return NotImplemented"


def plain(source: str) -> str:
    return ast.unparse(ast.fix_missing_locations(_Unguarded().visit(ast.parse(source))))


def write_plain_engine(engine: Path) -> list[Path]:
    """Write every module that students hand in without argument checks. Return the engine."""
    for chapter in load_chapters():
        source, folder = ROOT / "solutions" / chapter.name, engine / chapter.name
        folder.mkdir(parents=True)
        for file in chapter.edited_files:
            prefix = file.removesuffix(".py") + "."
            simple = BODIES.get(chapter.name, {}).items()
            bodies = {name.removeprefix(prefix): b for name, b in simple if name.startswith(prefix)}
            text = with_bodies((source / file).read_bytes(), bodies).decode()
            (folder / file).write_text(plain(text), encoding="utf-8")
        for file in chapter.data_files:
            shutil.copyfile(source / file, folder / file)
    (engine / "ch02_vectors/arguments.py").write_text(ARGUMENTS, encoding="utf-8")
    return [engine, ROOT / "solutions", ROOT / "chapters"]
