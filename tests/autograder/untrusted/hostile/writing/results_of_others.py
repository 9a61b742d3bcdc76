"""Spoils another student's work and result; its own answers are right.

earns: all
"""

for path in (
    "@CLASS@/controls-plain/ch90_sums/sums.py",
    "@OUT@/results/controls-plain.json",
    "@CLASS@/controls-other_style/ch90_sums/sums.py",
):
    try:
        with open(path, "w") as file:
            file.write("spoiled")
    except OSError:
        pass
