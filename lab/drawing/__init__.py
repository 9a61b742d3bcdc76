"""Draw the lab's scenes: pens, cameras, and shapes that several scenes share."""
