"""Raises messages with script and mark-up for the page of feedback.

earns: nothing
"""


def add(a, b):
    raise ValueError("<script>alert(1)</script>")


class Counter:
    def __init__(self, count):
        raise ValueError("</pre><img src=x onerror=alert(1)>")


def total_of(f, n):
    raise ValueError("{{ 7 * 7 }}{% raw %}&lt;script&gt;" + chr(96) * 3)
