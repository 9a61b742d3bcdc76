"""Is never done with being imported.

earns: nothing
says: did not finish
"""

import itertools

for number in itertools.count():
    pass
