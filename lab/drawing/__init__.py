"""Draw scenes: pens and cameras, and the shapes and contacts that scenes share."""
