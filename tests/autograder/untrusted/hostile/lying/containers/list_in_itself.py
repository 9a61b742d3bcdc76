"""Returns a list that holds itself.

earns: nothing
"""

RIGHT = []
RIGHT.append(RIGHT)
