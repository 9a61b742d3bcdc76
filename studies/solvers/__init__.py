"""Contact solvers compared: how far spheres sink in and ropes stretch, over the time it takes."""
