"""Fixtures with the reference's plots. All processes of a run share the work of drawing them."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from autograder.manifest import load_chapters

PATIENCE = 600.0  # s to wait for another process's plots; the longest chapter takes a minute or so


@pytest.fixture(scope="session")
def drawn(
    tmp_path_factory: pytest.TempPathFactory, worker_id: str, pytestconfig: pytest.Config
) -> tuple[Path, str]:
    """Draw the reference's plots. Return their folder and what the commands printed.

    Each process draws the chapters that no other process has begun. The last chapters are drawn
    first, because they take the longest.
    """
    from drawn_plots import plot  # tests/helpers/ is on the path only once pytest is configured

    alone = worker_id == "master"
    base = tmp_path_factory.getbasetemp()
    out = (base if alone else base.parent) / "plots"
    out.mkdir(exist_ok=True)
    only = pytestconfig.getoption("chapter", None)  # set by make test CH=6
    numbers = sorted((chapter.number for chapter in load_chapters()), reverse=True)
    numbers = [only] if only in numbers else numbers
    for number in numbers:
        try:
            (out / f"{number}.begun").touch(exist_ok=False)
        except FileExistsError:
            continue
        done = plot("solutions", out, str(number))
        told = done.stdout if done.returncode == 0 else f"{done.stdout}{done.stderr}FAILED"
        (out / f"{number}.telling").write_text(told, encoding="utf-8")
        (out / f"{number}.telling").rename(out / f"{number}.told")
    end = time.monotonic() + PATIENCE
    while not all((out / f"{number}.told").exists() for number in numbers):
        assert time.monotonic() < end, "another process has not drawn its plots"
        time.sleep(0.1)
    told = "".join((out / f"{number}.told").read_text(encoding="utf-8") for number in numbers)
    assert "FAILED" not in told, told
    return out, told


@pytest.fixture(scope="session")
def reference(drawn: tuple[Path, str]) -> Path:
    """Return the folder with the reference's plots."""
    return drawn[0]
