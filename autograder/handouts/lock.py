"""Read stubs.lock, the hashes that source files have if no student has edited them."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from autograder.manifest import ROOT

LOCK_NAME = "autograder/handouts/stubs.lock"


def stub_hash(text: str) -> str:
    """Compute the SHA-256 hash of a stub's text, as it is stored in stubs.lock."""
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def read_lock(root: Path = ROOT) -> dict[str, str]:
    """Return the hashes in stubs.lock, if there is one, keyed by the paths of the files."""
    path = root / LOCK_NAME
    if not path.exists():
        return {}
    hashes: dict[str, str] = json.loads(path.read_text(encoding="utf-8"))
    return hashes
