"""The path of the tests stays the same, although commands of studies put the tuned engine first."""

from __future__ import annotations

import sys

import pytest


@pytest.fixture(autouse=True)
def _same_path(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "path", [*sys.path])
