"""Run Node.js with the npm packages pinned in package-lock.json, in order to build the website."""

from __future__ import annotations

import hashlib
import re
import shutil
import subprocess
from pathlib import Path

WEB = Path(__file__).parent
OLDEST = 20
PACKAGES = WEB / "node_modules"


def missing() -> str:
    """Return a message that says what to install before Node.js can run, or "" if all is ready."""
    node = shutil.which("node")
    if node is None or shutil.which("npm") is None:
        what = "node" if node is None else "npm"
        return f"there is no {what}: install Node.js {OLDEST} or newer, from https://nodejs.org"
    command = [node, "--version"]
    version = subprocess.run(command, capture_output=True, encoding="utf-8", check=True).stdout
    number = re.match(r"v(\d+)", version)
    if number is None or int(number[1]) < OLDEST:
        return f"Node.js {OLDEST} or newer is needed, and this is {version.strip()}"
    return ""


def run_node(script: str, *arguments: str) -> None:
    """Run a JavaScript file of this folder. Raise ValueError if it fails."""
    prepare()
    done = subprocess.run(["node", script, *arguments], cwd=WEB, check=False)
    if done.returncode:
        raise ValueError(f"node {script} failed, see above")


def prepare() -> None:
    """Install the pinned npm packages if they are missing. Raise ValueError if that fails."""
    if why := missing():
        raise ValueError(why)
    wanted = hashlib.sha256((WEB / "package-lock.json").read_bytes()).hexdigest()
    stamp = PACKAGES / ".installed"
    if stamp.is_file() and stamp.read_text(encoding="utf-8") == wanted:
        return
    print("Installing the packages of web/package-lock.json ...", flush=True)
    # None of the packages needs an install script.
    npm = shutil.which("npm") or "npm"  # npm.cmd on Windows
    done = subprocess.run(
        [npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--silent"], cwd=WEB, check=False
    )
    if done.returncode:
        raise ValueError("npm ci failed in web/: is this computer online?")
    stamp.write_text(wanted, encoding="utf-8")
