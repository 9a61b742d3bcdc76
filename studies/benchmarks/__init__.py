"""The benchmarks of `make bench`, by subject. The function ``lines`` of a module sets them up."""
