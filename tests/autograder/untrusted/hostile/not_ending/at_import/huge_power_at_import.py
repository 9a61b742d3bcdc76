"""One long call into C while it is imported.

earns: nothing
"""

DIGITS = 7 ** (10**8)
