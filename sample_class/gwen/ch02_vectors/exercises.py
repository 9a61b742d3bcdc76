"""Gwen prints her answers and leaves."""

import sys

from ch02_vectors.vector import Vector3

v = Vector3(2, -2, -2)
print("2.1:", v.magnitude())
sys.exit()
