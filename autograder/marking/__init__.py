"""Marking written answers on a local page, one question after another."""
