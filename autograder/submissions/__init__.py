"""What students hand in: found, looked at from outside, and copied into a box of our own."""
