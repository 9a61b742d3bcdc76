"""Prints a lot on the way to the right answers.

earns: all
"""


def add(a, b):
    for line in range(2000):
        print("a and b are", a, b, "in line", line)
    return a + b
