"""The current stubs, which are read from chapters/ because generating them takes seconds."""

from __future__ import annotations

from functools import cache

from autograder.handouts.stubs import complete_hashes, read_lock, stub_hash
from autograder.manifest import ROOT


@cache
def made_stubs() -> dict[str, str]:
    """Return the text of every stub by its path. Each must have its hash in the lock."""
    lock = read_lock()
    paths = lock.keys() - complete_hashes().keys()
    stubs = {path: (ROOT / path).read_text(encoding="utf-8") for path in sorted(paths)}
    changed = [path for path, text in stubs.items() if stub_hash(text) != lock[path]]
    assert changed == [], "make update writes these again"
    return stubs
