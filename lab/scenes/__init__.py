"""The scenes, a module a chapter."""
