"""Analyze the results of a class: its exercises, its mistakes and its progress."""
