"""Draw the scenes of the lab, with pens, cameras, and the shapes that several scenes use."""
