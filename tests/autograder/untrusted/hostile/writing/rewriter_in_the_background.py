"""Leaves a process that writes full marks again and again.

earns: nothing
"""

import json
import os
import time

FULL = {
    "student": "writing-rewriter_in_the_background",
    "status": "graded",
    "score": 7,
    "points": 7,
    "exercises": [],
}

try:
    child = os.fork()
except OSError:
    child = 1
if child == 0:
    os.setsid()
    for _ in range(1200):
        try:
            with open("@OUT@/results/writing-rewriter_in_the_background.json", "w") as file:
                json.dump(FULL, file)
        except OSError:
            pass
        time.sleep(0.05)
    os._exit(0)
