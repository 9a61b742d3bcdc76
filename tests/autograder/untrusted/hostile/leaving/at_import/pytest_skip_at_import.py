"""Asks pytest to skip all its checks, while it is imported.

earns: nothing
"""

import sys

sys.path.append("@SITE@")
import pytest

pytest.skip("not today", allow_module_level=True)
