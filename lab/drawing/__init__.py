"""Tools for drawing the lab's scenes: pens, a camera, and shapes that several scenes share."""
