"""Releasing the reference after the deadline, beside each student's own solutions that passed."""
