"""Profiles of hypothesis are known before it reads --hypothesis-profile."""

from hypothesis import settings

settings.register_profile("long", max_examples=3000)
