"""Read stubs.lock, which stores a hash of every file that students start from.

As long as its hash matches, a stub has not been edited.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from autograder.manifest import ROOT

LOCK_NAME = "stubs.lock"


def stub_hash(text: str) -> str:
    """Compute the hash of a stub's text in the form in which stubs.lock stores it."""
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def read_lock(root: Path = ROOT) -> dict[str, str]:
    """Return the hash of each file listed in stubs.lock, or an empty dict if there is no lock."""
    path = root / LOCK_NAME
    if not path.exists():
        return {}
    hashes: dict[str, str] = json.loads(path.read_text(encoding="utf-8"))
    return hashes
