"""Grade what the students of a class have handed in, on one machine or on a cluster."""
