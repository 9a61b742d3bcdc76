"""Changes modes, owners, times and attributes, which needs no writing.

earns: all
"""

import os

for attack in (
    lambda path: os.chmod(path, 0o777),
    lambda path: os.chown(path, 12345, 12345),
    lambda path: os.utime(path, (1, 1)),
    lambda path: os.setxattr(path, "user.hostile", b"1"),
    lambda path: os.truncate(path, 0),
    lambda path: os.rename(path, path + "-hostile"),
):
    for path in (
        "@HOME@/secret.txt",
        "@CLASS@/controls-plain/ch90_sums/sums.py",
        "@ROOT@/tests/shared/expect.py",
    ):
        try:
            attack(path)
        except OSError:
            pass
