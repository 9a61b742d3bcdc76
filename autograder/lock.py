"""The lock of stubs: a hash of every file that students start from, as it was made."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from autograder.manifest import ROOT

LOCK_NAME = "stubs.lock"


def stub_hash(text: str) -> str:
    """Return the hash that stubs.lock keeps of a stub."""
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def read_lock(root: Path = ROOT) -> dict[str, str]:
    """Return the hash of each stub as it was last made, by its path; empty without a lock."""
    path = root / LOCK_NAME
    if not path.exists():
        return {}
    hashes: dict[str, str] = json.loads(path.read_text(encoding="utf-8"))
    return hashes
