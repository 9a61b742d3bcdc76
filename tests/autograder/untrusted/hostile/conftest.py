"""Nothing below this folder is a test of the companion: test_hostile.py, beside it, uses it all."""

collect_ignore_glob = ["*"]
