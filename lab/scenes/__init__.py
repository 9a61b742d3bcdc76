"""The interactive scenes of the lab, in modules that are named after the book's chapters."""
