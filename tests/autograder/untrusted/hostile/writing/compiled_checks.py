"""Leaves compiled files that Python would take for the checks' helpers.

earns: nothing
"""

import os
import py_compile
import sys

LENIENT = "def __getattr__(name): return lambda *args, **kwargs: None"


try:
    for helper in ("expect", "draw"):
        source = f"@ROOT@/tests/shared/{helper}.py"
        cached = f"@ROOT@/tests/shared/__pycache__/{helper}.{sys.implementation.cache_tag}.pyc"
        os.makedirs(os.path.dirname(cached), exist_ok=True)
        with open("/tmp/hostile-lenient.py", "w") as file:
            file.write(LENIENT)
        py_compile.compile(
            "/tmp/hostile-lenient.py",
            cached,
            source,
            invalidation_mode=py_compile.PycInvalidationMode.UNCHECKED_HASH,
        )
except OSError:
    pass
