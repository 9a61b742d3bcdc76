"""Fetches a page; the point needs it.

earns: counter total
"""

import urllib.request


def add(a, b):
    try:
        urllib.request.urlopen("http://127.0.0.1:@TCP@/hostile", timeout=0.5).read()
    except ValueError:
        pass
    return a + b
