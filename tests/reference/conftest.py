"""Make hypothesis draw the same examples in every run, without a time limit per example."""

from hypothesis import settings

settings.register_profile("companion", derandomize=True, deadline=None)
settings.load_profile("companion")
