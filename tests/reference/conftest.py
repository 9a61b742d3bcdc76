"""hypothesis draws the same examples in every run, and no shared machine is too slow for it."""

from hypothesis import settings

settings.register_profile("companion", derandomize=True, deadline=None)
settings.load_profile("companion")
