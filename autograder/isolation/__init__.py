"""Where untrusted code runs: a worker behind walls, and the wire between it and the checks."""
