"""Read stubs.lock, which holds a hash of every file that students start from."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from autograder.manifest import ROOT

LOCK_NAME = "stubs.lock"


def stub_hash(text: str) -> str:
    """Return the hash that stubs.lock stores for a file with this text."""
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def read_lock(root: Path = ROOT) -> dict[str, str]:
    """Return the hashes in stubs.lock, keyed by path, or an empty dict if there is no lock."""
    path = root / LOCK_NAME
    if not path.exists():
        return {}
    hashes: dict[str, str] = json.loads(path.read_text(encoding="utf-8"))
    return hashes
