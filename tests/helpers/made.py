"""The stubs as they are made now, once for all tests of a process: that takes some seconds."""

from __future__ import annotations

from functools import cache

from autograder.stubs import make_stubs

made_stubs = cache(make_stubs)
