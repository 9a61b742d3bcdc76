"""The current stubs, generated once for all tests of a process, because that takes seconds."""

from __future__ import annotations

from functools import cache

from autograder.stubs import make_stubs

made_stubs = cache(make_stubs)
