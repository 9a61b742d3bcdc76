#!/usr/bin/env bash
# Gradescope runs this once, as root, when it builds the image: a Python, and the pinned packages.
set -e
cd "${AUTOGRADER_ROOT:-/autograder}/source"
export DEBIAN_FRONTEND=noninteractive
apt-get update
apt-get install -y bubblewrap || echo "no bubblewrap: the other walls must do"
for version in 3.13 3.12 3.11; do
    if apt-get install -y "python$version" "python$version-venv"; then
        exec "python$version" autograder/make_venv.py
    fi
done
echo "Cannot set up: this image has no Python 3.11 or newer; choose Ubuntu 22.04 or a later one."
exit 1
