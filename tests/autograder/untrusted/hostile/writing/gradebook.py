"""Writes itself full marks into the gradebook and its own result.

earns: nothing
"""

import json

FULL = {
    "student": "writing-gradebook",
    "status": "graded",
    "score": 7,
    "points": 7,
    "exercises": [],
}

for path, text in (
    (
        "@OUT@/gradebook.csv",
        "student,status,score" + chr(10) + "writing-gradebook,graded,7" + chr(10),
    ),
    ("@OUT@/results/writing-gradebook.json", json.dumps(FULL)),
    ("@OUT@/hostile-note.txt", "I was here"),
):
    try:
        with open(path, "w") as file:
            file.write(text)
    except OSError:
        pass
