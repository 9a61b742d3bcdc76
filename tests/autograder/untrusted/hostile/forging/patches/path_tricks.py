"""Changes where later imports are looked for.

earns: nothing
"""

import os
import sys

sys.path[:0] = [os.path.dirname(__file__), "/tmp", "@CLASS@"]
sys.path_hooks.insert(0, lambda path: None)
sys.path_importer_cache.clear()
sys.dont_write_bytecode = False
try:
    os.chdir("/")
except OSError:
    pass
