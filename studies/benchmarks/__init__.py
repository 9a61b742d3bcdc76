"""The benchmarks of speed, by subject. The function ``lines`` of a module sets them up."""
