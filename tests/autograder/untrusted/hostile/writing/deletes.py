"""Deletes whatever it can reach; its own answers are right.

earns: all
"""

import shutil

for folder in ("@OUT@", "@HOME@", "@CLASS@/controls-plain", "@ROOT@/tests"):
    shutil.rmtree(folder, ignore_errors=True)
