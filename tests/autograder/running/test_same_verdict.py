"""What passes at home passes in grading: the same code has the same verdict, in the same words.

Beside the checks, as students run them, and behind the walls, as a class is graded.
"""

from __future__ import annotations

import importlib.metadata
import re
import shutil
import sys
from pathlib import Path

import pytest

from autograder.checks.runner import run_checks
from autograder.checks.verdict import Verdict
from autograder.manifest import ROOT, load_chapter
from small import RIGHT, make_root
from typed import typed
from walls import behind_walls

# What lies here besides the packages, and what a student may keep beside the code.
OURS = "autograder autograder.student.screen autograder.isolation.server studies plots.draw tests"
OURS += " chapters solutions expect draw lever conftest sitecustomize nowhere"
NOT_GRADED = ("ch90_small.helper", "ch90_small.test_small")
NO_MODULE = "ModuleNotFoundError: No module named "

# Code of a function body, and words of what comes of it. Each is tried in a check of its own.
ATTEMPTS = {
    "import_pytest": ("import pytest", f"{NO_MODULE}'pytest'"),
    "import_a_part": ("import numpy.linalg", f"{NO_MODULE}'numpy'"),
    "import_or_do_without": (
        "try:\n    import numpy\nexcept ImportError as error:\n    return 'without', error.name",
        "('without', 'numpy')",
    ),
    "import_by_name": ("import importlib; importlib.import_module('numpy')", f"{NO_MODULE}'numpy'"),
    "import_in_exec": ("exec('import numpy', {})", f"{NO_MODULE}'numpy'"),
    "import_relative": ("from .helper import x", f"{NO_MODULE}'ch90_small.helper'"),
    "import_from_folder": ("from ch90_small import helper", "cannot import name 'helper'"),
    "import_in_library": ("import pydoc; return pydoc.locate('numpy')", "None"),
    "import_itself": ("from ch90_small.small import double; return double(2)", "4"),
    "read_from_here": ("return open('tests/conftest.py').read()", "No such file or directory"),
    "read_not_graded": ("return open(HERE + '/notes.txt').read()", "No such file or directory"),
    "read_in_subfolder": (
        "return open(HERE + '/data/more.txt').read()",
        "No such file or directory",
    ),
    "read_beside_chapters": ("return open(HERE + '/../notes.txt').read()", "No such file"),
    "list_subfolder": ("import os; return os.listdir(HERE + '/data')", "No such file or directory"),
    "read_nowhere": ("return open('/nowhere/notes.txt').read()", "PermissionError: [Errno 13]"),
    "write_nowhere": ("open('/nowhere/notes.txt', 'w')", "PermissionError: [Errno 13]"),
    "read_own": ("return len(open(__file__).read()) > 100", "True"),
    "read_others": ("return open('/etc/passwd').read()", "PermissionError: [Errno 13]"),
    "write": ("open('/tmp/written-by-a-student', 'w')", "PermissionError: [Errno 13]"),
    "write_own": ("open(__file__, 'a')", "PermissionError: [Errno 13]"),
    "make_folder": ("import os; os.mkdir('/tmp/made-by-a-student')", "PermissionError: [Errno 1]"),
    "remove": ("import os; os.remove(__file__)", "PermissionError: [Errno 1]"),
    "rename": ("import os; os.rename(__file__, __file__ + '2')", "PermissionError: [Errno 1]"),
    "list": ("import os; return os.listdir('/tmp')", "PermissionError: [Errno 13]"),
    "temporary": ("import tempfile; tempfile.TemporaryFile()", "No usable temporary directory"),
    "run": ("import subprocess; subprocess.run(['true'])", "PermissionError: [Errno 1]"),
    "clear_screen": ("import os; return os.system('clear')", "32512"),
    "fork": ("import os; os.fork()", "PermissionError: [Errno 1]"),
    "thread": ("import threading; threading.Thread(target=int).start()", "can't start new thread"),
    "socket": ("import socket; socket.socket()", "PermissionError: [Errno 1]"),
    "name": ("import socket; socket.getaddrinfo('example.org', 80)", "gaierror"),
    "signal": ("import os; os.kill(os.getpid(), 0)", "PermissionError: [Errno 1]"),
    "type": ("return input()", "EOFError: EOF when reading a line"),
    "stop": ("exit()", "SystemExit"),
    "help": ("return help.__class__.__name__", "_Helper"),
    "where": ("import os; return os.getcwd()", "'/'"),
    "arguments": ("import sys; return sys.argv, sys.orig_argv", "([''], [])"),
    "user": ("import os; return os.environ['HOME']", "KeyError: 'HOME'"),
    "encoding": ("return open(__file__).encoding.lower()", "'utf-8'"),
    "much_memory": ("return len(bytearray(350 << 20))", "367001600"),
    "too_much_memory": ("return len(bytearray(560 << 20))", "MemoryError"),
    "deep": ("def f(n): return n and 1 + f(n - 1)\nreturn f(950)", "950"),
    "too_deep": ("def f(n): return n and 1 + f(n - 1)\nreturn f(1050)", "RecursionError"),
    "deeper": (
        "import sys\nsys.setrecursionlimit(10**5)\ndef f(n): return n and 1 + f(n - 1)\n"
        "return f(5000)",
        "5000",
    ),
    "count": ("global COUNT\nCOUNT += 1\nreturn COUNT", "1"),
    "count_again": ("global COUNT\nCOUNT += 1\nreturn COUNT", "1"),
    "change_built_in": ("import builtins\nbuiltins.abs = str\nreturn abs(-1)", "'-1'"),
    "use_built_in": ("return abs(-1)", "1"),
    "print": ("print('here', 1.5)", "printed   here 1.5"),
    "print_much": ("print('x' * 10**6)", f"printed   {'x' * 2000}"),
    "print_error": ("import sys; print('there', file=sys.stderr)", "printed   there"),
    "print_odd": ("print('\\ud800')", r"printed   \ud800"),
    "import_numbers": (
        "import cmath, fractions, statistics\n"
        "return cmath.sqrt(-1), fractions.Fraction(1, 3), statistics.mean([1, 2])",
        "(1j, Fraction(1, 3), 1.5)",
    ),
    "import_tests": ("from tests.shared.expect import expect_close", f"{NO_MODULE}'tests'"),
    "import_for_types": (
        "import typing\nif typing.TYPE_CHECKING: import numpy\nreturn typing.TYPE_CHECKING",
        "False",
    ),
    "import_relative_own": ("from .small import double; return double(3)", "6"),
    "import_from_path": (
        "import sys; sys.path.append(HERE); import helper; return helper.x",
        f"{NO_MODULE}'helper'",
    ),
    "own_name": ("return __name__", "ch90_small.small"),
    "read_data": ("return open(HERE + '/drops.csv').read()", "1,2"),
    "read_with_pathlib": (
        "from pathlib import Path; return Path(__file__).with_name('drops.csv').read_text()",
        "1,2",
    ),
    "write_nothing": ("import os; open(os.devnull, 'w')", "PermissionError: [Errno 13]"),
    "read_nothing": ("import os; open(os.devnull)", "PermissionError: [Errno 13]"),
    "inspect": ("import inspect; return inspect.getsource(double)", "return x + x"),
    "asyncio": (
        "import asyncio\nasync def f(): return 3\nreturn asyncio.run(f())",
        "PermissionError: [Errno 1]",
    ),
    "thread_pool": (
        "from concurrent.futures import ThreadPoolExecutor as P; P().submit(int).result()",
        "can't start new thread",
    ),
    "lock": ("import threading\nwith threading.Lock(): return 'held'", "held"),
    "queue": ("import queue; q = queue.Queue(); q.put(1); return q.get()", "1"),
    "logging": ("import logging; logging.warning('odd')", "printed   WARNING:root:odd"),
    "warning": ("import warnings; warnings.warn('odd')", "UserWarning: odd"),
    "print_trace": (
        "import traceback\ntry: 1 / 0\nexcept ZeroDivisionError: traceback.print_exc()",
        "ZeroDivisionError: division by zero",
    ),
    "print_bytes": ("import sys; sys.stdout.buffer.write(b'x')", "AttributeError"),
    "leave_with_code": ("import sys; sys.exit(3)", "SystemExit: 3"),
    "interrupt": ("raise KeyboardInterrupt('now')", "KeyboardInterrupt: now"),
    "catch_everything": (
        "import sys\ntry: sys.exit()\nexcept BaseException as error: return repr(error)",
        "SystemExit()",
    ),
    "at_exit": ("import atexit; atexit.register(print, 'bye'); return 'later'", "later"),
    "random": ("import random; return random.Random(3).random(), random.seed(1)", "0.2379"),
    "time": ("import time; time.sleep(0.01); return time.perf_counter() > 0", "True"),
    "dataclass": (
        "from dataclasses import dataclass\n@dataclass(slots=True)\nclass P: x: float = 1.0\n"
        "return P(2.0)",
        "P(x=2.0)",
    ),
    "cache": (
        "import functools\n@functools.cache\ndef f(n): return n if n < 2 else f(n - 1) + f(n - 2)\n"
        "return f(90), f.cache_info().hits",
        "(2880067194370816120, 88)",
    ),
    "generator": ("g = (n for n in range(2)); return [*g], next(g, 'none')", "([0, 1], 'none')"),
    "context": (
        "import contextlib\n@contextlib.contextmanager\ndef f(): yield 3\nwith f() as n: return n",
        "3",
    ),
    "metaclass": (
        "class M(type):\n    def __call__(_): return 'made'\nclass C(metaclass=M): 1\nreturn C()",
        "made",
    ),
    "slots": ("class C:\n    __slots__ = ('x',)\nC().y = 1", "no attribute 'y'"),
    "replace_itself": (
        "import sys; sys.modules[__name__].quadruple = lambda x: 7; return quadruple(1)",
        "7",
    ),
    "doctest": (
        "import doctest\ndef f(): '>>> 1 + 1\\n3'\ndoctest.run_docstring_examples(f, {})",
        "printed   *****",
    ),
    "set_variable": ("import os; os.environ['A'] = 'b'; return os.getenv('A')", "'b'"),
    "signal_handler": ("import signal; return signal.signal(signal.SIGUSR2, print)", "Handlers"),
    "processes": ("import multiprocessing as m; m.Process(target=int).start()", "Errno 1]"),
    "trace": ("import sys; sys.settrace(lambda *_: None); sys.settrace(None); return 1", "1"),
    "collect": ("import gc, weakref; gc.collect(); return weakref.ref(double)() is double", "True"),
    "copy": ("import copy, pickle; return copy.deepcopy(pickle.loads(pickle.dumps([1])))", "[1]"),
    "huge_number": ("return len(str(10**5000))", "ValueError: Exceeds the limit"),
    "database": ("import sqlite3; return sqlite3.connect(':memory:')", ""),
    "random_bytes": ("import secrets; return len(secrets.token_hex(4))", "8"),
    "leave": ("import os; os._exit(3)", "with exit code 3"),
    "crash": ("import ctypes; ctypes.string_at(0)", "Python crashed"),
}
MODULE = """
import os

HERE = os.path.dirname(__file__)
COUNT = 0
print("imported")


def double(x):
    return x + x


def quadruple(x):
    return 4 * x


def try_(name):
    try:
        return repr(globals()["try_" + name]())
    except BaseException as error:
        return f"{type(error).__name__}: {error}"


def imports(names):
    odd = []
    for name in names:
        for code in (f"import {name}", f"__import__('importlib').import_module({name!r})"):
            try:
                exec(code, globals())
                odd.append((code, "imported"))
            except ModuleNotFoundError as error:
                wanted = name if name.startswith("ch90") else name.partition(".")[0]
                if str(error) != f"No module named {wanted!r}" or error.name != wanted:
                    odd.append((code, str(error)))
    return odd
"""


def installed() -> list[str]:
    """Every package and module of .venv that Python's own library does not have."""
    names = {name for name in importlib.metadata.packages_distributions() if name.isidentifier()}
    return [*sorted({*names, *OURS.split()} - sys.stdlib_module_names), *NOT_GRADED]


def both_ways(root: Path, code: str) -> tuple[dict[str, Verdict], dict[str, Verdict]]:
    """Return the verdicts beside the checks, and behind walls on what a grader takes."""
    chapter = load_chapter(root / "chapters/ch90_small")
    home, graded = root / "home", root / "graded"
    for engine in (home, graded):
        shutil.rmtree(engine, ignore_errors=True)
        (engine / "ch90_small").mkdir(parents=True)
        (engine / "ch90_small/small.py").write_text(code, encoding="utf-8")
        (engine / "ch90_small/drops.csv").write_text("1,2", encoding="utf-8")
    (home / "ch90_small/helper.py").write_text("x = 1\n", encoding="utf-8")
    (home / "ch90_small/data").mkdir()
    for name in ("ch90_small/notes.txt", "ch90_small/data/more.txt", "notes.txt"):
        (home / name).write_text("mine\n", encoding="utf-8")
    beside = run_checks(chapter, [home], seed="1", root=root)
    behind = run_checks(chapter, [graded], seed="1", root=root, sandbox=behind_walls())
    return (
        {verdict.name: verdict for verdict in beside},
        {verdict.name: verdict for verdict in behind},
    )


def told(verdict: Verdict) -> tuple[str, str]:
    return verdict.status, str(verdict.message)


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small chapter with a check for each attempt, which fails with what came of it."""
    root = make_root(tmp_path_factory.mktemp("same"))
    manifest = root / "chapters/ch90_small/chapter.toml"
    text = manifest.read_text(encoding="utf-8")
    manifest.write_text(
        text.replace("edit =", 'files = ["drops.csv"]\nedit =', 1), encoding="utf-8"
    )
    checks = ["import pytest", "from ch90_small.small import imports, try_"]
    for name in ATTEMPTS:  # what is left behind is gone in the next exercise
        exercise = "90.1" if name in ("count_again", "use_built_in") else "B90.1"
        checks += [f"@pytest.mark.exercise('{exercise}')", f"def test_{name}():"]
        checks += [f"    pytest.fail(try_({name!r}))"]
    checks += ["@pytest.mark.exercise('B90.1')", "def test_imports():"]
    checks += [f"    assert imports({installed()!r}) == []"]
    (root / "tests/ch90_small/test_attempts.py").write_text("\n".join(checks), encoding="utf-8")
    return root


@pytest.fixture(scope="module")
def verdicts(root: Path) -> tuple[dict[str, Verdict], dict[str, Verdict]]:
    """What came of every attempt, both ways."""
    if not behind_walls().level["seccomp"]:
        pytest.skip("there are no walls here that refuse all of it")
    code = MODULE
    for name, (body, _) in ATTEMPTS.items():
        code += f"\n\ndef try_{name}():\n" + re.sub("(?m)^", "    ", body) + "\n"
    return both_ways(root, code)


@pytest.mark.parametrize("name", ATTEMPTS)
def test_an_attempt_comes_to_the_same(
    name: str, verdicts: tuple[dict[str, Verdict], dict[str, Verdict]]
) -> None:
    home, graded = (verdicts_of[f"test_{name}"] for verdicts_of in verdicts)
    assert ATTEMPTS[name][1] in str(graded.message)
    assert told(home) == told(graded)


def test_every_package_is_refused_in_pythons_own_words(
    verdicts: tuple[dict[str, Verdict], dict[str, Verdict]],
) -> None:
    assert {"numpy", "scipy", "pytest", "rich", "autograder"} <= {*installed()}
    for verdicts_of in verdicts:
        verdict = verdicts_of["test_imports"]
        assert verdict.status == "passed", verdict.message


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("import numpy", "likely .*only Python.s standard library"),
        ("from expect import expect_close", "likely .*only Python.s standard library"),
        ("from ch90_small.helper import x", "No module named 'ch90_small.helper'"),
        ("import ch91_nowhere.thing", "No module named 'ch91_nowhere'"),
        ("open('/tmp/written-by-a-student', 'w')", "likely .*should only compute"),
    ],
)
def test_a_module_that_asks_for_it_is_told_the_same(line: str, words: str, tmp_path: Path) -> None:
    root = make_root(tmp_path)
    home, graded = both_ways(root, f"{line}\n{RIGHT}")
    assert [told(home[name]) for name in home] == [told(graded[name]) for name in graded]
    assert re.search(words, str(home["test_double"].message))


def test_a_plot_and_a_scene_refuse_what_a_check_refuses(tmp_path: Path) -> None:
    vector = tmp_path / "ch02_vectors/vector.py"
    vector.parent.mkdir()
    source = (ROOT / "solutions/ch02_vectors/vector.py").read_text(encoding="utf-8")
    vector.write_text(
        source.replace("import math\n", "import math\nimport numpy\n"), encoding="utf-8"
    )
    for arguments in (["plots", "draw", "--chapter", "2"], ["lab", "record", "ball-game"]):
        done = typed(*arguments, "--engine", tmp_path)
        assert "No module named 'numpy' (" in done.stdout
        assert "vector.py, line" in done.stdout
        assert "only Python's standard library" in done.stdout
