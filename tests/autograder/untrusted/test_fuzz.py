"""Submissions that nobody would think of: every check has a verdict, and every loss a sentence.

To draw more of them, add --hypothesis-profile=long.
"""

from __future__ import annotations

import ast
import re
import tempfile
from functools import partial
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from autograder.checks.presentable import LONGEST_MESSAGE
from autograder.checks.runner import Limits, run_checks
from autograder.checks.verdict import with_needs
from autograder.definitions import functions
from autograder.manifest import ROOT, Chapter, load_chapters
from walls import behind_walls
from wrong import Wrong, write_wrong

CHAPTERS = load_chapters()
LONG = settings.get_current_profile_name() == "long"
# Whatever JSON can hold, and more: numbers without end, no numbers, half characters, tuples.
plain = st.recursive(
    st.none() | st.booleans() | st.integers() | st.just(10**400) | st.floats() | st.text(),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.tuples(inner, inner, inner)
        | st.dictionaries(st.text(max_size=5), inner, max_size=3)
    ),
    max_leaves=6,
)
ERRORS = """
ValueError AssertionError KeyError StopIteration SystemExit KeyboardInterrupt MemoryError
RecursionError NotImplementedError BaseException GeneratorExit OSError UnicodeError
"""
OTHER = [
    "return self",
    "return object()",
    "return lambda *arguments: 1.0",
    "return (number for number in (1.0, 2.0))",
    "return type('Vector3', (), {'x': 1.0, 'y': 2.0, 'z': 3.0})()",
    "return Ellipsis",
    "return b'1.0'",
    "yield 1.0",
    "return __import__('sys')",
    "globals().clear()",
    "return nothing_of_this_name",
    "class Own(Exception): __str__ = None\nraise Own",
    "class Own(float): __eq__ = __lt__ = __repr__ = None\nreturn Own(1.0)",
    "class Own(tuple): __len__ = __iter__ = None\nreturn Own((1.0, 2.0, 3.0))",
    "assert False, 'got 1 wanted 1'",
]
bodies = (
    plain.map(lambda value: f"nan, inf = float('nan'), float('inf')\nreturn {value!a}")
    | st.tuples(st.sampled_from(ERRORS.split()), st.text(max_size=50)).map(
        lambda drawn: f"raise {drawn[0]}({drawn[1]!a})"
    )
    | st.sampled_from(OTHER)
)


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
@settings(
    max_examples=(2 * settings.default.max_examples if LONG else 64) // len(CHAPTERS),
    derandomize=not LONG,
    deadline=None,
    suppress_health_check=list(HealthCheck),
)
@given(data=st.data())
def test_any_result_any_error_and_any_damage_to_a_file(
    chapter: Chapter, data: st.DataObject
) -> None:
    """Every check has a verdict of the student's, and whoever loses it reads why."""
    exercise = data.draw(st.sampled_from([e for e in chapter.exercises if e.edit]))
    damage = data.draw(st.sampled_from([lines_gone, renamed, other_parameters, odd_bytes]))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if data.draw(st.booleans(), label="the file is damaged"):
            file = f"{chapter.name}/{exercise.edit[0].split('.')[0]}.py"
            source = (ROOT / "solutions" / file).read_text(encoding="utf-8")
            (folder / chapter.name).mkdir()
            (folder / file).write_bytes(damage(data, source))
        else:
            drawn = {edit: data.draw(bodies, label=edit) for edit in exercise.edit}
            wrongs = [Wrong(edit, "", "", body=body) for edit, body in drawn.items()]
            write_wrong(chapter, wrongs, folder)
        engine = [folder, ROOT / "solutions", ROOT / "chapters"]
        limited = partial(run_checks, sandbox=behind_walls(), limits=Limits(1.0))
        verdicts = limited(chapter, engine, seed="1", exercises=[exercise.id])
    assert {verdict.exercise for verdict in verdicts} == {*with_needs(chapter, [exercise.id])}
    for verdict in verdicts:
        assert verdict.status in ("passed", "failed", "blocked"), verdict
        if verdict.status != "passed":
            assert re.search(r"\w+ \w+", str(verdict.message)), verdict
            assert len(str(verdict.message)) <= LONGEST_MESSAGE + 100
            assert "Traceback" not in str(verdict.message)


def lines_gone(data: st.DataObject, source: str) -> bytes:
    lines = source.splitlines(keepends=True)
    start = data.draw(st.integers(0, len(lines) - 1))
    return "".join(lines[:start] + lines[start + data.draw(st.integers(1, 20)) :]).encode()


def renamed(data: st.DataObject, source: str) -> bytes:
    names = sorted(set(re.findall(r"\b[a-zA-Z_]\w*\b", source)))
    old, new = (data.draw(st.sampled_from(names)) for _ in range(2))
    return re.sub(rf"\b{old}\b", new, source).encode()


def other_parameters(data: st.DataObject, source: str) -> bytes:
    tree = ast.parse(source)
    found = functions(tree)
    parameters = found[data.draw(st.sampled_from(sorted(found)))].args
    if data.draw(st.booleans()):
        parameters.args.append(ast.arg("one_more"))
    elif parameters.args:
        parameters.args.pop(data.draw(st.integers(0, len(parameters.args) - 1)))
    parameters.defaults.clear()
    return ast.unparse(tree).encode()


def odd_bytes(data: st.DataObject, source: str) -> bytes:
    code = source.encode()
    at = data.draw(st.integers(0, len(code)))
    return code[:at] + data.draw(st.binary(min_size=1, max_size=8)) + code[at:]
