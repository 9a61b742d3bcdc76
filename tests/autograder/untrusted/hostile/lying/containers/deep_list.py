"""Returns a list that is nested a hundred thousand deep.

earns: nothing
"""

RIGHT = []
for _ in range(100_000):
    RIGHT = [RIGHT]
