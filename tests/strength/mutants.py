"""Mutants of the reference: bodies with one operator or number changed, which checks should notice.

A survivor is as right as the reference, which survivors/ then explains, or a mistake that no check
notices. It runs again if any check has changed, and others if the check that killed them has.
"""

from __future__ import annotations

import ast
import hashlib
import json
import re
import tomllib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from queue import Queue

from cosmic_ray import plugins
from cosmic_ray.ast import ast_nodes, get_ast
from cosmic_ray.mutating import mutate_code
from rich.console import Console
from rich.progress import track

from autograder.checks.arrange import shared_by_checks
from autograder.definitions import functions
from autograder.manifest import ROOT, Chapter
from fingerprint import fingerprint
from kept import FOLDER, keep_mutants
from ready import Ready
from wrong import Wrong, body_of

SHARE = 0.97  # least fraction killed of the mutants that differ from the reference
# Shifts, bits and matrix products fail on every float, so they do not test a check. Nor does "is".
IMPLAUSIBLE = re.compile("BitAnd|BitOr|BitXor|Shift|MatMult|Invert|Is")
SEED = "1"
Change = tuple[str, str, str]  # a body, one of its lines and what it became, without spaces


@dataclass(frozen=True)
class Mutant:
    """A module of the reference with one change in a body that students write."""

    file: str
    edit: str  # the name of the body in the manifest
    line: str  # the original line, without its indent
    became: str
    code: str  # the source of the whole module

    @property
    def key(self) -> str:
        return hashlib.sha256(f"{self.file}\n{self.code}".encode()).hexdigest()

    @property
    def change(self) -> Change:
        return (self.edit, bare(self.line), bare(self.became))


def bare(line: str) -> str:
    """Return a line without spaces, because a mutation may leave a space too many."""
    return "".join(line.split())


def mutants_of(chapter: Chapter) -> Iterator[Mutant]:
    """Yield the mutants of a chapter, file by file."""
    operators = [
        plugins.get_operator(name)
        for name in sorted(plugins.operator_names())
        if not IMPLAUSIBLE.search(name) and not plugins.get_operator(name).arguments()
    ]
    for file in chapter.edited_files:
        source = (ROOT / "solutions" / chapter.name / file).read_text(encoding="utf-8")
        lines, tree = source.splitlines(), get_ast(source)
        bodies = _bodies(chapter, file, source)
        for operator in operators:
            places = [
                start
                for node in ast_nodes(tree)
                for start, _ in operator().mutation_positions(node)
            ]
            for occurrence, (row, _) in enumerate(places):
                edit = next((e for e, (first, last) in bodies.items() if first <= row <= last), "")
                if edit:
                    code = mutate_code(source, operator(), occurrence)
                    became = code.splitlines()[row - 1]
                    if _is_python(code):
                        yield Mutant(file, edit, lines[row - 1].strip(), became.strip(), code)


def _is_python(code: str) -> bool:
    """Return whether the code can be parsed: an operator may insert "not" where it is invalid."""
    with suppress(SyntaxError):
        return bool(ast.parse(code))
    return False


def _bodies(chapter: Chapter, file: str, source: str) -> dict[str, tuple[int, int]]:
    """Return the first and last line of each body in a file that students write."""
    defined = functions(ast.parse(source))
    bodies = {}
    for edit in (edit for exercise in chapter.exercises for edit in exercise.edit):
        module, _, name = edit.partition(".")
        if f"{module}.py" == file:
            bodies[edit] = (defined[name].body[0].lineno, defined[name].end_lineno or 0)
    return bodies


def killer_of(waiting: Ready, mutant: Mutant) -> str:
    """Return the first check that a mutant does not pass, its own exercise first, or ""."""
    chapter = waiting.chapter
    (exercise,) = (e.id for e in chapter.exercises if mutant.edit in e.edit)
    waiting.clear()
    (waiting.top / chapter.name / mutant.file).write_text(mutant.code, encoding="utf-8")
    for wanted in ([exercise], [e.id for e in chapter.exercises]):
        for verdict in waiting.run([mutant.edit], wanted):
            if verdict.status != "passed":
                return verdict.name
    return ""


def run_mutants(chapter: Chapter, jobs: int, console: Console) -> bool:
    """Run a chapter's mutants that have no result yet, print the survivors, and return success."""
    mutants = {mutant.key: mutant for mutant in mutants_of(chapter)}
    FOLDER.mkdir(parents=True, exist_ok=True)
    results = FOLDER / f"mutants_{chapter.name}.jsonl"
    known = dict(_read(results, chapter))
    todo = [mutant for key, mutant in mutants.items() if key not in known]
    free: Queue[Ready] = Queue()  # the waiting processes
    for _ in range(jobs):
        free.put(Ready(chapter, SEED))

    def killer(mutant: Mutant) -> str:
        waiting = free.get()
        try:
            return killer_of(waiting, mutant)
        finally:
            free.put(waiting)

    with results.open("a", encoding="utf-8") as out, ThreadPoolExecutor(jobs) as pool:
        futures = {pool.submit(killer, mutant): mutant.key for mutant in todo}
        title = f"mutants of chapter {chapter.number}"
        try:
            for future in track(
                as_completed(futures), title, len(todo), console=console, transient=True
            ):
                key, name = futures[future], future.result()
                known[key] = name
                line = {"mutant": key, "killer": name, "checks": _state(chapter.name, name)}
                out.write(json.dumps(line) + "\n")
                out.flush()
        except BaseException:  # most often Ctrl-C: the results so far are kept
            pool.shutdown(cancel_futures=True)
            raise
    return _print_result(chapter, mutants, known, results, console)


def _read(results: Path, chapter: Chapter) -> Iterator[tuple[str, str]]:
    """Yield the mutants and killers of earlier runs that are still valid."""
    for line in results.read_text(encoding="utf-8").splitlines() if results.exists() else ():
        result = json.loads(line)
        if result["checks"] == _state(chapter.name, result["killer"]):
            yield result["mutant"], result["killer"]


@cache
def _state(chapter: str, check: str) -> str:
    """Return a hash of a check's file, or of all of the chapter's, and of shared files."""
    folder = ROOT / "tests" / chapter
    files = [*folder.glob("*probes.py"), *shared_by_checks(ROOT)]
    for file in folder.glob("test_*.py"):
        if not check or f"def {check}(" in file.read_text(encoding="utf-8"):
            files.append(file)
    return fingerprint(sorted(files))


def read_survivors(chapter: Chapter) -> Iterator[tuple[str, Change]]:
    """Yield each mutant that is known to do the same as the reference, after its reason."""
    path = Path(__file__).parent / "survivors" / f"{chapter.name}.toml"
    for reason, edits in tomllib.loads(path.read_text(encoding="utf-8")).items():
        for edit, texts in edits.items():
            before = body_of(chapter, Wrong(edit, reason, "")).splitlines()
            for old, new in ((old, new) for old, *others in texts for new in others):
                after = body_of(chapter, Wrong(edit, reason, "", [old, new])).splitlines()
                (lines,) = (pair for pair in zip(before, after, strict=True) if len({*pair}) > 1)
                yield reason, (edit, *map(bare, lines))


def _print_result(
    chapter: Chapter,
    mutants: dict[str, Mutant],
    known: dict[str, str],
    results: Path,
    console: Console,
) -> bool:
    """Print the fraction that was killed, and survivors without a reason; return success."""
    living = [mutant for key, mutant in mutants.items() if not known[key]]
    listed = {change for _, change in read_survivors(chapter)}
    unlisted = [mutant for mutant in living if mutant.change not in listed]
    others = listed - {mutant.change for mutant in living}
    for mutant in unlisted:
        change = f"{mutant.edit}\n  - {mutant.line}\n  + {mutant.became}"
        console.print(change, markup=False, soft_wrap=True)
    for edit, line, became in sorted(others):
        console.print(f"does not survive: {edit}: {line} -> {became}", markup=False)
    same = len(living) - len(unlisted)
    killed, others_of = len(mutants) - len(living), len(mutants) - same
    share = killed / others_of
    result = f"{killed} of {others_of} mutants killed, {100.0 * share:.1f} %, and {same} do the"
    result = f"chapter {chapter.number}: {result} same as the reference; {results}"
    console.print(result, markup=False, soft_wrap=True)
    keep_mutants(chapter, killed=killed, of=others_of, same=same)
    return share >= SHARE and not unlisted and not others
