"""Returns a generator that never ends.

earns: nothing
"""

import itertools

RIGHT = itertools.count()
