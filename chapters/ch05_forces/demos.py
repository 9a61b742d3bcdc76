"""Demos."""
DEMOS = ()
