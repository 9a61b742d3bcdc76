"""Sends what is no message: half lines, deep nests, huge numbers, no text at all.

earns: nothing
"""

import os

NONSENSE = {
    "add": b"[" * 100_000 + b"\n",
    "count": b'{"id": 1e999, "value": NaN}\n',
    "total": b"\xff\x00\xfe\n",
}


def send(data):
    for file in range(3, 64):
        try:
            os.write(file, data)
        except OSError:
            pass


def add(a, b):
    send(NONSENSE["add"])


class Counter:
    def __init__(self, count):
        send(NONSENSE["count"])
        send(b'{"id": 1' + b"0" * 5000 + b"}\n")


def total_of(f, n):
    send(NONSENSE["total"])
    send(b'{"callback": 99, "with": []}\n{"callback": -1}\n{"callback": "x", "with": 3}\n')
