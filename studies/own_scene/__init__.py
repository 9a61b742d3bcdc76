"""Find the cheapest model of a scene that a reader describes in a file of their own."""
