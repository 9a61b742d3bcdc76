"""What holds before any of these tests is read, and the class that most tests of grading use."""

from __future__ import annotations

import signal
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import settings

if TYPE_CHECKING:
    from small_class import SmallClass

settings.register_profile("long", max_examples=3000)

# Under nohup an interrupt is ignored, and would be by all that the tests start and interrupt.
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """Return a repository with a single small chapter."""
    from small import make_root  # tests/helpers/ is on the path only once pytest is configured

    return make_root(tmp_path / "root")


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    from small_class import make_class

    return make_class(tmp_path / "class")


@pytest.fixture
def small(
    tmp_path: Path, submissions: Path, root: Path, capsys: pytest.CaptureFixture[str]
) -> SmallClass:
    """Return the class above, with its repository and a place for its grades."""
    from small_class import SmallClass

    return SmallClass(tmp_path, submissions, root, capsys)
