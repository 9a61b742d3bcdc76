"""The scenes of the lab, in modules named after their chapters."""
