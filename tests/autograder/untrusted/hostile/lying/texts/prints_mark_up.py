"""Prints script, mark-up and control characters before it fails.

earns: counter total
"""


def add(a, b):
    print("<script>alert(1)</script><img src=x onerror=alert(1)>", chr(27) + "[2J", chr(0))
