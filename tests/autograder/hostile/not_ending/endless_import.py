"""Is never done with being imported.

earns: nothing
says: did not end
"""

import itertools

for number in itertools.count():
    pass
