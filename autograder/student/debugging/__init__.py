"""Stop in a student's function, at the call with which a check fails."""
