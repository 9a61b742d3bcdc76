"""Release the reference after the deadline, and show students their own solutions beside it."""
