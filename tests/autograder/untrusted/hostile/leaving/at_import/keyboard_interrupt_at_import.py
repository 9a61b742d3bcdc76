"""Pretends that the instructor pressed Ctrl-C, while it is imported.

earns: nothing
"""

raise KeyboardInterrupt
