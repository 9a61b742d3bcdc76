"""Returns True, which is a number to Python.

earns: nothing
"""

RIGHT = True
