"""Grade a class, on one machine or over a cluster."""
