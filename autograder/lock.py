"""Read stubs.lock, which contains a hash of every file from which students start."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from autograder.manifest import ROOT

LOCK_NAME = "stubs.lock"


def stub_hash(text: str) -> str:
    """Return the hash of a text, as it is stored in stubs.lock."""
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def read_lock(root: Path = ROOT) -> dict[str, str]:
    """Return the hashes in stubs.lock, keyed by path. If there is no lock, return an empty dict."""
    path = root / LOCK_NAME
    if not path.exists():
        return {}
    hashes: dict[str, str] = json.loads(path.read_text(encoding="utf-8"))
    return hashes
