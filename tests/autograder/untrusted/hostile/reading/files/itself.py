"""Reads its own file and its probes, which it may.

earns: all
"""

import pathlib


def add(a, b):
    for path in (pathlib.Path(__file__), pathlib.Path(__file__).with_name("probes.py")):
        try:
            path.read_text()
        except OSError:
            pass
    return a + b
