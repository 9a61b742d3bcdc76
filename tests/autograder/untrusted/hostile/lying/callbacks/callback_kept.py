"""Keeps the function it was given and calls it where nobody expects it.

earns: add counter
"""


def total_of(f, n):
    class Wrong(ValueError):
        def __str__(self):
            return f"{f(0)} {f(1)}"

    raise Wrong if n > 0 else ValueError
