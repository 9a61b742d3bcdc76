"""Read stubs.lock, which stores a hash of every file that students start from.

A stub whose hash still matches has not been edited.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from autograder.manifest import ROOT

LOCK_NAME = "stubs.lock"


def stub_hash(text: str) -> str:
    """Compute the hash of a stub's text, as stubs.lock stores it."""
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def read_lock(root: Path = ROOT) -> dict[str, str]:
    """Read stubs.lock, and return the hash of each file. Without a lock, return an empty dict."""
    path = root / LOCK_NAME
    if not path.exists():
        return {}
    hashes: dict[str, str] = json.loads(path.read_text(encoding="utf-8"))
    return hashes
