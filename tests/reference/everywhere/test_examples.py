"""The examples in the docstrings of solutions/, including the book's own numbers, are correct."""

from __future__ import annotations

import doctest
import importlib
from pathlib import Path

import pytest

from autograder.manifest import ROOT

MODULES = sorted((ROOT / "solutions").glob("ch*/*.py"))


@pytest.mark.parametrize("path", MODULES, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_the_docstring_examples_hold(path: Path) -> None:
    module = importlib.import_module(f"{path.parent.name}.{path.stem}")
    assert module.__file__ == str(path)
    result = doctest.testmod(module)
    assert result.failed == 0
