#!/usr/bin/env bash
# Gradescope runs this once, as root, to build the image: it installs Python and pinned packages.
set -e
cd "${AUTOGRADER_ROOT:-/autograder}/source"
export DEBIAN_FRONTEND=noninteractive
apt-get update
apt-get install -y bubblewrap || echo "bubblewrap is not available: the sandbox uses its other layers"
for version in 3.15 3.14 3.13 3.12 3.11; do
    if apt-get install -y "python$version" "python$version-venv"; then
        exec "python$version" autograder/make_venv.py teaching
    fi
done
echo "Cannot set up: this image has no Python 3.11 or newer. Choose Ubuntu 22.04 or newer."
exit 1
