"""The benchmarks of `make bench`, in one module per subject, such as springs or rotations.

Each module has a function ``lines`` that sets up its benchmarks and returns them.
"""
