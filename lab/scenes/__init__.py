"""The scenes of the lab. Each module is named after its chapter."""
