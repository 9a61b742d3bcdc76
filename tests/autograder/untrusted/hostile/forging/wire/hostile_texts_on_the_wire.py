"""Sends names of types, files and errors that are far too long, or no text.

earns: nothing
"""

import json
import os


def send(number, **message):
    for file in range(3, 64):
        try:
            os.write(file, json.dumps({"id": number, **message}).encode() + b"\n")
        except OSError:
            pass


def add(a, b):
    for number in range(60):
        send(
            number, value={"object": 0, "type": "<script>alert(1)</script>" + chr(27) + "[2J" * 900}
        )


class Counter:
    def __init__(self, count):
        for number in range(60):
            send(
                number,
                raised={"as": "BaseException", "type": 7, "text": None, "frames": 3, "syntax": []},
            )


def total_of(f, n):
    for number in range(60):
        send(number, missing=chr(27) + "]0;owned" + chr(7) + "x" * 9000)
